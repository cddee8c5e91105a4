//! Edges where two faces of a body meet: `share_of_other` of `shaders/body.wgsl`.

use super::body::{PacketGroup, RestRays};
use super::ray::movement;
use crate::simd::lanes::{F, Simd, SimdFloat, V3, all, clamp};

/// Returns the share of the other face in pixels whose rays meet one of two faces: these pass the common edge
/// at the distance `from_edge`, `across` is the unit vector across the edge and the ray, and `width` that of
/// the other face as it is seen.
#[inline(always)]
pub fn share_of_other<S: Simd>(
    group: &PacketGroup,
    from_edge: F<S>,
    width: F<S>,
    across: V3<S>,
    ray: &RestRays<S>,
    beyond: F<S>,
) -> F<S> {
    let simd = beyond.simd;
    let pixel = ((ray.to_centre + beyond) * movement(group, ray, across).length()).max(1e-30);
    let own = 0.5 + (from_edge / pixel).min(0.5);
    let other = clamp(0.5 - from_edge / pixel, all(simd, 0.0), (width / pixel).max(0.0));
    other / (own + other)
}
