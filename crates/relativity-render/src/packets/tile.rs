//! A tile of 8 x 8 pixels: what is the nearest in each sample of each of them.

use super::body::{Body, Group, Ray, Surface};
use super::lanes::{F, LANES, Mask, Simd, V3, all};
use super::look::{Look, Seen};
use super::passing::Middles;
use super::ray::{depth, line_of_sight, movement, rest_ray};
use super::turning::{Spin, surface_when_shown};
use super::shape;
use crate::candidates::TileLook;
use crate::hierarchy::Beam;
use crate::tiles::Tile;

/// Packets of a tile: four pixels wide and two high.
pub const PACKETS: usize = 8;
/// No body.
const NONE: f32 = -1.0;

/// The four samples of a pixel, from its centre, in the standard places.
pub const STANDARD: [[f32; 2]; 4] = [[-0.125, -0.375], [0.375, -0.125], [-0.375, 0.125], [0.125, 0.375]];
/// Its centre alone.
pub const CENTRE: [[f32; 2]; 1] = [[0.0, 0.0]];

/// The pixel at the top left of the packet of this number, in the tile with this `corner`.
pub fn packet_places([left, top]: [u32; 2], packet: usize) -> [u32; 2] {
    [left + 4 * (packet as u32 % 2), top + 2 * (packet as u32 / 2)]
}

/// The centres of the pixels of a packet.
#[inline(always)]
pub fn centres<S: Simd>(simd: S, [left, top]: [u32; 2]) -> [F<S>; 2] {
    let u: [f32; LANES] = std::array::from_fn(|lane| (left + lane as u32 % 4) as f32 + 0.5);
    let v: [f32; LANES] = std::array::from_fn(|lane| (top + lane as u32 / 4) as f32 + 0.5);
    [F::simd_from(simd, u), F::simd_from(simd, v)]
}

/// The nearest in a sample of eight pixels.
#[derive(Debug, Clone, Copy)]
pub struct Nearest<S: Simd> {
    /// Beyond the middle of its group, or where there are several the negative of its depth among all.
    pub beyond: F<S>,
    /// Its place in the list of what is in the tile.
    pub owner: F<S>,
}

/// A body that is seen in a tile, and the group of which it is.
#[derive(Debug, Clone, Copy)]
pub struct Owner {
    pub number: usize,
    pub group: usize,
}

/// What is in a tile: in each of `N` samples of a pixel.
pub struct Drawn<S: Simd, const N: usize> {
    /// What covers it.
    pub solid: [[Nearest<S>; N]; PACKETS],
    /// What is thinner than a pixel, and covers a part of it.
    pub thin: [[Nearest<S>; N]; PACKETS],
    /// The bodies of which something is seen, or was before something nearer was found.
    pub owners: Vec<Owner>,
    /// For each group its rays, where it has any such body.
    pub rays: Vec<Option<Box<[Ray<S>; PACKETS]>>>,
    /// How far the farthest of what covers a sample is, for each packet.
    farthest: [f32; PACKETS],
}

/// A ray test with what a picture needs of it.
pub struct Test<S: Simd> {
    pub surface: Surface<S>,
    /// From the camera, rest frame.
    pub distance: F<S>,
    /// How deep inside the outline, in pixels to the right and down.
    pub gradient: [F<S>; 2],
    pub clearance: F<S>,
    /// Share of a pixel that it covers, 1 unless it is thinner.
    pub alpha: F<S>,
    /// Whether it is in front of the camera, and above the ground.
    pub is_there: Mask<S>,
}

impl Look<'_> {
    /// What is in `tile`.
    #[inline(always)]
    pub fn draw<S: Simd, const N: usize>(
        &self,
        simd: S,
        samples: &[[f32; 2]; N],
        tile: &TileLook,
    ) -> Drawn<S, N> {
        let nothing = Nearest { beyond: all(simd, f32::INFINITY), owner: all(simd, NONE) };
        let mut drawn = Drawn {
            solid: [[nothing; N]; PACKETS],
            thin: [[nothing; N]; PACKETS],
            owners: Vec::new(),
            rays: Vec::new(),
            farthest: [f32::INFINITY; PACKETS],
        };
        let mut others = tile.others.as_slice();
        for (number, view) in self.views.iter().enumerate() {
            let group = self.group(number);
            let prepared = &self.scene.groups()[number];
            let own;
            (own, others) = others.split_at(others.partition_point(|&body| (body as usize) < prepared.bodies.end));
            drawn.rays.push(None);
            // Distances beyond the middle of one group say nothing of another's.
            drawn.farthest = [f32::INFINITY; PACKETS];
            let mut middles = None;
            for &body in own {
                let seen = self.seen(body as usize);
                simd.vectorize(
                    #[inline(always)]
                    || drawn.add(simd, &group, samples, &tile.tile, &seen, [true; PACKETS]),
                );
            }
            let enter = |drawn: &mut Drawn<S, N>, middles: &mut Option<Middles<S>>, body: usize| {
                simd.vectorize(
                    #[inline(always)]
                    || {
                        let seen = self.seen(body);
                        let middles = middles.get_or_insert_with(|| Middles::new(simd, &group, tile.tile.corner));
                        let placed = Body::new(simd, &seen.shown.placement);
                        let packets = middles.may_show(simd, &shape::around(seen.body.kind, &placed));
                        drawn.add(simd, &group, samples, &tile.tile, &seen, lanes_of(packets));
                    },
                );
            };
            match Beam::new(view, &tile.cone, prepared.extent.middle) {
                Some(beam) => self.scene.hierarchy(number).along(&beam, |candidate| {
                    enter(&mut drawn, &mut middles, candidate.body as usize);
                    drawn.reach()
                }),
                None => {
                    for body in prepared.bodies.clone() {
                        if self.scene.turning(body).is_none() {
                            enter(&mut drawn, &mut middles, body);
                        }
                    }
                }
            }
            if self.views.len() > 1 {
                drawn.tell_depths(simd, &group, number);
            }
        }
        drawn
    }
}

impl<S: Simd, const N: usize> Drawn<S, N> {
    /// What is farther than this is seen nowhere in the tile.
    fn reach(&self) -> f32 {
        self.farthest.into_iter().fold(f32::NEG_INFINITY, f32::max)
    }

    /// Tests a body in these packets.
    #[inline(always)]
    fn add(
        &mut self,
        simd: S,
        group: &Group<'_>,
        samples: &[[f32; 2]; N],
        tile: &Tile,
        seen: &Seen<'_>,
        packets: [bool; PACKETS],
    ) {
        let rays = self.rays.last_mut().expect("there is a group");
        let rays = rays.get_or_insert_with(|| {
            Box::new(std::array::from_fn(|packet| {
                let [u, v] = centres(simd, packet_places(tile.corner, packet));
                rest_ray(simd, group, line_of_sight(simd, group.frame, u, v))
            }))
        });
        let body = Body::new(simd, &seen.shown.placement);
        let spin = Spin::new(simd, seen.shown.spin, seen.shown.rim);
        // The last one again, if it is in several pieces.
        let group_number = self.rays.len() - 1;
        let owner = self.owners.len();
        let mut is_seen = false;
        for packet in 0..PACKETS {
            if !packets[packet] {
                continue;
            }
            let test = Test::new(simd, group, seen, &body, &spin, &rays[packet], N > 1);
            let beyond = test.surface.beyond;
            let is_whole = test.alpha.simd_ge(1.0);
            let mut changed = false;
            for (sample, [right, down]) in samples.iter().enumerate() {
                let clearance = test.clearance + test.gradient[0] * *right + test.gradient[1] * *down;
                let is_inside = clearance.simd_gt(0.0) & test.is_there;
                for (nearest, layer) in [(&mut self.solid, is_whole), (&mut self.thin, !is_whole)] {
                    let nearest = &mut nearest[packet][sample];
                    let holds = is_inside & layer & nearest.is_behind(beyond, seen.body.number, &self.owners);
                    nearest.beyond = holds.select(beyond, nearest.beyond);
                    nearest.owner = holds.select(all(simd, owner as f32), nearest.owner);
                    changed |= holds.any_true();
                }
            }
            if changed {
                is_seen = true;
                let farthest = self.solid[packet].iter().fold(all(simd, f32::NEG_INFINITY), |most, nearest| most.max(nearest.beyond));
                self.farthest[packet] = (0..LANES).fold(f32::NEG_INFINITY, |most, lane| most.max(farthest[lane]));
            }
        }
        if is_seen {
            self.owners.push(Owner { number: seen.body.number, group: group_number });
        }
    }

    /// Replaces distances beyond the middle of a group by depths among all.
    #[inline(always)]
    fn tell_depths(&mut self, simd: S, group: &Group<'_>, number: usize) {
        let _ = (simd, group, number);
    }
}

impl<S: Simd> Nearest<S> {
    /// Where a surface this far `beyond`, of the body of this `number`, is seen before it: of equally near ones the first.
    #[inline(always)]
    fn is_behind(&self, beyond: F<S>, number: usize, owners: &[Owner]) -> Mask<S> {
        let is_farther = self.beyond.simd_gt(beyond);
        let is_as_near = self.beyond.simd_eq(beyond);
        if !is_as_near.any_true() {
            return is_farther;
        }
        let is_later: [bool; LANES] = std::array::from_fn(|lane| {
            let owner = self.owner[lane];
            owner >= 0.0 && owners.get(owner as usize).is_some_and(|owner| owner.number > number)
        });
        is_farther | (is_as_near & mask_of(self.beyond.simd, is_later))
    }
}
