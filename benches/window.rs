//! What the views, the map, a ride, and the window's own way to paint itself cost: frames of a 1200x760
//! window while it plays, with and without each, in one run. Prints medians of whole frames, each drawn on
//! the device before the next begins and not read back, and of what the program itself does of them: all but
//! waiting for the device.
//!
//! `cargo bench --bench window`

use std::time::{Duration, Instant};

use eframe::egui::{Context, Pos2, RawInput, Rect};
use eframe::egui_wgpu::{RenderState, RendererOptions, WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use eframe::wgpu;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::riding::saddle::RideCommand;
use gamow::app::tools::painting;
use gamow::app::views::offscreen;
use gamow::scene::Scene;
use gamow::settings::{Presence, Settings, WindowSettings};

const SIZE: [u32; 2] = [1200, 760];
const FRAMES: usize = 30;
const ROUNDS: usize = 3;

fn main() {
    println!("{}", gpu_description());
    let part = |views, map| {
        let window = WindowSettings { views, map, ..WindowSettings::default() };
        State::new(Settings { window, ..Settings::default() }, Scene::default())
    };
    compare(
        "views",
        [part(true, Presence::Off), part(false, Presence::Off)].map(|parts| Shown::new(parts, true)),
    );
    compare(
        "map",
        [part(true, Presence::On), part(true, Presence::Off)].map(|parts| Shown::new(parts, true)),
    );
    compare("riding", [riding("coast"), part(true, Presence::Off)].map(|state| Shown::new(state, true)));
    let legs: Vec<_> = (0..1000).map(|leg| if leg / 2 % 2 == 0 { "0.02@0.4" } else { "0.02@-0.4" }).collect();
    compare("legs", [riding(&legs.join(",")), riding("coast")].map(|state| Shown::new(state, true)));
    compare("painting", [true, false].map(|is_painted| Shown::new(part(true, Presence::Off), is_painted)));
}

/// The same street from a bicycle at 0.9 c, with these legs.
fn riding(legs: &str) -> State {
    let mut state = State::new(Settings::default(), Scene::default());
    state.run(RideCommand::Toggle);
    let mut settings = Settings::clone(&state.document.settings);
    settings.ride.ride_speed = "0.9".parse().expect("a velocity");
    settings.ride.ride = legs.parse().expect("legs");
    settings.window.map = Presence::Off;
    state.run(RideCommand::Set(settings.ride.clone()));
    state.run(SettingsCommand::Window(settings.window));
    state
}

/// Prints what a part costs that the first of these windows has and the second has not.
fn compare(name: &str, mut windows: [Shown; 2]) {
    let mut times = [[Vec::new(), Vec::new()], [Vec::new(), Vec::new()]];
    for _ in 0..ROUNDS {
        for (window, times) in windows.iter_mut().zip(&mut times) {
            window.frames(times);
        }
    }
    let [with, without] = times.map(|times| times.map(|mut times| 1e3 * median(&mut times).as_secs_f64()));
    for (part, [with, without]) in [("frame", [with[0], without[0]]), ("own part", [with[1], without[1]])] {
        println!(
            "{name:<8} {part:<9} with {with:6.1} ms, without {without:6.1} ms: {:.2} times, {:.1} ms more",
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

/// A window that is drawn on a texture.
struct Shown {
    app: App,
    ctx: Context,
    render_state: RenderState,
    target: wgpu::TextureView,
    frame: u32,
}

impl Shown {
    /// A window of this `state`, which is painted as the program's is on a software GPU, or by the toolkit.
    fn new(state: State, is_painted: bool) -> Self {
        let config = WgpuConfiguration {
            wgpu_setup: WgpuSetup::CreateNew(WgpuSetupCreateNew::without_display_handle()),
            ..WgpuConfiguration::default()
        };
        let render_state = pollster::block_on(async {
            let instance = config.wgpu_setup.new_instance().await;
            RenderState::create(&config, &instance, None, RendererOptions::default()).await.expect("a device")
        });
        let ctx = Context::default();
        if is_painted {
            painting::install(&ctx, &render_state);
        }
        let app = App::new(&ctx, Some(&render_state), state);
        let [width, height] = SIZE;
        let target = render_state.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: render_state.target_format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        let target = target.create_view(&wgpu::TextureViewDescriptor::default());
        let mut shown = Self { app, ctx, render_state, target, frame: 0 };
        shown.frames(&mut Default::default());
        shown
    }

    /// Runs and draws frames, each finished before the next begins: how long each took, and the program's own
    /// part.
    fn frames(&mut self, [frames, own]: &mut [Vec<Duration>; 2]) {
        for _ in 0..FRAMES {
            let start = Instant::now();
            self.draw();
            own.push(start.elapsed());
            self.render_state.device.poll(wgpu::PollType::wait_indefinitely()).expect("a device");
            frames.push(start.elapsed());
        }
    }

    /// Draws the next frame, as the toolkit does.
    fn draw(&mut self) {
        self.frame += 1;
        self.app.run(PlaybackCommand::GoTo(f64::from(self.frame % 200) / 20.0));
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, SIZE.map(|side| side as f32).into())),
            time: Some(f64::from(self.frame) / 60.0),
            ..RawInput::default()
        };
        let app = &mut self.app;
        let mut output = self.ctx.run_ui(input, |ui| app.show(ui));
        offscreen::load(&self.render_state, &mut output);
        offscreen::paint(&self.render_state, &self.ctx, output, &self.target, SIZE);
    }
}

fn median(times: &mut [Duration]) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}
