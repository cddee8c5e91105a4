//! How a hierarchy is built: from above, each box divided where that makes looking cheapest.
//!
//! Reference: I. Wald, *On fast construction of SAH-based bounding volume hierarchies* (2007).

use glam::{DVec3, Vec3};
use relativity_core::threads::join;

use super::pieces::Piece;
use super::{Hierarchy, Holds, MOST_WAITING, Node, Pair};

/// Places, along the longest side, at which a division is tried.
const BINS: usize = 16;
/// Fewer than this are built by one thread.
const LEAST_FOR_TWO: usize = 4096;
/// Below this depth boxes are halved by number, so that none is deeper than what may wait.
const DEEPEST_BY_COST: usize = MOST_WAITING - 34;

/// A box, in f32.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: Vec3,
    high: Vec3,
}

impl Hierarchy {
    /// Of these, which are told from `middle`.
    #[must_use]
    pub fn new(pieces: impl IntoIterator<Item = Piece>, middle: DVec3) -> Self {
        let mut leaves: Vec<_> = pieces.into_iter().map(|piece| Node::leaf(&piece, middle)).collect();
        if leaves.is_empty() {
            return Self::default();
        }
        let mut pairs = vec![Pair::default(); leaves.len() - 1];
        let root = build(&mut leaves, 0, 0, &mut pairs);
        Self { root: Some(root), pairs }
    }
}

impl Node {
    /// Of `piece`, rounded outwards.
    fn leaf(piece: &Piece, middle: DVec3) -> Self {
        let [low, high] = piece.corners.map(|corner| corner - middle);
        // More than f32 loses, of it and of the boxes that it is in.
        let room = 1e-6 * low.abs().max(high.abs()).max_element() as f32;
        let bounds = Bounds { low: low.as_vec3() - room, high: high.as_vec3() + room };
        let holds = if piece.is_one_of_some { Holds::Piece } else { Holds::Body };
        bounds.node(piece.body, holds)
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: self.center - self.half, high: self.center + self.half }
    }
}

impl Bounds {
    const NONE: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// A node, of what has this `number`.
    fn node(self, number: u32, holds: Holds) -> Node {
        let (center, half) = (0.5 * (self.low + self.high), 0.5 * (self.high - self.low));
        Node { center, half: half * (1.0 + 1e-6), number, holds }
    }

    /// Half of its surface; none of one that holds nothing.
    fn area(&self) -> f32 {
        let side = (self.high - self.low).max(Vec3::ZERO);
        side.x * side.y + side.y * side.z + side.z * side.x
    }
}

/// A node of all `leaves`, which are put in another order. It takes all of `pairs`, one less, of which the first has this
/// number.
fn build(leaves: &mut [Node], number: u32, depth: usize, pairs: &mut [Pair]) -> Node {
    let Some((pair, pairs)) = pairs.split_first_mut() else { return leaves[0] };
    let around = leaves.iter().fold(Bounds::NONE, |around, leaf| around.joined(leaf.bounds()));
    let count = divided(leaves, depth);
    let (first, second) = leaves.split_at_mut(count);
    let (first_pairs, second_pairs) = pairs.split_at_mut(count - 1);
    let (is_worth_two, depth) = (first.len().min(second.len()) >= LEAST_FOR_TWO, depth + 1);
    let mut first = || build(first, number + 1, depth, first_pairs);
    let mut second = || build(second, number + count as u32, depth, second_pairs);
    let (first, second) = if is_worth_two { join(first, second) } else { (first(), second()) };
    *pair = Pair([first, second]);
    around.node(number, Holds::Pair)
}

/// Puts `leaves` in two halves, and says how many are in the first.
fn divided(leaves: &mut [Node], depth: usize) -> usize {
    let middles = leaves
        .iter()
        .fold(Bounds::NONE, |around, leaf| around.joined(Bounds { low: leaf.center, high: leaf.center }));
    let sides = middles.high - middles.low;
    let axis = sides.max_position();
    let halved = leaves.len() / 2;
    if sides[axis] <= 0.0 || !sides[axis].is_finite() {
        return halved;
    }
    if depth > DEEPEST_BY_COST || leaves.len() <= 4 {
        leaves.select_nth_unstable_by(halved, |a, b| a.center[axis].total_cmp(&b.center[axis]));
        return halved;
    }
    let scale = BINS as f32 * (1.0 - 1e-6) / sides[axis];
    let bin = |leaf: &Node| (((leaf.center[axis] - middles.low[axis]) * scale) as usize).min(BINS - 1);
    let mut bins = [(Bounds::NONE, 0_usize); BINS];
    for leaf in leaves.iter() {
        let (bounds, count) = &mut bins[bin(leaf)];
        *bounds = bounds.joined(leaf.bounds());
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
fn cheapest(bins: &[(Bounds, usize); BINS]) -> usize {
    let mut costs = [0.0; BINS - 1];
    let mut so_far = (Bounds::NONE, 0);
    for (cost, (bounds, count)) in costs.iter_mut().zip(bins) {
        so_far = (so_far.0.joined(*bounds), so_far.1 + count);
        *cost += so_far.0.area() * so_far.1 as f32;
    }
    let mut so_far = (Bounds::NONE, 0);
    for (cost, (bounds, count)) in costs.iter_mut().zip(&bins[1..]).rev() {
        so_far = (so_far.0.joined(*bounds), so_far.1 + count);
        *cost += so_far.0.area() * so_far.1 as f32;
    }
    let cheaper = |best: usize, next: usize| if costs[next] < costs[best] { next } else { best };
    (0..BINS - 1).fold(0, cheaper)
}
