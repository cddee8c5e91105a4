//! Coverage of a surface by pixels, and the averages of lines, bands and discs over it.

use crate::scene::pattern::coverage::{COVERED, GRAZING};
use crate::simd::lanes::{F, Simd, SimdFloat as _, V3, all, clamp, select};

/// The coverage of a pixel: the shifts on the surface towards the pixel on the right, and below.
#[derive(Debug, Clone, Copy)]
pub struct PixelShifts<S: Simd> {
    right: V3<S>,
    down: V3<S>,
}

impl<S: Simd> PixelShifts<S> {
    /// On surfaces with this `normal`, met at this distance by rays which move by `right` and `down` per
    /// distance.
    #[inline(always)]
    pub fn new(direction: V3<S>, normal: V3<S>, right: V3<S>, down: V3<S>, distance: F<S>) -> Self {
        let cosine = direction.dot(normal).min(-GRAZING as f32);
        Self {
            right: (right - direction * (right.dot(normal) / cosine)) * distance,
            down: (down - direction * (down.dot(normal) / cosine)) * distance,
        }
    }

    /// Returns the range of a coordinate with this gradient that is covered.
    #[inline(always)]
    pub fn range(&self, gradient: V3<S>) -> F<S> {
        let (right, down) = (gradient.dot(self.right), gradient.dot(self.down));
        (right * right + down * down).sqrt()
    }
}

#[inline(always)]
fn held<S: Simd>(covered: F<S>) -> F<S> {
    let simd = covered.simd;
    clamp(covered, all(simd, COVERED[0] as f32), all(simd, COVERED[1] as f32))
}

#[inline(always)]
pub fn line<S: Simd>(x: F<S>, half_width: F<S>, quarter: f32, covered: F<S>) -> F<S> {
    let nearest = x.round_ties_even();
    let from_quarter = (nearest - (nearest / quarter).round_ties_even() * quarter).abs();
    let half = select(from_quarter.simd_lt(0.5), half_width * 2.0, half_width).min(0.5);
    let (width, off) = (held(covered), x - nearest);
    let low = line_before(off - width * 0.5, half);
    (line_before(off + width * 0.5, half) - low) / width
}

#[inline(always)]
fn line_before<S: Simd>(x: F<S>, half: F<S>) -> F<S> {
    let nearest = x.round_ties_even();
    half * 2.0 * nearest + clamp(x - nearest, -half, half)
}

#[inline(always)]
pub fn wave<S: Simd>(x: F<S>, covered: F<S>) -> F<S> {
    let near = x - (x * 0.5).round_ties_even() * 2.0;
    let width = held(covered);
    (sawtooth(near + width * 0.5) - sawtooth(near - width * 0.5)) / width
}

#[inline(always)]
fn sawtooth<S: Simd>(x: F<S>) -> F<S> {
    (x - (x * 0.5).round_ties_even() * 2.0).abs()
}

/// Returns the coverage of a disc, at this place from its middle.
#[inline(always)]
pub fn pip<S: Simd>(off: V3<S>, radius: F<S>, covered: &PixelShifts<S>) -> F<S> {
    let simd = radius.simd;
    let distance = off.length();
    let width = covered.range(off * (1.0 / distance.max(1e-30)));
    let wide = radius.max(width * 0.5);
    let share = (wide - distance) / width.max(1e-30) + 0.5;
    let size = radius / wide;
    clamp(share, all(simd, 0.0), all(simd, 1.0)) * size * size
}

#[inline(always)]
pub fn rim<S: Simd>(distance: F<S>, width: F<S>, covered: F<S>) -> F<S> {
    let wide = covered.max(width * 1e-6);
    let within = (distance + wide * 0.5).min(width) - (distance - wide * 0.5).max(0.0);
    (within / wide).max(0.0)
}
