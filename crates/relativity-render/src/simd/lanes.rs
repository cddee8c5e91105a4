//! Eight pixels at once: numbers, vectors and quaternions of which each lane belongs to one of them.
//!
//! Only `+ - * /`, roots, comparisons and roundings are used, which IEEE 754 fixes to the bit, and no fused
//! ones: so pictures are the same whatever registers a processor has.
//!
//! What is given to `Option::map`, `array::map` or `bool::then` is compiled for the narrowest registers, with
//! a call for each number: here it is `match` and `if`, or `vectorize` inside.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

pub use fearless_simd::prelude::*;
use fearless_simd::{f32x8, mask32x8};

/// The value of `body`, which is compiled for the widest registers that there are.
macro_rules! vectorized {
    ($simd:expr, $body:expr) => {
        $simd.vectorize(
            #[inline(always)]
            || $body,
        )
    };
}
pub(crate) use vectorized;

/// Number of pixels that are drawn at once.
pub const LANES: usize = 8;

/// A number for each.
pub type F<S> = f32x8<S>;
/// Yes or no for each.
pub type Mask<S> = mask32x8<S>;

/// In the picture, or in a plane.
#[derive(Debug, Clone, Copy)]
pub struct V2<S: Simd> {
    pub x: F<S>,
    pub y: F<S>,
}

/// In space, or linear sRGB.
#[derive(Debug, Clone, Copy)]
pub struct V3<S: Simd> {
    pub x: F<S>,
    pub y: F<S>,
    pub z: F<S>,
}

/// A unit quaternion in each lane.
#[derive(Debug, Clone, Copy)]
pub struct Quaternion<S: Simd> {
    pub v: V3<S>,
    pub w: F<S>,
}

/// Returns a number that is the same in each lane.
#[inline(always)]
pub fn all<S: Simd>(simd: S, value: f32) -> F<S> {
    F::splat(simd, value)
}

/// Returns a mask that is false in each lane.
#[inline(always)]
pub fn no<S: Simd>(simd: S) -> Mask<S> {
    Mask::splat(simd, 0)
}

/// A bit for each lane where it holds.
#[inline(always)]
pub fn bits<S: Simd>(holds: Mask<S>) -> u32 {
    let lanes: [i32; LANES] = holds.into();
    let mut bits = 0;
    for (lane, holds) in lanes.into_iter().enumerate() {
        bits |= u32::from(holds != 0) << lane;
    }
    bits
}

/// `value` where it holds, else `other`.
#[inline(always)]
pub fn select<S: Simd>(holds: Mask<S>, value: F<S>, other: F<S>) -> F<S> {
    holds.select(value, other)
}

/// At least `low`, at most `high`.
#[inline(always)]
pub fn clamp<S: Simd>(value: F<S>, low: F<S>, high: F<S>) -> F<S> {
    value.max(low).min(high)
}

/// 1, or -1 below 0.
#[inline(always)]
pub fn sign_of<S: Simd>(x: F<S>) -> F<S> {
    let simd = x.simd;
    select(x.simd_lt(0.0), all(simd, -1.0), all(simd, 1.0))
}

impl<S: Simd> V2<S> {
    #[inline(always)]
    pub fn new(x: F<S>, y: F<S>) -> Self {
        Self { x, y }
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> F<S> {
        self.x * other.x + self.y * other.y
    }

    #[inline(always)]
    pub fn select(holds: Mask<S>, value: Self, other: Self) -> Self {
        Self { x: select(holds, value.x, other.x), y: select(holds, value.y, other.y) }
    }

    #[inline(always)]
    pub fn length(self) -> F<S> {
        (self.x * self.x + self.y * self.y).sqrt()
    }
}

impl<S: Simd> V3<S> {
    #[inline(always)]
    pub fn new(x: F<S>, y: F<S>, z: F<S>) -> Self {
        Self { x, y, z }
    }

    /// A vector that is the same in each lane.
    #[inline(always)]
    pub fn all(simd: S, [x, y, z]: [f32; 3]) -> Self {
        Self { x: all(simd, x), y: all(simd, y), z: all(simd, z) }
    }

    /// The first three of four, the same for all.
    #[inline(always)]
    pub fn of_four(simd: S, [x, y, z, _]: [f32; 4]) -> Self {
        Self::all(simd, [x, y, z])
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> F<S> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    #[inline(always)]
    pub fn length(self) -> F<S> {
        self.dot(self).sqrt()
    }

    /// Returns the product, part by part.
    #[inline(always)]
    pub fn times(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y, z: self.z * other.z }
    }

    /// The greater of both, part by part.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { x: self.x.max(other.x), y: self.y.max(other.y), z: self.z.max(other.z) }
    }

    /// At least `low`, at most `high`, part by part.
    #[inline(always)]
    pub fn clamp(self, low: Self, high: Self) -> Self {
        Self {
            x: clamp(self.x, low.x, high.x),
            y: clamp(self.y, low.y, high.y),
            z: clamp(self.z, low.z, high.z),
        }
    }

    /// At least `low`, each part.
    #[inline(always)]
    pub fn at_least(self, low: f32) -> Self {
        Self { x: self.x.max(low), y: self.y.max(low), z: self.z.max(low) }
    }

    /// The root of each part.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self { x: self.x.sqrt(), y: self.y.sqrt(), z: self.z.sqrt() }
    }

    /// Returns [`sign_of`] of each part.
    #[inline(always)]
    pub fn signs(self) -> Self {
        Self { x: sign_of(self.x), y: sign_of(self.y), z: sign_of(self.z) }
    }

    /// Without signs, part by part.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self { x: self.x.abs(), y: self.y.abs(), z: self.z.abs() }
    }

    /// Returns the greatest of the parts.
    #[inline(always)]
    pub fn max_part(self) -> F<S> {
        self.x.max(self.y.max(self.z))
    }

    /// Returns the least of the parts.
    #[inline(always)]
    pub fn min_part(self) -> F<S> {
        self.x.min(self.y.min(self.z))
    }

    /// The parts y, z and x.
    #[inline(always)]
    pub fn yzx(self) -> Self {
        Self { x: self.y, y: self.z, z: self.x }
    }

    /// The parts z, x and y.
    #[inline(always)]
    pub fn zxy(self) -> Self {
        Self { x: self.z, y: self.x, z: self.y }
    }

    /// The sum of these columns, each times one of its parts.
    #[inline(always)]
    pub fn sum_of(self, columns: [[f32; 4]; 3]) -> Self {
        let simd = self.x.simd;
        let [x, y, z] = columns;
        Self::of_four(simd, x) * self.x + Self::of_four(simd, y) * self.y + Self::of_four(simd, z) * self.z
    }

    /// Returns the vector's products with these columns.
    #[inline(always)]
    pub fn in_columns(self, columns: [[f32; 4]; 3]) -> Self {
        let simd = self.x.simd;
        let [x, y, z] = columns;
        Self {
            x: self.dot(Self::of_four(simd, x)),
            y: self.dot(Self::of_four(simd, y)),
            z: self.dot(Self::of_four(simd, z)),
        }
    }

    /// With x reversed where `sign` is -1.
    #[inline(always)]
    pub fn reflected(self, sign: f32) -> Self {
        Self { x: self.x * sign, ..self }
    }

    #[inline(always)]
    pub fn select(holds: Mask<S>, value: Self, other: Self) -> Self {
        Self {
            x: select(holds, value.x, other.x),
            y: select(holds, value.y, other.y),
            z: select(holds, value.z, other.z),
        }
    }

    #[inline(always)]
    pub fn mix(first: Self, second: Self, share: F<S>) -> Self {
        first * (1.0 - share) + second * share
    }

    /// Returns the vector of one lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> [f32; 3] {
        [self.x[lane], self.y[lane], self.z[lane]]
    }
}

impl<S: Simd> Quaternion<S> {
    /// A quaternion that is the same in each lane.
    #[inline(always)]
    pub fn all(simd: S, [x, y, z, w]: [f32; 4]) -> Self {
        Self { v: V3::all(simd, [x, y, z]), w: all(simd, w) }
    }

    /// Returns the opposite turn.
    #[inline(always)]
    pub fn conjugate(self) -> Self {
        Self { v: -self.v, w: self.w }
    }

    /// `v`, turned by it.
    #[inline(always)]
    pub fn turned(self, v: V3<S>) -> V3<S> {
        let twist = self.v.cross(v) * 2.0;
        v + twist * self.w + self.v.cross(twist)
    }
}

impl<S: Simd> Add for V3<S> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<S: Simd> AddAssign for V3<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Simd> Sub for V3<S> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<S: Simd> Neg for V3<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl<S: Simd> Div<F<S>> for V3<S> {
    type Output = Self;

    #[inline(always)]
    fn div(self, divisor: F<S>) -> Self {
        Self { x: self.x / divisor, y: self.y / divisor, z: self.z / divisor }
    }
}

/// Divides part by part.
impl<S: Simd> Div for V3<S> {
    type Output = Self;

    #[inline(always)]
    fn div(self, divisors: Self) -> Self {
        Self { x: self.x / divisors.x, y: self.y / divisors.y, z: self.z / divisors.z }
    }
}

impl<S: Simd> Mul<F<S>> for V3<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: F<S>) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}

impl<S: Simd> Mul<f32> for V3<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f32) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}
