//! What the views cost: frames of a 1200x760 window while it plays, with the views and without, in one
//! run. Prints medians and their ratio.
//!
//! `cargo bench --bench window`

use std::time::{Duration, Instant};

use egui_kittest::Harness;
use gamow::app::App;
use gamow::app::state::State;
use gamow::scene::Scene;
use gamow::settings::Settings;

const SIZE: [f32; 2] = [1200.0, 760.0];
const FRAMES: usize = 60;
const ROUNDS: usize = 3;

fn main() {
    println!("{}", gpu_description());
    let mut with_views = window(true);
    let mut without = window(false);
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        frames(&mut with_views, &mut times[0]);
        frames(&mut without, &mut times[1]);
    }
    let [with_views, without] = times.map(|mut times| median(&mut times));
    println!("with views    {:6.1} ms", 1e3 * with_views.as_secs_f64());
    println!("without       {:6.1} ms", 1e3 * without.as_secs_f64());
    println!("ratio         {:6.2}", with_views.as_secs_f64() / without.as_secs_f64());
}

fn gpu_description() -> String {
    match relativity_render::Gpu::headless() {
        Ok(gpu) => gpu.description(),
        Err(error) => error.to_string(),
    }
}

fn window(views: bool) -> Harness<'static, App> {
    let mut settings = Settings::default();
    settings.window.views = views;
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
