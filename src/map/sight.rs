//! Fields of view of the eyes, on the map.

use glam::DVec3;
use relativity_render::Camera;

use super::MapProjection;

/// The directions of both edges of what `camera` shows, in `projection`: unit vectors right and up, the left
/// edge first. `None` where it looks so steeply out of the plane that there is no edge.
#[must_use]
pub fn field_of_view(camera: &Camera, projection: MapProjection) -> Option<[[f64; 2]; 2]> {
    let [width, height] = camera.size.map(f64::from);
    let places = [[0.5 * width, 0.5 * height], [0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
    let mut sights = [[0.0; 2]; 5];
    for (sight, place) in sights.iter_mut().zip(places) {
        *sight = flat(camera.line_of_sight(place), projection)?;
    }
    // An edge has all the others on its one side. (A sheared picture may reach further than 90 degrees from
    // its middle.)
    let edge = |side: f64| {
        let is_outermost = |at: &[f64; 2]| sights.iter().all(|&other| side * cross(*at, other) >= -ALIKE);
        sights.into_iter().find(is_outermost)
    };
    let edges = [edge(-1.0)?, edge(1.0)?];
    (dot(edges[0], edges[1]) > -1.0 + ALIKE && edges[0] != edges[1]).then_some(edges)
}

/// Distance up to which two edges seem in one place, either way, by rounding.
const ALIKE: f64 = 1e-12;

/// The direction of `v` in `projection`, unless it looks along that.
fn flat(v: DVec3, projection: MapProjection) -> Option<[f64; 2]> {
    let [right, up] = projection.flat(v);
    let length = relativity_core::math::hypot(right, up);
    (length > 0.1).then(|| [right / length, up / length])
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use relativity_core::Aperture;
    use relativity_render::Gaze;

    #[test]
    fn a_level_gaze_has_its_field_of_view_in_the_plan() {
        let camera = Camera::new(Aperture::default(), Gaze { azimuth: 2.0, elevation: 0.0 }, 0.8, [400, 4]);
        let edges = field_of_view(&camera, MapProjection::Plan).expect("it looks along the plane");
        for (edge, azimuth) in edges.into_iter().zip([2.4f64, 1.6]) {
            let off = (edge[0] - azimuth.cos()).hypot(edge[1] - azimuth.sin());
            assert!(off < 1e-12, "{edges:?}");
        }
        let ahead = Camera { gaze: Gaze::STRAIGHT_AHEAD, ..camera };
        assert_eq!(field_of_view(&ahead, MapProjection::Side), None);
    }
}
