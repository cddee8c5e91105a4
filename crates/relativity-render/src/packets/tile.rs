//! A tile of 8 x 8 pixels: what is the nearest in each sample of each of them.

use super::body::{Body, Group, Ray, Surface};
use super::look::{Look, Seen};
use super::model::{Meetings, ModelPart};
use super::passing::{Middles, may_show as may_show_in};
use super::places::PACKETS;
use super::ray::{TileSights, depth, height_on_ground, movement, rest_ray};
use super::shape;
use super::spin::Spin;
use super::turning::surface_when_shown;
use crate::candidates::TileLook;
use crate::cap::Cap;
use crate::kind::Kind;
use crate::lanes::{F, LANES, Mask, Simd, SimdFloat, SimdFrom, SimdMask, V2, all, select};
use crate::pipelines::AmongOthers;
use crate::triangles::Triangles;
use crate::wheel::packed::Turns;

/// Marks the absence of a body.
const NONE: f32 = -1.0;

/// The four samples of a pixel, from its centre, in the standard places.
pub const STANDARD: [[f32; 2]; 4] = [[-0.125, -0.375], [0.375, -0.125], [-0.375, 0.125], [0.125, 0.375]];
/// The sample at the centre alone.
pub const CENTRE: [[f32; 2]; 1] = [[0.0, 0.0]];

/// The nearest in a sample of eight pixels.
#[derive(Debug, Clone, Copy)]
pub struct Nearest<S: Simd> {
    /// Beyond the middle of its group, or where there are several groups the negative of its depth among all.
    pub beyond: F<S>,
    /// Place in the list of the tile's bodies, or a negative number.
    pub owner: F<S>,
}

/// A body that is seen in a tile.
#[derive(Debug, Clone, Copy)]
pub struct Owner {
    pub number: usize,
    pub group: usize,
}

/// The part of a packet that shows one group, in `N` samples of each of its pixels.
#[derive(Debug, Clone, Copy)]
pub struct Packet<S: Simd, const N: usize> {
    /// Place of the packet in the tile.
    pub place: usize,
    /// Through the middles of its pixels.
    pub ray: Ray<S>,
    /// Nearest bodies that cover samples.
    pub solid: [Nearest<S>; N],
    /// Nearest bodies that are thinner than a pixel, and cover a part of it.
    pub thin: [Nearest<S>; N],
    /// Range of the owners that belong to its group.
    pub owners: [usize; 2],
}

/// The bodies that are seen in a tile.
pub struct TileContents<S: Simd, const N: usize> {
    /// The packets that were looked into, group by group.
    pub packets: Vec<Packet<S, N>>,
    /// The bodies of which something is seen, or was before something nearer was found.
    pub owners: Vec<Owner>,
    /// Models of triangles among them, where they are seen.
    models: Vec<ModelPart<S, N>>,
}

/// The bodies of one group that are seen in a tile.
struct OfGroup<'a, S: Simd, const N: usize> {
    simd: S,
    look: &'a Look<'a>,
    group: Group<'a>,
    number: usize,
    samples: &'a [[f32; 2]; N],
    sights: TileSights<'a, S>,
    drawn: &'a mut TileContents<S, N>,
    /// Places of this group's packets among all, for those that were tested.
    places: [Option<usize>; PACKETS],
    middles: Middles<S>,
    /// Distance of the farthest body that covers a sample, for each packet.
    farthest: [f32; PACKETS],
    /// Bodies in several pieces that were tested.
    tested: Vec<u32>,
}

/// A ray test with what a picture needs of it.
pub struct Test<S: Simd> {
    /// From the camera, rest frame.
    pub distance: F<S>,
    /// Depth of the pixel's middle inside the outline, and its change from pixel to pixel.
    clearance: F<S>,
    gradient: V2<S>,
    /// Share of a pixel that it covers, 1 unless it is thinner.
    pub alpha: F<S>,
    /// Whether it is in front of the camera, and above the ground.
    is_there: Mask<S>,
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
                tested: Vec::new(),
            };
            let first_owner = own.drawn.owners.len();
            for &body in turning {
                own.enter(body as usize, false);
            }
            if let Some(beam) = beam {
                self.scene.hierarchy(number).along_on(simd, &beam, |candidate| {
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
        if self.views.len() > 1 {
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
        self.simd.vectorize(
            #[inline(always)]
            || self.test(&self.look.seen(number), is_told_about),
        );
    }

    #[inline(always)]
    fn test(&mut self, seen: &Seen<'_>, is_told_about: bool) {
        let simd = self.simd;
        let body = Body::new(simd, &seen.shown.placement);
        let packets: [i32; PACKETS] = if is_told_about {
            self.middles.may_show(seen.body.kind, &body, self.farthest).into()
        } else {
            [-1; PACKETS]
        };
        let spin = Spin::new(simd, &seen.shown);
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
                let farthest = packet.farthest(simd);
                if !may_show_in(seen.body.kind, &body, &packet.ray, pixel, farthest).any_true() {
                    continue;
                }
            }
            is_seen |= match self.look.scene.triangles(seen.number) {
                Some(triangles) => self.test_model_in(number, triangles, seen, &body, owner),
                None => self.test_in(number, pixel, seen, &body, &spin, owner),
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

    /// Tests a body in the packet of this number, in which a `pixel` has this width per distance; returns whether it is seen
    /// there.
    #[inline(always)]
    fn test_in(
        &mut self,
        number: usize,
        pixel: F<S>,
        seen: &Seen<'_>,
        body: &Body<S>,
        spin: &Spin<S>,
        owner: usize,
    ) -> bool {
        let Self { simd, group, .. } = *self;
        let ray = &self.drawn.packets[number].ray;
        let kind = seen.body.kind;
        let surface = surface_when_shown(simd, kind, seen.turns, &group, body, ray, spin);
        // Farther outside than a pixel it is in no sample, and not widened into one.
        let pixels = (ray.to_centre + surface.beyond).max(0.0) * pixel;
        if !(surface.clearance + pixels).simd_gt(0.0).any_true() {
            return false;
        }
        let test = Test::new(simd, &group, kind, body, ray, surface, N > 1);
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
                is_in_solid |= whole.take(is_inside & is_whole, beyond, at, seen.number, owners);
            }
            if any_thin {
                let thin = &mut packet.thin[sample];
                is_in_thin |= thin.take(is_inside & is_thin, beyond, at, seen.number, owners);
            }
        }
        if is_in_solid {
            self.farthest[packet.place] = packet.reach(simd);
        }
        is_in_solid || is_in_thin
    }
}

impl<S: Simd, const N: usize> OfGroup<'_, S, N> {
    /// Tests the model that is `seen` in the packet of this number, sample by sample; returns whether it is seen there.
    #[inline(always)]
    fn test_model_in(
        &mut self,
        number: usize,
        triangles: &Triangles,
        seen: &Seen<'_>,
        placed: &Body<S>,
        owner: usize,
    ) -> bool {
        let Self { simd, look, group, sights, samples, .. } = *self;
        let turning = look.scene.turning(seen.number).filter(|_| seen.turns == Turns::About);
        let side = (N as f64).sqrt();
        let Packet { place, ray, .. } = self.drawn.packets[number];
        let samples = samples.map(|offset| {
            let is_centre = offset == [0.0, 0.0];
            let ray = if is_centre { ray } else { rest_ray(simd, &group, sights.of_sample(place, offset)) };
            match turning {
                Some(turning) => Meetings::with_turning(simd, look, seen, turning, triangles, &ray, side),
                None => Meetings::new(simd, triangles, &group, placed, &ray, side),
            }
        });
        let at = all(simd, owner as f32);
        let mut is_seen = false;
        let packet = &mut self.drawn.packets[number];
        for (meetings, solid) in samples.iter().zip(&mut packet.solid) {
            let holds = if N > 1 { meetings.above_ground(&group, placed) } else { meetings.holds };
            is_seen |= solid.take(holds, meetings.beyond, at, seen.number, &self.drawn.owners);
        }
        if is_seen {
            self.farthest[place] = packet.reach(simd);
            self.drawn.models.push(ModelPart { place, owner, samples });
        }
        is_seen
    }
}

impl<S: Simd, const N: usize> Packet<S, N> {
    #[inline(always)]
    fn new(simd: S, group: &Group<'_>, sights: &TileSights<'_, S>, place: usize) -> Self {
        let nothing = [Nearest::none(simd); N];
        Self {
            place,
            ray: rest_ray(simd, group, sights.of_packet(place)),
            solid: nothing,
            thin: nothing,
            owners: [0; 2],
        }
    }

    /// Returns the distance of the farthest body that covers a pixel's samples.
    #[inline(always)]
    fn farthest(&self, simd: S) -> F<S> {
        let mut farthest = all(simd, f32::NEG_INFINITY);
        for nearest in &self.solid {
            farthest = farthest.max(nearest.beyond);
        }
        farthest
    }

    /// Returns the distance beyond which nothing is seen in the packet.
    #[inline(always)]
    fn reach(&self, simd: S) -> f32 {
        self.farthest(simd).as_slice().iter().copied().fold(f32::NEG_INFINITY, f32::max)
    }

    /// Replaces distances beyond the middle of a group by depths among all.
    #[inline(always)]
    fn compare_depths(&mut self, group: &Group<'_>, among_others: Option<AmongOthers>) {
        for nearest in self.solid.iter_mut().chain(&mut self.thin) {
            let depth = depth(group, among_others, &self.ray, nearest.beyond);
            nearest.beyond = select(nearest.owner.simd_lt(0.0), nearest.beyond, -depth);
        }
    }

    /// Returns the nearest bodies in each sample: those that cover it, and the thinner ones.
    #[inline(always)]
    fn layers(&mut self) -> [&mut [Nearest<S>; N]; 2] {
        [&mut self.solid, &mut self.thin]
    }

    /// Whether the body at this place in the list owns a sample of `layer`, and that place for comparison.
    #[inline(always)]
    pub fn owned(simd: S, layer: &[Nearest<S>; N], owner: usize) -> Option<F<S>> {
        let at = all(simd, owner as f32);
        let mut owns = layer[0].owner.simd_eq(at);
        for nearest in &layer[1..] {
            owns |= nearest.owner.simd_eq(at);
        }
        owns.any_true().then_some(at)
    }
}

impl<S: Simd, const N: usize> TileContents<S, N> {
    /// Returns the samples of a model, if the body at the place `owner` in the list is one, in the packet at this place.
    pub fn model(&self, place: usize, owner: usize) -> Option<&[Meetings<S>; N]> {
        let part = self.models.iter().find(|part| (part.place, part.owner) == (place, owner))?;
        Some(&part.samples)
    }

    /// Tells the nearest of several groups, of equally near ones the first, and forgets the rest.
    #[inline(always)]
    fn compare_depths(&mut self, simd: S, look: &Look<'_>) {
        let mut nearest = [[[all(simd, f32::INFINITY); N]; 2]; PACKETS];
        for packet in &mut self.packets {
            let group = self.owners.get(packet.owners[0]).map_or(0, |owner| owner.group);
            packet.compare_depths(&look.group(group), look.among_others(group));
            for (nearest, layer) in nearest[packet.place].iter_mut().zip(packet.layers()) {
                for (nearest, own) in nearest.iter_mut().zip(layer) {
                    *nearest = select(own.beyond.simd_lt(*nearest), own.beyond, *nearest);
                }
            }
        }
        let mut kept = 0;
        for number in 0..self.packets.len() {
            let packet = &mut self.packets[number];
            let mut is_seen = false;
            for (nearest, layer) in nearest[packet.place].iter_mut().zip(packet.layers()) {
                for (nearest, own) in nearest.iter_mut().zip(layer) {
                    let is_nearest = own.beyond.simd_le(*nearest);
                    own.forget(!is_nearest);
                    // The next that is as near is not the first.
                    *nearest = select(is_nearest, all(simd, f32::NEG_INFINITY), *nearest);
                    is_seen |= own.owner.simd_ge(0.0).any_true();
                }
            }
            if is_seen {
                self.packets.swap(kept, number);
                kept += 1;
            }
        }
        self.packets.truncate(kept);
    }
}

impl<S: Simd> Nearest<S> {
    #[inline(always)]
    fn none(simd: S) -> Self {
        Self { beyond: all(simd, f32::INFINITY), owner: all(simd, NONE) }
    }

    /// Takes a surface this far `beyond` of the body of this `number`, which will be `at` that place in the list, where
    /// it `is_inside` and nearest, and says whether it is anywhere.
    #[inline(always)]
    fn take(&mut self, is_inside: Mask<S>, beyond: F<S>, at: F<S>, number: usize, owners: &[Owner]) -> bool {
        let holds = is_inside & self.is_behind(beyond, number, owners);
        self.beyond = select(holds, beyond, self.beyond);
        self.owner = select(holds, at, self.owner);
        holds.any_true()
    }

    #[inline(always)]
    fn forget(&mut self, holds: Mask<S>) {
        let none = Self::none(self.beyond.simd);
        self.beyond = select(holds, none.beyond, self.beyond);
        self.owner = select(holds, none.owner, self.owner);
    }

    /// Returns where a surface this far `beyond`, of the body of this `number`, is seen before the present one: of equally near ones the first.
    #[inline(always)]
    fn is_behind(&self, beyond: F<S>, number: usize, owners: &[Owner]) -> Mask<S> {
        let is_farther = self.beyond.simd_gt(beyond);
        let is_as_near = self.beyond.simd_eq(beyond);
        if !is_as_near.any_true() {
            return is_farther;
        }
        let mut is_later = [0; LANES];
        for (is_later, owner) in is_later.iter_mut().zip(self.owner.as_slice()) {
            let is_known = *owner >= 0.0;
            *is_later = -i32::from(is_known && owners[*owner as usize].number > number);
        }
        is_farther | (is_as_near & Mask::simd_from(self.beyond.simd, is_later))
    }
}

impl<S: Simd> Test<S> {
    /// Returns the fragment of the `body` that is `seen`, whose `surface` was found; in a picture it is drawn at least a pixel wide.
    #[inline(always)]
    pub fn new(
        simd: S,
        group: &Group<'_>,
        kind: Kind,
        body: &Body<S>,
        ray: &Ray<S>,
        surface: Surface<S>,
        is_picture: bool,
    ) -> Self {
        let distance = ray.to_centre + surface.beyond;
        let is_in_front = distance.simd_gt(0.0);
        let zero = all(simd, 0.0);
        let mut test = Self {
            distance,
            clearance: surface.clearance,
            gradient: V2::new(zero, zero),
            alpha: all(simd, 1.0),
            is_there: is_in_front,
        };
        if !is_picture {
            return test;
        }
        let movement = movement(group, ray, surface.outward);
        let least = -distance.max(0.0);
        test.gradient = V2::new(least * movement.x, least * movement.y);
        let half_pixel = test.gradient.length() * 0.5;
        test.alpha = (surface.half_width / half_pixel.max(1e-30)).min(1.0);
        test.clearance += (half_pixel - surface.half_width).max(0.0);
        let height = shape::middle(kind, body).z + surface.place.z + group.frame.middle[2];
        let height = height_on_ground(group, height, shape::middle(kind, body) + surface.place);
        test.is_there = is_in_front & height.simd_ge(group.frame.ground[2]);
        test
    }

    /// Returns the pixels in which the sample this far from the centre is inside.
    #[inline(always)]
    fn holds(&self, [right, down]: [f32; 2]) -> Mask<S> {
        let clearance = self.clearance + self.gradient.x * right + self.gradient.y * down;
        clearance.simd_gt(0.0) & self.is_there
    }
}
