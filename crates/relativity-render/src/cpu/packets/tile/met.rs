//! The meeting of a packet's rays with a body that is seen there.

use super::{Owner, Packet, RayTest};
use crate::cpu::packets::body::{RestRays, Surface};
use crate::cpu::packets::look::{Look, Seen};
use crate::cpu::packets::wheel::turning::TurningBody;
use crate::simd::lanes::{F, Simd};

/// The meeting of eight pixels with a body.
pub struct Met<'a, S: Simd> {
    pub seen: Seen<'a>,
    pub turning: TurningBody<'a, S>,
    pub ray: &'a RestRays<S>,
    pub surface: Surface<S>,
    pub test: RayTest<S>,
    /// Doppler factor of the light from there.
    pub doppler: F<S>,
    /// From the camera, ground frame.
    pub distance: F<S>,
}

impl<'a, S: Simd> Met<'a, S> {
    /// Returns the meeting with `owner`, in a packet with `N` samples to a pixel: in a picture there is more
    /// than one.
    #[inline(always)]
    pub fn new<const N: usize>(simd: S, look: &'a Look<'a>, owner: Owner, packet: &'a Packet<S, N>) -> Self {
        let (seen, ray) = (look.seen(owner.number), &packet.ray);
        let turning = TurningBody::new(simd, look.group(owner.group), &seen);
        let surface = turning.surface_when_shown(simd, ray, None);
        let test = RayTest::new(simd, &turning.group, turning.kind, &turning.body, ray, surface, N > 1);
        let doppler = turning.doppler(surface.place, surface.normal, ray);
        let distance = test.distance * ray.ground_per_rest;
        Self { seen, turning, ray, surface, test, doppler, distance }
    }
}
