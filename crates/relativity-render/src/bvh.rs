//! A tree of boxes over the bodies, so that a ray meets few of them.
//!
//! Built over rest-frame boxes, where the bodies never move: one tree serves every view, speed and time.
//! Reference: I. Wald, *On fast construction of SAH-based bounding volume hierarchies* (2007); the split
//! here is the plain median, which measured as fast on these scenes.

use glam::DVec3;

use crate::intersect::{Entry, Solid};

/// Bodies per leaf at most.
const LEAF_SIZE: usize = 2;
/// Depth of the traversal's stack; a median tree of 2^32 bodies stays below it.
const STACK_SIZE: usize = 40;
/// Rounding of a slab distance: three operations, so three units in the last place, doubled.
const SLAB_SLACK: f64 = 1.0 + 6.0 * f64::EPSILON;

/// The tree. Solids are kept in the tree's order, with their numbers.
#[derive(Debug, Clone)]
pub struct Bvh {
    nodes: Vec<Node>,
    solids: Vec<(usize, Solid)>,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    low: DVec3,
    high: DVec3,
    content: Content,
}

#[derive(Debug, Clone, Copy)]
enum Content {
    /// Range of `solids`.
    Leaf { first: u32, end: u32 },
    /// The first child follows its parent.
    Branch { second: u32 },
}

/// A ray with what every box test needs of it.
struct BoxRay {
    origin: DVec3,
    direction: DVec3,
    inverse_direction: DVec3,
}

impl Bvh {
    /// The tree over `solids`, numbered from 0.
    #[must_use]
    pub fn new(solids: impl IntoIterator<Item = Solid>) -> Self {
        let mut tree = Self { nodes: Vec::new(), solids: solids.into_iter().enumerate().collect() };
        if !tree.solids.is_empty() {
            tree.build(0, tree.solids.len());
        }
        tree
    }

    fn build(&mut self, first: usize, end: usize) {
        let solids = &mut self.solids[first..end];
        let [low, high] = bounds(solids.iter().map(|(_, solid)| solid.bounds()));
        let node = self.nodes.len();
        let content = Content::Leaf { first: first as u32, end: end as u32 };
        self.nodes.push(Node { low, high, content });
        if solids.len() <= LEAF_SIZE {
            return;
        }
        let [low, high] = bounds(solids.iter().map(|(_, solid)| [solid.center(); 2]));
        let axis = (high - low).max_position();
        let half = solids.len() / 2;
        solids.select_nth_unstable_by(half, |a, b| a.1.center()[axis].total_cmp(&b.1.center()[axis]));
        self.build(first, first + half);
        self.nodes[node].content = Content::Branch { second: self.nodes.len() as u32 };
        self.build(first + half, end);
    }

    /// The nearest entry of the ray from `origin` along the unit vector `direction`, with the number of
    /// its body; of equally near ones the lowest number.
    #[must_use]
    pub fn nearest_entry(&self, origin: DVec3, direction: DVec3) -> Option<(usize, Entry)> {
        let ray = BoxRay { origin, direction, inverse_direction: direction.recip() };
        let root = self.nodes.first()?;
        let mut nearest = None;
        let mut pending = [(0, ray.distance(root)?); STACK_SIZE];
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (node, start) = pending[count];
            if start > reach(nearest.as_ref()) {
                continue;
            }
            match self.nodes[node].content {
                Content::Leaf { first, end } => {
                    nearest = ray.nearest(nearest, &self.solids[first as usize..end as usize]);
                }
                Content::Branch { second } => {
                    for child in ray.far_to_near([node + 1, second as usize], &self.nodes) {
                        pending[count] = child;
                        count += usize::from(child.1.is_finite());
                    }
                }
            }
        }
        nearest
    }
}

/// Boxes that start beyond this hold nothing nearer.
fn reach(nearest: Option<&(usize, Entry)>) -> f64 {
    nearest.map_or(f64::INFINITY, |(_, entry)| entry.distance * SLAB_SLACK)
}

impl BoxRay {
    /// The nearer of `nearest` and the entries into `solids`.
    fn nearest(&self, nearest: Option<(usize, Entry)>, solids: &[(usize, Solid)]) -> Option<(usize, Entry)> {
        solids.iter().fold(nearest, |nearest, &(body, solid)| {
            let Some(entry) = solid.entry(self.origin, self.direction) else { return nearest };
            let nearer = nearest.is_none_or(|(other, e)| (entry.distance, body) < (e.distance, other));
            if nearer { Some((body, entry)) } else { nearest }
        })
    }

    /// Distance at which the ray enters the box of `node`, `None` if it misses it.
    fn distance(&self, node: &Node) -> Option<f64> {
        let a = (node.low - self.origin) * self.inverse_direction;
        let b = (node.high - self.origin) * self.inverse_direction;
        let enter = a.min(b).max_element().max(0.0);
        let leave = a.max(b).min_element();
        (enter <= leave * SLAB_SLACK).then_some(enter)
    }

    /// The two nodes with their distances, the nearer one last; missed ones are at infinity.
    fn far_to_near(&self, nodes: [usize; 2], all: &[Node]) -> [(usize, f64); 2] {
        let [a, b] = nodes.map(|node| (node, self.distance(&all[node]).unwrap_or(f64::INFINITY)));
        if a.1 < b.1 { [b, a] } else { [a, b] }
    }
}

/// The box around all `boxes`.
fn bounds(boxes: impl Iterator<Item = [DVec3; 2]>) -> [DVec3; 2] {
    let nothing = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    boxes.fold(nothing, |[low, high], [l, h]| [low.min(l), high.max(h)])
}
