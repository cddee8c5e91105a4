//! The renderers on the CPU, shaders as text, and whatever else needs no graphics device: one program.

mod bands;
mod conformal;
mod contact_shadow;
mod groups;
mod hatch;
mod joints;
mod mercator;
mod models;
mod nested;
mod oblique_riding;
mod patterns;
mod picking;
mod projections;
mod rectified_wheels;
mod reference;
mod reference_colour;
mod reference_intersect;
mod reference_planck;
mod reference_rolling;
mod reference_wheels;
mod riding;
mod rolling_models;
mod scale;
#[path = "gpu_support/scenes.rs"]
#[expect(dead_code, reason = "shared with the tests on the GPU")]
mod scenes;
mod shaders;
mod spokes;
mod street_daylight;
mod sunlight;
mod support;
mod textures;
mod triangles;
#[expect(dead_code, reason = "shared with the tests on the GPU")]
mod wheels;
