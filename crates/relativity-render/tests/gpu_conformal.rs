//! Conformal pictures by the renderers on the GPU, against formulas of their own.

use glam::DVec3;
use relativity_core::Aperture;
use relativity_render::{
    Body, Camera, Gaze, Geometry, Method, PreparedScene, Projection, Renderers, Shape, View,
};

use crate::gpu_support::Test;
use crate::mercator;
use crate::support::documented;

pub const TESTS: &[Test] = &[
    ("u_and_v_are_linear_in_column_and_row", u_and_v_are_linear_in_column_and_row),
    ("a_ball_keeps_its_outline", a_ball_keeps_its_outline),
    ("pictures_go_all_around", pictures_go_all_around),
    ("motion_slides_the_picture_and_nothing_else", motion_slides_the_picture_and_nothing_else),
];

const RENDERERS: &str = include_str!("../src/renderers.rs");

/// The bounds for the rays and for the mesh, px.
const BOUNDS: [(Method, f64); 2] = [(Method::Rays, 0.03), (Method::Mesh, Method::MESH_ERROR_PX)];

fn u_and_v_are_linear_in_column_and_row(renderers: &mut Renderers) {
    for (method, bound_px) in BOUNDS {
        mercator::u_and_v_are_linear(renderers, method, bound_px);
    }
}

fn a_ball_keeps_its_outline(renderers: &mut Renderers) {
    for (method, bound_px) in BOUNDS {
        mercator::a_ball_keeps_its_outline(renderers, method, bound_px);
    }
}

/// Pixels differ from those at rest only at outlines, as far off as each of both pictures may be.
fn motion_slides_the_picture_and_nothing_else(renderers: &mut Renderers) {
    let wrong_percent = documented(RENDERERS, "the body differs at fewer than ");
    let rays = mercator::slid(renderers, Method::Rays, documented(RENDERERS, "all of them within "));
    assert!(rays.differing as f64 <= 0.02 * wrong_percent * rays.shown as f64, "{rays:?}");
}

/// Pictures that go all around the line through the eyes, and of bodies around it: what each pixel shows, the
/// reference shows no farther off than the bound.
fn pictures_go_all_around(renderers: &mut Renderers) {
    let shapes = [
        Shape::Ring { centre: [0.3, 0.1, -0.2], axis: [1.0, 0.0, 0.0], radius: 1.5, tube_radius: 0.2 },
        Shape::Cylinder { from: [1.5, -2.0, 0.05], to: [1.5, -1.0, -0.05], radius: 0.3 },
        Shape::Box { centre: [-2.0, 0.3, 0.1], half: [0.1, 1.5, 0.4], turn: [0.0, 0.0, 0.0, 1.0] },
        Shape::Sphere { centre: [-0.5, -3.0, 0.4], radius: 0.8 },
        Shape::Sphere { centre: [-0.5, 3.0, 0.4], radius: 0.8 },
    ];
    let bodies = shapes.map(|shape| Body::new(shape, 600.0));
    let scene = PreparedScene::moving(&bodies);
    for (of, elevation) in [(0.0, 0.0), (0.6, 0.9), (0.95, -0.4)] {
        // As high as once around, and a little more.
        let horizontal_fov = 2.0 * 1.1f64.sinh().atan();
        let gaze = Gaze { azimuth: 1.6, elevation };
        let camera = Camera::new(Aperture::default(), gaze, horizontal_fov, [120, 350]);
        for right in [DVec3::X, DVec3::new(0.9, 0.3, 0.316_227_766)] {
            let camera = Camera {
                projection: Projection::Mercator { right: right.normalize(), shift: 0.0 },
                ..camera
            };
            let view =
                View { camera, speed: mercator::beta(of), observation_time: 1.0, geometry: Geometry::Seen };
            let truth = scene.hit_image(&view);
            let methods =
                [(Method::Rays, 0.05), (Method::Packets, 0.05), (Method::Mesh, Method::MESH_ERROR_PX)];
            for (method, reach_px) in methods {
                let image = renderers.hits(method, &scene, &view).expect("device works");
                let mut wrong = 0;
                for (i, (hit, true_hit)) in image.hits.iter().zip(&truth.hits).enumerate() {
                    let body = hit.map(|hit| hit.body);
                    if body == true_hit.map(|hit| hit.body) {
                        continue;
                    }
                    let place = mercator::pixel_centre(&image, i);
                    let found = [1.0, 0.5].into_iter().any(|share| {
                        mercator::bodies_around(&scene, &view, place, share * reach_px).contains(&body)
                    });
                    wrong += usize::from(!found);
                    if !found {
                        println!(
                            "{method} beta {of} {right}: {body:?} for {:?} at {place}",
                            true_hit.map(|hit| hit.body)
                        );
                    }
                }
                let shown = truth.hits.iter().flatten().count();
                assert!(shown > 2000, "{shown} pixels are too few to judge by");
                assert_eq!(wrong, 0, "{method}, beta {of}, {right}: {wrong} of {shown} pixels");
            }
        }
    }
}
