//! Boxes within boxes around the bodies of a group, in its rest frame.
//!
//! Bodies rest there and rays are straight, so that one hierarchy, built once, serves every speed, time and eye: only the
//! [`Beam`]s differ, which a tile of the picture looks along. A kept crate (`obvhs`) was considered: it knows rays from one
//! place, in f32, where this looks along cones whose tip may be 1e30 away, and the building of it is the shorter part.

mod beam;
mod build;
mod pieces;

use glam::Vec3;

pub use beam::{Beam, Line, Looks};
pub use pieces::pieces;

/// Marks a body in [`Hierarchy::bodies`] of which there is more than one piece.
const IN_PIECES: u32 = 1 << 31;
/// Nodes that wait while others are looked into: no hierarchy is as deep.
const MOST_WAITING: usize = 64;

/// Of those bodies of a group that stand still in it.
#[derive(Debug, Default)]
pub struct Hierarchy {
    /// The first is around all. The children of a node are the next one and that at `start`.
    nodes: Vec<Node>,
    /// The numbers of the bodies in the leaves, in their order.
    bodies: Vec<u32>,
}

/// A box, counted from the middle of the group: of two nodes, or of `count` bodies from `start` on.
#[derive(Debug, Clone, Copy, Default)]
struct Node {
    center: Vec3,
    start: u32,
    half: Vec3,
    count: u32,
}

/// What a beam may meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// The number of the body.
    pub body: u32,
    /// Whether it may be told a second time.
    pub is_one_of_some: bool,
    /// It is met no nearer than this, beyond the middle of the group.
    pub nearest: f32,
}

impl Hierarchy {
    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
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
    pub fn along(&self, looks: &impl Looks, mut visit: impl FnMut(Candidate) -> f32) {
        let Some(root) = self.nodes.first() else { return };
        let mut waiting = [(0_u32, 0_f32); MOST_WAITING];
        let mut count = 0;
        let mut farthest = f32::INFINITY;
        let mut next = looks.nearest(root.center, root.half).map(|nearest| (0, nearest));
        loop {
            let (number, nearest) = match next.take() {
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
            let node = &self.nodes[number as usize];
            if node.count > 0 {
                for &body in &self.bodies[node.start as usize..(node.start + node.count) as usize] {
                    let is_one_of_some = body & IN_PIECES != 0;
                    farthest = visit(Candidate { body: body & !IN_PIECES, is_one_of_some, nearest });
                }
                continue;
            }
            let child = |number: u32| {
                let child = &self.nodes[number as usize];
                Some((number, looks.nearest(child.center, child.half)?))
            };
            let children = [child(number + 1), child(node.start)];
            let (near, far) = match children {
                [Some(first), Some(second)] if second.1 < first.1 => (Some(second), Some(first)),
                [first, second] => (first.or(second), first.and(second)),
            };
            next = near;
            if let Some(far) = far {
                waiting[count] = far;
                count += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_is_half_a_line_of_cache() {
        assert_eq!(size_of::<Node>(), 32);
    }
}
