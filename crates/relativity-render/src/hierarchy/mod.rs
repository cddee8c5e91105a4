//! Boxes within boxes around the bodies of a group, in its rest frame.
//!
//! Bodies rest there and rays are straight, so that one hierarchy, built once, serves every speed, time and eye: only the
//! [`Beam`]s differ, which a tile of the picture looks along. A kept crate (`obvhs`) was considered: it knows rays from one
//! place, in f32, where this looks along cones whose tip may be 1e30 away, and the building of it is the shorter part.

mod beam;
mod build;
mod lines;
mod pieces;

use glam::Vec3;

pub use beam::{Beam, Line, Looks};
pub use lines::Lines;
pub use pieces::pieces;

/// Nodes that wait while others are looked into: no hierarchy is as deep.
const MOST_WAITING: usize = 64;

/// Of those bodies of a group that stand still in it.
#[derive(Debug, Default)]
pub struct Hierarchy {
    /// Around all, if there are any.
    root: Option<Node>,
    pairs: Vec<Pair>,
}

/// The two halves of a node, which are looked at together: a line of cache.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(64))]
struct Pair([Node; 2]);

/// A box, counted from the middle of the group.
#[derive(Debug, Clone, Copy, Default)]
struct Node {
    center: Vec3,
    /// Of what it holds.
    number: u32,
    half: Vec3,
    holds: Holds,
}

#[derive(Debug, Clone, Copy, Default)]
enum Holds {
    /// The nodes of a pair.
    #[default]
    Pair,
    Body,
    /// A body of which there is more than one piece.
    Piece,
}

/// What may be met, in its box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// The number of the body.
    pub body: u32,
    /// Whether it may be told a second time.
    pub is_one_of_some: bool,
    /// It is met no nearer than this, beyond the middle of the group.
    pub nearest: f32,
    /// The middle of the box, from that of the group.
    pub center: Vec3,
    /// Half of its sides.
    pub half: Vec3,
}

impl Hierarchy {
    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.root.is_none()
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

    /// Has `visit` told of all that `looks` may meet, about from the nearest to the farthest. What lies farther beyond the
    /// middle of the group than `visit` answers is left out from then on.
    #[inline(always)]
    pub fn along(&self, looks: &impl Looks, mut visit: impl FnMut(Candidate) -> f32) {
        let Some(root) = &self.root else { return };
        let mut waiting = [(root, 0_f32); MOST_WAITING];
        let mut count = 0;
        let mut farthest = f32::INFINITY;
        let around = [root.center, root.half];
        let mut next = looks.nearest([around, around])[0].map(|nearest| (root, nearest));
        loop {
            let (node, nearest) = match next.take() {
                Some(node) => node,
                None if count > 0 => {
                    count -= 1;
                    waiting[count]
                }
                None => return,
            };
            if nearest > farthest {
                continue;
            }
            if !matches!(node.holds, Holds::Pair) {
                let Node { center, half, number, holds } = *node;
                let is_one_of_some = matches!(holds, Holds::Piece);
                farthest = visit(Candidate { body: number, is_one_of_some, nearest, center, half });
                continue;
            }
            let Pair([first, second]) = &self.pairs[node.number as usize];
            let nearest = looks.nearest([[first.center, first.half], [second.center, second.half]]);
            next = match nearest {
                [Some(near), Some(far)] => {
                    let (near, far) = ((first, near), (second, far));
                    let (near, far) = if far.1 < near.1 { (far, near) } else { (near, far) };
                    waiting[count] = far;
                    count += 1;
                    Some(near)
                }
                [Some(near), None] => Some((first, near)),
                [None, Some(near)] => Some((second, near)),
                [None, None] => None,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_is_a_line_of_cache() {
        assert_eq!(size_of::<Pair>(), 64);
    }
}
