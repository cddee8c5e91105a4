//! What becomes of the window's state where the window cannot go on: it is opened again once, else the state is kept for the
//! next start.

use std::collections::BTreeMap;
use std::fmt;
use std::io::Write as _;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use anyhow::Context as _;
use eframe::Storage;
use eframe::egui::{Context, Ui};

use super::notice::Notice;
use super::state::{Session, State};
use super::{App, memory};
use crate::caption::capitalised;
use crate::files::whole::write_whole;
use crate::platform::clock::Instant;
use crate::platform::files;

/// A device that is lost again within this time is not asked for another window.
const SOON: Duration = Duration::from_secs(60);

/// What a window leaves when it ends, however it does.
#[derive(Debug)]
pub struct Left {
    /// What it showed.
    pub state: State,
    /// Why its device was lost, if it was.
    pub loss: Option<String>,
}

/// Where a window leaves it.
pub type Estate = Arc<Mutex<Option<Left>>>;

/// The window, whose state outlives it.
pub struct Bequeathed {
    app: App,
    estate: Estate,
}

impl Bequeathed {
    /// `app`, which leaves its state to the `estate`.
    pub const fn new(app: App, estate: Estate) -> Self {
        Self { app, estate }
    }
}

impl eframe::App for Bequeathed {
    fn logic(&mut self, ctx: &Context, frame: &mut eframe::Frame) {
        self.app.logic(ctx, frame);
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.app.ui(ui, frame);
    }

    fn save(&mut self, storage: &mut dyn Storage) {
        self.app.save(storage);
    }
}

impl Drop for Bequeathed {
    fn drop(&mut self) {
        let left = Left { state: self.app.state().clone(), loss: self.app.loss() };
        *self.estate.lock().unwrap_or_else(PoisonError::into_inner) = Some(left);
    }
}

/// What ended a window without its user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Break {
    /// It could not be had, or it could not go on, as the windowing library says.
    Window(String),
    /// The display that it was on is gone.
    Display,
    /// The graphics device is of no use any more, as its library says.
    Device(String),
}

impl fmt::Display for Break {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Window(reason) => f.write_str(reason),
            Self::Display => f.write_str("the display is gone"),
            Self::Device(reason) => write!(f, "the graphics device was lost ({reason})"),
        }
    }
}

impl Break {
    /// What a panic of one of the libraries below the window is, if it is none of its defects: a `message` from the source
    /// `file`. Any other panic is a defect of this program or of theirs.
    fn of(message: &str, file: &str) -> Option<Self> {
        let is_from = |library: &str| file.replace('\\', "/").contains(&format!("/{library}-"));
        if message.contains("could not be loaded") {
            return Some(Self::Window(message.to_owned()));
        }
        let is_windowing =
            ["winit", "egui-winit", "x11rb", "x11rb-protocol", "eframe"].into_iter().any(is_from);
        if is_windowing
            && ["Connection(", "ConnectionError", "IoError"].iter().any(|word| message.contains(word))
        {
            return Some(Self::Display);
        }
        let said = [
            "Failed to create staging buffer",
            "wgpu error",
            "surface isn't supported",
            "Error in Surface::",
        ];
        let is_drawing = ["egui-wgpu", "wgpu"].into_iter().any(is_from);
        (is_drawing && said.iter().any(|word| message.contains(word)))
            .then(|| Self::Device(message.split_whitespace().collect::<Vec<_>>().join(" ")))
    }
}

/// Runs the event loop. Where a system library is missing, where the display goes away and where the graphics device is lost
/// the libraries below the window panic; that becomes an error. Any other panic is a defect and is reported as usual.
///
/// # Errors
/// What ended it.
pub fn guarded(run: impl FnOnce() -> eframe::Result) -> Result<(), Break> {
    let usual = Arc::new(panic::take_hook());
    let (found, hook) = (Arc::new(Mutex::new(None)), Arc::clone(&usual));
    let noted = Arc::clone(&found);
    panic::set_hook(Box::new(move |info| match broken(info) {
        Some(reason) => {
            noted.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(reason);
        }
        None => hook(info),
    }));
    let outcome = panic::catch_unwind(AssertUnwindSafe(run));
    panic::set_hook(Box::new(move |info| usual(info)));
    let found = found.lock().unwrap_or_else(PoisonError::into_inner).take();
    match (outcome, found) {
        (Ok(result), _) => result.map_err(|error| Break::Window(error.to_string())),
        (Err(_), Some(reason)) => Err(reason),
        (Err(payload), None) => panic::resume_unwind(payload),
    }
}

fn broken(info: &PanicHookInfo<'_>) -> Option<Break> {
    let file = info.location().map_or("", |place| place.file());
    Break::of(info.payload_as_str().unwrap_or_default(), file)
}

/// How a window that did not end by its user came to its end.
#[derive(Debug)]
pub enum Ended {
    /// It was never there.
    Unopened(Break),
    /// It could not go on; it showed this.
    Broken(Break, Box<State>),
}

/// Has windows open, the first in the state that `open` finds, until one is closed by its user. One that loses its device is
/// followed by another, which begins in the state of the one before, unless that was itself the other one a minute ago.
///
/// # Errors
/// The window that was not to be had, or did not go on.
pub fn kept_open(
    mut open: impl FnMut(Option<State>, &Estate) -> Result<(), Break>,
    mut since: impl FnMut(&Instant) -> Duration,
) -> Result<(), Ended> {
    let mut begin: Option<State> = None;
    loop {
        let opened = Instant::now();
        let estate = Estate::default();
        let result = open(begin.clone(), &estate);
        let left = estate.lock().unwrap_or_else(PoisonError::into_inner).take();
        let (state, loss) = match (left, &begin) {
            (Some(Left { state, loss }), _) => (state, loss),
            (None, Some(state)) => (state.clone(), None),
            (None, None) => return result.map_err(Ended::Unopened),
        };
        let reason = match (result, loss) {
            (Err(Break::Display), _) => Break::Display,
            (_, Some(why)) => Break::Device(why),
            (Ok(()), None) => return Ok(()),
            (Err(reason), None) => reason,
        };
        let is_again = begin.is_some() && since(&opened) < SOON;
        if is_again || !matches!(reason, Break::Device(_)) {
            return Err(Ended::Broken(reason, Box::new(state)));
        }
        let text = format!(
            "{}. This is another window, with all that the last one showed.",
            capitalised(&reason.to_string())
        );
        log::warn!("{text}");
        begin =
            Some(State { session: Session { notice: Some(Notice::error(text)), ..state.session }, ..state });
    }
}

/// What eframe keeps in its file, without a window.
#[derive(Default)]
struct Stored(BTreeMap<String, String>);

impl Storage for Stored {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

/// Keeps `state` as the window of the program `app_id` does when it is closed, and says where.
///
/// # Errors
/// The file system's.
pub fn keep(state: &State, app_id: &str) -> anyhow::Result<PathBuf> {
    let folder = eframe::storage_dir(app_id).context("there is no folder for it")?;
    files::create_folder(&folder)?;
    let path = folder.join("app.ron");
    keep_in(&path, state)?;
    Ok(path)
}

/// Keeps `state` in eframe's file at `path`, with what else is there.
fn keep_in(path: &Path, state: &State) -> anyhow::Result<()> {
    let text = files::read_to_string(path).unwrap_or_default();
    let mut stored = Stored(ron::from_str(&text).unwrap_or_default());
    memory::keep(&mut stored, state);
    let text = ron::to_string(&stored.0)?;
    write_whole(path, |file| Ok(file.write_all(text.as_bytes())?))
}
