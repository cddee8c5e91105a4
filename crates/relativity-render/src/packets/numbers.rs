//! What a tile shows in numbers.

use super::body::Body;
use super::lanes::{LANES, Simd, SimdFloat};
use super::look::Look;
use super::places::{packet_places, write_one};
use super::tile::{Drawn, Packet, Test};
use super::turning::{Spin, doppler_of, place_of_hit, surface_when_shown};
use crate::candidates::Rows;
use crate::tiles::Tile;

/// What a pixel shows in numbers, as the shaders write it.
pub type Numbers = ([f32; 4], [f32; 4]);

impl<S: Simd> Drawn<S, 1> {
    /// Writes what the pixels of `tile` show into `rows`.
    #[inline(always)]
    pub fn measure(&self, simd: S, look: &Look<'_>, tile: &Tile, rows: &mut Rows<'_, Numbers>) {
        for packet in &self.packets {
            let corner = packet_places(tile.corner, packet.place);
            for owner in packet.owners[0]..packet.owners[1] {
                let Some(at) = Packet::owned(simd, &packet.solid, owner) else { continue };
                let owner = self.owners[owner];
                let (group, seen) = (look.group(owner.group), look.seen(owner.number));
                let (kind, turns, ray) = (seen.body.kind, seen.turns, &packet.ray);
                let body = Body::new(simd, &seen.shown.placement);
                let spin = Spin::new(simd, &seen.shown);
                let surface = surface_when_shown(simd, kind, turns, &group, &body, ray, &spin);
                let test = Test::new(simd, &group, &seen, &body, ray, surface, false);
                let doppler = doppler_of(
                    kind,
                    turns,
                    &group,
                    &body,
                    surface.place,
                    surface.normal,
                    ray.sight,
                    ray.doppler,
                    &spin,
                );
                let distance = test.distance * ray.ground_per_rest;
                let place = place_of_hit(kind, turns, &body, surface.place, &spin);
                let holds: [i32; LANES] = packet.solid[0].owner.simd_eq(at).into();
                let number = owner.number as f32;
                for lane in (0..LANES).filter(|&lane| holds[lane] != 0) {
                    let [x, y, z] = place.lane(lane);
                    let numbers = ([number, distance[lane], doppler[lane], 1.0], [x, y, z, 0.0]);
                    write_one(tile, corner, rows, lane, numbers);
                }
            }
        }
    }
}
