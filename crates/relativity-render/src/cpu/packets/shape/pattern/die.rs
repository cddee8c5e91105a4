//! Patterns on boxes, as `shaders/pattern_box.wgsl` has them. All in the body's own axes.

use super::coverage::{PixelShifts, pip, rim, wave};
use crate::cpu::packets::body::PacketBody;
use crate::scene::pattern::die::{PIP_PLACE, PIP_RADIUS, RIM};
use crate::scene::pattern::{NUDGE, Ruling};
use crate::simd::lanes::{F, Simd, SimdFloat as _, V3, all, select, sign_of};

/// The normal of the face, not what lies between two where a pixel shows both.
#[inline(always)]
pub fn normal_of_box<S: Simd>(body: &PacketBody<S>, place: V3<S>) -> V3<S> {
    let zero = all(place.x.simd, 0.0);
    let below = body.halves() - place.abs();
    let along_x = V3::new(sign_of(place.x), zero, zero);
    let along_y = V3::new(zero, sign_of(place.y), zero);
    let along_z = V3::new(zero, zero, sign_of(place.z));
    let other = V3::select(below.y.simd_lt(below.z), along_y, along_z);
    V3::select(below.x.simd_lt(below.y.min(below.z)), along_x, other)
}

/// Returns the darkness of `pattern` on a box at this place.
#[inline(always)]
pub fn darkness_of_box<S: Simd>(
    body: &PacketBody<S>,
    pattern: [f32; 3],
    place: V3<S>,
    normal: V3<S>,
    covered: &PixelShifts<S>,
) -> F<S> {
    let half = body.halves();
    let simd = half.x.simd;
    let [ruling, step, _] = pattern;
    if ruling == f32::from(Ruling::Faces as u8) {
        return face(half, place, normal, covered);
    }
    let levels = (place - normal * (NUDGE as f32 * step) + half) / all(simd, step);
    let along_x = wave(levels.x, covered.range(V3::all(simd, [1.0, 0.0, 0.0])) / step);
    if ruling != f32::from(Ruling::Chequer as u8) {
        return 0.5 - along_x * 0.5;
    }
    let along_y = wave(levels.y, covered.range(V3::all(simd, [0.0, 1.0, 0.0])) / step);
    let along_z = wave(levels.z, covered.range(V3::all(simd, [0.0, 0.0, 1.0])) / step);
    0.5 - along_x * along_y * along_z * 0.5
}

/// Returns the darkness of a die's face.
#[inline(always)]
fn face<S: Simd>(half: V3<S>, place: V3<S>, normal: V3<S>, covered: &PixelShifts<S>) -> F<S> {
    let simd = half.x.simd;
    let zero = all(simd, 0.0);
    let side = normal.abs();
    // The axes of the face: those that follow its normal's.
    let (a, b) = (side.zxy(), side.yzx());
    let first = side.dot(V3::all(simd, [1.0, 2.0, 3.0]));
    let number = select(side.dot(normal).simd_gt(0.0), first, 7.0 - first);
    let (half_a, half_b) = (half.dot(a), half.dot(b));
    let (at_a, at_b) = (place.dot(a), place.dot(b));
    let smaller = half_a.min(half_b);
    let corner_a = at_a - half_a * PIP_PLACE as f32 * sign_of(at_a);
    let corner_b = at_b - half_b * PIP_PLACE as f32 * sign_of(at_b);
    let (radius, edge) = (smaller * PIP_RADIUS as f32, smaller * RIM as f32);
    let rim_a = rim(half_a - at_a.abs(), edge, covered.range(a));
    let rim_b = rim(half_b - at_b.abs(), edge, covered.range(b));
    let on_first_diagonal = (at_a * at_b).simd_gt(0.0);
    let has_corner = number.simd_gt(select(on_first_diagonal, all(simd, 1.5), all(simd, 3.5)));
    let corners = pip(a * corner_a + b * corner_b, radius, covered);
    let has_middle = number.simd_eq(1.0) | number.simd_eq(3.0) | number.simd_eq(5.0);
    let middle = pip(a * at_a + b * at_b, radius, covered);
    let has_sides = number.simd_gt(5.5);
    let sides = pip(a * corner_a + b * at_b, radius, covered);
    rim_a
        .max(rim_b)
        .max(select(has_corner, corners, zero))
        .max(select(has_middle, middle, zero))
        .max(select(has_sides, sides, zero))
}
