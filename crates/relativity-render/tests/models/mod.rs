//! Models of triangles that tests share.

use std::f64::consts::PI;

use glam::DVec3;
use relativity_core::{Aperture, Speed};
use relativity_render::{Body, Camera, Gaze, Geometry, Model, PreparedScene, Shape, View};

use crate::support::{centred, spread};

/// A view of the box from (-1, 3, 2) to (1, 5, 3) and what takes its place.
pub fn view(beta: f64, geometry: Geometry, size: [u32; 2]) -> View {
    let speed = Speed::from_beta(beta).expect("a speed");
    let camera = Camera::new(Aperture::pair(0.1)[1], Gaze::STRAIGHT_AHEAD, 0.6, size);
    let mut view = View { camera, speed, observation_time: 4.5, geometry };
    let centre = view.apparent_position([0.0, 4.0, 0.5]).expect("inside the domain");
    view.camera.gaze = Gaze::along(centre.to_array());
    view
}

/// Prepares a scene of this model alone.
pub fn scene_of(model: Model) -> PreparedScene {
    PreparedScene::moving(&[Body::of_triangles(model.prepared().expect("a model"))])
}

/// The box that [`box_model`] stands for.
pub fn exact_box() -> Shape {
    Shape::Box { center: [0.0, 4.0, 0.5], half: [1.0, 0.75, 0.5], turn: [0.0, 0.0, 0.0, 1.0] }
}

/// The corners and the twelve triangles of that box.
pub fn box_model() -> Model {
    let corner = |i: usize| {
        let side = |bit: usize, half: f64| if i & bit == 0 { -half } else { half };
        [side(1, 1.0), 4.0 + side(2, 0.75), 0.5 + side(4, 0.5)]
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Model { corners: (0..8).map(corner).collect(), triangles, ..Model::default() }
}

/// A ball of `rings` times twice as many squares, each of two triangles.
pub fn ball_model(center: [f64; 3], radius: f64, rings: u32) -> Model {
    let turns = 2 * rings;
    let corner = |i: u32| {
        let (polar, azimuth) = (
            PI * f64::from(i / turns) / f64::from(rings),
            2.0 * PI * f64::from(i % turns) / f64::from(turns),
        );
        let (x, y, z) = (polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos());
        (DVec3::from(center) + radius * DVec3::new(x, y, z)).to_array()
    };
    let square = |i: u32| {
        let (ring, turn) = (i / turns, i % turns);
        let at = |ring: u32, turn: u32| ring * turns + turn % turns;
        let [a, b, c, d] = [at(ring, turn), at(ring + 1, turn), at(ring + 1, turn + 1), at(ring, turn + 1)];
        [[a, b, c], [a, c, d]]
    };
    Model {
        corners: (0..(rings + 1) * turns).map(corner).collect(),
        triangles: (0..rings * turns).flat_map(square).collect(),
        ..Model::default()
    }
}

/// A thousand triangles about the box's middle, anyhow, with colours.
pub fn soup(is_two_sided: bool) -> Model {
    let corner = |i: u32| {
        let middle = centred(spread(i / 3)) * DVec3::new(1.0, 0.75, 0.5);
        (DVec3::new(0.0, 4.0, 0.5) + middle + 0.15 * centred(spread(i + 7))).to_array()
    };
    let paint = |i: u32| spread::<3>(i + 11).map(|part| part as f32);
    Model {
        corners: (0..3000).map(corner).collect(),
        triangles: (0..1000).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        paints: (0..3000).map(paint).collect(),
        is_two_sided,
        ..Model::default()
    }
}
