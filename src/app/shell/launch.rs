//! Launch of the window: it is opened, or one sentence gives the reason why it cannot be, and the remedy.

use std::path::Path;

use eframe::egui::{ViewportBuilder, ViewportCommand};
use eframe::{CreationContext, NativeOptions};
use gamow_platform::clock::Instant;
use gamow_platform::last_word::LastWord;
use gamow_platform::{environment, messages, threads, wishes};
use relativity_render::colour::{self, planck, sunlit};

use crate::app::shell::args::WindowArgs;
use crate::app::shell::persistence::{Keeper, Loaded, Memory, recall};
use crate::app::shell::recovery::{self, Break, Ended, RecoverableApp, StateSlot};
use crate::app::shell::screenshot;
use crate::app::shell::{App, TITLE};
use crate::app::state::State;
use crate::app::state::notice::Notice;
use crate::app::tools::{graphics, icon, painting};
use crate::files::whole::ensure_ending;
use crate::flags::words::Shell;
use crate::settings::Settings;

/// Name of the window for the system, and of the folder of its settings.
const APP_ID: &str = "gamow";

/// Least inner width and height of the window, points.
const LEAST_SIDE: f32 = 320.0;

const WHAT_TO_DO: &str = "On Debian and Ubuntu install `libx11-6 libxcursor1 libxi6 libxkbcommon-x11-0 mesa-vulkan-drivers` \
    and start it inside a graphical session; without one, `gamow --screenshot window.png`, `gamow render --out cyclist.png` and \
    `gamow curve` work all the same";

/// Opens the window and returns when it is closed; with `--screenshot` draws it once instead.
///
/// # Errors
/// A bad flag or scene, no display, no graphics adapter, a missing system library, or settings and answers
/// that could not be written.
pub fn launch(args: &WindowArgs) -> anyhow::Result<()> {
    if let Some(path) = &args.screenshot {
        ensure_ending("--screenshot", path, "png")?;
        let state = args.state(Settings::default())?;
        report(&state);
        let provenance =
            state.document.scene.provenance(state.shown().relative_to(path).window_command(Shell::RECORDED));
        return screenshot::save(state, args.window_size_or_default(), &provenance.texts(), path);
    }
    // Flags are judged before a window appears; the saved settings are only known once it has.
    report(&args.state(Settings::default())?);
    if !has_display() {
        return Err(unopened("there is no display"));
    }
    begin_tables();
    let keeper = Keeper::of_user(APP_ID)?;
    recovery::kept_open(|begin, state_slot| open(args, begin, state_slot, &keeper), Instant::elapsed)
        .map_err(|ended| match ended {
            Ended::Unopened(reason) => unopened(&reason.to_string()),
            Ended::Broken(reason, state) => broken(&reason, &state, &keeper),
        })?;
    keeper.end()
}

/// Prints the reports on the models of the scene.
fn report(state: &State) {
    state.document.scene.reports().for_each(|report| messages::remark(format_args!("gamow: {report}")));
}

/// Has the tables made in which colours are looked up, while the window opens: its first frame needs them,
/// and they take longer than all else of it.
fn begin_tables() {
    threads::spawn(|| (colour::linear_srgb(550.0), planck::black_body(12.0), sunlit::log2_level(0.0)));
}

fn unopened(reason: &str) -> anyhow::Error {
    anyhow::anyhow!("the window cannot be opened: {}. {WHAT_TO_DO}.", in_one_line(reason))
}

/// Returns the error for a window that ended for this `reason`, after its `state` is kept.
fn broken(reason: &Break, state: &State, keeper: &Keeper) -> anyhow::Error {
    let reason = in_one_line(&reason.to_string());
    match keeper.keep(state) {
        Ok(()) => {
            anyhow::anyhow!("the window cannot go on: {reason}. What it showed is kept for the next start.")
        }
        Err(error) => {
            anyhow::anyhow!("the window cannot go on: {reason}. What it showed could not be kept: {error:#}.")
        }
    }
}

/// Whether the environment names a display, where that is how displays are found.
fn has_display() -> bool {
    let names = ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"];
    !cfg!(target_os = "linux") || names.into_iter().any(|name| environment::variable(name).is_some())
}

/// An error of the windowing library, without line breaks and without the place in its source.
fn in_one_line(message: &str) -> String {
    let reason = message.rsplit_once(".rs:").map_or(message, |(_, reason)| reason);
    let reason = reason.trim_start_matches(|c: char| c.is_ascii_digit() || c == ':' || c == ' ');
    reason.split_whitespace().collect::<Vec<_>>().join(" ").trim_end_matches('.').to_owned()
}

/// Opens a window in the state `begin`, or by default in that of the flags and the last window, and leaves
/// its own state to the `state_slot`; returns when it is closed.
fn open(
    args: &WindowArgs,
    begin: Option<State>,
    state_slot: &StateSlot,
    keeper: &Keeper,
) -> Result<(), Break> {
    // Another window in place of a broken one begins in the state of that.
    let loaded = if begin.is_none() { keeper.load() } else { Loaded::default() };
    let viewport = ViewportBuilder::default()
        .with_title(TITLE)
        .with_app_id(APP_ID)
        .with_icon(icon::icon())
        .with_inner_size(args.window_size_or_default().map(|side| side as f32))
        .with_min_inner_size([LEAST_SIDE; 2]);
    let viewport = if args.window_size.is_none() {
        keeper.placed(viewport)
    } else {
        // A size that is asked for is no habit: it does not take the place of the remembered one.
        keeper.forget_place();
        viewport
    };
    let options =
        NativeOptions { viewport, wgpu_options: graphics::configuration(), ..NativeOptions::default() };
    let (left, left_to) = (state_slot.clone(), keeper.clone());
    let _last_word = LastWord::new(move || {
        messages::failure(&match left.take() {
            Some(left) => broken(&Break::Exit, &left.state, &left_to),
            None => unopened(&Break::Exit.to_string()),
        })
    });
    let (args, state_slot, keeper) = (args.clone(), state_slot.clone(), keeper.clone());
    let create = move |cc: &CreationContext<'_>| {
        let state = match begin {
            Some(state) => state,
            None => first_state(&args, loaded)?,
        };
        keeper.memory().restore_in(&cc.egui_ctx, args.window_size.is_none());
        if args.window_size.is_none() {
            let memory = keeper.memory();
            bring_back(cc, &memory);
            if !memory.has_place() {
                fit_on_screen(cc, args.window_size_or_default());
            }
        }
        if let Some(render_state) = &cc.wgpu_render_state {
            painting::install(&cc.egui_ctx, render_state);
        }
        let app = App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state);
        let app = app.preparing_in_background(&cc.egui_ctx).kept_by(keeper);
        Ok(Box::new(RecoverableApp::new(app, state_slot)) as Box<dyn eframe::App>)
    };
    wishes::ask();
    recovery::guarded(|| eframe::run_native(APP_ID, options, Box::new(create)))
}

/// Has a window that was left on a screen that is no longer there come back.
fn bring_back(cc: &CreationContext<'_>, memory: &Memory) {
    let Some(window) = cc.winit_window() else { return };
    let scale = window.scale_factor();
    let monitors = window.available_monitors().map(|monitor| {
        let (position, size) = (monitor.position(), monitor.size());
        let places = [[position.x.into(), position.y.into()], [size.width.into(), size.height.into()]];
        places.map(|pair: [f64; 2]| pair.map(|side| (side / scale) as f32))
    });
    memory.bring_back(&cc.egui_ctx, monitors);
}

/// Has a first window of this `size`, points, leave room on its screen for its frame and the desktop's
/// panels.
fn fit_on_screen(cc: &CreationContext<'_>, size: [u32; 2]) {
    let Some(monitor) = cc.winit_window().and_then(|window| window.current_monitor()) else { return };
    let screen = monitor.size().to_logical::<f32>(monitor.scale_factor());
    let size = size.map(|side| side as f32);
    let fitting = fitting(size, [screen.width, screen.height]);
    if fitting != size {
        cc.egui_ctx.send_viewport_cmd(ViewportCommand::InnerSize(fitting.into()));
    }
}

/// Returns `size`, or as much of it as fits on a `screen`, both in points. The room that the desktop takes is
/// not known on any system: a title bar and a panel at the top or at the bottom are left out.
fn fitting(size: [f32; 2], screen: [f32; 2]) -> [f32; 2] {
    const ROOM: [f32; 2] = [16.0, 96.0];
    std::array::from_fn(|axis| size[axis].min(screen[axis] - ROOM[axis]).max(LEAST_SIDE))
}

/// The state that the flags ask for, and the rest as the last window left it.
fn first_state(args: &WindowArgs, left: Loaded) -> anyhow::Result<State> {
    let Loaded { settings, memory, answers, notice } = left;
    let mut state = state_from(args, settings)?;
    state.session.recent.extend(memory.recent());
    recall(&mut state, &memory, &answers, args.welcomes());
    state.scratch.notice = notice.or(state.scratch.notice);
    Ok(state)
}

/// The state to start in. Where the scene that was left is no more, the usual one is shown, and why.
fn state_from(args: &WindowArgs, left: Settings) -> anyhow::Result<State> {
    let scene = left.scene.clone();
    let default = left.clone().with_scene(Settings::default().scene);
    args.state(left).or_else(|error| {
        let mut state = args.state(default)?;
        state.tell(Notice::error(error).about(Path::new(&scene)));
        Ok(state)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::state::lesson::LessonCommand;
    use crate::app::state::overlay::Overlay;
    use crate::lesson::{Library, Record};

    #[test]
    fn a_first_window_leaves_room_for_its_frame_and_for_panels() {
        let usual = [1280.0, 800.0];
        assert_eq!(fitting(usual, [1920.0, 1080.0]), usual);
        assert_eq!(fitting(usual, [1366.0, 768.0]), [1280.0, 672.0]);
        assert_eq!(fitting(usual, [800.0, 360.0]), [784.0, LEAST_SIDE]);
    }

    /// A window over what is kept in a folder, and what it did there.
    fn started(keeper: &Keeper, welcomes: bool) -> State {
        let Loaded { settings, memory, answers, .. } = keeper.load();
        let mut state = State::open(settings).expect("a preset");
        recall(&mut state, &memory, &answers, welcomes);
        state
    }

    #[test]
    fn newcomers_begin_with_the_start_page() {
        let folder = tempfile::tempdir().expect("a folder");
        let keeper = || Keeper::in_folder(folder.path());
        let overlay = |welcomes| started(&keeper(), welcomes).session.overlay;
        assert_eq!((overlay(true), overlay(false)), (Some(Overlay::Start), None));
        // Closing it and the window changes nothing.
        let window = keeper();
        window.keep(&started(&window, true)).expect("it is written");
        assert_eq!(overlay(true), Some(Overlay::Start));
        let window = keeper();
        let mut state = started(&window, true);
        let lesson = Library::own().open("turned").expect("it is there");
        state.begin_lesson(&lesson).expect("it can be shown");
        assert_eq!(state.session.overlay, None);
        window.keep(&state).expect("it is written");
        // The lesson shows no controls; the next window does.
        let again = started(&keeper(), true);
        assert!(!state.document.settings.window.controls && again.document.settings.window.controls);
        assert_eq!((again.session.overlay, again.session.next_lesson.as_deref()), (None, Some("turned")));
        let other = tempfile::tempdir().expect("a folder");
        let window = Keeper::in_folder(other.path());
        let mut state = started(&window, true);
        state.session.hint = false;
        window.keep(&state).expect("it is written");
        assert_eq!(started(&Keeper::in_folder(other.path()), true).session.overlay, None);
    }

    #[test]
    fn answers_in_a_lesson_outlast_the_window() {
        let folder = tempfile::tempdir().expect("a folder");
        let keeper = Keeper::in_folder(folder.path());
        let lesson = Library::own().open("turned").expect("it is there");
        let mut state = started(&keeper, false);
        state.begin_lesson(&lesson).expect("it can be shown");
        state.run(LessonCommand::Skip);
        let left = state.course().expect("a lesson").clone();
        assert_ne!(left.records()[0], Record::default());
        keeper.keep(&state).expect("it is written");
        // Begun from the start page, and by a flag.
        for begins_first in [false, true] {
            let Loaded { memory, answers, .. } = Keeper::in_folder(folder.path()).load();
            let mut state = State::open(Settings::default()).expect("a preset");
            if begins_first {
                state.begin_lesson(&lesson).expect("it can be shown");
            }
            recall(&mut state, &memory, &answers, false);
            if !begins_first {
                state.begin_lesson(&lesson).expect("it can be shown");
            }
            let course = state.course().expect("a lesson");
            assert_eq!((course.records(), course.place()), (left.records(), left.place()));
        }
    }
}
