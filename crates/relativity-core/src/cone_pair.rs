//! The differences between two light cones of one point, formed without subtracting one view from the other.
//!
//! Two things would spoil a plain difference. Small separations cancel; so the difference of the two X comes
//! from a formula of its own. And where a disparity is extreme or zero, it does not depend on the time to
//! first order, but each view alone does; so both views must carry the *same* rounding errors of S and X.

use crate::aperture::Aperture;
use crate::apparent::{LightCone, rounded};
use crate::math::{self, Elementary};
use crate::source::SourcePoint;
use crate::speed::Coefficients;

/// S, y and z of the primary light cone minus those of the secondary, known without subtraction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Offset<F> {
    pub s: F,
    pub y: F,
    pub z: F,
}

/// Two light cones of one point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConePair<F> {
    pub beta: F,
    pub left: LightCone<F>,
    pub right: LightCone<F>,
    pub offset: Offset<F>,
    /// The sum of both S, known better than by addition where they cancel.
    pub sum_s: F,
}

/// Both apparent X, their difference and their sum.
struct ApparentXs<F> {
    left: F,
    right: F,
    difference: F,
    sum: F,
    /// Whether the two X have opposite signs and similar size, so that their sum cancels.
    is_opposite: bool,
}

impl<F: Elementary> ConePair<F> {
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "a batch works out once what all its rows share")]
    pub fn new(
        coefficients: &Coefficients<F>,
        point: SourcePoint,
        primary: Aperture,
        secondary: Aperture,
        time: F,
    ) -> Self {
        let [x0, y, z]: [F; 3] = rounded([point.x0, point.y, point.z]);
        let [lx, ly, lz]: [F; 3] = rounded([primary.x, primary.y, primary.z]);
        let [rx, ry, rz]: [F; 3] = rounded([secondary.x, secondary.y, secondary.z]);
        let offset = Offset { s: rx - lx, y: ry - ly, z: rz - lz };
        let moved = coefficients.beta * time;
        let sum_s = ((x0 + x0) - (lx + rx)) + (moved + moved);
        let (from_left, from_right) = (x0 - lx, x0 - rx);
        // S of both from their common mean, unless the separation dwarfs what the mean is made of.
        let is_close = offset.s.abs() <= from_left.abs().min(from_right.abs()) + moved.abs();
        let (left_s, right_s) = if is_close {
            (half(sum_s + offset.s), half(sum_s - offset.s))
        } else {
            (from_left + moved, from_right + moved)
        };
        Self {
            beta: coefficients.beta,
            left: LightCone::at(coefficients, left_s, y - ly, z - lz),
            right: LightCone::at(coefficients, right_s, y - ry, z - rz),
            offset,
            sum_s,
        }
    }

    /// (Delta-phi, Delta-theta), from the sines and cosines of the differences.
    #[inline]
    pub fn angle_differences(&self) -> (F, F) {
        self.wanted_angle_differences([true, true])
    }

    /// (Delta-phi, Delta-theta), with 0 for a difference that is not `wanted`, since each has its price.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "a batch works out once what all its rows share")]
    pub fn wanted_angle_differences(&self, wanted: [bool; 2]) -> (F, F) {
        let Self { left, right, offset, .. } = self;
        let zero = F::zero();
        if left.solution.q + right.solution.q == zero {
            return (zero, zero); // the point is inside both apertures, which then coincide
        }
        let x = self.apparent_xs();
        let y = AcrossMotion { left: left.y, right: right.y, offset: offset.y };
        let z = AcrossMotion { left: left.z, right: right.z, offset: offset.z };
        let dphi = if wanted[0] {
            math::atan2(self.cross_with_x(&x, &y, &z), x.left * x.right + y.left * y.right)
        } else {
            zero
        };
        if !wanted[1] {
            return (dphi, zero);
        }
        let left_h = (x.left * x.left + y.left * y.left).sqrt();
        let right_h = (x.right * x.right + y.right * y.right).sqrt();
        let sine = self.elevation_cross(&x, &y, &z, left_h, right_h);
        (dphi, math::atan2(sine, left_h * right_h + z.left * z.right))
    }

    /// `u_l X_r - u_r X_l` for a coordinate u across the motion, v being the other one.
    ///
    /// With X = gamma^2 (S - beta q) the products of u and q are reduced like a difference of roots; what
    /// remains vanishes term by term where the two lines of sight agree.
    #[inline]
    fn cross_with_x(&self, x: &ApparentXs<F>, u: &AcrossMotion<F>, v: &AcrossMotion<F>) -> F {
        let (left, right) = (&self.left.solution, &self.right.solution);
        let plain = (u.left * x.right, -u.right * x.left);
        let u_q = u.left * right.q + u.right * left.q;
        if !u.same_sign() || u_q == F::zero() {
            return plain.0 + plain.1;
        }
        let u_r = u.left * right.r + u.right * left.r;
        let u_v = u.left * v.right + u.right * v.left;
        let cross_s = u.offset * self.left.s - u.left * self.offset.s;
        smaller_terms(plain, (cross_s * (u_r / u_q), -self.beta * u.cross(v) * (u_v / u_q)))
    }

    /// `z_l h_r - z_r h_l`, h being the horizontal distances: as
    /// `(z_l^2 h_r^2 - z_r^2 h_l^2)/(z_l h_r + z_r h_l)` with the differences of squares factored.
    #[inline]
    fn elevation_cross(
        &self,
        x: &ApparentXs<F>,
        y: &AcrossMotion<F>,
        z: &AcrossMotion<F>,
        left_h: F,
        right_h: F,
    ) -> F {
        let plain = (z.left * right_h, -z.right * left_h);
        let sum = plain.0 - plain.1;
        if !z.same_sign() || sum == F::zero() {
            return plain.0 + plain.1;
        }
        let with_x = if x.is_opposite {
            half((z.left + z.right) * x.sum - z.offset * x.difference)
        } else {
            z.left * x.right + z.right * x.left
        };
        let with_y = z.left * y.right + z.right * y.left;
        smaller_terms(plain, (self.cross_with_x(x, z, y) * (with_x / sum), z.cross(y) * (with_y / sum)))
    }

    /// `(X_l - X_r)/d` of apertures d apart along x; none for a point inside both.
    pub fn gain(&self) -> Option<F> {
        let (left, right) = (&self.left.solution, &self.right.solution);
        let sum_q = left.q + right.q;
        (sum_q > F::zero()).then(|| (left.r + right.r) / sum_q)
    }

    /// The mean of both X; 0 for a point inside both apertures.
    pub fn mean_x(&self) -> F {
        if self.gain().is_some() { half(self.apparent_xs().sum) } else { F::zero() }
    }

    /// Both lines of sight, from apertures between which the point is at `y` and `z`; none for a point inside
    /// both apertures.
    pub fn lines_of_sight(&self, y: F, z: F) -> Option<SightPair<F>> {
        let Self { left, right, offset, .. } = self;
        let sum_q = left.solution.q + right.solution.q;
        if sum_q == F::zero() {
            return None;
        }
        let x = self.apparent_xs();
        let along = half(offset.s * x.sum) + offset.y * y + offset.z * z;
        let of_y = (y, AcrossMotion { left: left.y, right: right.y, offset: offset.y });
        let of_z = (z, AcrossMotion { left: left.z, right: right.z, offset: offset.z });
        Some(SightPair {
            each: [[x.left, left.y, left.z], [x.right, right.y, right.z]],
            mean: [half(x.sum), y, z],
            difference: [x.difference, offset.y, offset.z],
            normal: [
                offset.y * z - offset.z * y,
                self.mean_cross_with_x(&x, &of_z, &of_y),
                -self.mean_cross_with_x(&x, &of_y, &of_z),
            ],
            excess: [-(self.beta + self.beta) * (along / sum_q), F::zero(), F::zero()],
        })
    }

    /// [`Self::cross_with_x`] from the means of u and v over both apertures, which come with them: where the
    /// point is between the apertures the coordinates from each are known less well.
    fn mean_cross_with_x(
        &self,
        x: &ApparentXs<F>,
        (mean_u, u): &(F, AcrossMotion<F>),
        (mean_v, v): &(F, AcrossMotion<F>),
    ) -> F {
        let (left, right) = (&self.left.solution, &self.right.solution);
        let plain = (u.offset * half(x.sum), -*mean_u * x.difference);
        let u_q = u.left * right.q + u.right * left.q;
        if !u.same_sign() || u_q == F::zero() {
            return plain.0 + plain.1;
        }
        let u_r = u.left * right.r + u.right * left.r;
        let u_v = u.left * v.right + u.right * v.left;
        let cross_s = u.offset * half(self.sum_s) - *mean_u * self.offset.s;
        let cross_v = u.offset * *mean_v - *mean_u * v.offset;
        smaller_terms(plain, (cross_s * (u_r / u_q), -self.beta * cross_v * (u_v / u_q)))
    }

    /// With q^2 = S^2 + rho^2/gamma^2, X = gamma^2 (S - beta q); so the difference of the two X is
    /// `(dS (R_l + R_r) - beta d(rho^2))/(q_l + q_r)`, in which small separations do not cancel.
    #[inline]
    fn apparent_xs(&self) -> ApparentXs<F> {
        let Self { beta, left, right, offset, sum_s } = self;
        let (xl, xr) = (left.solution.x, right.solution.x);
        let sum_r = left.solution.r + right.solution.r;
        let sum_q = left.solution.q + right.solution.q;
        let by_offset = offset.s * sum_r / sum_q;
        let by_rho = *beta * (offset.y * (left.y + right.y) + offset.z * (left.z + right.z)) / sum_q;
        let difference = by_offset - by_rho;
        let size = xl.abs() + xr.abs();
        // Each X alone is known to a rounding of X and S. Only where the difference is worse known than both
        // (apertures far apart across the motion) are the two X left as they are.
        if by_offset.abs() + by_rho.abs() > size + size + left.s.abs() + right.s.abs() {
            return ApparentXs { left: xl, right: xr, difference, sum: xl + xr, is_opposite: false };
        }
        let sum = xl + xr;
        if size > F::from(3).map_or(size, |three| three * sum.abs()) {
            // Opposite and alike: their sum as S_l + S_r - beta (R_l + R_r).
            let sum = *sum_s - *beta * sum_r;
            return ApparentXs {
                left: half(sum + difference),
                right: half(sum - difference),
                difference,
                sum,
                is_opposite: true,
            };
        }
        let (xl, xr) = if xl.abs() < xr.abs() { (xl, xl - difference) } else { (xr + difference, xr) };
        ApparentXs { left: xl, right: xr, difference, sum: xl + xr, is_opposite: false }
    }
}

/// From two apertures to where they see one point: `P_l` and `P_r`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SightPair<F> {
    /// Both lines of sight, `P_l` and `P_r`.
    pub each: [[F; 3]; 2],
    /// Mean of both lines of sight, (`P_l` + `P_r`)/2.
    pub mean: [F; 3],
    /// Difference of both lines of sight, `P_l` - `P_r`.
    pub difference: [F; 3],
    /// `P_l` x `P_r`, across both.
    pub normal: [F; 3],
    /// By how much more they differ than the apertures' places do, which is all that sets them apart from two
    /// lines to one resting point: by how far the source moved between the two emissions.
    ///
    /// Of a point that does not turn that is -beta (`R_l` - `R_r`) along x. Since `R_l^2` - `R_r^2` is the
    /// product of the sum of both lines with their difference, `R_l` - `R_r` is that of their sum with the
    /// baseline over `q_l` + `q_r`.
    pub excess: [F; 3],
}

impl SightPair<f64> {
    /// (Delta-phi, Delta-theta), from the sines and cosines of the differences.
    pub fn angle_differences(&self) -> (f64, f64) {
        let Self { each: [left, right], normal: [nx, ny, nz], .. } = *self;
        let [left_h, right_h] = [left, right].map(|[x, y, _]| (x * x + y * y).sqrt());
        let dphi = math::atan2(-nz, left[0] * right[0] + left[1] * right[1]);
        // z_l h_r - z_r h_l as the difference of the squares over the sum, where both have one sign.
        let terms = [left[2] * right_h, right[2] * left_h];
        let sum = terms[0] + terms[1];
        let sine = if terms[0] * terms[1] > 0.0 {
            let of = |i: usize| (left[2] * right[i] + right[2] * left[i]) / sum;
            ny * of(0) - nx * of(1)
        } else {
            terms[0] - terms[1]
        };
        (dphi, math::atan2(sine, left_h * right_h + left[2] * right[2]))
    }
}

/// A coordinate across the motion, from both apertures, and left minus right.
struct AcrossMotion<F> {
    left: F,
    right: F,
    offset: F,
}

impl<F: Elementary> AcrossMotion<F> {
    #[inline]
    fn same_sign(&self) -> bool {
        let zero = F::zero();
        (self.left > zero && self.right > zero) || (self.left < zero && self.right < zero)
    }

    /// `u_l v_r - u_r v_l`.
    #[inline]
    fn cross(&self, v: &Self) -> F {
        self.offset * v.left - self.left * v.offset
    }
}

/// Returns that of two sums for the same number in which less cancels.
#[inline]
fn smaller_terms<F: Elementary>(a: (F, F), b: (F, F)) -> F {
    if a.0.abs() + a.1.abs() < b.0.abs() + b.1.abs() { a.0 + a.1 } else { b.0 + b.1 }
}

#[inline]
fn half<F: Elementary>(x: F) -> F {
    x / (F::one() + F::one())
}
