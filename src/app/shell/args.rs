//! The flags with which the window starts in a given state.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Arg, Args};

use crate::app::state::State;
use crate::app::state::stage::Stage;
use crate::flags::choices::sides;
use crate::lesson::{LessonError, Library, Sequence};
use crate::scene::Scene;
use crate::settings::{Settings, StartArgs};

/// The flags of the window. Settings that are not given stay as they were left or, with a scene or a state
/// given, are defaults.
#[derive(Debug, Clone, Args)]
#[command(mut_args(without_the_files))]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag")]
pub struct WindowArgs {
    /// Start with T running.
    #[arg(long, conflicts_with = "paused")]
    play: bool,
    /// Start with T at rest, as by default.
    #[arg(long)]
    paused: bool,
    /// Start in front of an audience: on the whole screen, with large writing, without controls.
    #[arg(long)]
    present: bool,
    /// Keep settings as they were left: with `--scene` or `--state`, which else start from the defaults, all
    /// others (with a state: the parts of the window, the screen and the layout).
    #[arg(long)]
    keep_settings: bool,
    /// Begin this lesson or preset; the name of a file has its ending, `.md`. `--list` names them all.
    #[arg(long, value_name = "NAME|FILE", conflicts_with = "state")]
    lesson: Option<PathBuf>,
    /// Go through a sequence of your own: a text file that names a preset, a state, a link or a step of a
    /// lesson in each line. Page Down and Page Up go through it.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["state", "scene", "lesson"])]
    sequence: Option<PathBuf>,
    /// A folder with your own lessons, beside the program's. A lesson of the same name replaces the
    /// program's.
    #[arg(long, value_name = "DIR")]
    lessons: Option<PathBuf>,
    /// Name all lessons and presets, or with `--scene` or `--state` all bodies of that scene, and exit.
    #[arg(long)]
    pub list: bool,
    /// With `--list`: write JSON.
    #[arg(long, requires = "list")]
    pub json: bool,
    /// Inner size of the window.
    #[arg(long, value_parser = size, value_name = "WIDTHxHEIGHT")]
    pub window_size: Option<[u32; 2]>,
    /// Draw the window once, save it as a PNG file and exit. Needs no display. What was left in the window is
    /// neither used nor changed.
    #[arg(long, value_name = "FILE.png")]
    pub screenshot: Option<PathBuf>,
    #[command(flatten)]
    start: StartArgs,
}

/// Leaves out of the help what is about files only.
fn without_the_files(flag: Arg) -> Arg {
    let is_of_views = ["layout", "swapped"].map(Some).contains(&flag.get_long());
    let is_of_files = flag.get_help_heading() == Some("Picture") && !is_of_views;
    flag.hide(is_of_files)
}

/// Default inner size of the window, points.
const DEFAULT_SIZE: [u32; 2] = [1280, 800];

impl WindowArgs {
    /// The state to start in: settings as they were `left`, unless the flags name what is shown, with what
    /// they say in their stead.
    ///
    /// # Errors
    /// A bad flag, file or scene.
    pub fn state(&self, left: Settings) -> anyhow::Result<State> {
        let is_kept = self.keep_settings || !self.names_what_is_shown();
        let mut state =
            State::open(self.start.settings(if is_kept { left } else { Settings::default() })?)?;
        state.scratch.playing = self.play;
        state.document.opened = self.start.file().map(Path::to_owned);
        if self.present {
            state.session.stage = Stage::presented();
        }
        if self.lessons.is_some() {
            state.session.library = Some(Arc::new(self.library()?));
        }
        if let Some(name) = &self.lesson {
            let lesson = state.library().open(name)?;
            state.begin_lesson(&lesson)?;
            state.scratch.playing = self.play;
        }
        if let Some(path) = &self.sequence {
            state.begin_sequence(Sequence::load(path, &state.library())?);
            state.session.recent.add(path);
        }
        for file in state.shown_files().iter().rev() {
            state.session.recent.add(file);
        }
        Ok(state)
    }

    /// Whether they say what is shown: a scene, a state, a lesson or a sequence.
    #[must_use]
    pub fn names_what_is_shown(&self) -> bool {
        self.lesson.is_some() || self.sequence.is_some() || self.start.name_what_is_shown()
    }

    /// Whether a newcomer is to find the start page: not where something is named to be shown, or an audience
    /// waits.
    #[must_use]
    pub fn welcomes(&self) -> bool {
        !self.names_what_is_shown() && !self.present
    }

    /// The scene that a flag or a state names, if one does.
    ///
    /// # Errors
    /// A bad flag, file or scene.
    pub fn named_scene(&self) -> anyhow::Result<Option<Scene>> {
        if !self.start.name_what_is_shown() {
            return Ok(None);
        }
        Ok(Some(self.start.settings(Settings::default())?.opened_scene()?))
    }

    /// The lessons that there are.
    ///
    /// # Errors
    /// A folder that cannot be listed, or a lesson in it that cannot be read.
    pub fn library(&self) -> Result<Library, LessonError> {
        Library::new(self.lessons.as_deref())
    }

    /// Inner size of the window, points.
    #[must_use]
    pub fn window_size_or_default(&self) -> [u32; 2] {
        self.window_size.unwrap_or(DEFAULT_SIZE)
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    sides(text, 64..=8192)
}
