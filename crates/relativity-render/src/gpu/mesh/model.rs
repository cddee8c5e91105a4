//! Models as triangles with edges so short that lines may bend between their ends: longer ones are halved.
//!
//! Whether an edge is halved follows from the edge alone, and both triangles at it agree on its middle: so no
//! gap opens between them.

use glam::DVec3;

use crate::geometry::corners::{Corner, Template};
use crate::geometry::triangles::Triangles;

/// Number of edges that make a whole side of the model's box, at least.
const SEGMENTS: f64 = 96.0;
/// Greatest number of triangles that a model is divided into, unless it has more itself: beyond it edges stay
/// longer.
const MOST_TRIANGLES: usize = 2_000_000;

/// Edges that are too long.
struct LongEdges<'a> {
    model: &'a Triangles,
    /// Number of segments along a whole side of the model's box.
    segments: f64,
    /// Triangles that may still be added.
    room: usize,
}

impl Triangles {
    /// Returns the triangles of the model, divided where they are large: their edges are at most
    /// 1/[`SEGMENTS`] of the box's side along any axis, or longer where that would be too many triangles.
    pub(super) fn template(&self) -> Template {
        let (first, order) = self.packed_order();
        let room = MOST_TRIANGLES.saturating_sub(order.len());
        let mut segments = SEGMENTS;
        loop {
            let mut template = Template { corners: Vec::new(), triangles: Vec::new() };
            let mut edges = LongEdges { model: self, segments, room };
            let whole = (first..)
                .zip(&order)
                .all(|(record, &triangle)| edges.add(self.corners_of(triangle), record, &mut template));
            if whole {
                template.triangles = (0..template.corners.len() as u32).collect();
                return template;
            }
            segments *= 0.7;
        }
    }
}

impl LongEdges<'_> {
    /// Adds a triangle, divided; whether there was room for it.
    fn add(&mut self, corners: [DVec3; 3], record: u32, template: &mut Template) -> bool {
        let mut waiting = vec![corners];
        while let Some([a, b, c]) = waiting.pop() {
            let edges = [(a, b, c), (b, c, a), (c, a, b)]
                .map(|edge| (self.segments * self.model.relative_length(edge.1 - edge.0), edge));
            let (length, (from, to, other)) = edges
                .into_iter()
                .fold((0.0, (a, b, c)), |most, edge| if edge.0 > most.0 { edge } else { most });
            if length <= 1.0 {
                template.corners.extend([a, b, c].map(|place| corner(place, record)));
                continue;
            }
            if self.room == 0 {
                return false;
            }
            self.room -= 1;
            let middle = 0.5 * (from + to);
            waiting.extend([[from, middle, other], [middle, to, other]]);
        }
        true
    }
}

/// A corner of the triangle in this record.
fn corner(place: DVec3, record: u32) -> Corner {
    let [x, y, z] = place.as_vec3().to_array();
    Corner { profile: [x, y, z, 0.0], turn: [(record >> 12) as f32, (record & 4095) as f32] }
}
