//! Blocks of bodies: neighbours of one kind and about one size, for renderers that decide on many at once.

use std::collections::{BTreeMap, HashSet};
use std::ops::Range;

use super::prepared_body::PreparedBody;
use super::prepared_scene::PreparedScene;
use super::standing::StandingBodies;
use crate::geometry::capsule::Capsule;
use crate::geometry::extent::Extent;
use crate::geometry::hierarchy::{Hierarchy, pieces};
use crate::geometry::kind::Kind;

/// The bodies of a group that keep their places, in blocks.
#[derive(Debug)]
pub(crate) struct Blocks {
    all: Vec<Block>,
    /// The numbers of the bodies, block by block, those that [`Block::are_simple`] before all others.
    bodies: Vec<u32>,
}

/// Bodies that are near each other, as many as there are boxes in a node of a hierarchy at most.
#[derive(Debug)]
pub(crate) struct Block {
    /// Common properties.
    pub alike: Alike,
    /// Range of the block in the group's list of bodies.
    pub range: Range<usize>,
    /// A ball around all, rest frame.
    pub ball: Capsule,
    /// The greatest radius of a ball around a body.
    pub largest: f64,
    /// Boxes around the bodies.
    pub hierarchy: Hierarchy,
    /// The least and the greatest radius of the bodies themselves, as [`Placement`] has it.
    ///
    /// [`Placement`]: super::prepared_body::Placement
    pub radii: [f64; 2],
}

/// The common properties of the bodies of a block, in the order of blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Alike {
    /// Whether some may turn, are models, or share an end with others, among which the first is to be drawn.
    is_special: bool,
    /// Kind of their shapes.
    pub kind: Kind,
    /// Whether any of them carries a pattern.
    pub is_patterned: bool,
    /// Whether a ball hides them from all eyes outside of balls.
    is_inside: bool,
    /// log4 of their sizes.
    size: u64,
}

impl Alike {
    fn of(body: &PreparedBody, around: &Capsule, is_inside: bool) -> Self {
        let is_joined = body.joint.as_it_is || body.joint.widened;
        Self {
            is_special: is_joined || body.spin.is_some() || body.kind == Kind::Model,
            kind: body.kind,
            is_patterned: body.is_patterned,
            is_inside,
            // Half of the binary exponent.
            size: around.radius.to_bits() >> 53,
        }
    }
}

impl Blocks {
    /// Takes the `standing` bodies of a group of `scene`, which has this `extent`.
    pub fn new(scene: &PreparedScene, extent: &Extent, standing: &StandingBodies) -> Self {
        let mut by_alike: BTreeMap<Alike, Vec<u32>> = BTreeMap::new();
        for (number, is_inside) in standing.numbers() {
            let body = &scene.bodies()[number as usize];
            let alike = Alike::of(body, scene.ball_around(body), is_inside);
            by_alike.entry(alike).or_default().push(number);
        }
        let (mut all, mut bodies, mut told) = (Vec::new(), Vec::new(), HashSet::new());
        for (alike, numbers) in by_alike {
            for neighbours in hierarchy(scene, extent, &numbers).bodies_by_node() {
                let first = bodies.len();
                bodies.extend(neighbours.filter(|&body| told.insert(body)));
                if first < bodies.len() {
                    all.push(Block::new(scene, extent, alike, first, &bodies[first..]));
                }
            }
        }
        Self { all, bodies }
    }

    /// The blocks that an eye sees, which is in one of the balls that hide bodies, or is not.
    pub fn seen(&self, is_in_a_ball: bool) -> impl Iterator<Item = &Block> {
        self.all.iter().filter(move |block| is_in_a_ball || !block.alike.is_inside)
    }

    /// The numbers of the bodies of `block`.
    pub fn bodies_of(&self, block: &Block) -> &[u32] {
        &self.bodies[block.range.clone()]
    }

    /// The numbers of all bodies that [`Block::are_simple`].
    pub fn simple_bodies(&self) -> &[u32] {
        let end = self.all.iter().take_while(|block| block.are_simple()).last();
        &self.bodies[..end.map_or(0, |block| block.range.end)]
    }
}

impl Block {
    fn new(scene: &PreparedScene, extent: &Extent, alike: Alike, first: usize, numbers: &[u32]) -> Self {
        let bodies = || numbers.iter().map(|&number| &scene.bodies()[number as usize]);
        let balls: Vec<_> = bodies().map(|body| *scene.ball_around(body)).collect();
        let radii = bodies().map(|body| f64::from(body.placement.place_radius[3]));
        Self {
            alike,
            range: first..first + numbers.len(),
            ball: Capsule::ball_around(&balls),
            hierarchy: hierarchy(scene, extent, numbers),
            largest: balls.iter().map(|ball| ball.radius).fold(0.0, f64::max),
            radii: radii.fold([f64::INFINITY, 0.0], |[low, high], r| [r.min(low), r.max(high)]),
        }
    }

    /// Whether the bodies stand still, are no models and share no end with others: they may be drawn in any
    /// order, and their data never change.
    pub const fn are_simple(&self) -> bool {
        !self.alike.is_special
    }
}

/// Boxes around the bodies with these numbers, of a group of this `extent`.
fn hierarchy(scene: &PreparedScene, extent: &Extent, numbers: &[u32]) -> Hierarchy {
    let bodies = numbers.iter().map(|&number| &scene.bodies()[number as usize]);
    let parts = |body: &PreparedBody| {
        pieces(scene.solid(body.number), scene.capsules(body), body.number as u32, extent)
    };
    Hierarchy::new(bodies.flat_map(parts), extent.middle)
}
