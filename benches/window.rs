//! What the views and the map cost: frames of a 1280x800 window while it plays, with and without each, in one run.
//! Prints medians of whole frames and of what the program itself does of them: all but drawing its triangles and pictures,
//! which is the GPU's part, or that of its stand-in.
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
    let mut times = [[Vec::new(), Vec::new()], [Vec::new(), Vec::new()]];
    for _ in 0..ROUNDS {
        for (window, times) in windows.iter_mut().zip(&mut times) {
            frames(window, times);
        }
    }
    let [with, without] = times.map(|times| times.map(|mut times| 1e3 * median(&mut times).as_secs_f64()));
    for (part, [with, without]) in [("frame", [with[0], without[0]]), ("own part", [with[1], without[1]])] {
        println!(
            "{name:<6} {part:<9} with {with:6.1} ms, without {without:6.1} ms: {:.2} times, {:.1} ms more",
            with / without,
            with - without
        );
    }
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
    frames(&mut window, &mut Default::default());
    window
}

/// Runs and draws frames, each finished before the next begins: how long each took, and the program's own part.
fn frames(window: &mut Harness<'_, App>, [frames, own]: &mut [Vec<Duration>; 2]) {
    for _ in 0..FRAMES {
        let start = Instant::now();
        window.step();
        let stepped = start.elapsed();
        window.render().expect("a picture");
        frames.push(start.elapsed());
        let start = Instant::now();
        let shapes = window.output().shapes.clone();
        std::hint::black_box(window.ctx.tessellate(shapes, 1.0));
        own.push(stepped + start.elapsed());
    }
}

fn median(times: &mut [Duration]) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}
