//! Patterns on bodies, as `shaders/pattern.wgsl` has them.

pub(super) mod chart;
pub(super) mod coverage;
pub(super) mod die;
#[cfg(test)]
mod tests;

use crate::cpu::packets::body::{PacketBody, PacketGroup, RestRays};
use crate::cpu::packets::shape;
use crate::geometry::kind::Kind;
use crate::scene::pattern::DARK;
use crate::simd::lanes::{F, Simd, V3, all, clamp, vectorized};
use crate::view::Geometry;
use coverage::PixelShifts;

/// The mark of `pattern` (its ruling, and its steps along and around) on `body` at `place` (from its middle),
/// at this ground distance along the rays: what share of its light is left.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "those of the shader, and what is global there")]
pub fn mark<S: Simd>(
    simd: S,
    kind: Kind,
    group: &PacketGroup,
    body: &PacketBody<S>,
    pattern: [f32; 3],
    place: V3<S>,
    normal: V3<S>,
    ray: &RestRays<S>,
    distance: F<S>,
) -> F<S> {
    if pattern[0] == 0.0 {
        return all(simd, 1.0);
    }
    vectorized!(simd, {
        let place = body.body_from_rest(place);
        let normal = shape::own_normal(kind, body, place, body.body_from_rest(normal));
        let covered = covered_by_pixel(group, body, ray, normal, distance);
        let dark = shape::darkness(kind, body, pattern, place, normal, &covered);
        1.0 - clamp(dark, all(simd, 0.0), all(simd, 1.0)) * (1.0 - DARK) as f32
    })
}

/// In the body's own axes.
#[inline(always)]
fn covered_by_pixel<S: Simd>(
    group: &PacketGroup,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    normal: V3<S>,
    distance: F<S>,
) -> PixelShifts<S> {
    let direction = body.body_from_rest(ray.direction);
    let [right, down] = shifts(group, ray);
    PixelShifts::new(direction, normal, body.body_from_rest(right), body.body_from_rest(down), distance)
}

/// Returns the shifts in the rest frame of the place seen, to the next pixel on the right and to the one
/// below, per ground distance, without their parts along the ray.
#[inline(always)]
pub fn shifts<S: Simd>(group: &PacketGroup, ray: &RestRays<S>) -> [V3<S>; 2] {
    let [right, down] = ray.steps;
    [shift(group, ray, right), shift(group, ray, down)]
}

/// Returns the shift in the rest frame of the place seen, from pixel to pixel along `across`, per ground
/// distance, without its part along the ray. As `GroupView::shift` has it, but for one light cone of both
/// eyes.
#[inline(always)]
fn shift<S: Simd>(group: &PacketGroup, ray: &RestRays<S>, across: V3<S>) -> V3<S> {
    let turn = (across - ray.sight * ray.sight.dot(across)) * ray.scale;
    let frame = group.frame;
    let [beta, _, _, gamma] = frame.speed;
    let is_oblique = frame.is_oblique();
    let direction = if is_oblique { ray.direction.in_columns(frame.group_axes) } else { ray.direction };
    let shift = match group.geometry {
        Geometry::Seen | Geometry::Published | Geometry::OneCone => {
            let along = turn.x * (frame.motion[0] * beta * gamma);
            V3::new(ray.doppler * turn.x, turn.y - along * direction.y, turn.z - along * direction.z)
        }
        Geometry::Contracted => V3::new(turn.x * gamma, turn.y, turn.z),
        Geometry::Rest => turn,
    };
    if is_oblique { shift.sum_of(frame.group_axes) } else { shift }
}
