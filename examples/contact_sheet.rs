//! Every preset on one sheet, to look at: a row for each in a dark and in a light window, in it for each
//! speed what the left eye sees before the selected point passes, abreast of it, and after.
//!
//! `cargo run --release --example contact_sheet -- sheet.png [PRESET ...]`

use std::env;
use std::fs::File;

use anyhow::Context as _;
use gamow::app::state::State;
use gamow::eye::Eye;
use gamow::files::png;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::settings::{Preset, Settings};
use relativity_render::{Gpu, Picture, Renderers};

/// Size of each picture, pixels.
const SIZE: [u32; 2] = [240, 180];
/// White between pictures, pixels.
const GAP: u32 = 4;
/// Speeds, in units of that of light.
const BETAS: [f64; 6] = [0.0, 0.3, 0.6, 0.9, 0.99, 0.9999];

fn main() -> anyhow::Result<()> {
    let mut words = env::args().skip(1);
    let out = words.next().context("which file is it to be? contact_sheet FILE.png [PRESET ...]")?;
    let names: Vec<_> = words.collect();
    let is_wanted = |preset: &&Preset| names.is_empty() || names.iter().any(|name| name == preset.name);
    let mut renderers = Renderers::new(Gpu::headless().ok());
    let mut rows = Vec::new();
    for preset in Preset::all().iter().filter(is_wanted) {
        for light in [false, true] {
            rows.push(row(&mut renderers, &preset.settings, light)?);
        }
    }
    png::write(&sheet(&rows), &[("Title", "Contact sheet")], File::create(out)?)
}

/// The pictures of a preset in a light or a dark window.
fn row(renderers: &mut Renderers, settings: &Settings, light: bool) -> anyhow::Result<Vec<Picture>> {
    let mut row = Vec::new();
    for beta in BETAS {
        let mut settings = settings.clone();
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).map_err(anyhow::Error::msg)?;
        let mut state = State::open(settings)?;
        for time in times(&state) {
            state.document.time = time;
            state.frame.picture.size = SIZE;
            let (view, appearance) = (state.view(Eye::Left, SIZE), state.appearance(light));
            let method = state.method(&view);
            row.push(renderers.picture(method, &state.document.prepared, &view, &appearance, 2)?);
        }
    }
    Ok(row)
}

/// When the selected point comes, is abreast, and goes.
fn times(state: &State) -> [f64; 3] {
    let [from, to] = state.time_range();
    let abreast = state.equidistance_time(state.document.points.selected()).unwrap_or_default();
    [from + 0.15 * (to - from), abreast, to - 0.15 * (to - from)]
}

/// The rows of pictures, one below the other.
fn sheet(rows: &[Vec<Picture>]) -> Picture {
    let pitch = SIZE.map(|side| (side + GAP) as usize);
    let columns = rows.first().map_or(0, Vec::len);
    let (width, height) = (columns * pitch[0], rows.len() * pitch[1]);
    let mut rgba = vec![[u8::MAX; 4]; width * height];
    for (row, pictures) in rows.iter().enumerate() {
        for (column, picture) in pictures.iter().enumerate() {
            for (line, pixels) in picture.rgba.chunks_exact(SIZE[0] as usize).enumerate() {
                let start = (row * pitch[1] + line) * width + column * pitch[0];
                rgba[start..start + pixels.len()].copy_from_slice(pixels);
            }
        }
    }
    Picture { size: [width as u32, height as u32], rgba }
}
