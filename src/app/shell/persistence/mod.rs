//! Everything that outlasts the window, in a folder of the user's data: the settings, what the window
//! remembers beside them, and the answers that were given in lessons, in a file for each lesson. Files are
//! written whole or not at all, and a failure is told: in the window, and again when it is closed.

mod answers_file;
mod kept_file;
mod memory;
#[cfg(test)]
mod tests;

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::time::Duration;

use eframe::egui::{Context, ViewportBuilder};
use gamow_platform::clock::Instant;
#[cfg(feature = "desktop")]
use gamow_platform::environment;
use gamow_platform::files;
use gamow_platform::locks::{self, Lock};

use crate::app::state::State;
use crate::app::state::notice::Notice;
use crate::app::state::overlay::Overlay;
use crate::app::tools::debounce::Debounce;
use crate::lesson::Answers;
use crate::settings::{Preset, Settings};
use answers_file::AnswersFiles;
use kept_file::KeptFile;

pub use memory::Memory;

/// The name of the file of the settings, which can be opened like any other.
pub const SETTINGS: &str = "settings.toml";
/// The name of the file of what is remembered beside them.
pub const MEMORY: &str = "window.toml";
/// The file that is locked as long as a window is open.
const WINDOW_LOCK: &str = "window.lock";

/// Time between two writings of the settings.
const INTERVAL: Duration = Duration::from_secs(30);
/// Time after which an answer that is half entered is written too.
const REST: Duration = Duration::from_secs(1);
/// At most this many problems of the settings are listed one by one.
const MOST_LISTED: usize = 5;

/// Everything that the last window has left.
#[derive(Debug, Default)]
pub struct Loaded {
    /// The settings; the default ones if there are none, and where one was invalid. The first window of all
    /// shows few controls.
    pub settings: Settings,
    /// The memory of the window beside them.
    pub memory: Memory,
    /// The answers in lessons.
    pub answers: Answers,
    /// The message to show at the start, if any.
    pub notice: Option<Notice>,
}

/// Writes what outlasts the window, and reads what the last one has left. Clones write the same files.
#[derive(Debug, Clone)]
pub struct Keeper(Rc<RefCell<Files>>);

#[derive(Debug)]
struct Files {
    settings: KeptFile,
    memory_file: KeptFile,
    answers: AnswersFiles,
    memory: Memory,
    /// Whether the window has the place and size that it is to have again.
    is_usual_place: bool,
    saved: Instant,
    /// Whether anything may have changed since then.
    is_changed: bool,
    /// Why the settings, what is beside them, and the answers could not be written the last time.
    failures: [Option<String>; 3],
    /// The failure that was shown.
    shown: Option<String>,
    entering: Debounce<Answers>,
    folder: PathBuf,
    window_lock: Option<Lock>,
}

impl Keeper {
    /// Keeps everything in the user's folder for the program called `name`.
    ///
    /// # Errors
    /// A user without a home.
    #[cfg(feature = "desktop")]
    pub fn of_user(name: &str) -> anyhow::Result<Self> {
        use anyhow::Context as _;
        let folder =
            environment::data_folder(name).context("there is no folder for settings: $HOME is not set")?;
        Ok(Self::in_folder(&folder))
    }

    /// Keeps everything in `folder`.
    #[must_use]
    pub fn in_folder(folder: &Path) -> Self {
        Self(Rc::new(RefCell::new(Files {
            settings: KeptFile::new(folder.join(SETTINGS)),
            memory_file: KeptFile::new(folder.join(MEMORY)),
            answers: AnswersFiles::new(folder),
            memory: Memory::default(),
            is_usual_place: true,
            saved: Instant::now(),
            is_changed: false,
            failures: [None, None, None],
            shown: None,
            entering: Debounce::after(REST),
            folder: folder.to_owned(),
            window_lock: None,
        })))
    }

    /// Reads what the last window has left. A file that cannot be read is moved aside.
    #[must_use]
    pub fn load(&self) -> Loaded {
        let mut files = self.0.borrow_mut();
        let (settings, bad_settings) = files.read_settings();
        let bad_memory = files.read_memory();
        let mut problems: Vec<_> = bad_settings.into_iter().chain(bad_memory).collect();
        let answers = files.answers.load(&mut problems);
        let greeting = files.greeting();
        let problems = (!problems.is_empty()).then(|| Notice::error(problems.join(" ")));
        Loaded { settings, memory: files.memory.clone(), answers, notice: problems.or(greeting) }
    }

    /// Has the window not note its place and size, which a flag gave it.
    pub fn forget_place(&self) {
        self.0.borrow_mut().is_usual_place = false;
    }

    /// Returns the memory of the window beside its settings, as far as it is known.
    #[must_use]
    pub fn memory(&self) -> Memory {
        self.0.borrow().memory.clone()
    }

    /// The `window` where the last one was.
    #[must_use]
    pub fn placed(&self, window: ViewportBuilder) -> ViewportBuilder {
        self.0.borrow().memory.placed(window)
    }

    /// Notes that something was done in `state`. An answer that was given is written at once.
    pub fn note(&self, state: &mut State) {
        let mut files = self.0.borrow_mut();
        files.is_changed = true;
        if files.answers.lacks_an_answer(&state.session.answers) {
            let replaced = files.write_answers(state);
            files.show(&replaced, state);
        }
    }

    /// Writes what is due: now and then everything, and what is half entered once nobody goes on with it.
    pub fn keep_on(&self, state: &mut State, ctx: &Context) {
        let files = &mut *self.0.borrow_mut();
        let is_default = files.is_usual_place;
        files.memory.note_window(ctx, is_default);
        let answers = &state.session.answers;
        let is_rested = files.answers.lacks_an_entry(answers) && files.entering.is_still(ctx, answers);
        let replaced = if files.saved.elapsed() >= INTERVAL {
            files.keep(state)
        } else if is_rested {
            files.write_answers(state)
        } else {
            if files.is_changed {
                // A frame in which it is due, even if nothing else happens.
                ctx.request_repaint_after(INTERVAL.saturating_sub(files.saved.elapsed()));
            }
            return;
        };
        files.show(&replaced, state);
    }

    /// Writes all files of the window.
    ///
    /// # Errors
    /// What could not be written, and why.
    pub fn keep(&self, state: &State) -> anyhow::Result<()> {
        for replaced in self.0.borrow_mut().keep(state) {
            log::warn!("{replaced}");
        }
        self.end()
    }

    /// Ends the program's work.
    ///
    /// # Errors
    /// What could not be written the last time, and why.
    pub fn end(&self) -> anyhow::Result<()> {
        self.0.borrow().failure().map_or(Ok(()), |failure| Err(anyhow::anyhow!(failure)))
    }
}

/// Has `state` know what its user has done before; newcomers, who have neither clicked a point nor begun a
/// lesson, begin with the start page if the window `welcomes` them.
pub fn recall(state: &mut State, memory: &Memory, answers: &Answers, welcomes: bool) {
    state.session.hint = !memory.clicked;
    let next = state.session.next_lesson.take().or_else(|| memory.lesson.clone());
    if welcomes && state.session.hint && next.is_none() {
        state.session.overlay = Some(Overlay::Start);
    }
    state.session.next_lesson = next;
    state.recall_answers(answers);
}

impl Files {
    /// Reads the settings; with a message if some of them were reset.
    fn read_settings(&mut self) -> (Settings, Option<String>) {
        let read = self.settings.read().map(|text| match text {
            Some(text) => Settings::as_far_as_told(&text),
            None => (of_the_first_window(), Vec::new()),
        });
        let (settings, problems) = read.unwrap_or_else(|problem| (Settings::default(), vec![problem]));
        (!problems.is_empty())
            .then(|| reset(&mut self.settings, &settings.to_toml(), &problems))
            .map_or((settings.clone(), None), |message| (settings, Some(message)))
    }

    /// Reads what is remembered beside them, in the same way.
    fn read_memory(&mut self) -> Option<String> {
        let read = self.memory_file.read();
        let read =
            read.and_then(|text| text.map_or_else(|| Ok(Default::default()), |text| Memory::of_text(&text)));
        let (memory, problems) = read.unwrap_or_else(|problem| (Memory::default(), vec![problem]));
        self.memory = memory;
        (!problems.is_empty()).then(|| reset(&mut self.memory_file, &self.memory.to_text(), &problems))
    }

    /// Takes the lock of windows. Returns a message if another window holds it, or if nothing can be written
    /// there.
    fn greeting(&mut self) -> Option<Notice> {
        let locked =
            files::create_folder(&self.folder).and_then(|()| locks::try_lock(&self.folder.join(WINDOW_LOCK)));
        match locked {
            Ok(Some(lock)) => {
                self.window_lock = Some(lock);
                None
            }
            Ok(None) => Some(Notice::done(
                "Another window of Gamow is open. Of each lesson's answers, and of the settings, those \
                    that are changed last are kept.",
            )),
            Err(error) => Some(Notice::error(advice(&format!("{}: {error}", files::shown(&self.folder))))),
        }
    }

    /// Writes everything, each file also where another one fails. Returns messages for the answers of another
    /// window that are replaced.
    fn keep(&mut self, state: &State) -> Vec<String> {
        (self.saved, self.is_changed) = (Instant::now(), false);
        self.memory.note(state);
        self.failures[0] = self.settings.write(&left(state).to_toml()).err();
        self.failures[1] = self.memory_file.write(&self.memory.to_text()).err();
        self.write_answers(state)
    }

    /// Writes the answers, and returns the same messages.
    fn write_answers(&mut self, state: &State) -> Vec<String> {
        let mut replaced = Vec::new();
        self.failures[2] = self.answers.write(&state.session.answers, &mut replaced).err();
        replaced
    }

    /// Returns the files that could not be written the last time, and why.
    fn failure(&self) -> Option<String> {
        let mut failures: Vec<_> = self.failures.iter().flatten().map(String::as_str).collect();
        failures.dedup();
        let [settings, memory, answers] = self.failures.each_ref().map(Option::is_some);
        let what = match (settings || memory, answers) {
            (_, false) => "the settings are not saved",
            (false, true) => "the answers in lessons are not saved",
            (true, true) => "the settings and the answers in lessons are not saved",
        };
        (!failures.is_empty()).then(|| format!("{what}: {}", failures.join("; ")))
    }

    /// Shows that answers of another window were `replaced`, and a failure, once.
    fn show(&mut self, replaced: &[String], state: &mut State) {
        if !replaced.is_empty() {
            state.tell(Notice::error(replaced.join(" ")));
        }
        let failure = self.failure();
        if let Some(failure) = failure.as_ref().filter(|_| failure != self.shown) {
            state.tell(Notice::error(advice(failure)));
        }
        self.shown = failure;
    }
}

/// The settings that the next window begins with. The parts of the window that a lesson shows are its own, as
/// its layout is, and a scene's file is found again wherever the program starts next.
fn left(state: &State) -> Settings {
    let mut settings = Settings { window: state.lesson_base().window, ..state.shown() };
    if let Some(running) = &state.session.lesson {
        settings.picture.layout = running.layout;
    }
    if let Some(path) = state.scene_file().and_then(|path| files::canonical(path).ok()) {
        settings.scene = path.to_string_lossy().into_owned();
    }
    settings
}

/// Returns the message for a `failure`, with the remedy.
fn advice(failure: &str) -> String {
    let failure = crate::caption::capitalised(failure);
    format!(
        "{failure}. Free some space, or make the folder writable: it is tried again every 30 s and when the window is closed."
    )
}

/// Moves a file with `problems` aside, writes `text` in its place, and returns a message for both.
fn reset(file: &mut KeptFile, text: &str, problems: &[String]) -> String {
    let where_it_is = file.set_aside();
    // Where this fails it fails again when the window is closed, and is told.
    let _ = file.write(text);
    let listed = problems.iter().take(MOST_LISTED).map(String::as_str).collect::<Vec<_>>().join("; ");
    let more = match problems.len().saturating_sub(MOST_LISTED) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    format!("These saved settings were invalid and have been reset: {listed}{more}. {where_it_is}")
}

/// The settings of a user's first window: the first preset among few controls.
fn of_the_first_window() -> Settings {
    let settings = Preset::all()[0].settings.clone();
    Settings { window: settings.window.with_few(true), ..settings }
}
