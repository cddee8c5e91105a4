//! The edges that a model is drawn with as lines: its sharp ones, and those where it turns away from whoever
//! looks.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use glam::{DVec3, Vec3};

use crate::geometry::shape::strokes::Onlooker;

/// Greatest number of triangles whose own edges are drawn. Of a larger model the corners in a cell of a grid
/// count as one of them.
const MOST_TRIANGLES: usize = 5_000;
/// Cells of that grid along the longest side of the box around the model: lines are off by up to so small a
/// part of it.
const CELLS: f64 = 40.0;
/// Cells in each of which all places are the same.
const SAME: f64 = 1e6;
/// Greatest number of sharp edges that are drawn, and of those where the model turns away; the longest.
const MOST_EDGES: usize = 240;
/// The cosine of the least angle between two triangles whose edge is sharp, 37 degrees; and of the greatest
/// of those that lie in one plane.
const SHARP: f64 = 0.8;
const FLAT: f64 = 0.999_999;

/// An edge of triangles, from the middle of their box and along its axes.
#[derive(Debug, Clone, Copy)]
struct Edge {
    ends: [DVec3; 2],
    /// The normals of both triangles, on one side of the surface; none of a sharp edge.
    bend: Option<[DVec3; 2]>,
}

/// The edges of a model, the longest first.
#[derive(Debug, Default)]
pub struct Edges(Vec<Edge>);

impl Edges {
    /// The ends of the sharp edges, from the middle of the box; at most 240, the longest.
    pub fn sharp(&self) -> impl Iterator<Item = [DVec3; 2]> {
        self.0.iter().filter(|edge| edge.bend.is_none()).map(|edge| edge.ends).take(MOST_EDGES)
    }

    /// Returns the ends of the edges where the surface turns away from `onlooker`, from the middle of the
    /// box; at most 240, the longest, and none of the sharp ones.
    pub fn turning(&self, onlooker: Onlooker) -> impl Iterator<Item = [DVec3; 2]> {
        let turns_away = move |edge: &&Edge| {
            let direction = onlooker.line_of_sight(edge.ends[0]);
            edge.bend.is_some_and(|[one, other]| one.dot(direction) * other.dot(direction) < 0.0)
        };
        self.0.iter().filter(turns_away).map(|edge| edge.ends).take(MOST_EDGES)
    }

    /// Finds the edges of the triangles with these `corners` by number, in a box whose longest side is
    /// `size`.
    pub fn new(corners: &[Vec3], faces: &[[u32; 3]], size: f64) -> Self {
        let place = |corner: u32| corners[corner as usize].as_dvec3();
        let stands_for = joined(corners, size / if faces.len() > MOST_TRIANGLES { CELLS } else { SAME });
        let mut found: HashMap<[u32; 2], EdgeTriangles> = HashMap::new();
        for face in faces {
            let [a, b, c] = face.map(|corner| stands_for[corner as usize]);
            // Most triangles of a large model are within a cell.
            if a == b && b == c {
                continue;
            }
            let [place_a, place_b, place_c] = face.map(place);
            let Some(normal) = (place_b - place_a).cross(place_c - place_a).try_normalize() else { continue };
            for [from, to] in [[a, b], [b, c], [c, a]].into_iter().filter(|[from, to]| from != to) {
                let met = EdgeTriangles { normal, is_forward: from < to, other: None };
                match found.entry([from.min(to), from.max(to)]) {
                    Entry::Vacant(place) => {
                        place.insert(met);
                    }
                    Entry::Occupied(mut first) => first.get_mut().meet(&met),
                }
            }
        }
        let length = |edge: &Edge| (edge.ends[1] - edge.ends[0]).length_squared();
        // Hashing has no order: edges of one length stand in that of their corners.
        let mut found: Vec<_> = found.into_iter().collect();
        found.sort_unstable_by_key(|(ends, _)| *ends);
        let mut edges: Vec<_> =
            found.into_iter().filter_map(|(ends, met)| met.edge(ends.map(place))).collect();
        edges.sort_by(|a, b| length(b).total_cmp(&length(a)));
        Self(edges)
    }
}

/// The triangles that meet in an edge.
#[derive(Debug, Clone, Copy)]
struct EdgeTriangles {
    /// Normal of the first.
    normal: DVec3,
    /// Whether the first runs along the edge from its lower corner to its higher.
    is_forward: bool,
    /// The normal of the second, on the same side of the surface.
    other: Option<DVec3>,
}

impl EdgeTriangles {
    /// Adds another triangle. Of more than two the one that is bent most against the first counts.
    fn meet(&mut self, next: &Self) {
        // Neighbours run against each other along their edge, unless one is turned inside out.
        let is_inside_out = self.is_forward == next.is_forward && self.normal.dot(next.normal) < 0.0;
        let normal = if is_inside_out { -next.normal } else { next.normal };
        let is_bent_more = |other: DVec3| self.normal.dot(normal) < self.normal.dot(other);
        if self.other.is_none_or(is_bent_more) {
            self.other = Some(normal);
        }
    }

    /// The edge that is drawn between these `ends`, if any.
    fn edge(self, ends: [DVec3; 2]) -> Option<Edge> {
        let bend = match self.other {
            Some(other) if self.normal.dot(other) > FLAT => return None,
            Some(other) if self.normal.dot(other) > SHARP => Some([self.normal, other]),
            _ => None,
        };
        Some(Edge { ends, bend })
    }
}

/// Returns, for each corner, the first corner in the same cell of a grid of this step. A fine grid joins the
/// corners that a file has several times in one place; a coarse one makes a coarser model.
fn joined(corners: &[Vec3], step: f64) -> Vec<u32> {
    let mut first = HashMap::new();
    let cell = |corner: &Vec3| (corner.as_dvec3() / step).round().as_i64vec3();
    let numbered = corners.iter().zip(0u32..);
    numbered.map(|(corner, number)| *first.entry(cell(corner)).or_insert(number)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edges(corners: &[[f64; 3]], triangles: &[[u32; 3]]) -> Edges {
        let corners: Vec<_> = corners.iter().map(|&corner| DVec3::from(corner).as_vec3()).collect();
        Edges::new(&corners, triangles, 2.0)
    }

    /// A box whose six sides share no corners, as in a file with a normal at each.
    fn crate_edges() -> Edges {
        let corner =
            |i: u32| [0, 1, 2].map(|bit: u32| if i >> bit & 1 == 0 { -1.0 } else { 1.0 + f64::from(bit) });
        let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let corners: Vec<_> = sides.iter().flatten().map(|&i| corner(i)).collect();
        let triangles =
            (0..6u32).flat_map(|side| [[0, 1, 2], [0, 2, 3]].map(|face| face.map(|i| 4 * side + i)));
        edges(&corners, &triangles.collect::<Vec<_>>())
    }

    #[test]
    fn a_box_is_drawn_with_its_twelve_edges() {
        let found = crate_edges();
        let edges: Vec<_> = found.sharp().collect();
        assert_eq!(edges.len(), 12);
        for [from, to] in edges {
            // An edge of a box runs along one axis; a diagonal would run along two.
            assert_eq!((to - from).abs().to_array().iter().filter(|part| **part > 0.0).count(), 1);
        }
        assert_eq!(found.turning(Onlooker::Afar(DVec3::new(0.3, 0.5, 0.8))).count(), 0);
    }
}
