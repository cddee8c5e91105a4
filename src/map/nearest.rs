//! The nearest outline under the pointer.

use glam::DVec3;

use super::lines::{OutlineLine, OutlineLines, Vertex};
use super::{Chart, MapProjection};

/// A point of a body's outline that is near the pointer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest<'a> {
    /// Outline that is nearest.
    pub line: &'a OutlineLine,
    /// Nearest place on it: in the middle of its thickness.
    pub vertex: Vertex,
    /// Place on the body's surface, in front of that on the side of the eyes; in the scene's coordinates, at
    /// rest, or at t' = 0 if it turns.
    pub surface: DVec3,
}

impl OutlineLines {
    /// The point of the outlines nearest to `pointer`, a place on screen, unless it is further than `reach`
    /// points from all of them; of equally near ones that drawn last.
    #[must_use]
    pub fn nearest(
        &self,
        (projection, chart): (MapProjection, &Chart),
        pointer: [f64; 2],
        reach: f64,
    ) -> Option<Nearest<'_>> {
        let mut least = reach;
        let mut nearest = None;
        for line in self.all.iter().filter(|line| line.is_in(projection)) {
            for pair in self.vertices(line).windows(2) {
                let ends = [pair[0], pair[1]].map(|end| projection.flat(end.place));
                let [from, to] = ends.map(|end| chart.screen(end));
                let (part, distance) = along(from, to, pointer);
                let distance = (distance - line.half_width(projection, ends) * chart.scale).max(0.0);
                if distance <= least {
                    least = distance;
                    nearest = Some((line, [pair[0], pair[1]], part));
                }
            }
        }
        nearest.map(|(line, ends, part)| Nearest::new(line, ends, part))
    }
}

impl<'a> Nearest<'a> {
    fn new(line: &'a OutlineLine, [from, to]: [Vertex; 2], part: f64) -> Self {
        let vertex = Vertex { rest: from.rest.lerp(to.rest, part), place: from.place.lerp(to.place, part) };
        let along = (to.rest - from.rest).try_normalize();
        let outwards = along.and_then(|along| DVec3::NEG_Y.reject_from_normalized(along).try_normalize());
        let radius = line.ball.map_or(0.0, |ball| ball.radius);
        let surface = vertex.rest + radius * outwards.unwrap_or(DVec3::Z);
        Self { line, vertex, surface }
    }
}

/// Returns the fraction of the way from `from` to `to` that is nearest to `place`, and its distance.
#[must_use]
pub fn along(from: [f64; 2], to: [f64; 2], place: [f64; 2]) -> (f64, f64) {
    let [way, here] = [to, place].map(|end| glam::DVec2::from(end) - glam::DVec2::from(from));
    let length = way.length_squared();
    let part = if length > 0.0 { (here.dot(way) / length).clamp(0.0, 1.0) } else { 0.0 };
    (part, (here - part * way).length())
}
