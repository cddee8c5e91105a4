//! A window that is painted where it changed looks as one that the toolkit paints.

use eframe::egui::{pos2, vec2};
use egui_kittest::Harness;
use gamow::app::commands::{Command, PlaybackCommand, SettingsCommand, Switch, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::overlay::Overlay;
use gamow::app::tools::painting;
use gamow::flags::choices::{Layout, RendererChoice};
use gamow::settings::Theme;

use super::support::{builder, cyclist, in_layout};
use super::{Test, device};

pub const TESTS: &[Test] =
    trials![what_changed_is_painted_as_the_whole_would_be, what_changed_is_painted_so_at_any_scale,];

/// The same window twice: painted whole, and where it changes.
struct Pair {
    windows: Vec<Harness<'static, App>>,
}

impl Pair {
    /// Of the cyclist at this beta.
    fn new(beta: f64, pixels_per_point: f32) -> Self {
        let window = |is_painted: bool| {
            let mut state = cyclist(beta);
            state.document.settings.quality.renderer = RendererChoice::Rays;
            builder([960.0, 560.0])
                .with_pixels_per_point(pixels_per_point)
                .renderer(device::renderer())
                .build_eframe(|cc| {
                    if let Some(render_state) = cc.wgpu_render_state.as_ref().filter(|_| is_painted) {
                        painting::install(&cc.egui_ctx, render_state);
                    }
                    // Neither of them draws less of a picture that takes long.
                    App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state).without_refinement()
                })
        };
        Self { windows: [false, true].into_iter().map(window).collect() }
    }

    /// Does the same in both for `frames` frames; they look alike after every other and after the last.
    fn does(&mut self, what: &str, frames: usize, act: impl Fn(&mut Harness<'static, App>)) {
        self.windows.iter_mut().for_each(act);
        for frame in 0..frames {
            let [whole, painted] = self.windows.as_mut_slice() else { panic!("two windows") };
            whole.step();
            painted.step();
            if frame % 2 == 0 && frame + 1 != frames {
                continue;
            }
            assert_eq!(painted.output().shapes.len(), 1, "it is painted as it is in the toolkit's way");
            let pictures = [whole, painted].map(|window| window.render().expect("a picture"));
            let [whole, painted] = [pictures[0].as_raw(), pictures[1].as_raw()];
            assert_eq!(whole.len(), painted.len(), "{what}");
            let off = |at: &usize| whole[*at].abs_diff(painted[*at]) > 3;
            let wrong: Vec<usize> = (0..whole.len()).filter(off).map(|at| at / 4).collect();
            let width = pictures[0].width() as usize;
            let place = wrong.first().map(|at| [at % width, at / width]);
            assert!(
                wrong.is_empty(),
                "{what}, frame {frame}: {} values, the first at {place:?}",
                wrong.len()
            );
        }
    }

    fn asks(&mut self, command: &Command) {
        self.does(&format!("{command:?}"), 2, |window| window.state_mut().run(command.clone()));
    }
}

fn what_changed_is_painted_as_the_whole_would_be() {
    let mut pair = Pair::new(0.9, 1.0);
    pair.does("the beginning", 3, |_| ());
    for time in [1.0, 1.1, 9.0] {
        pair.asks(&Command::Playback(PlaybackCommand::GoTo(time)));
    }
    pair.does("the pointer on a plot", 2, |window| window.hover_at(pos2(300.0, 480.0)));
    pair.does("the pointer in a view", 3, |window| window.hover_at(pos2(210.0, 180.0)));
    pair.does("the pointer gone", 2, |window| window.hover_at(pos2(959.0, 559.0)));
    pair.asks(&Command::Settings(SettingsCommand::NudgeSpeed(-7)));
    pair.asks(&Command::Window(WindowCommand::Toggle(Overlay::Help)));
    pair.asks(&Command::Window(WindowCommand::Toggle(Overlay::Help)));
    pair.asks(&Command::Settings(SettingsCommand::Switch(Switch::Map)));
    let mut window = pair.windows[0].state().state().document.settings.window;
    window.theme = Theme::Light;
    pair.asks(&Command::Settings(SettingsCommand::Window(window)));
    for layout in [Layout::Anaglyph, Layout::SideBySide] {
        pair.asks(&in_layout(layout));
    }
    pair.does("a smaller window", 3, |window| {
        window.set_size(vec2(840.0, 500.0));
    });
    pair.asks(&Command::Window(WindowCommand::TogglePresenting));
}

fn what_changed_is_painted_so_at_any_scale() {
    let mut pair = Pair::new(0.6, 1.3);
    for time in [2.0, 2.2] {
        pair.asks(&Command::Playback(PlaybackCommand::GoTo(time)));
    }
    pair.does("the pointer on a plot", 2, |window| window.hover_at(pos2(300.0, 480.0)));
}
