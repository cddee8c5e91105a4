//! The outlines of bodies at rest as the map draws them.

use glam::{DQuat, DVec3};
use relativity_render::shape::strokes::{Path, Stroke};
use relativity_render::{Body, Shape, Triangles};

use super::MapProjection;

/// The outline of `body`, with the only projection that each part is drawn in, if not in both; `line_of_sight` is the
/// direction of the body at a place, at rest, that a projection looks along.
pub(super) fn outline(
    body: &Body,
    line_of_sight: impl Fn(DVec3, MapProjection) -> DVec3,
) -> Vec<(Stroke, Option<MapProjection>)> {
    if let Some((model, at_rest)) = model_of(body) {
        let sharp = model.sharp_edges().map(|ends| (at_rest.edge(ends), None));
        if body.spin.is_some() {
            // The edges turn, and the cylinder in which they do.
            return body.outline().strokes().into_iter().map(|stroke| (stroke, None)).chain(sharp).collect();
        }
        // Where it turns away depends on who looks; in the middle they look as they do everywhere, nearly.
        let turning = MapProjection::BOTH.into_iter().flat_map(|projection| {
            let direction = at_rest.turn.inverse() * line_of_sight(at_rest.middle, projection);
            model.turning_edges(direction).map(move |ends| (ends, Some(projection)))
        });
        return sharp.chain(turning.map(|(ends, only)| (at_rest.edge(ends), only))).collect();
    }
    if let Shape::Sphere { center, radius } = body.shape {
        // The circle that a ball shows to each projection: across its line of sight.
        let circle = |projection| {
            let path = Path::circle(center.into(), line_of_sight(center.into(), projection), radius);
            (Stroke::edge(path), Some(projection))
        };
        return MapProjection::BOTH.map(circle).to_vec();
    }
    body.shape.strokes().into_iter().map(|stroke| (stroke, None)).collect()
}

/// The places along each stroke of `body`, at rest: of a model its sharp edges, or the box around one without.
pub fn strokes(body: &Body) -> impl Iterator<Item = Vec<DVec3>> + use<> {
    let sharp =
        model_of(body).map(|(model, at_rest)| model.sharp_edges().map(|ends| at_rest.edge(ends)).collect());
    let strokes: Vec<Stroke> =
        sharp.filter(|edges: &Vec<_>| !edges.is_empty()).unwrap_or_else(|| body.outline().strokes());
    strokes.into_iter().map(|stroke| {
        let parts = 4 * stroke.path.parts();
        (0..=parts).map(|part| stroke.path.at(f64::from(part) / f64::from(parts))).collect()
    })
}

/// The place of the box around a model, at rest in its group.
#[derive(Debug, Clone, Copy)]
struct AtRest {
    middle: DVec3,
    turn: DQuat,
}

impl AtRest {
    /// The edge between two places in the box.
    fn edge(self, ends: [DVec3; 2]) -> Stroke {
        let [from, to] = ends.map(|end| self.middle + self.turn * end);
        Stroke::edge(Path::Line { from, to })
    }
}

/// Returns the triangles of a model, and where their box is; `None` of other bodies.
fn model_of(body: &Body) -> Option<(&Triangles, AtRest)> {
    let Shape::Box { center, turn, .. } = body.shape else { return None };
    let at_rest = AtRest { middle: center.into(), turn: DQuat::from_array(turn) };
    Some((body.triangles.as_deref()?, at_rest))
}
