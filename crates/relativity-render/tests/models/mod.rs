//! Models of triangles that tests share.

#![allow(dead_code, reason = "each program that includes this module uses its own part")]
#![allow(clippy::allow_attributes, reason = "an expectation would fail in the programs that use every part")]

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use relativity_core::{Aperture, Speed, Turning};
use relativity_render::{
    Body, Camera, Gaze, Geometry, Hit, Method, PreparedScene, RawModel, Renderers, Shape, Spin, View,
};

use crate::support::{centred, spread};

/// The middle of the box, which is the hub of wheels.
pub const HUB: [f64; 3] = [0.0, 4.0, 0.5];

/// A view of the box from (-1, 3, 2) to (1, 5, 3) and what takes its place.
pub fn view(beta: f64, geometry: Geometry, size: [u32; 2]) -> View {
    let speed = Speed::from_beta(beta).expect("a speed");
    let camera = Camera::new(Aperture::pair(0.1)[1], Gaze::STRAIGHT_AHEAD, 0.6, size);
    let mut view = View { camera, speed, observation_time: 4.5, geometry };
    let centre = view.apparent_position(HUB).expect("inside the domain");
    view.camera.gaze = Gaze::along(centre.to_array());
    view
}

/// Prepares a scene of this model alone.
pub fn scene_of(model: RawModel) -> PreparedScene {
    PreparedScene::moving(&[Body::of_triangles(model.prepared().expect("a model"))])
}

/// The box that [`box_model`] stands for.
pub fn exact_box() -> Shape {
    Shape::Box { centre: [0.0, 4.0, 0.5], half: [1.0, 0.75, 0.5], turn: [0.0, 0.0, 0.0, 1.0] }
}

/// The corners and the twelve triangles of that box.
pub fn box_model() -> RawModel {
    let corner = |i: usize| {
        let side = |bit: usize, half: f64| if i & bit == 0 { -half } else { half };
        [side(1, 1.0), 4.0 + side(2, 0.75), 0.5 + side(4, 0.5)]
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    RawModel { corners: (0..8).map(corner).collect(), triangles, ..RawModel::default() }
}

/// A ball of `rings` times twice as many squares, each of two triangles.
pub fn ball_model(centre: [f64; 3], radius: f64, rings: u32) -> RawModel {
    let turns = 2 * rings;
    let corner = |i: u32| {
        let (polar, azimuth) = (
            PI * f64::from(i / turns) / f64::from(rings),
            2.0 * PI * f64::from(i % turns) / f64::from(turns),
        );
        let (x, y, z) = (polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos());
        (DVec3::from(centre) + radius * DVec3::new(x, y, z)).to_array()
    };
    let square = |i: u32| {
        let (ring, turn) = (i / turns, i % turns);
        let at = |ring: u32, turn: u32| ring * turns + turn % turns;
        let [a, b, c, d] = [at(ring, turn), at(ring + 1, turn), at(ring + 1, turn + 1), at(ring, turn + 1)];
        [[a, b, c], [a, c, d]]
    };
    RawModel {
        corners: (0..(rings + 1) * turns).map(corner).collect(),
        triangles: (0..rings * turns).flat_map(square).collect(),
        ..RawModel::default()
    }
}

/// A thousand triangles about the box's middle, anyhow, with colours.
pub fn soup(is_two_sided: bool) -> RawModel {
    let corner = |i: u32| {
        let middle = centred(spread(i / 3)) * DVec3::new(1.0, 0.75, 0.5);
        (DVec3::new(0.0, 4.0, 0.5) + middle + 0.15 * centred(spread(i + 7))).to_array()
    };
    let paint = |i: u32| spread::<3>(i + 11).map(|part| part as f32);
    RawModel {
        corners: (0..3000).map(corner).collect(),
        triangles: (0..1000).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        paints: (0..3000).map(paint).collect(),
        is_two_sided,
        ..RawModel::default()
    }
}

/// The spin of a wheel about the hub that reaches so far.
pub fn spin(radius: f64) -> Spin {
    Spin { hub: HUB, radius, turning: Turning::Rolling }
}

/// Prepares a scene of this model alone, which rolls and reaches so far from the hub.
pub fn rolling(model: RawModel, radius: f64) -> PreparedScene {
    PreparedScene::moving(&[Body::of_triangles(model.prepared().expect("a model")).turning(spin(radius))])
}

/// A torus about the axle, of `around` times `tube` squares, each of two triangles, and bars across it.
pub fn wheel_model(radius: f64, tube_radius: f64, around: u32, tube: u32, bars: u32) -> RawModel {
    let place = |turn: f64, off: f64, y: f64| {
        let (sine, cosine) = turn.sin_cos();
        (DVec3::from(HUB) + DVec3::new(off * cosine, y, off * sine)).to_array()
    };
    let corner = |i: u32| {
        let [turn, angle] =
            [TAU * f64::from(i / tube) / f64::from(around), TAU * f64::from(i % tube) / f64::from(tube)];
        place(turn, radius + tube_radius * angle.cos(), tube_radius * angle.sin())
    };
    let square = |i: u32| {
        let at = |ring: u32, angle: u32| ring % around * tube + angle % tube;
        let (ring, angle) = (i / tube, i % tube);
        let [a, b, c, d] =
            [at(ring, angle), at(ring, angle + 1), at(ring + 1, angle + 1), at(ring + 1, angle)];
        [[a, b, c], [a, c, d]]
    };
    let mut model = RawModel {
        corners: (0..around * tube).map(corner).collect(),
        triangles: (0..around * tube).flat_map(square).collect(),
        is_two_sided: true,
        ..RawModel::default()
    };
    for bar in 0..bars {
        let turn = TAU * f64::from(bar) / f64::from(bars);
        let first = model.corners.len() as u32;
        model.corners.extend([
            place(turn, 0.0, 0.02),
            place(turn - 0.05, radius, 0.0),
            place(turn + 0.05, radius, 0.0),
        ]);
        model.triangles.push([first, first + 1, first + 2]);
    }
    model
}

/// Whether a triangle of the reference's is at the pixel or as far from it as an outline may be off.
pub fn is_nearby(scene: &PreparedScene, view: &View, i: usize, hit: Option<&Hit>, outline_px: f64) -> bool {
    let width = view.camera.size[0] as usize;
    let (u, v) = ((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
    // What is seen aslant may be a narrow strip.
    (0..512).any(|k| {
        let (sine, cosine) = (TAU * f64::from(k % 32) / 32.0).sin_cos();
        let off = outline_px * f64::from(k / 32 + 1) / 16.0;
        let place = [u + off * cosine, v + off * sine];
        let there = scene.first_hit(view, view.camera.line_of_sight(place));
        there.and_then(|there| there.triangle).map(|point| point.triangle)
            == hit.and_then(|hit| hit.triangle).map(|point| point.triangle)
    })
}

/// Holds the published model's meshes of two scenes at these speeds against each other, which are of the same
/// faces, though not of the same triangles.
pub fn assert_published_alike(renderers: &mut Renderers, scenes: &[PreparedScene; 2], betas: [f64; 3]) {
    for beta in betas {
        let view = view(beta, Geometry::Published, [96, 72]);
        let [expected, found] = scenes
            .each_ref()
            .map(|scene| renderers.hits(Method::Mesh, scene, &view).expect("device works").hits);
        let (mut both, mut either) = (0, 0);
        for pair in expected.iter().zip(&found) {
            either += usize::from(pair.0.is_some() || pair.1.is_some());
            let (Some(expected), Some(found)) = pair else { continue };
            // A pixel is about 0.03 wide there, and more of a face that is seen aslant.
            both += usize::from(expected.material_position.distance(found.material_position) < 0.02);
        }
        assert!(both > 500 && 100 * both > 97 * either, "{both} of {either} at {beta}");
    }
}
