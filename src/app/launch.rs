//! Opens the window, or says in one sentence why it cannot be opened and what to do instead.

use std::path::Path;

use eframe::egui::{ViewportBuilder, ViewportCommand};
use eframe::{CreationContext, NativeOptions, Storage, WindowBuilderHook};
use relativity_render::{colour, planck};

use super::args::WindowArgs;
use super::notice::Notice;
use super::overlay::Overlay;
use super::reopening::{self, Bequeathed, Break, Ended, Estate};
use super::state::State;
use super::{App, graphics, icon, memory, painting, screenshot, storage};
use crate::files::whole::ensure_ending;
use crate::flags::words::Shell;
use crate::platform::clock::Instant;
use crate::platform::last_word::LastWord;
use crate::platform::{tell, threads};
use crate::settings::Settings;

/// Name under which settings are saved.
const APP_ID: &str = "gamow";

const WHAT_TO_DO: &str = "On Debian and Ubuntu install `libx11-6 libxcursor1 libxi6 libxkbcommon-x11-0 mesa-vulkan-drivers` \
    and start it inside a graphical session; without one, `gamow --screenshot window.png`, `gamow render --out cyclist.png` and \
    `gamow curve` work all the same";

/// Opens the window and returns when it is closed; with `--screenshot` draws it once instead.
///
/// # Errors
/// A bad flag or scene, no display, no graphics adapter, or a missing system library.
pub fn launch(args: &WindowArgs) -> anyhow::Result<()> {
    if let Some(path) = &args.screenshot {
        ensure_ending("--screenshot", path, "png")?;
        let state = args.state(Settings::default())?;
        let provenance =
            state.session.scene.provenance(state.shown().as_told_in(path).window_command(Shell::RECORDED));
        return screenshot::save(state, args.window_size_or_default(), &provenance.texts(), path);
    }
    // Flags are judged before a window appears; the saved settings are only known once it has.
    args.state(Settings::default())?;
    if !has_display() {
        return Err(unopened("there is no display"));
    }
    begin_tables();
    reopening::kept_open(|begin, estate| open(args, begin, estate), Instant::elapsed).map_err(|ended| {
        match ended {
            Ended::Unopened(reason) => unopened(&reason.to_string()),
            Ended::Broken(reason, state) => broken(&reason, &state),
        }
    })
}

/// Has the tables made in which colours are looked up, while the window opens: its first frame needs them, and they take
/// longer than all else of it.
fn begin_tables() {
    threads::spawn(|| (colour::linear_srgb(550.0), planck::black_body(12.0), planck::band(9.0)));
}

fn unopened(reason: &str) -> anyhow::Error {
    anyhow::anyhow!("the window cannot be opened: {}. {WHAT_TO_DO}.", in_one_line(reason))
}

/// That a window ended for this `reason`, after its `state` is kept.
fn broken(reason: &Break, state: &State) -> anyhow::Error {
    let reason = in_one_line(&reason.to_string());
    match reopening::keep(state, APP_ID) {
        Ok(_) => {
            anyhow::anyhow!("the window cannot go on: {reason}. What it showed is kept for the next start.")
        }
        Err(error) => {
            anyhow::anyhow!("the window cannot go on: {reason}. What it showed could not be kept: {error:#}.")
        }
    }
}

/// Whether the environment names a display, where that is how displays are found.
fn has_display() -> bool {
    let names_one = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !cfg!(target_os = "linux") || ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"].into_iter().any(names_one)
}

/// An error of the windowing library, without line breaks and without the place in its source.
fn in_one_line(message: &str) -> String {
    let reason = message.rsplit_once(".rs:").map_or(message, |(_, reason)| reason);
    let reason = reason.trim_start_matches(|c: char| c.is_ascii_digit() || c == ':' || c == ' ');
    reason.split_whitespace().collect::<Vec<_>>().join(" ").trim_end_matches('.').to_owned()
}

/// Opens a window that begins in this state, or else as the flags and the last one have it, and leaves its own to the
/// `estate`; returns when it is closed.
fn open(args: &WindowArgs, begin: Option<State>, estate: &Estate) -> Result<(), Break> {
    let viewport = ViewportBuilder::default()
        .with_title("Gamow")
        .with_app_id(APP_ID)
        .with_icon(icon::icon())
        .with_inner_size(args.window_size_or_default().map(|side| side as f32))
        .with_min_inner_size([480.0, 320.0]);
    let looked = eframe::storage_dir(APP_ID)
        .map(|folder| storage::look_through(&folder.join(storage::FILE)))
        .unwrap_or_default();
    let options = NativeOptions {
        persistence_path: looked.instead,
        viewport,
        // A size that is asked for is no habit: it does not take the place of the remembered one.
        persist_window: args.window_size().is_none(),
        window_builder: args
            .window_size()
            .map(|size| -> WindowBuilderHook { Box::new(move |viewport| of_size(viewport, size)) }),
        wgpu_options: graphics::configuration(),
        ..NativeOptions::default()
    };
    let left = estate.clone();
    let _last_word = LastWord::new(move || {
        tell::failure(&match left.take() {
            Some(left) => broken(&Break::Exit, &left.state),
            None => unopened(&Break::Exit.to_string()),
        })
    });
    let (args, estate) = (args.clone(), estate.clone());
    let create = move |cc: &CreationContext<'_>| {
        let mut state = match begin {
            Some(state) => state,
            None => first_state(&args, cc.storage)?,
        };
        state.session.notice = looked.notice.or(state.session.notice);
        if args.window_size().is_some() {
            // Where windows are shown before they can be maximised, eframe has a remembered one so once more.
            cc.egui_ctx.send_viewport_cmd(ViewportCommand::Fullscreen(false));
            cc.egui_ctx.send_viewport_cmd(ViewportCommand::Maximized(false));
        }
        if let Some(render_state) = &cc.wgpu_render_state {
            painting::install(&cc.egui_ctx, render_state);
        }
        let app = App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state);
        Ok(Box::new(Bequeathed::new(app, estate)) as Box<dyn eframe::App>)
    };
    reopening::guarded(|| eframe::run_native(APP_ID, options, Box::new(create)))
}

/// The state that the flags ask for, and the rest as the last window left it.
fn first_state(args: &WindowArgs, storage: Option<&dyn Storage>) -> anyhow::Result<State> {
    let mut state = state_from(args, storage.map(memory::remembered).unwrap_or_default())?;
    state.session.recent.extend(storage.map(memory::recent).unwrap_or_default());
    recall(&mut state, storage, args.welcomes());
    Ok(state)
}

/// Has `state` know what its user has done before; newcomers, who have neither clicked a point nor begun a lesson, begin with
/// the start page if the window `welcomes` them.
fn recall(state: &mut State, storage: Option<&dyn Storage>, welcomes: bool) {
    state.session.hint = storage.is_none_or(memory::lacks_a_click);
    let begun = state.session.next_lesson.take().or_else(|| storage.and_then(memory::next_lesson));
    if welcomes && state.session.hint && begun.is_none() {
        state.session.overlay = Some(Overlay::Start);
    }
    state.session.next_lesson = begun;
    state.recall_begun(storage.map(memory::begun).unwrap_or_default());
}

/// The window that eframe is to make, which has put the remembered size into it, with the size that is asked for instead.
fn of_size(viewport: ViewportBuilder, size: [u32; 2]) -> ViewportBuilder {
    viewport.with_inner_size(size.map(|side| side as f32)).with_maximized(false).with_fullscreen(false)
}

/// The state to start in. Where the scene that was left is no more, the usual one is shown, and why.
fn state_from(args: &WindowArgs, left: Settings) -> anyhow::Result<State> {
    let scene = left.scene.clone();
    let usual = left.clone().with_scene(Settings::default().scene);
    args.state(left).or_else(|error| {
        let mut state = args.state(usual)?;
        state.session.notice = Some(Notice::error(error).about(Path::new(&scene)));
        Ok(state)
    })
}

#[cfg(test)]
mod tests {
    use super::reopening::Stored as Kept;
    use super::*;
    use crate::app::command::Command;
    use crate::app::running::LessonCommand;
    use crate::lesson::{Library, Record};

    fn started(storage: Option<&dyn Storage>, welcomes: bool) -> State {
        let mut state = State::open(Settings::default()).expect("a preset");
        recall(&mut state, storage, welcomes);
        state
    }

    #[test]
    fn newcomers_begin_with_the_start_page() {
        let overlay = |storage: &Kept, welcomes| started(Some(storage), welcomes).session.overlay;
        let mut kept = Kept::default();
        assert_eq!(started(None, true).session.overlay, Some(Overlay::Start));
        assert_eq!(overlay(&kept, true), Some(Overlay::Start));
        assert_eq!(overlay(&kept, false), None);
        // Closing it and the window changes nothing.
        let closed = started(Some(&kept), true);
        memory::remember(&mut kept, &closed);
        assert_eq!(overlay(&kept, true), Some(Overlay::Start));
        let mut clicked = Kept::default();
        memory::remember_a_click(&mut clicked);
        assert_eq!(overlay(&clicked, true), None);
        let mut state = started(None, true);
        let lesson = Library::own().open("turned").expect("it is there");
        state.begin_lesson(&lesson).expect("it can be shown");
        assert_eq!(state.session.overlay, None);
        memory::remember(&mut kept, &state);
        // The lesson shows no controls; the next window does.
        assert!(!state.settings.window.controls && memory::remembered(&kept).window.controls);
        let again = started(Some(&kept), true).session;
        assert_eq!((again.overlay, again.next_lesson.as_deref()), (None, Some("turned")));
    }

    #[test]
    fn answers_in_a_lesson_outlast_the_window() {
        let lesson = Library::own().open("turned").expect("it is there");
        let mut state = started(None, false);
        state.begin_lesson(&lesson).expect("it can be shown");
        state.apply(Command::Lesson(LessonCommand::Skip));
        let left = state.course().expect("a lesson").clone();
        assert_ne!(left.records()[0], Record::default());
        let mut kept = Kept::default();
        memory::remember(&mut kept, &state);
        let again = |mut state: State, begins_first: bool| {
            if begins_first {
                state.begin_lesson(&lesson).expect("it can be shown");
            }
            recall(&mut state, Some(&kept), false);
            if !begins_first {
                state.begin_lesson(&lesson).expect("it can be shown");
            }
            let course = state.course().expect("a lesson");
            assert_eq!((course.records(), course.place()), (left.records(), left.place()));
        };
        // Begun from the start page, and by a flag.
        for begins_first in [false, true] {
            again(started(None, false), begins_first);
        }
        kept.set_string("begun", "[{]".to_owned());
        assert_eq!(memory::begun(&kept), []);
    }
}
