//! The colours of a tile.

use super::met::Met;
use super::{Owner, Packet, TileContents};
use crate::cpu::packets::body::Surface;
use crate::cpu::packets::light::colour::Hatched;
use crate::cpu::packets::light::encode::encoded;
use crate::cpu::packets::light::received::Element;
use crate::cpu::packets::light::tables::Tables;
use crate::cpu::packets::look::Look;
use crate::cpu::packets::places::{PACKETS, packet_places, write_one};
use crate::cpu::packets::ray::TileSights;
use crate::cpu::packets::shape::pattern::mark;
use crate::cpu::packets::street::backdrop::{behind, part};
use crate::cpu::packets::wheel::turning::{Standing, TurningBody};
use crate::picture::candidates::PixelRows;
use crate::picture::tiles::Tile;
use crate::simd::lanes::{F, LANES, Simd, SimdFloat, SimdMask, V3, all, select, vectorized};
use crate::street::backdrop::BackdropPart;
use crate::view::Appearance;

/// The pixels of a tile behind which no body is.
#[inline(always)]
pub fn shade_backdrop<S: Simd>(simd: S, look: &Look<'_>, tile: &Tile, rows: &mut PixelRows<'_, [u8; 4]>) {
    let part = part_of(simd, look, tile);
    let sights = TileSights::new(simd, look.frame(), tile.corner);
    for place in 0..PACKETS {
        let corner = packet_places(tile.corner, place);
        write(tile, corner, rows, encoded(simd, behind(simd, look.frame(), part, sights.of_packet(place))));
    }
}

#[inline(always)]
fn part_of<S: Simd>(simd: S, look: &Look<'_>, tile: &Tile) -> BackdropPart {
    part(simd, look.frame(), tile.corner.map(|v| v as f32), tile.size.map(|v| v as f32))
}

#[inline(always)]
fn write(tile: &Tile, corner: [u32; 2], rows: &mut PixelRows<'_, [u8; 4]>, pixels: [[u8; 4]; LANES]) {
    for (lane, pixel) in pixels.into_iter().enumerate() {
        write_one(tile, corner, rows, lane, pixel);
    }
}

impl<S: Simd> TileContents<S, 4> {
    /// Writes the pixels of `tile` into `rows`.
    #[inline(always)]
    pub fn shade(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        tile: &Tile,
        rows: &mut PixelRows<'_, [u8; 4]>,
    ) {
        let part = part_of(simd, look, tile);
        let sights = TileSights::new(simd, look.frame(), tile.corner);
        for place in 0..PACKETS {
            let corner = packet_places(tile.corner, place);
            let (mut linear, cover) = self.bodies(simd, look, appearance, tables, place, corner);
            if cover.simd_lt(1.0).any_true() {
                linear += behind(simd, look.frame(), part, sights.of_packet(place)) * (1.0 - cover);
            }
            write(tile, corner, rows, encoded(simd, linear));
        }
    }

    /// Linear sRGB of the bodies in the packet at this place, times the share of each pixel that they cover,
    /// and that share.
    #[inline(always)]
    fn bodies(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        place: usize,
        corner: [u32; 2],
    ) -> (V3<S>, F<S>) {
        let hatched = Hatched { hatch: &look.hatch, corner };
        let zero = all(simd, 0.0);
        let mut samples = [(V3::all(simd, [0.0; 3]), zero); 4];
        let mut nearest_solid = [all(simd, f32::INFINITY); 4];
        for packet in &self.packets {
            if packet.place != place {
                continue;
            }
            for owner in packet.owners[0]..packet.owners[1] {
                let Some(at) = Packet::owned(simd, &packet.solid, owner) else { continue };
                let colours = self.colours(simd, look, appearance, tables, owner, packet, hatched);
                for (sample, colour) in colours.into_iter().enumerate() {
                    let nearest = packet.solid[sample];
                    let holds = nearest.owner.simd_eq(at);
                    samples[sample].0 = V3::select(holds, colour, samples[sample].0);
                    samples[sample].1 = select(holds, all(simd, 1.0), samples[sample].1);
                    nearest_solid[sample] = select(holds, nearest.beyond, nearest_solid[sample]);
                }
            }
        }
        for packet in &self.packets {
            if packet.place != place {
                continue;
            }
            for owner in packet.owners[0]..packet.owners[1] {
                let Some(at) = Packet::owned(simd, &packet.thin, owner) else { continue };
                let (colour, alpha) =
                    Self::colour(simd, look, appearance, tables, self.owners[owner], packet, hatched);
                let through = 1.0 - alpha;
                for sample in 0..4 {
                    let thin = packet.thin[sample];
                    let holds = thin.owner.simd_eq(at) & thin.beyond.simd_lt(nearest_solid[sample]);
                    let (behind, cover) = samples[sample];
                    samples[sample].0 = V3::select(holds, colour * alpha + behind * through, behind);
                    samples[sample].1 = select(holds, alpha + cover * through, cover);
                }
            }
        }
        let [first, second, third, fourth] = samples;
        let linear = (first.0 + second.0) + (third.0 + fourth.0);
        let cover = (first.1 + second.1) + (third.1 + fourth.1);
        (linear * 0.25, cover * 0.25)
    }

    /// Linear sRGB of the body at the place `owner` in the list, in each sample of a packet: of a model as it
    /// is there, of others as in the middle of the pixel.
    #[expect(clippy::too_many_arguments, reason = "a body, where it is seen, and how pictures look")]
    #[inline(always)]
    fn colours(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        owner: usize,
        packet: &Packet<S, 4>,
        hatched: Hatched<'_>,
    ) -> [V3<S>; 4] {
        let body = self.owners[owner];
        if let Some(samples) = self.model(packet.place, owner) {
            return samples.map(|meetings| {
                vectorized!(simd, meetings.colour(simd, look, appearance, tables, body.number, hatched))
            });
        }
        [Self::colour(simd, look, appearance, tables, body, packet, hatched).0; 4]
    }

    /// Linear sRGB of a body where the rays through the middles of a packet's pixels meet it, and the share
    /// of a pixel that it covers as it is too thin.
    #[inline(always)]
    fn colour(
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        owner: Owner,
        packet: &Packet<S, 4>,
        hatched: Hatched<'_>,
    ) -> (V3<S>, F<S>) {
        vectorized!(simd, {
            let Met { seen, turning, ray, surface, test, doppler, distance } =
                Met::new(simd, look, owner, packet);
            let Surface { place, normal, .. } = surface;
            let there = Element { seen: &seen, turning: &turning, place, normal, doppler };
            let colour = there.colour(simd, look, appearance, tables, None, hatched);
            if seen.body.marking.is_none() {
                return (colour, test.alpha);
            }
            let (TurningBody { kind, group, .. }, pattern) = (&turning, seen.body.pattern());
            let Standing { body, place } = turning.standing(simd, place);
            let mark = mark(simd, *kind, group, &body, pattern, place, normal, ray, distance);
            (colour * mark, test.alpha)
        })
    }
}
