//! What a tile shows in numbers.

use super::body::Body;
use super::lanes::{LANES, Simd, SimdFloat};
use super::look::Look;
use super::tile::{Drawn, PACKETS, Test, packet_places, write_one};
use super::turning::{Spin, doppler_of, place_of_hit};
use crate::candidates::Rows;
use crate::tiles::Tile;

/// What a pixel shows in numbers, as the shaders write it.
pub type Numbers = ([f32; 4], [f32; 4]);

impl<S: Simd> Drawn<S, 1> {
    /// Writes what the pixels of `tile` show into `rows`.
    #[inline(always)]
    pub fn measure(&self, simd: S, look: &Look<'_>, tile: &Tile, rows: &mut Rows<'_, Numbers>) {
        for packet in 0..PACKETS {
            let corner = packet_places(tile.corner, packet);
            for place in 0..self.owners.len() {
            let Some((owner, at)) = self.owner_in(simd, &self.solid, packet, place) else { continue };
                let (group, seen) = (look.group(owner.group), look.seen(owner.number));
                let ray = &self.rays[owner.group].as_ref().expect("it was met")[packet];
                let body = Body::new(simd, &seen.shown.placement);
                let spin = Spin::new(simd, &seen.shown);
                let test = Test::new(simd, &group, &seen, &body, &spin, ray, false);
                let (kind, turns, surface) = (seen.body.kind, seen.turns, test.surface);
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
                let holds: [i32; LANES] = self.solid[packet][0].owner.simd_eq(at).into();
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
