//! The outlines of bodies at rest as the map draws them.

use glam::DVec3;
use relativity_render::Body;
use relativity_render::geometry::shape::strokes::{Onlooker, Stroke};

use super::MapProjection;

/// The outline of `body`, with the only projection that each part is drawn in, if not in both;
/// `line_of_sight` is the direction of the body at a place, at rest, that a projection looks along.
pub(super) fn outline(
    body: &Body,
    line_of_sight: impl Fn(DVec3, MapProjection) -> DVec3,
) -> Vec<(Stroke, Option<MapProjection>)> {
    let mut strokes: Vec<_> = body.strokes().into_iter().map(|stroke| (stroke, None)).collect();
    for projection in MapProjection::BOTH {
        // In the middle the map looks along it as it does everywhere, nearly.
        let silhouette = body.silhouette(|middle| Onlooker::Afar(line_of_sight(middle, projection)));
        strokes.extend(silhouette.into_iter().map(|stroke| (stroke, Some(projection))));
    }
    strokes
}
