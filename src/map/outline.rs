//! The outlines of bodies at rest as the map draws them.

use glam::DVec3;
use relativity_render::Shape;
use relativity_render::shape::strokes::{Path, Stroke};

use super::Projection;

/// The outline of `shape`, with the only projection that each part is drawn in, if not in both; `line_of_sight` is the
/// direction of the body at a place, at rest, that a projection looks along.
pub(super) fn outline(
    shape: &Shape,
    line_of_sight: impl Fn(DVec3, Projection) -> DVec3,
) -> Vec<(Stroke, Option<Projection>)> {
    if let Shape::Sphere { center, radius } = *shape {
        // The circle that a ball shows to each projection: across its line of sight.
        let circle = |projection| {
            let path = Path::circle(center.into(), line_of_sight(center.into(), projection), radius);
            (Stroke::edge(path), Some(projection))
        };
        return Projection::BOTH.map(circle).to_vec();
    }
    shape.strokes().into_iter().map(|stroke| (stroke, None)).collect()
}

/// The places along each stroke of `shape`, at rest.
pub fn strokes(shape: &Shape) -> impl Iterator<Item = Vec<DVec3>> + use<> {
    shape.strokes().into_iter().map(|stroke| {
        let parts = 4 * stroke.path.parts();
        (0..=parts).map(|part| stroke.path.at(f64::from(part) / f64::from(parts))).collect()
    })
}
