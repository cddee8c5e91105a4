//! Conformal pictures by the renderers on the GPU, against formulas of their own.

mod gpu_support;
mod mercator;
mod support;

use std::process::ExitCode;

use gpu_support::scenes;
use relativity_render::{Method, Renderers};
use support::documented;

fn main() -> ExitCode {
    gpu_support::run(&[
        ("u_and_v_are_linear_in_column_and_row", u_and_v_are_linear_in_column_and_row),
        ("a_ball_keeps_its_outline", a_ball_keeps_its_outline),
        ("motion_slides_the_picture_and_nothing_else", motion_slides_the_picture_and_nothing_else),
    ])
}

const RENDERERS: &str = include_str!("../src/renderers.rs");

/// Of the rays, and of meshes, px.
const BOUNDS: [(Method, f64); 3] =
    [(Method::Rays, 0.03), (Method::Mesh { bound_px: 0.5 }, 0.5), (Method::Mesh { bound_px: 0.1 }, 0.1)];

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
