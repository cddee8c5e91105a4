//! How a hierarchy is built: from above, each box divided where that makes looking cheapest.
//!
//! Reference: I. Wald, *On fast construction of SAH-based bounding volume hierarchies* (2007).

use glam::{DVec3, Vec3};
use relativity_core::threads::join;

use super::pieces::Piece;
use super::{Hierarchy, IN_PIECES, MOST_WAITING, Node};

/// Places, along the longest side, at which a division is tried.
const BINS: usize = 16;
/// So many are not divided any more.
const MOST_IN_LEAF: usize = 1;
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

/// What is divided: a piece, counted from the middle of the group and rounded outwards.
#[derive(Debug, Clone, Copy)]
struct Part {
    bounds: Bounds,
    body: u32,
}

impl Hierarchy {
    /// Of these, which are told from `middle`.
    #[must_use]
    pub fn new(pieces: impl IntoIterator<Item = Piece>, middle: DVec3) -> Self {
        let mut parts: Vec<_> = pieces.into_iter().map(|piece| Part::new(&piece, middle)).collect();
        if parts.is_empty() {
            return Self::default();
        }
        let mut nodes = Vec::new();
        build(&mut parts, 0, 0, &mut nodes);
        Self { nodes, bodies: parts.iter().map(|part| part.body).collect() }
    }
}

impl Part {
    fn new(piece: &Piece, middle: DVec3) -> Self {
        let [low, high] = piece.corners.map(|corner| corner - middle);
        let mark = if piece.is_one_of_some { IN_PIECES } else { 0 };
        // More than f32 loses, of it and of the middle and half of a box.
        let room = 1e-6 * low.abs().max(high.abs()).max_element() as f32;
        let bounds = Bounds { low: low.as_vec3() - room, high: high.as_vec3() + room };
        Self { bounds, body: piece.body | mark }
    }
}

impl Bounds {
    const NONE: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Twice its middle.
    fn sum(&self) -> Vec3 {
        self.low + self.high
    }

    /// Half of its surface; none of one that holds nothing.
    fn area(&self) -> f32 {
        let side = (self.high - self.low).max(Vec3::ZERO);
        side.x * side.y + side.y * side.z + side.z * side.x
    }
}

/// Adds the nodes of `parts`, which are put in the order of the leaves, to `nodes`; they are `first` and the next of all.
fn build(parts: &mut [Part], first: usize, depth: usize, nodes: &mut Vec<Node>) {
    let around = parts.iter().fold(Bounds::NONE, |around, part| around.joined(part.bounds));
    let (center, half) = (0.5 * around.sum(), 0.5 * (around.high - around.low));
    let place = nodes.len();
    nodes.push(Node { center, half: half * (1.0 + 1e-6), start: first as u32, count: parts.len() as u32 });
    if parts.len() <= MOST_IN_LEAF {
        return;
    }
    let count = divided(parts, depth);
    let (left, right) = parts.split_at_mut(count);
    nodes[place].count = 0;
    if left.len().min(right.len()) < LEAST_FOR_TWO {
        build(left, first, depth + 1, nodes);
        nodes[place].start = nodes.len() as u32;
        build(right, first + count, depth + 1, nodes);
        return;
    }
    let built = |parts: &mut [Part], first| {
        let mut nodes = Vec::new();
        build(parts, first, depth + 1, &mut nodes);
        nodes
    };
    let (left, right) = join(|| built(left, first), || built(right, first + count));
    for half in [left, right] {
        let start = nodes.len() as u32;
        nodes[place].start = start;
        nodes.extend(half.into_iter().map(|node| {
            let start = if node.count == 0 { node.start + start } else { node.start };
            Node { start, ..node }
        }));
    }
}

/// Puts `parts` in two halves, and says how many are in the first.
fn divided(parts: &mut [Part], depth: usize) -> usize {
    let middles = parts.iter().fold(Bounds::NONE, |around, part| {
        let middle = part.bounds.sum();
        around.joined(Bounds { low: middle, high: middle })
    });
    let sides = middles.high - middles.low;
    let axis = sides.max_position();
    let halved = parts.len() / 2;
    if sides[axis] <= 0.0 || !sides[axis].is_finite() {
        return halved;
    }
    let by_middle = |a: &Part, b: &Part| a.bounds.sum()[axis].total_cmp(&b.bounds.sum()[axis]);
    if depth > DEEPEST_BY_COST || parts.len() <= 4 {
        parts.select_nth_unstable_by(halved, by_middle);
        return halved;
    }
    let scale = BINS as f32 * (1.0 - 1e-6) / sides[axis];
    let bin = |part: &Part| (((part.bounds.sum()[axis] - middles.low[axis]) * scale) as usize).min(BINS - 1);
    let mut bins = [(Bounds::NONE, 0_usize); BINS];
    for part in parts.iter() {
        let (bounds, count) = &mut bins[bin(part)];
        *bounds = bounds.joined(part.bounds);
        *count += 1;
    }
    let last = cheapest(&bins);
    let mut count = 0;
    for i in 0..parts.len() {
        if bin(&parts[i]) <= last {
            parts.swap(i, count);
            count += 1;
        }
    }
    if count == 0 || count == parts.len() { halved } else { count }
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
