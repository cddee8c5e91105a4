//! The renderers on a graphics device: one program, and one device for all tests but those that need their
//! own.

mod gpu_allocations;
mod gpu_compose;
mod gpu_conformal;
mod gpu_faults;
mod gpu_mesh;
mod gpu_models;
mod gpu_pictures;
mod gpu_preparation;
mod gpu_rays;
mod gpu_rolling_models;
mod gpu_support;
mod gpu_textures;
mod gpu_wheels;
mod joints;
mod mercator;
mod models;
mod support;
mod wheels;

use std::process::ExitCode;

use gpu_support::scenes;

fn main() -> ExitCode {
    let shared = [
        ("gpu_compose", gpu_compose::TESTS),
        ("gpu_conformal", gpu_conformal::TESTS),
        ("gpu_mesh", gpu_mesh::TESTS),
        ("gpu_models", gpu_models::TESTS),
        ("gpu_pictures", gpu_pictures::TESTS),
        ("gpu_rays", gpu_rays::TESTS),
        ("gpu_rolling_models", gpu_rolling_models::TESTS),
        ("gpu_textures", gpu_textures::TESTS),
        ("gpu_wheels", gpu_wheels::TESTS),
    ];
    let own = [
        ("gpu_allocations", gpu_allocations::TESTS),
        ("gpu_faults", gpu_faults::TESTS),
        ("gpu_preparation", gpu_preparation::TESTS),
    ];
    gpu_support::run(&shared, &own)
}
