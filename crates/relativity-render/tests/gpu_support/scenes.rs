//! Scenes and views for the renderers to agree on.

use glam::{DQuat, DVec3};
use relativity_core::{Aperture, MAX_GAMMA, ObserverVelocity, SourcePoint, Speed, sighting};
use relativity_render::{Body, Camera, Gaze, Geometry, Projection, Shape, View};

use crate::support::{centred, spread};

/// A few bodies of every shape, thin and thick, that do not touch; about 1.5 long.
pub fn still_life() -> Vec<Body> {
    [round_still_life(), flat_still_life()].concat()
}

/// Returns the bodies of the still life without flat faces.
pub fn round_still_life() -> Vec<Body> {
    let ring = |centre, axis: [f64; 3], radius, tube_radius| Shape::Ring {
        centre,
        axis: DVec3::from(axis).normalize().to_array(),
        radius,
        tube_radius,
    };
    bodies(vec![
        ring([0.0, 3.0, 0.4], [0.0, 1.0, 0.0], 0.33, 0.02),
        ring([-0.8, 3.1, 0.5], [0.3, 1.0, 0.2], 0.3, 0.1),
        ring([-0.4, 3.0, 1.2], [1.0, 0.1, 0.0], 0.2, 0.05),
        Shape::Sphere { centre: [-0.4, 3.0, 0.75], radius: 0.12 },
        Shape::Sphere { centre: [0.0, 3.0, 0.4], radius: 0.05 },
        Shape::Tube { from: [-1.2, 3.0, 0.9], to: [0.3, 3.0, 0.95], radius: 0.03 },
        Shape::Tube { from: [0.4, 2.8, 0.0], to: [0.4, 3.3, 1.3], radius: 0.05 },
        Shape::Tube { from: [-1.2, 2.6, 0.0], to: [0.3, 2.6, 0.1], radius: 0.004 },
        Shape::Tube { from: [-1.3, 3.3, 0.2], to: [-1.1, 3.3, 1.2], radius: 0.01 },
    ])
}

/// Boxes and cylinders: cubes, plates and rods.
fn flat_still_life() -> Vec<Body> {
    let turned = |centre, half, axis: [f64; 3], angle| {
        let turn = DQuat::from_axis_angle(DVec3::from(axis).normalize(), angle).to_array();
        Shape::Box { centre, half, turn }
    };
    bodies(vec![
        turned([0.0, 2.8, 1.15], [0.12; 3], [0.3, 0.5, 1.0], 0.7),
        turned([0.15, 3.4, 0.7], [0.1, 0.15, 0.05], [0.0, 0.0, 1.0], 0.0),
        turned([-0.5, 3.5, 0.0], [0.6, 0.3, 0.003], [0.0, 0.2, 1.0], 0.1),
        turned([-0.9, 2.5, 0.65], [0.004, 0.005, 0.3], [1.0, 0.2, 0.0], 0.5),
        Shape::Cylinder { from: [-0.75, 2.7, 0.7], to: [-0.55, 2.8, 0.85], radius: 0.07 },
        Shape::Cylinder { from: [-0.1, 2.5, 0.65], to: [-0.1, 2.502, 0.66], radius: 0.1 },
        Shape::Cylinder { from: [-0.7, 3.6, 1.0], to: [0.2, 3.6, 1.4], radius: 0.015 },
        Shape::Cylinder { from: [0.55, 3.0, 0.2], to: [0.55, 3.0, 1.0], radius: 0.04 },
    ])
}

/// `count` bodies of every shape strewn around the aperture, some of them around it or behind it.
pub fn crowd(count: u32) -> Vec<Body> {
    let shape = |i| {
        let [_, _, _, size] = spread(i);
        strewn(i, DVec3::ZERO, 0.02 + 0.5 * size * size)
    };
    bodies((0..count).map(shape).collect())
}

/// `count` swarms of twelve small bodies each, strewn as the bodies of a crowd.
pub fn swarms(count: u32) -> Vec<Body> {
    let shape = |i| {
        let [size, x, y, z] = spread(i);
        let size = 0.002 + 0.02 * size * size;
        strewn(i / 12, 10.0 * size * centred([x, y, z]), size)
    };
    bodies((0..12 * count).map(shape).collect())
}

/// The body of this number in a crowd, moved by `off`.
fn strewn(i: u32, off: DVec3, size: f64) -> Shape {
    let [x, y, z, _, u, v, w] = spread(i);
    let centre = centred([x, y, z]) * DVec3::new(6.0, 3.0, 3.0) + off;
    let direction = centred([u, v, w]).normalize();
    match i % 5 {
        0 => Shape::Sphere { centre: centre.to_array(), radius: 0.5 * size },
        3 => Shape::Box {
            centre: centre.to_array(),
            half: [2.0 * size, (0.1 + u) * size, 0.5 * v * size + 1e-3],
            turn: DQuat::from_rotation_arc(DVec3::X, direction).to_array(),
        },
        4 => Shape::Cylinder {
            from: (centre - direction * 2.0 * u * size).to_array(),
            to: (centre + direction * (2.0 * u * size + 1e-3)).to_array(),
            radius: (0.1 + w) * size,
        },
        1 => Shape::Tube {
            from: (centre - direction * 3.0 * size).to_array(),
            to: (centre + direction * 3.0 * size).to_array(),
            radius: 0.2 * size,
        },
        _ => Shape::Ring {
            centre: centre.to_array(),
            axis: direction.to_array(),
            radius: 2.0 * size,
            tube_radius: 0.15 * size,
        },
    }
}

fn bodies(shapes: Vec<Shape>) -> Vec<Body> {
    shapes.into_iter().map(|shape| Body::new(shape, 600.0)).collect()
}

/// A view from the origin that follows the rest-frame point `rest`, as seen at `observation_time`.
pub fn view_following(rest: [f64; 3], speed: Speed, observation_time: f64, fov_degrees: f64) -> View {
    let aperture = Aperture::default();
    let seen = sighting(&speed, SourcePoint::from_rest(rest, &speed), aperture, observation_time);
    View {
        camera: Camera::new(
            aperture,
            Gaze::along(seen.expect("inside the domain").position),
            fov_degrees.to_radians(),
            [320, 240],
        ),
        speed,
        observation_time,
        geometry: Geometry::Seen,
    }
}

/// Views as above with pictures parallel to baselines along the motion, tilted and upright, in which `rest`
/// is seen far aside: at most 72 degrees from the picture's axis.
pub fn parallel_views(speeds: impl IntoIterator<Item = Speed>, rest: [f64; 3]) -> impl Iterator<Item = View> {
    fused_views(speeds, rest, |right, shift| Projection::Parallel { right, shift })
}

/// The same with conformal pictures, every other of which shows the sky from far on the left to far on the
/// right.
pub fn conformal_views(
    speeds: impl IntoIterator<Item = Speed>,
    rest: [f64; 3],
) -> impl Iterator<Item = View> {
    let views = fused_views(speeds, rest, |right, shift| Projection::Mercator { right, shift });
    views.zip([false, true].into_iter().cycle()).map(|(mut view, is_wide)| {
        if is_wide {
            view.camera.horizontal_fov = 150f64.to_radians();
        }
        view
    })
}

/// Views of eyes whose baselines are along the motion, tilted and upright.
fn fused_views(
    speeds: impl IntoIterator<Item = Speed>,
    rest: [f64; 3],
    projection: impl Fn(DVec3, f64) -> Projection,
) -> impl Iterator<Item = View> {
    let baselines = [DVec3::X, DVec3::new(0.8, -0.36, 0.48), DVec3::Z];
    let cases = speeds.into_iter().flat_map(|speed| [-3.0, -0.8, 0.4, 2.5].map(|along| (speed, along)));
    cases.zip((0..).map(move |i| (baselines[i % 3], 0.04 * (i % 5) as f64 - 0.05))).map(
        move |((speed, along), (right, shift))| {
            let mut view = view_following(rest, speed, time_seen_at(rest, &speed, along), 45.0);
            view.camera.projection = projection(right, shift);
            view
        },
    )
}

/// Views by cameras that move across the scene's motion, aslant and upwards, past groups at several speeds,
/// of the rest-frame point `rest` as it approaches, is abreast, and recedes; in pictures of every projection.
pub fn oblique_views(rest: [f64; 3]) -> Vec<View> {
    let baseline = DVec3::new(0.8, -0.36, 0.48);
    let projections = [
        Projection::Gaze,
        Projection::Parallel { right: baseline, shift: 0.02 },
        Projection::Mercator { right: baseline, shift: 0.02 },
    ];
    let headings = [
        (2.0, [std::f64::consts::FRAC_PI_2, 0.0]),
        (1.25, [2.3, 0.4]),
        (10.0, [-0.6, -1.1]),
        (1e6, [0.9, 0.2]),
    ];
    let gamma = |gamma| Speed::from_gamma(gamma).expect("at least 1");
    let speeds = [1.0, 1.25, 100.0, 1e6].map(gamma);
    let cases = headings.into_iter().flat_map(|heading| speeds.map(|speed| (heading, speed)));
    let cases = cases.flat_map(|case| [-1.0, 0.0, 2.0].map(|along| (case, along)));
    let numbered = cases.zip(projections.into_iter().cycle());
    let views = numbered.map(|(((heading, speed), along), projection)| {
        let (own, [azimuth, elevation]) = heading;
        let mut view = view_following(rest, speed, time_seen_at(rest, &speed, along), 50.0);
        view.camera.velocity = ObserverVelocity::new(gamma(own), azimuth, elevation);
        view.camera.size = [160, 120];
        let seen = view.apparent_position(DVec3::from(rest)).expect("inside the domain");
        view.camera.gaze = Gaze::along(seen.to_array());
        view.camera.projection = projection;
        view
    });
    views.collect()
}

/// The speeds that the renderers are held to, slow to fast.
pub fn speeds() -> [Speed; 7] {
    let beta = |beta| Speed::from_beta(beta).expect("below 1");
    let gamma = |gamma| Speed::from_gamma(gamma).expect("at least 1");
    [beta(0.0), beta(0.5), beta(0.9), beta(0.9999), gamma(100.0), gamma(1000.0), gamma(MAX_GAMMA)]
}

/// The observation time at which the rest-frame point `rest` is seen at the place `along` past the
/// aperture, in units of its distance from the path: negative before it passes.
pub fn time_seen_at([x, y, z]: [f64; 3], speed: &Speed, along: f64) -> f64 {
    let off_path = y.hypot(z);
    // At rest it is seen where it is, at any time.
    let emission = (along * off_path - x / speed.gamma()) / speed.beta().max(1e-3);
    emission + off_path * along.hypot(1.0)
}
