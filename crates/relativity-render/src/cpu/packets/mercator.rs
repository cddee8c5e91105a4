//! Lines of sight of a conformal picture: `conformal_line` of `shaders/frame.wgsl`, and what that needs.

use crate::frame::uniform::FrameUniform;
use crate::simd::lanes::{F, Simd, SimdFloat as _, V3, select};

/// A sine and a cosine less 1.
#[derive(Debug, Clone, Copy)]
struct SmallArc<S: Simd> {
    sine: F<S>,
    versine: F<S>,
}

/// sin and cos - 1 of `angle`, or the hyperbolic ones where `sign` is 1, of numbers up to 6: both from the
/// series of a quarter of it, doubled twice. No sum cancels, so that small ones keep all their digits.
#[inline(always)]
fn arc<S: Simd>(angle: F<S>, sign: f32) -> SmallArc<S> {
    let quarter = angle * 0.25;
    let square = quarter * quarter * sign;
    let mut sine = quarter * series(square, [6.0, 20.0, 42.0, 72.0]);
    let mut versine = square * 0.5 * series(square, [12.0, 30.0, 56.0, 90.0]);
    for _ in 0..2 {
        sine = sine * 2.0 * (versine + 1.0);
        versine = versine * 2.0 * (versine + 2.0);
    }
    SmallArc { sine, versine }
}

/// 1 + x/a (1 + x/b (1 + x/c (1 + x/d))). Without a closure, which would be a call between registers of other
/// widths.
#[inline(always)]
fn series<S: Simd>(x: F<S>, [a, b, c, d]: [f32; 4]) -> F<S> {
    let last = x * (1.0 / d) + 1.0;
    let third = x * (1.0 / c) * last + 1.0;
    let second = x * (1.0 / b) * third + 1.0;
    x * (1.0 / a) * second + 1.0
}

/// The part of lines of sight that all of a column share: by how much sinh u exceeds that of the pole, at
/// this much u from it.
///
/// With w half of that and P at the pole, sinh(P + 2 w) = sinh P + sinh w (e^P e^w + e^-P e^-w).
#[inline(always)]
pub fn column<S: Simd>(frame: &FrameUniform, u: F<S>) -> F<S> {
    let across = arc(u * 0.5, 1.0);
    let grown = across.versine + 1.0 + across.sine.abs();
    let shrunk = 1.0 / grown;
    let grows = u.simd_ge(0.0);
    let [at_pole, per_pole] = [frame.right[3], frame.down[3]];
    let powers = select(grows, grown, shrunk) * at_pole + select(grows, shrunk, grown) * per_pole;
    across.sine * powers
}

/// The part of lines of sight that all of a row share: how the unit vector across the baseline turns from the
/// pole to this much v from it.
#[inline(always)]
pub fn row<S: Simd>(simd: S, frame: &FrameUniform, v: F<S>) -> V3<S> {
    let up = arc(v * 0.5, -1.0);
    let sine = up.sine * 2.0 * (up.versine + 1.0);
    let versine = up.sine * up.sine * -2.0;
    V3::of_four(simd, frame.radial) * versine + V3::of_four(simd, frame.down) * sine
}

/// cosh u times the line of sight in this column and row.
#[inline(always)]
pub fn line<S: Simd>(simd: S, frame: &FrameUniform, column: F<S>, row: V3<S>) -> V3<S> {
    V3::of_four(simd, frame.base) + V3::of_four(simd, frame.clip_right) * column + row
}
