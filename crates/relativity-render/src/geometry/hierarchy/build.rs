//! Construction of a hierarchy: from above, each box divided where that makes searching cheapest.
//!
//! Reference: I. Wald, *On fast construction of SAH-based bounding volume hierarchies* (2007).

use glam::{DVec3, Vec3};
use relativity_core::threads::prelude::*;

use super::beam::ROUNDING;
use super::boxes::{Boxes, WIDTH};
use super::pieces::BodyPart;
use super::{DEEPEST, Hierarchy, Holds, Node};

/// Places, along the longest side, at which a division is tried.
const BINS: usize = 16;
/// Fewer than this are built by one thread.
const LEAST_FOR_TWO: usize = 4096;
/// Below this depth boxes are halved by number, so that none is deeper than what may wait.
const DEEPEST_BY_COST: usize = DEEPEST - 32;

/// A box, in f32.
#[derive(Debug, Clone, Copy)]
struct BoundingBox {
    low: Vec3,
    high: Vec3,
}

/// A box of what is not divided further.
#[derive(Debug, Clone, Copy)]
struct Leaf {
    bounds: BoundingBox,
    number: u32,
    holds: Holds,
}

/// Some of the leaves, in a box.
struct LeafGroup<'a> {
    leaves: &'a mut [Leaf],
    bounds: BoundingBox,
    /// Number of divisions above this one.
    depth: usize,
}

impl Hierarchy {
    /// Returns the hierarchy of these pieces, measured from `middle`.
    #[must_use]
    pub fn new(pieces: impl IntoIterator<Item = BodyPart>, middle: DVec3) -> Self {
        let mut leaves: Vec<_> = pieces.into_iter().map(|piece| Leaf::new(&piece, middle)).collect();
        let mut nodes = Vec::with_capacity(leaves.len() / 3);
        if !leaves.is_empty() {
            LeafGroup::new(&mut leaves, 0).build(&mut nodes);
        }
        Self { nodes }
    }
}

impl Leaf {
    /// Returns the leaf of `piece`, rounded outwards.
    fn new(piece: &BodyPart, middle: DVec3) -> Self {
        let [low, high] = piece.corners.map(|corner| corner - middle);
        // More than f32 loses, of it and of the boxes that it is in.
        let room = 1e-6 * low.abs().max(high.abs()).max_element() as f32;
        let bounds = BoundingBox { low: low.as_vec3() - room, high: high.as_vec3() + room };
        let holds = if piece.is_one_of_some { Holds::Piece } else { Holds::Body };
        Self { bounds, number: piece.body, holds }
    }

    fn middle(&self) -> Vec3 {
        0.5 * (self.bounds.low + self.bounds.high)
    }
}

impl<'a> LeafGroup<'a> {
    fn new(leaves: &'a mut [Leaf], depth: usize) -> Self {
        let bounds = leaves.iter().fold(BoundingBox::NONE, |around, leaf| around.joined(leaf.bounds));
        Self { leaves, bounds, depth }
    }

    fn halves(self) -> [Self; 2] {
        let count = divided(self.leaves, self.depth);
        let (first, second) = self.leaves.split_at_mut(count);
        [first, second].map(|half| Self::new(half, self.depth + 1))
    }

    /// Itself in as many as there are boxes in a node: in halves, and ever again the one that holds the most;
    /// what fits into a node stays together.
    fn parts(self) -> Vec<Self> {
        if self.leaves.len() <= WIDTH {
            return self.leaves.chunks_mut(1).map(|leaf| Self::new(leaf, self.depth + 1)).collect();
        }
        let mut parts = vec![self];
        while parts.len() < WIDTH {
            let count = |part: &usize| parts[*part].leaves.len();
            let Some(largest) = (0..parts.len()).max_by_key(count).filter(|part| count(part) > WIDTH) else {
                break;
            };
            let largest = parts.swap_remove(largest);
            parts.extend(largest.halves());
        }
        parts
    }

    /// Adds its node, and the nodes in that.
    fn build(self, nodes: &mut Vec<Node>) {
        let is_worth_two = self.leaves.len() >= LEAST_FOR_TWO;
        let place = nodes.len();
        nodes.push(Node::EMPTY);
        let mut inner = Vec::new();
        for (lane, part) in self.parts().into_iter().enumerate() {
            nodes[place].put(lane, &part);
            if part.leaves.len() > 1 {
                inner.push((lane, part));
            }
        }
        if is_worth_two {
            let built = inner.into_par_iter().map(|(lane, part)| {
                let mut own = Vec::new();
                part.build(&mut own);
                (lane, own)
            });
            for (lane, own) in built.collect::<Vec<_>>() {
                let first = nodes.len() as u32;
                nodes[place].numbers[lane] = first;
                nodes.extend(own.into_iter().map(|node| node.after(first)));
            }
            return;
        }
        for (lane, part) in inner {
            nodes[place].numbers[lane] = nodes.len() as u32;
            part.build(nodes);
        }
    }
}

impl Node {
    const EMPTY: Self = Self {
        boxes: Boxes { centre: [[0.0; WIDTH]; 3], half: [[f32::NEG_INFINITY; WIDTH]; 3] },
        numbers: [0; WIDTH],
        holds: [Holds::Nothing; WIDTH],
    };

    /// Puts the box of `part` here, and what that holds if it is a leaf.
    fn put(&mut self, lane: usize, part: &LeafGroup<'_>) {
        let BoundingBox { low, high } = part.bounds;
        let centre = 0.5 * (low + high);
        let half = 0.5 * (high - low) * (1.0 + 1e-6) + ROUNDING * centre.abs();
        for axis in 0..3 {
            self.boxes.centre[axis][lane] = centre[axis];
            self.boxes.half[axis][lane] = half[axis];
        }
        (self.numbers[lane], self.holds[lane]) = match &*part.leaves {
            [Leaf { number, holds, .. }] => (*number, *holds),
            _ => (0, Holds::Node),
        };
    }

    /// Returns the node with the numbers that it has once `count` nodes stand before its own.
    fn after(mut self, count: u32) -> Self {
        for (number, holds) in self.numbers.iter_mut().zip(self.holds) {
            if holds == Holds::Node {
                *number += count;
            }
        }
        self
    }
}

impl BoundingBox {
    const NONE: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Half of its surface; none of one that holds nothing.
    fn area(&self) -> f32 {
        let side = (self.high - self.low).max(Vec3::ZERO);
        side.x * side.y + side.y * side.z + side.z * side.x
    }
}

/// Sorts `leaves` into two halves, and returns the length of the first.
fn divided(leaves: &mut [Leaf], depth: usize) -> usize {
    let middles = leaves.iter().fold(BoundingBox::NONE, |around, leaf| {
        around.joined(BoundingBox { low: leaf.middle(), high: leaf.middle() })
    });
    let sides = middles.high - middles.low;
    let axis = sides.max_position();
    let halved = leaves.len() / 2;
    if sides[axis] <= 0.0 || !sides[axis].is_finite() {
        return halved;
    }
    if depth > DEEPEST_BY_COST {
        leaves.select_nth_unstable_by(halved, |a, b| a.middle()[axis].total_cmp(&b.middle()[axis]));
        return halved;
    }
    let scale = BINS as f32 * (1.0 - 1e-6) / sides[axis];
    let bin = |leaf: &Leaf| (((leaf.middle()[axis] - middles.low[axis]) * scale) as usize).min(BINS - 1);
    let mut bins = [(BoundingBox::NONE, 0_usize); BINS];
    for leaf in leaves.iter() {
        let (bounds, count) = &mut bins[bin(leaf)];
        *bounds = bounds.joined(leaf.bounds);
        *count += 1;
    }
    let last = cheapest(&bins);
    let mut count = 0;
    for i in 0..leaves.len() {
        if bin(&leaves[i]) <= last {
            leaves.swap(i, count);
            count += 1;
        }
    }
    if count == 0 || count == leaves.len() { halved } else { count }
}

/// The last bin of the first half where the sum of surfaces, each times how many are in it, is least.
fn cheapest(bins: &[(BoundingBox, usize); BINS]) -> usize {
    let mut costs = [0.0; BINS - 1];
    let mut so_far = (BoundingBox::NONE, 0);
    for (cost, (bounds, count)) in costs.iter_mut().zip(bins) {
        so_far = (so_far.0.joined(*bounds), so_far.1 + count);
        *cost += so_far.0.area() * so_far.1 as f32;
    }
    let mut so_far = (BoundingBox::NONE, 0);
    for (cost, (bounds, count)) in costs.iter_mut().zip(&bins[1..]).rev() {
        so_far = (so_far.0.joined(*bounds), so_far.1 + count);
        *cost += so_far.0.area() * so_far.1 as f32;
    }
    let cheaper = |best: usize, next: usize| if costs[next] < costs[best] { next } else { best };
    (0..BINS - 1).fold(0, cheaper)
}

#[cfg(test)]
mod tests {
    use super::super::BeamLine;
    use super::*;
    use crate::geometry::ray::Ray;

    /// Returns the number of times that each of `bodies` is reported to a ray along x, which meets all: boxes
    /// around places there, of this size.
    fn told(bodies: &[(f64, f64)]) -> Vec<u32> {
        let pieces = bodies.iter().zip(0..).map(|(&(x, half), body)| {
            let corners = [-half, half].map(|off| DVec3::new(x + off, off, off));
            BodyPart { body, is_one_of_some: false, corners }
        });
        let hierarchy = Hierarchy::new(pieces, DVec3::ZERO);
        let ray = Ray::new(DVec3::X * -10.0, DVec3::X).counted_from(DVec3::ZERO);
        let mut told = vec![0; bodies.len()];
        hierarchy.along(&BeamLine::new(&ray, DVec3::ZERO), |candidate| {
            told[candidate.body as usize] += 1;
            f32::INFINITY
        });
        told
    }

    #[test]
    fn however_bodies_lie_each_is_told_once() {
        let in_one_place = vec![(1.0, 0.1); 20_000];
        let in_a_row: Vec<_> = (0..20_000).map(|i| (f64::from(i % 141) * 0.1, 0.04)).collect();
        // Each half as far as the one before: a division by cost leaves out one at a time.
        let towards_a_point: Vec<_> =
            (0..120).map(|i| f64::from(-i).exp2()).map(|x| (x, 0.2 * x)).cycle().take(9000).collect();
        for bodies in [&in_one_place, &in_a_row, &towards_a_point] {
            for count in [1, 2, 7, 8, 9, 17, 64, 65, 1000, bodies.len()] {
                assert_eq!(told(&bodies[..count]), vec![1; count]);
            }
        }
        assert!(told(&[]).is_empty());
    }
}
