//! Rays against bodies of each kind, and the patterns on these.

pub(super) mod block;
mod cylinder;
pub(super) mod pattern;
pub(super) mod ring;
mod tube;

use super::body::{Limits, PacketBody, PacketCapsule, PacketGroup, RestRays, Surface};
use crate::geometry::kind::Kind;
use crate::simd::lanes::{F, Simd, V3, vectorized};
use pattern::coverage::PixelShifts;
use pattern::die;

/// Returns the surface of a body where rays meet it. If `limits` exclude it, it is any excluded surface.
///
/// Each kind's test is there once, and called.
#[inline(always)]
pub fn surface<S: Simd>(
    simd: S,
    kind: Kind,
    group: &PacketGroup,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    limits: Option<&Limits<S>>,
) -> Surface<S> {
    match kind {
        Kind::Tube => vectorized!(simd, tube::surface(body, ray, limits)),
        Kind::Ring => vectorized!(simd, ring::surface(simd, body, ray)),
        Kind::Box | Kind::Model => vectorized!(simd, block::surface(simd, group, body, ray, limits)),
        Kind::Cylinder => vectorized!(simd, cylinder::surface(simd, group, body, ray, limits)),
    }
}

/// A body's middle, from that of its group.
#[inline(always)]
pub fn middle<S: Simd>(kind: Kind, body: &PacketBody<S>) -> V3<S> {
    match kind {
        Kind::Tube => tube::middle(body),
        Kind::Ring => ring::middle(body),
        Kind::Box | Kind::Cylinder | Kind::Model => block::middle(body),
    }
}

/// Returns a capsule that contains a body.
#[inline(always)]
pub fn around<S: Simd>(kind: Kind, body: &PacketBody<S>) -> PacketCapsule<S> {
    match kind {
        Kind::Tube => tube::around(body),
        Kind::Ring => ring::around(body),
        Kind::Box | Kind::Cylinder | Kind::Model => block::around(body),
    }
}

/// Returns the normal by which the pattern at `place` is looked up, in the body's own axes: of flat faces
/// that of the face.
#[inline(always)]
pub fn own_normal<S: Simd>(kind: Kind, body: &PacketBody<S>, place: V3<S>, normal: V3<S>) -> V3<S> {
    match kind {
        Kind::Tube | Kind::Ring => normal,
        Kind::Cylinder => cylinder::pattern_normal(body, place),
        Kind::Box | Kind::Model => die::normal_of_box(body, place),
    }
}

/// Returns the share of what is `covered` that `pattern` leaves dark at `place`, in the body's own axes.
#[inline(always)]
pub fn darkness<S: Simd>(
    kind: Kind,
    body: &PacketBody<S>,
    pattern: [f32; 3],
    place: V3<S>,
    normal: V3<S>,
    covered: &PixelShifts<S>,
) -> F<S> {
    match kind {
        Kind::Tube => tube::chart(body, pattern, place, normal).darkness(pattern, covered),
        Kind::Ring => ring::chart(body, place).darkness(pattern, covered),
        Kind::Cylinder => cylinder::chart(body, pattern, place, normal).darkness(pattern, covered),
        Kind::Box | Kind::Model => die::darkness_of_box(body, pattern, place, normal, covered),
    }
}
