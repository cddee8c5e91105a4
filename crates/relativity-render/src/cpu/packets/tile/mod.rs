//! A tile of 8 x 8 pixels: what is the nearest in each sample of each of them.

mod contents;
mod met;
mod numbers;
mod passing;
mod ray_test;
pub(super) mod shading;

use super::body::{Limits, PacketBody, PacketGroup};
use super::look::{Look, Seen};
use super::model::{Meetings, ModelPart};
use super::places::PACKETS;
use super::ray::{TileSights, rest_ray};
use super::wheel::turning::TurningBody;
use crate::geometry::kind::Kind;
use crate::geometry::triangles::Triangles;
use crate::picture::candidates::TileLook;
use crate::scene::wheel::packed::Turns;
use crate::simd::lanes::{F, Simd, SimdFloat, SimdMask, all, vectorized};
use crate::view::cap::Cap;
use passing::{Middles, may_show as may_show_in};

pub use contents::{Owner, Packet, TileContents};
pub use ray_test::RayTest;

/// The four samples of a pixel, from its centre, in the standard places.
pub const STANDARD: [[f32; 2]; 4] = [[-0.125, -0.375], [0.375, -0.125], [-0.375, 0.125], [0.125, 0.375]];
/// The sample at the centre alone.
pub const CENTRE: [[f32; 2]; 1] = [[0.0, 0.0]];

/// The bodies of one group that are seen in a tile.
struct OfGroup<'a, S: Simd, const N: usize> {
    simd: S,
    look: &'a Look<'a>,
    group: PacketGroup<'a>,
    number: usize,
    samples: &'a [[f32; 2]; N],
    sights: TileSights<'a, S>,
    drawn: &'a mut TileContents<S, N>,
    /// Places of this group's packets among all, for those that were tested.
    places: [Option<usize>; PACKETS],
    middles: Middles<S>,
    /// Distance beyond the middle of the group behind which each packet is covered, and that from the eye.
    farthest: [f32; PACKETS],
    covered: [f32; PACKETS],
    /// Bodies in several pieces that were tested.
    tested: Vec<u32>,
}

impl Look<'_> {
    /// Draws the bodies of `tile`, whose lines of sight are in `cap`.
    #[inline(always)]
    pub fn draw<S: Simd, const N: usize>(
        &self,
        simd: S,
        samples: &[[f32; 2]; N],
        tile: &TileLook<'_>,
        cap: &Cap,
    ) -> TileContents<S, N> {
        let mut drawn =
            TileContents { packets: Vec::with_capacity(PACKETS), owners: Vec::new(), models: Vec::new() };
        let mut others = tile.others;
        for number in tile.groups.iter().map(|&number| number as usize) {
            let view = &self.views[number];
            let prepared = &self.scene.groups()[number];
            let count = others.partition_point(|&body| (body as usize) < prepared.bodies.end);
            let (turning, later) = others.split_at(count);
            others = later;
            let beam = self.scene.beam(number, view, cap);
            let group = self.group(number);
            let mut own = OfGroup {
                simd,
                look: self,
                group,
                number,
                samples,
                sights: TileSights::new(simd, group.frame, tile.tile.corner),
                drawn: &mut drawn,
                places: [None; PACKETS],
                middles: Middles::new(simd, &group, tile.tile.corner),
                farthest: [f32::INFINITY; PACKETS],
                covered: [f32::INFINITY; PACKETS],
                tested: Vec::new(),
            };
            let first_owner = own.drawn.owners.len();
            for &body in turning {
                own.enter(body as usize, false);
            }
            if let Some(beam) = beam {
                self.scene.hierarchy(number, view).along_on(simd, &beam, |candidate| {
                    if !candidate.is_one_of_some || own.is_new(candidate.body) {
                        own.enter(candidate.body as usize, true);
                    }
                    own.reach()
                });
            } else {
                let standing = prepared.bodies.clone().filter(|&body| self.scene.turning(body).is_none());
                standing.for_each(|body| own.enter(body, true));
            }
            let places = own.places;
            let owners = [first_owner, drawn.owners.len()];
            for place in places.into_iter().flatten() {
                drawn.packets[place].owners = owners;
            }
        }
        if drawn.is_of_several_groups() {
            drawn.compare_depths(simd, self);
        }
        drawn
    }
}

impl<S: Simd, const N: usize> OfGroup<'_, S, N> {
    /// Returns the distance beyond which nothing is seen anywhere in the tile.
    fn reach(&self) -> f32 {
        self.farthest.into_iter().fold(f32::NEG_INFINITY, f32::max)
    }

    fn is_new(&mut self, body: u32) -> bool {
        let is_new = !self.tested.contains(&body);
        if is_new {
            self.tested.push(body);
        }
        is_new
    }

    /// Tests a body, if it `is_told_about` only in those packets that may show it.
    #[inline(never)]
    fn enter(&mut self, number: usize, is_told_about: bool) {
        vectorized!(self.simd, self.test(&self.look.seen(number), is_told_about));
    }

    #[inline(always)]
    fn test(&mut self, seen: &Seen<'_>, is_told_about: bool) {
        let simd = self.simd;
        let turning = TurningBody::new(simd, self.group, seen);
        let packets: [i32; PACKETS] = if is_told_about {
            self.middles.may_show(seen.body.kind, &turning.body, self.covered).into()
        } else {
            [-1; PACKETS]
        };
        let owner = self.drawn.owners.len();
        let mut is_seen = false;
        for (place, may_show) in packets.into_iter().enumerate() {
            if may_show == 0 {
                continue;
            }
            let number = self.packet(place);
            let pixel = self.middles.pixel_of(place);
            // The search along a ring costs far more than to ask this.
            if is_told_about && seen.body.kind == Kind::Ring {
                let packet = &self.drawn.packets[number];
                let covered = packet.ray.to_centre + packet.farthest(simd);
                if !may_show_in(seen.body.kind, &turning.body, &packet.ray, pixel, covered).any_true() {
                    continue;
                }
            }
            is_seen |= match self.look.scene.triangles(seen.number) {
                Some(triangles) => self.test_model_in(number, triangles, seen, &turning.body, owner),
                None => self.test_in(number, pixel, seen.number, &turning, owner),
            };
        }
        if is_seen {
            self.drawn.owners.push(Owner { number: seen.number, group: self.number });
        }
    }

    /// The number of the packet at this place.
    #[inline(always)]
    fn packet(&mut self, place: usize) -> usize {
        if let Some(number) = self.places[place] {
            return number;
        }
        let number = self.drawn.packets.len();
        self.drawn.packets.push(Packet::new(self.simd, &self.group, &self.sights, place));
        self.places[place] = Some(number);
        number
    }

    /// Tests a body in the packet of this number, in which a `pixel` has this width per distance; returns
    /// whether it is seen there.
    #[inline(always)]
    fn test_in(
        &mut self,
        number: usize,
        pixel: F<S>,
        body_number: usize,
        turning: &TurningBody<'_, S>,
        owner: usize,
    ) -> bool {
        let simd = self.simd;
        let ray = &self.drawn.packets[number].ray;
        let limits = Limits { pixel, farthest: self.drawn.packets[number].farthest(simd) };
        let surface = turning.surface_when_shown(simd, ray, Some(&limits));
        if limits.exclude(ray, surface.clearance, surface.beyond) {
            return false;
        }
        let test = RayTest::new(simd, &turning.group, turning.kind, &turning.body, ray, surface, N > 1);
        let is_whole = test.alpha.simd_ge(1.0);
        let is_thin = !is_whole;
        let (any_whole, any_thin) = (is_whole.any_true(), is_thin.any_true());
        let beyond = surface.beyond;
        let at = all(simd, owner as f32);
        let owners = &self.drawn.owners;
        let packet = &mut self.drawn.packets[number];
        let (mut is_in_solid, mut is_in_thin) = (false, false);
        for sample in 0..N {
            let is_inside = test.holds(self.samples[sample]);
            if any_whole {
                let whole = &mut packet.solid[sample];
                is_in_solid |= whole.take(is_inside & is_whole, beyond, at, body_number, owners);
            }
            if any_thin {
                let thin = &mut packet.thin[sample];
                is_in_thin |= thin.take(is_inside & is_thin, beyond, at, body_number, owners);
            }
        }
        if is_in_solid {
            [self.farthest[packet.place], self.covered[packet.place]] = packet.reach(simd);
        }
        is_in_solid || is_in_thin
    }
}

impl<S: Simd, const N: usize> OfGroup<'_, S, N> {
    /// Tests the model that is `seen` in the packet of this number, sample by sample; returns whether it is
    /// seen there.
    #[inline(always)]
    fn test_model_in(
        &mut self,
        number: usize,
        triangles: &Triangles,
        seen: &Seen<'_>,
        placed: &PacketBody<S>,
        owner: usize,
    ) -> bool {
        let Self { simd, look, group, sights, samples, .. } = *self;
        let turning = look.scene.turning(seen.number).filter(|_| seen.turns == Turns::About);
        let side = (N as f64).sqrt();
        let Packet { place, ray, .. } = self.drawn.packets[number];
        let samples = samples.map(|offset| {
            vectorized!(simd, {
                let is_centre = offset == [0.0, 0.0];
                let ray =
                    if is_centre { ray } else { rest_ray(simd, &group, sights.of_sample(place, offset)) };
                match turning {
                    Some(turning) => Meetings::with_turning(simd, look, seen, turning, triangles, &ray, side),
                    None => Meetings::new(simd, triangles, &group, placed, &ray, side),
                }
            })
        });
        let at = all(simd, owner as f32);
        let mut is_seen = false;
        let packet = &mut self.drawn.packets[number];
        for (meetings, solid) in samples.iter().zip(&mut packet.solid) {
            let holds = if N > 1 { meetings.above_ground(&group, placed) } else { meetings.holds };
            is_seen |= solid.take(holds, meetings.beyond, at, seen.number, &self.drawn.owners);
        }
        if is_seen {
            [self.farthest[place], self.covered[place]] = packet.reach(simd);
            self.drawn.models.push(ModelPart { place, owner, samples });
        }
        is_seen
    }
}
