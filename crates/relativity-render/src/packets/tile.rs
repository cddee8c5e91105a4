//! A tile of 8 x 8 pixels: what is the nearest in each sample of each of them.

use super::body::{Body, Group, Ray, Surface};
use super::lanes::{F, LANES, Mask, Simd, SimdFloat, SimdFrom, SimdMask, V2, all, select};
use super::look::{Look, Seen};
use super::passing::Middles;
use super::ray::{depth, line_of_sight, movement, rest_ray};
use super::shape;
use super::turning::{Spin, surface_when_shown};
use crate::candidates::{Rows, TileLook};
use crate::hierarchy::Beam;
use crate::pipelines::AmongOthers;
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
    /// Beyond the middle of its group, or where there are several groups the negative of its depth among all.
    pub beyond: F<S>,
    /// Its place in the list of what is in the tile, or a negative number.
    pub owner: F<S>,
}

/// The same of `N` samples of each pixel of a tile.
pub type Layer<S, const N: usize> = [[Nearest<S>; N]; PACKETS];

/// A body that is seen in a tile.
#[derive(Debug, Clone, Copy)]
pub struct Owner {
    pub number: usize,
    pub group: usize,
}

/// What is in a tile.
pub struct Drawn<S: Simd, const N: usize> {
    /// What covers samples.
    pub solid: Layer<S, N>,
    /// What is thinner than a pixel, and covers a part of it.
    pub thin: Layer<S, N>,
    /// The bodies of which something is seen, or was before something nearer was found.
    pub owners: Vec<Owner>,
    /// For each group its rays, where it has any such body.
    pub rays: Vec<Option<Box<[Ray<S>; PACKETS]>>>,
}

/// What is in a tile of one group.
struct OfGroup<'a, S: Simd, const N: usize> {
    simd: S,
    look: &'a Look<'a>,
    group: Group<'a>,
    number: usize,
    samples: &'a [[f32; 2]; N],
    tile: &'a Tile,
    layers: [Layer<S, N>; 2],
    rays: Option<Box<[Ray<S>; PACKETS]>>,
    middles: Option<Middles<S>>,
    /// How far the farthest of what covers a sample is, for each packet.
    farthest: [f32; PACKETS],
    /// Bodies in several pieces that were tested.
    tested: Vec<u32>,
}

/// A ray test with what a picture needs of it.
pub struct Test<S: Simd> {
    pub surface: Surface<S>,
    /// From the camera, rest frame.
    pub distance: F<S>,
    /// How deep inside the outline the middle of the pixel is, in pixels' worth of length, and how that changes from pixel
    /// to pixel.
    clearance: F<S>,
    gradient: V2<S>,
    /// Share of a pixel that it covers, 1 unless it is thinner.
    pub alpha: F<S>,
    /// Whether it is in front of the camera, and above the ground.
    is_there: Mask<S>,
}

impl Look<'_> {
    /// What is in `tile`.
    #[inline(always)]
    pub fn draw<S: Simd, const N: usize>(
        &self,
        simd: S,
        samples: &[[f32; 2]; N],
        tile: &TileLook<'_>,
    ) -> Drawn<S, N> {
        let nothing = [[Nearest::none(simd); N]; PACKETS];
        let mut drawn = Drawn { solid: nothing, thin: nothing, owners: Vec::new(), rays: Vec::new() };
        let Some(cap) = &tile.cap else { return drawn };
        let mut others = tile.others;
        for (number, view) in self.views.iter().enumerate() {
            let prepared = &self.scene.groups()[number];
            let mut own = OfGroup {
                simd,
                look: self,
                group: self.group(number),
                number,
                samples,
                tile: &tile.tile,
                layers: [nothing; 2],
                rays: None,
                middles: None,
                farthest: [f32::INFINITY; PACKETS],
                tested: Vec::new(),
            };
            let count = others.partition_point(|&body| (body as usize) < prepared.bodies.end);
            let (turning, later) = others.split_at(count);
            others = later;
            for &body in turning {
                own.enter(&mut drawn.owners, body as usize, false);
            }
            match Beam::new(view, cap, prepared.extent.middle) {
                Some(beam) => self.scene.hierarchy(number).along(&beam, |candidate| {
                    if !candidate.is_one_of_some || own.is_new(candidate.body) {
                        own.enter(&mut drawn.owners, candidate.body as usize, true);
                    }
                    own.reach()
                }),
                None => {
                    let standing = prepared.bodies.clone().filter(|&body| self.scene.turning(body).is_none());
                    standing.for_each(|body| own.enter(&mut drawn.owners, body, true));
                }
            }
            simd.vectorize(
                #[inline(always)]
                || drawn.join(own, self.among_others(number)),
            );
        }
        drawn
    }
}

/// The rays through the middles of the pixels of the tile with this `corner`.
#[inline(always)]
fn rays_of<S: Simd>(simd: S, group: &Group<'_>, corner: [u32; 2]) -> Box<[Ray<S>; PACKETS]> {
    let mut rays = Box::new([ray_of(simd, group, corner, 0); PACKETS]);
    for packet in 1..PACKETS {
        rays[packet] = ray_of(simd, group, corner, packet);
    }
    rays
}

#[inline(always)]
fn ray_of<S: Simd>(simd: S, group: &Group<'_>, corner: [u32; 2], packet: usize) -> Ray<S> {
    let [u, v] = centres(simd, packet_places(corner, packet));
    rest_ray(simd, group, line_of_sight(simd, group.frame, u, v))
}

impl<S: Simd, const N: usize> OfGroup<'_, S, N> {
    /// What is farther than this is seen nowhere in the tile.
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
    fn enter(&mut self, owners: &mut Vec<Owner>, number: usize, is_told_about: bool) {
        self.simd.vectorize(
            #[inline(always)]
            || self.test(owners, &self.look.seen(number), is_told_about),
        );
    }

    #[inline(always)]
    fn test(&mut self, owners: &mut Vec<Owner>, seen: &Seen<'_>, is_told_about: bool) {
        let Self { simd, group, tile, .. } = *self;
        COUNT[0].fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        let body = Body::new(simd, &seen.shown.placement);
        let packets: [i32; PACKETS] = if is_told_about {
            if self.middles.is_none() {
                self.middles = Some(Middles::new(simd, &group, tile.corner));
            }
            let Some(middles) = &self.middles else { return };
            middles.may_show(&shape::around(seen.body.kind, &body)).into()
        } else {
            [-1; PACKETS]
        };
        if self.rays.is_none() {
            self.rays = Some(rays_of(simd, &group, tile.corner));
        }
        let Some(rays) = &self.rays else { return };
        let spin = Spin::new(simd, &seen.shown);
        let owner = all(simd, owners.len() as f32);
        let mut is_seen = false;
        for packet in (0..PACKETS).filter(|&packet| packets[packet] != 0) {
            COUNT[1].fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            let test = Test::new(simd, &group, seen, &body, &spin, &rays[packet], N > 1);
            let beyond = test.surface.beyond;
            let is_whole = test.alpha.simd_ge(1.0);
            let mut is_nearer = false;
            for (sample, place) in self.samples.iter().enumerate() {
                let is_inside = test.holds(*place);
                for (layer, is_in) in self.layers.iter_mut().zip([is_whole, !is_whole]) {
                    let nearest = &mut layer[packet][sample];
                    let holds = is_inside & is_in & nearest.is_behind(beyond, seen.body.number, owners);
                    nearest.beyond = select(holds, beyond, nearest.beyond);
                    nearest.owner = select(holds, owner, nearest.owner);
                    is_nearer |= holds.any_true();
                }
            }
            if is_nearer {
                is_seen = true;
                let mut most = all(simd, f32::NEG_INFINITY);
                for nearest in &self.layers[0][packet] {
                    most = most.max(nearest.beyond);
                }
                self.farthest[packet] = most.as_slice().iter().copied().fold(f32::NEG_INFINITY, f32::max);
            }
        }
        if is_seen {
            COUNT[2].fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            owners.push(Owner { number: seen.body.number, group: self.number });
        }
    }
}

impl<S: Simd, const N: usize> Drawn<S, N> {
    /// Takes what of another group is nearer, which stands so among others if there are any.
    #[inline(always)]
    fn join(&mut self, own: OfGroup<'_, S, N>, among_others: Option<AmongOthers>) {
        let OfGroup { group, mut layers, rays, .. } = own;
        if let (Some(rays), Some(_)) = (&rays, among_others) {
            for (nearest, ray) in layers.iter_mut().flat_map(|layer| layer.iter_mut().zip(rays.iter())) {
                for nearest in nearest {
                    let depth = depth(&group, among_others, ray, nearest.beyond);
                    let is_none = nearest.owner.simd_lt(0.0);
                    nearest.beyond = select(is_none, nearest.beyond, -depth);
                }
            }
        }
        if rays.is_some() {
            for (known, new) in [&mut self.solid, &mut self.thin].into_iter().zip(layers) {
                for (known, new) in known.iter_mut().flatten().zip(new.into_iter().flatten()) {
                    let is_nearer = known.beyond.simd_gt(new.beyond);
                    known.beyond = select(is_nearer, new.beyond, known.beyond);
                    known.owner = select(is_nearer, new.owner, known.owner);
                }
            }
        }
        self.rays.push(rays);
    }
}

impl<S: Simd> Nearest<S> {
    #[inline(always)]
    fn none(simd: S) -> Self {
        Self { beyond: all(simd, f32::INFINITY), owner: all(simd, NONE) }
    }

    /// Where a surface this far `beyond`, of the body of this `number`, is seen before it: of equally near ones the first.
    #[inline(always)]
    fn is_behind(&self, beyond: F<S>, number: usize, owners: &[Owner]) -> Mask<S> {
        let is_farther = self.beyond.simd_gt(beyond);
        let is_as_near = self.beyond.simd_eq(beyond);
        if !is_as_near.any_true() {
            return is_farther;
        }
        let is_later: [i32; LANES] = std::array::from_fn(|lane| {
            let owner = self.owner[lane];
            let is_later =
                owner >= 0.0 && owners.get(owner as usize).is_some_and(|owner| owner.number > number);
            -i32::from(is_later)
        });
        is_farther | (is_as_near & Mask::simd_from(self.beyond.simd, is_later))
    }
}

impl<S: Simd> Test<S> {
    /// Of the `body` that is `seen`; in a picture what is thinner than a pixel is drawn a pixel wide.
    #[inline(always)]
    pub fn new(
        simd: S,
        group: &Group<'_>,
        seen: &Seen<'_>,
        body: &Body<S>,
        spin: &Spin<S>,
        ray: &Ray<S>,
        is_picture: bool,
    ) -> Self {
        let kind = seen.body.kind;
        let surface = surface_when_shown(simd, kind, seen.turns, group, body, ray, spin);
        let distance = ray.to_centre + surface.beyond;
        let is_in_front = distance.simd_gt(0.0);
        let zero = all(simd, 0.0);
        let mut test = Self {
            surface,
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
        test.is_there = is_in_front & height.simd_ge(group.frame.ground[2]);
        test
    }

    /// In which pixels the sample this far from the centre is inside.
    #[inline(always)]
    fn holds(&self, [right, down]: [f32; 2]) -> Mask<S> {
        let clearance = self.clearance + self.gradient.x * right + self.gradient.y * down;
        clearance.simd_gt(0.0) & self.is_there
    }
}

impl<S: Simd, const N: usize> Drawn<S, N> {
    /// The body at this place in the list, if it owns a sample of a packet, and that place.
    #[inline(always)]
    pub fn owner_in(&self, simd: S, layer: &Layer<S, N>, packet: usize, place: usize) -> Option<(Owner, F<S>)> {
        let at = all(simd, place as f32);
        let mut owns = layer[packet][0].owner.simd_eq(at);
        for nearest in &layer[packet][1..] {
            owns = owns | nearest.owner.simd_eq(at);
        }
        owns.any_true().then(|| (self.owners[place], at))
    }
}

/// Writes the pixel in this lane of the packet with this corner, if it is in `tile`, into the rows that that is in.
#[inline(always)]
pub fn write_one<T>(tile: &Tile, [left, top]: [u32; 2], rows: &mut Rows<'_, T>, lane: usize, value: T) {
    let [u, v] = [left + lane as u32 % 4, top + lane as u32 / 4];
    if u < tile.corner[0] + tile.size[0] && v < tile.corner[1] + tile.size[1] {
        rows.put([u, v], value);
    }
}

pub static COUNT: [std::sync::atomic::AtomicUsize; 3] = [const { std::sync::atomic::AtomicUsize::new(0) }; 3];
