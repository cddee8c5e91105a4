//! Gamow's street from the saddle, to look at: a row each for looking ahead, aside and behind, a column each
//! for being at rest, at 0.5 c, at 0.9 c and at a Lorentz factor of 10. The rider is at the same place in all
//! of them.
//!
//! `cargo run --release --example ride_sheet -- sheet.png [dusk]`

use std::env;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fs::File;

use anyhow::Context as _;
use gamow::files::png;
use gamow::scene::Scene;
use gamow::settings::Settings;
use relativity_core::{Aperture, Speed};
use relativity_render::{Camera, Gaze, Geometry, Gpu, Method, Picture, Renderers, Velocity, View};

/// Size of each picture, pixels.
const SIZE: [u32; 2] = [400, 260];
/// White between pictures, pixels.
const GAP: u32 = 4;
/// Place of the rider's eyes: on the road, 1.6 m above it.
const EYES: Aperture = Aperture { x: -3.0, y: 4.0, z: 0.0 };
/// Azimuths of the gazes.
const GAZES: [f64; 3] = [0.0, FRAC_PI_2, PI];

fn main() -> anyhow::Result<()> {
    let mut words = env::args().skip(1);
    let out = words.next().context("which file is it to be? ride_sheet FILE.png [dusk]")?;
    let is_dusk = words.next().is_some_and(|word| word == "dusk");
    let mut renderers = Renderers::new(Gpu::headless().ok());
    let scene = Scene::open("street")?;
    let prepared = scene.prepared();
    let appearance = Settings::default().appearance(&scene, 0.0, !is_dusk);
    let velocities = [Speed::REST, Speed::from_beta(0.5)?, Speed::from_beta(0.9)?, Speed::from_gamma(10.0)?];
    let mut pictures = Vec::new();
    for azimuth in GAZES {
        for velocity in velocities.map(Velocity::forward) {
            let gaze = Gaze { azimuth, elevation: 0.0 };
            let camera = Camera { velocity: velocity.into(), ..Camera::new(EYES, gaze, 1.4, SIZE) };
            let geometry = Geometry::Seen;
            let view = View { camera, speed: Speed::REST, observation_time: 0.0, geometry };
            pictures.push(renderers.picture(Method::Packets, &prepared, &view, &appearance, 2)?);
        }
    }
    png::write(&sheet(&pictures, velocities.len()), &[("Title", "A ride")], File::create(out)?)
}

/// Lays the pictures out in rows of this number of columns.
fn sheet(pictures: &[Picture], columns: usize) -> Picture {
    let pitch = SIZE.map(|side| (side + GAP) as usize);
    let (width, height) = (columns * pitch[0], pictures.len() / columns * pitch[1]);
    let mut rgba = vec![[u8::MAX; 4]; width * height];
    for (number, picture) in pictures.iter().enumerate() {
        for (line, pixels) in picture.rgba.chunks_exact(SIZE[0] as usize).enumerate() {
            let start = (number / columns * pitch[1] + line) * width + number % columns * pitch[0];
            rgba[start..start + pixels.len()].copy_from_slice(pixels);
        }
    }
    Picture { size: [width as u32, height as u32], rgba }
}
