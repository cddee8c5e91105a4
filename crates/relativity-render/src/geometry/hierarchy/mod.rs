//! Boxes within boxes around the bodies of a group, in its rest frame.
//!
//! Bodies rest there and rays are straight, so that one hierarchy, built once, serves every speed, time and
//! eye: only the [`Beam`]s differ, which a tile of the picture looks along. A kept crate (`obvhs`) was
//! considered: it knows rays from one place, in f32, where this looks along cones whose tip may be 1e30 away,
//! and the building of it is the shorter part.

mod beam;
mod boxes;
mod build;
mod lines;
mod pieces;
mod slabs;
#[cfg(test)]
mod testing;

use fearless_simd::{Level, dispatch};
use glam::Vec3;

pub use beam::{Beam, BeamLine, Looks};
pub use lines::RayBundle;
pub use pieces::{BodyPart, pieces};
pub use slabs::Slabs;

use self::boxes::{Boxes, WIDTH};
use crate::simd::lanes::{Simd, SimdFloat, bits};

/// A hierarchy is no deeper.
const DEEPEST: usize = 62;
/// Greatest number of boxes that wait, in order, while the nearest of them is looked into.
const MOST_IN_ORDER: usize = 64;
/// Boxes that wait while others are looked into.
const MOST_WAITING: usize = MOST_IN_ORDER + WIDTH + DEEPEST * (WIDTH - 1);

/// The hierarchy of those bodies of a group that stand still in it.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Hierarchy {
    /// The first of them is around all, if there are any.
    nodes: Vec<Node>,
}

/// A node: its child boxes and what each holds, aligned to lines of the cache.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(align(64))]
struct Node {
    boxes: Boxes,
    /// Numbers of what is in each box.
    numbers: [u32; WIDTH],
    holds: [Holds; WIDTH],
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum Holds {
    Nothing,
    /// Boxes, which are a node.
    Node,
    Body,
    /// A body of which there is more than one piece.
    Piece,
}

/// A box of a node, and what is in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Child {
    /// The middle of the box, from that of the group.
    pub centre: Vec3,
    /// Half of its sides.
    pub half: Vec3,
    /// The node or the body in it.
    pub content: Content,
}

/// The contents of a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Content {
    /// The node of this number.
    Node(usize),
    /// The body of this number, or a piece of it.
    Body(u32),
}

/// A candidate: a body that may be met, in its box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// The number of the body.
    pub body: u32,
    /// Whether the body may be reported a second time.
    pub is_one_of_some: bool,
    /// Least distance at which it is met, beyond the middle of the group.
    pub nearest: f32,
    /// The middle of the box, from that of the group.
    pub centre: Vec3,
    /// Half of its sides.
    pub half: Vec3,
}

impl Hierarchy {
    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The numbers of the bodies in each node, neighbours; one of several pieces more than once.
    pub fn bodies_by_node(&self) -> impl Iterator<Item = impl Iterator<Item = u32>> {
        let are_bodies = |holds| matches!(holds, Holds::Body | Holds::Piece);
        let in_node = move |node: &Node| {
            let lanes = node.numbers.into_iter().zip(node.holds);
            lanes.filter(move |(_, holds)| are_bodies(*holds)).map(|(number, _)| number)
        };
        self.nodes.iter().map(in_node)
    }

    /// The boxes in the node of this number; the first is around all.
    pub fn children(&self, node: usize) -> impl Iterator<Item = Child> {
        let node = &self.nodes[node];
        (0..WIDTH).filter_map(|lane| {
            let content = match node.holds[lane] {
                Holds::Nothing => return None,
                Holds::Node => Content::Node(node.numbers[lane] as usize),
                Holds::Body | Holds::Piece => Content::Body(node.numbers[lane]),
            };
            let Candidate { centre, half, .. } = node.candidate(lane, 0.0);
            Some(Child { centre, half, content })
        })
    }

    /// Whether `beam` may meet anything.
    pub fn is_met(&self, beam: &Beam) -> bool {
        let mut is_met = false;
        self.along(beam, |_| {
            is_met = true;
            f32::NEG_INFINITY
        });
        is_met
    }

    /// Calls `visit` with every candidate of `looks`, roughly from the nearest to the farthest. From then on
    /// it leaves out candidates that are no nearer, beyond the middle of the group, than the distance `visit`
    /// returns.
    pub fn along(&self, looks: &impl Looks, visit: impl FnMut(Candidate) -> f32) {
        dispatch!(Level::new(), simd => self.along_on(simd, looks, visit));
    }

    /// Adds the numbers of all candidates of `looks` to `out`, some more than once.
    pub fn add_along(&self, looks: &impl Looks, out: &mut Vec<u32>) {
        self.along(looks, |candidate| {
            out.push(candidate.body);
            f32::INFINITY
        });
    }

    /// Visits candidates as [`Self::along`] does, where the registers `simd` are in use already.
    #[inline(always)]
    pub fn along_on<S: Simd, L: Looks>(&self, simd: S, looks: &L, mut visit: impl FnMut(Candidate) -> f32) {
        if self.nodes.is_empty() {
            return;
        }
        let mut waiting = [(0_u32, 0_f32); MOST_WAITING];
        let mut count = 0;
        let mut farthest = f32::INFINITY;
        let mut number = 0;
        loop {
            let nearest = looks.nearest(simd, &self.nodes[number as usize].boxes);
            let mut met = bits(nearest.simd_lt(farthest));
            let nearest: [f32; WIDTH] = nearest.into();
            // Among a few, the nearest of all is next; among many, the nearest in the last node.
            let first = if L::IS_IN_ORDER && count <= MOST_IN_ORDER { 0 } else { count };
            while met != 0 {
                let lane = met.trailing_zeros() as usize % WIDTH;
                met &= met - 1;
                // The nearest of them last.
                let mut place = count;
                while place > first && waiting[place - 1].1 < nearest[lane] {
                    waiting[place] = waiting[place - 1];
                    place -= 1;
                }
                waiting[place] = (number * WIDTH as u32 + lane as u32, nearest[lane]);
                count += 1;
            }
            loop {
                if count == 0 {
                    return;
                }
                count -= 1;
                let (place, nearest) = waiting[count];
                if nearest >= farthest {
                    continue;
                }
                let (node, lane) = (&self.nodes[place as usize / WIDTH], place as usize % WIDTH);
                if node.holds[lane] == Holds::Node {
                    number = node.numbers[lane];
                    break;
                }
                farthest = visit(node.candidate(lane, nearest));
            }
        }
    }
}

impl Node {
    fn candidate(&self, lane: usize, nearest: f32) -> Candidate {
        Candidate {
            body: self.numbers[lane],
            is_one_of_some: self.holds[lane] == Holds::Piece,
            nearest,
            centre: self.boxes.centre.map(|part| part[lane]).into(),
            half: self.boxes.half.map(|part| part[lane]).into(),
        }
    }
}
