//! What effects of light cost: the cyclist abreast at 0.9 c by rays, with one effect after the other left
//! out.
//!
//! `cargo bench --bench effects` prints milliseconds per picture of one eye and ratios to the picture with
//! everything on. The pictures are timed in turns, so that all meet the same disturbances, and the first once
//! more: smaller differences are noise.

use std::slice;

use gamow::accuracy::{TrackedPlace, frame_ms, view_at};
use gamow::scene::Scene;
use relativity_core::Speed;
use relativity_render::{Appearance, Geometry, Gpu, GpuError, Method, Renderers, Shading, View};

const TURNS: u32 = 6;
const SIZE: [u32; 2] = [480, 360];

/// An effect, and how it is left out.
type Effect = (&'static str, fn(&mut View, &mut Appearance));

const EFFECTS: [Effect; 6] = [
    ("without Doppler shift of colour", |_, appearance| appearance.doppler_shift = false),
    ("without intensity D^n", |_, appearance| appearance.intensity_exponent = None),
    ("without shading of form", |_, appearance| appearance.shading = Shading::Emission),
    ("without ground grid", |_, appearance| appearance.ground_z = None),
    ("without sky gradient", |_, appearance| appearance.sky = false),
    ("without delay of light (contracted)", |view, _| view.geometry = Geometry::Contracted),
];

fn main() -> Result<(), GpuError> {
    let gpu = Gpu::headless()?;
    println!("{}, {} x {}, ms an eye", gpu.description(), SIZE[0], SIZE[1]);
    let mut renderers = Renderers::new(Some(gpu));
    let scene = Scene::preset("cyclist").expect("a preset");
    let prepared = scene.prepared();
    let pictures = pictures(&scene);
    let mut fastest = vec![f64::INFINITY; pictures.len()];
    for _ in 0..TURNS {
        for (fastest, (_, view, appearance)) in fastest.iter_mut().zip(&pictures) {
            let ms = frame_ms(&mut renderers, Method::Rays, &prepared, view, appearance, 2)?;
            *fastest = fastest.min(ms);
        }
    }
    for ((name, ..), ms) in pictures.iter().zip(&fastest) {
        println!("{name:36}{ms:9.2} ({:4.2} x)", ms / fastest[0]);
    }
    Ok(())
}

/// The pictures that are timed, each with its name.
fn pictures(scene: &Scene) -> Vec<(&'static str, View, Appearance)> {
    let speed = Speed::from_beta(0.9).expect("it is a speed");
    let fov = 60_f64.to_radians();
    let view = view_at(TrackedPlace::Abreast, speed, scene.tracked, 0.1, fov, SIZE).expect("in the domain");
    let without = |name, effects: &[Effect]| {
        let appearance = Appearance { ground_z: scene.ground_z, ..Appearance::default() };
        effects.iter().fold((name, view, appearance), |(name, mut view, mut appearance), (_, leave_out)| {
            leave_out(&mut view, &mut appearance);
            (name, view, appearance)
        })
    };
    let single = EFFECTS.iter().map(|effect| without(effect.0, slice::from_ref(effect)));
    [without("everything on", &[])]
        .into_iter()
        .chain(single)
        .chain([without("without all of these", &EFFECTS), without("everything on, once more", &[])])
        .collect()
}
