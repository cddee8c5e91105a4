//! The numbers of a tile.

use super::met::Met;
use super::{Packet, TileContents};
use crate::cpu::packets::look::Look;
use crate::cpu::packets::model::Meetings;
use crate::cpu::packets::places::{packet_places, write_one};
use crate::cpu::packets::wheel::turning::TurningBody;
use crate::picture::candidates::PixelRows;
use crate::picture::tiles::Tile;
use crate::simd::lanes::{F, LANES, Simd, SimdFloat, V3, all};

/// The numbers of a pixel, as the shaders write them.
pub type Numbers = ([f32; 4], [f32; 4]);

/// Numbers of eight pixels that show one body.
struct Shown<S: Simd> {
    place: V3<S>,
    doppler: F<S>,
    distance: F<S>,
    /// Number of the triangle of a model; else 0.
    triangle: F<S>,
}

impl<S: Simd> Shown<S> {
    #[inline(always)]
    fn new(simd: S, met: &Met<'_, S>) -> Self {
        let Met { turning, surface, doppler, distance, .. } = met;
        let place = turning.place_of_hit(surface.place);
        Self { place, doppler: *doppler, distance: *distance, triangle: all(simd, 0.0) }
    }

    #[inline(always)]
    fn of_model(turning: &TurningBody<'_, S>, meetings: &Meetings<S>) -> Self {
        let Meetings { place, doppler, distance, triangle, .. } = *meetings;
        let place = turning.place_of_hit(place);
        Self { place, doppler, distance, triangle }
    }
}

impl<S: Simd> TileContents<S, 1> {
    /// Writes what the pixels of `tile` show into `rows`.
    #[inline(always)]
    pub fn measure(&self, simd: S, look: &Look<'_>, tile: &Tile, rows: &mut PixelRows<'_, Numbers>) {
        for packet in &self.packets {
            let corner = packet_places(tile.corner, packet.place);
            for owner in packet.owners[0]..packet.owners[1] {
                let Some(at) = Packet::owned(simd, &packet.solid, owner) else { continue };
                let model = self.model(packet.place, owner);
                let owner = self.owners[owner];
                let shown = match model {
                    None => Shown::new(simd, &Met::new(simd, look, owner, packet)),
                    Some([meetings]) => {
                        let turning =
                            TurningBody::new(simd, look.group(owner.group), &look.seen(owner.number));
                        Shown::of_model(&turning, meetings)
                    }
                };
                let Shown { place, doppler, distance, triangle } = shown;
                let holds: [i32; LANES] = packet.solid[0].owner.simd_eq(at).into();
                let number = owner.number as f32;
                for lane in (0..LANES).filter(|&lane| holds[lane] != 0) {
                    let [x, y, z] = place.lane(lane);
                    let numbers = ([number, distance[lane], doppler[lane], 1.0], [x, y, z, triangle[lane]]);
                    write_one(tile, corner, rows, lane, numbers);
                }
            }
        }
    }
}
