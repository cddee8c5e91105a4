//! What the views and the map cost: frames of a 1280x800 window while it plays, with and without each, in one run.
//! Prints medians, ratios, and what the map takes.
//!
//! `cargo bench --bench window`

use std::time::{Duration, Instant};

use egui_kittest::Harness;
use gamow::app::App;
use gamow::app::state::State;
use gamow::scene::Scene;
use gamow::settings::{Presence, Settings, Window};

const SIZE: [f32; 2] = [1280.0, 800.0];
const FRAMES: usize = 60;
const ROUNDS: usize = 3;

fn main() {
    println!("{}", gpu_description());
    let part = |views, map| Window { views, map, ..Window::default() };
    compare("views", [part(true, Presence::Off), part(false, Presence::Off)]);
    compare("map", [part(true, Presence::On), part(true, Presence::Off)]);
}

/// Prints what a part costs that the first of these windows has and the second has not.
fn compare(name: &str, windows: [Window; 2]) {
    let mut windows = windows.map(window);
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        for (window, times) in windows.iter_mut().zip(&mut times) {
            frames(window, times);
        }
    }
    let [with, without] = times.map(|mut times| 1e3 * median(&mut times).as_secs_f64());
    println!("with {name:<9}{with:6.1} ms");
    println!("without       {without:6.1} ms");
    println!("ratio         {:6.2}, {:.1} ms more", with / without, with - without);
}

fn gpu_description() -> String {
    match relativity_render::Gpu::headless() {
        Ok(gpu) => gpu.description(),
        Err(error) => error.to_string(),
    }
}

fn window(parts: Window) -> Harness<'static, App> {
    let settings = Settings { window: parts, ..Settings::default() };
    let mut state = State::new(settings, Scene::default());
    state.session.playing = true;
    let mut window = Harness::builder()
        .with_size(SIZE)
        .with_step_dt(1.0 / 60.0)
        .with_render_cursor(false)
        .wgpu()
        .build_eframe(|cc| App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state));
    frames(&mut window, &mut Vec::new());
    window
}

/// Runs and draws frames, each finished before the next begins.
fn frames(window: &mut Harness<'_, App>, times: &mut Vec<Duration>) {
    for _ in 0..FRAMES {
        let start = Instant::now();
        window.step();
        window.render().expect("a picture");
        times.push(start.elapsed());
    }
}

fn median(times: &mut [Duration]) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}
