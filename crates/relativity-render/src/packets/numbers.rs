//! The numbers of a tile.

use super::look::Look;
use super::met::Met;
use super::places::{packet_places, write_one};
use super::tile::{Packet, TileContents};
use super::turning::place_of_hit;
use crate::candidates::Rows;
use crate::lanes::{LANES, Simd, SimdFloat};
use crate::tiles::Tile;

/// The numbers of a pixel, as the shaders write them.
pub type Numbers = ([f32; 4], [f32; 4]);

impl<S: Simd> TileContents<S, 1> {
    /// Writes what the pixels of `tile` show into `rows`.
    #[inline(always)]
    pub fn measure(&self, simd: S, look: &Look<'_>, tile: &Tile, rows: &mut Rows<'_, Numbers>) {
        for packet in &self.packets {
            let corner = packet_places(tile.corner, packet.place);
            for owner in packet.owners[0]..packet.owners[1] {
                let Some(at) = Packet::owned(simd, &packet.solid, owner) else { continue };
                let owner = self.owners[owner];
                let Met { seen, body, spin, surface, doppler, distance, .. } =
                    Met::new(simd, look, owner, packet);
                let place = place_of_hit(seen.body.kind, seen.turns, &body, surface.place, &spin);
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
