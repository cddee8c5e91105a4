//! What a tile looks like.

use super::backdrop::{behind, part};
use super::body::Body;
use super::colour::{Tables, received_colour};
use super::encode::encoded;
use super::lanes::{F, LANES, Simd, SimdFloat, SimdMask, V3, all, select};
use super::look::Look;
use super::tile::{Drawn, Owner, PACKETS, Test, centres, packet_places, write_one};
use super::turning::{Spin, doppler_of, standing};
use crate::candidates::Rows;
use crate::tiles::Tile;
use crate::view::Appearance;

impl<S: Simd> Drawn<S, 4> {
    /// Writes the pixels of `tile` into `rows`, which are those it is in, `width` pixels each.
    #[inline(always)]
    pub fn shade(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        tile: &Tile,
        rows: &mut Rows<'_, [u8; 4]>,
    ) {
        let frame = look.frame();
        let part = part(frame, tile.corner.map(|v| v as f32), tile.size.map(|v| v as f32));
        for packet in 0..PACKETS {
            let corner = packet_places(tile.corner, packet);
            let [u, v] = centres(simd, corner);
            let (mut linear, cover) = self.bodies(simd, look, appearance, tables, packet);
            if cover.simd_lt(1.0).any_true() {
                linear += behind(simd, frame, part, u, v) * (1.0 - cover);
            }
            let pixels = encoded(simd, linear);
            for (lane, pixel) in pixels.into_iter().enumerate() {
                write_one(tile, corner, rows, lane, pixel);
            }
        }
    }

    /// Linear sRGB of the bodies in a packet, times the share of each pixel that they cover, and that share.
    #[inline(always)]
    fn bodies(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        packet: usize,
    ) -> (V3<S>, F<S>) {
        let zero = all(simd, 0.0);
        let mut samples = [(V3::all(simd, [0.0; 3]), zero); 4];
        for place in 0..self.owners.len() {
            let Some((owner, at)) = self.owner_in(simd, &self.solid, packet, place) else { continue };
            let (colour, _) = self.colour(simd, look, appearance, tables, owner, packet);
            for ((sample, cover), nearest) in samples.iter_mut().zip(&self.solid[packet]) {
                let holds = nearest.owner.simd_eq(at);
                *sample = V3::select(holds, colour, *sample);
                *cover = select(holds, all(simd, 1.0), *cover);
            }
        }
        for place in 0..self.owners.len() {
            let Some((owner, at)) = self.owner_in(simd, &self.thin, packet, place) else { continue };
            let (colour, alpha) = self.colour(simd, look, appearance, tables, owner, packet);
            let through = 1.0 - alpha;
            let nearest = self.thin[packet].iter().zip(&self.solid[packet]);
            for ((sample, cover), (thin, solid)) in samples.iter_mut().zip(nearest) {
                let holds = thin.owner.simd_eq(at) & thin.beyond.simd_lt(solid.beyond);
                *sample = V3::select(holds, colour * alpha + *sample * through, *sample);
                *cover = select(holds, alpha + *cover * through, *cover);
            }
        }
        let [first, second, third, fourth] = samples;
        let linear = (first.0 + second.0) + (third.0 + fourth.0);
        let cover = (first.1 + second.1) + (third.1 + fourth.1);
        (linear * 0.25, cover * 0.25)
    }

    /// Linear sRGB of a body where the rays through the middles of a packet's pixels meet it, and the share of a pixel
    /// that it covers as it is too thin.
    #[inline(always)]
    fn colour(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        owner: Owner,
        packet: usize,
    ) -> (V3<S>, F<S>) {
        simd.vectorize(
            #[inline(always)]
            || {
                let (group, seen) = (look.group(owner.group), look.seen(owner.number));
                let ray = &self.rays[owner.group].as_ref().expect("it was met")[packet];
                let body = Body::new(simd, &seen.shown.placement);
                let spin = Spin::new(simd, &seen.shown);
                let test = Test::new(simd, &group, &seen, &body, &spin, ray, true);
                let (kind, turns, surface) = (seen.body.kind, seen.turns, test.surface);
                let doppler = doppler_of(kind, turns, &group, &body, surface.place, surface.normal, ray.sight, ray.doppler, &spin);
                let effects = look.effects(owner.group, turns, appearance);
                let light = look.light(seen.body, turns, appearance);
                let colour = received_colour(simd, effects, tables, light, doppler, surface.normal);
                let colour = colour * (seen.body.brightness as f32);
                if true || seen.body.marking.is_none() {
                    return (colour, test.alpha);
                }
                let there = standing(simd, kind, turns, &group, &body, surface.place, &spin);
                let distance = test.distance * ray.ground_per_rest;
                let pattern = seen.body.pattern();
                let mark = all(simd, 1.0);
                (colour * mark, test.alpha)
            },
        )
    }
}
