//! The meeting of a packet's rays with a body that is seen there.

use super::body::{PacketBody, PacketGroup, RestRays, Surface};
use super::look::{Look, Seen};
use super::spin::PacketSpin;
use super::tile::{Owner, Packet, RayTest};
use super::turning::{doppler_of, surface_when_shown};
use crate::lanes::{F, Simd};

/// The meeting of eight pixels with a body.
pub struct Met<'a, S: Simd> {
    pub group: PacketGroup<'a>,
    pub seen: Seen<'a>,
    pub body: PacketBody<S>,
    pub spin: PacketSpin<S>,
    pub ray: &'a RestRays<S>,
    pub surface: Surface<S>,
    pub test: RayTest<S>,
    /// Doppler factor of the light from there.
    pub doppler: F<S>,
    /// From the camera, ground frame.
    pub distance: F<S>,
}

impl<'a, S: Simd> Met<'a, S> {
    /// Returns the meeting with `owner`, in a packet with `N` samples to a pixel: in a picture there is more than one.
    #[inline(always)]
    pub fn new<const N: usize>(simd: S, look: &'a Look<'a>, owner: Owner, packet: &'a Packet<S, N>) -> Self {
        let (group, seen, ray) = (look.group(owner.group), look.seen(owner.number), &packet.ray);
        let (kind, turns) = (seen.body.kind, seen.turns);
        let body = PacketBody::new(simd, &seen.shown.placement);
        let spin = PacketSpin::new(simd, &seen.shown);
        let surface = surface_when_shown(simd, kind, turns, &group, &body, ray, &spin);
        let test = RayTest::new(simd, &group, kind, &body, ray, surface, N > 1);
        let Surface { place, normal, .. } = surface;
        let doppler = doppler_of(kind, turns, &group, &body, place, normal, ray.sight, ray.doppler, &spin);
        let distance = test.distance * ray.ground_per_rest;
        Self { group, seen, body, spin, ray, surface, test, doppler, distance }
    }
}
