//! The nearest bodies in each sample of a tile.

use super::super::body::{PacketGroup, RestRays};
use super::super::look::Look;
use super::super::model::{Meetings, ModelPart};
use super::super::places::PACKETS;
use super::super::ray::{TileSights, depth, rest_ray};
use crate::frame::pipeline_key::AmongOthers;
use crate::simd::lanes::{F, LANES, Mask, Simd, SimdFloat, SimdFrom, SimdMask, all, select};

/// Marks the absence of a body.
const NONE: f32 = -1.0;

/// The nearest in a sample of eight pixels.
#[derive(Debug, Clone, Copy)]
pub struct NearestHits<S: Simd> {
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
    pub ray: RestRays<S>,
    /// Nearest bodies that cover samples.
    pub solid: [NearestHits<S>; N],
    /// Nearest bodies that are thinner than a pixel, and cover a part of it.
    pub thin: [NearestHits<S>; N],
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
    pub(super) models: Vec<ModelPart<S, N>>,
}

impl<S: Simd, const N: usize> Packet<S, N> {
    #[inline(always)]
    pub(super) fn new(simd: S, group: &PacketGroup<'_>, sights: &TileSights<'_, S>, place: usize) -> Self {
        let nothing = [NearestHits::none(simd); N];
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
    pub(super) fn farthest(&self, simd: S) -> F<S> {
        let mut farthest = all(simd, f32::NEG_INFINITY);
        for nearest in &self.solid {
            farthest = farthest.max(nearest.beyond);
        }
        farthest
    }

    /// Returns the distance behind which nothing is seen in the packet, beyond the middle of the group and
    /// from the eye.
    #[inline(always)]
    pub(super) fn reach(&self, simd: S) -> [f32; 2] {
        let farthest = self.farthest(simd);
        let [mut beyond, mut from_eye] = [f32::NEG_INFINITY; 2];
        for (farthest, to_centre) in farthest.as_slice().iter().zip(self.ray.to_centre.as_slice()) {
            beyond = beyond.max(*farthest);
            from_eye = from_eye.max(farthest + to_centre);
        }
        [beyond, from_eye]
    }

    /// Replaces distances beyond the middle of a group by depths among all.
    #[inline(always)]
    pub(super) fn compare_depths(&mut self, group: &PacketGroup<'_>, among_others: Option<AmongOthers>) {
        for nearest in self.solid.iter_mut().chain(&mut self.thin) {
            if nearest.is_empty() {
                continue;
            }
            let depth = depth(group, among_others, &self.ray, nearest.beyond);
            nearest.beyond = select(nearest.owner.simd_lt(0.0), nearest.beyond, -depth);
        }
    }

    /// Returns the nearest bodies in each sample: those that cover it, and the thinner ones.
    #[inline(always)]
    fn layers(&mut self) -> [&mut [NearestHits<S>; N]; 2] {
        [&mut self.solid, &mut self.thin]
    }

    /// Whether the body at this place in the list owns a sample of `layer`, and that place for comparison.
    #[inline(always)]
    pub fn owned(simd: S, layer: &[NearestHits<S>; N], owner: usize) -> Option<F<S>> {
        let at = all(simd, owner as f32);
        let mut owns = layer[0].owner.simd_eq(at);
        for nearest in &layer[1..] {
            owns |= nearest.owner.simd_eq(at);
        }
        owns.any_true().then_some(at)
    }
}

impl<S: Simd, const N: usize> TileContents<S, N> {
    /// Returns the samples of a model, if the body at the place `owner` in the list is one, in the packet at
    /// this place.
    pub fn model(&self, place: usize, owner: usize) -> Option<&[Meetings<S>; N]> {
        let part = self.models.iter().find(|part| (part.place, part.owner) == (place, owner))?;
        Some(&part.samples)
    }

    /// Whether bodies of more than one group are seen, or were before something nearer was found.
    pub(super) fn is_of_several_groups(&self) -> bool {
        // They come group by group.
        let [first, last] = [self.owners.first(), self.owners.last()];
        first.map(|owner| owner.group) != last.map(|owner| owner.group)
    }

    /// Tells the nearest of several groups, of equally near ones the first, and forgets the rest.
    #[inline(always)]
    pub(super) fn compare_depths(&mut self, simd: S, look: &Look<'_>) {
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

impl<S: Simd> NearestHits<S> {
    #[inline(always)]
    fn none(simd: S) -> Self {
        Self { beyond: all(simd, f32::INFINITY), owner: all(simd, NONE) }
    }

    /// Whether no pixel has a body.
    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.owner.simd_lt(0.0).all_true()
    }

    /// Takes a surface this far `beyond` of the body of this `number`, which will be `at` that place in the
    /// list, where it `is_inside` and nearest, and says whether it is anywhere.
    #[inline(always)]
    pub(super) fn take(
        &mut self,
        is_inside: Mask<S>,
        beyond: F<S>,
        at: F<S>,
        number: usize,
        owners: &[Owner],
    ) -> bool {
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

    /// Returns where a surface this far `beyond`, of the body of this `number`, is seen before the present
    /// one: of equally near ones the first.
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
