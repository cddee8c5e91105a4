//! Reopening of a window that cannot go on: it is opened again once, else its state is left for the
//! next start.

use std::cell::RefCell;
use std::fmt;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::rc::{Rc, Weak};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use eframe::egui::{Context, Ui};
use gamow_platform::clock::Instant;

use crate::app::shell::App;
use crate::app::state::notice::Notice;
use crate::app::state::{Scratch, State};
use crate::caption::capitalised;

/// Time within which a device that is lost again is given up.
const SOON: Duration = Duration::from_mins(1);

/// The state that a window leaves when it ends, however it does.
#[derive(Debug)]
pub struct LastState {
    /// State that the lost window showed.
    pub state: State,
    /// Why the graphics device was lost, if it was.
    pub loss: Option<String>,
}

impl LastState {
    /// Returns the state that `app` would leave now.
    fn from_app(app: &App) -> Self {
        Self { state: app.state().clone(), loss: app.loss() }
    }
}

/// The place where a window leaves its state, and where it is found until then.
#[derive(Clone, Default)]
pub struct StateSlot {
    window: Rc<RefCell<Weak<RefCell<App>>>>,
    left: Rc<RefCell<Option<LastState>>>,
}

impl StateSlot {
    fn leave(&self, left: LastState) {
        self.left.replace(Some(left));
    }

    /// Returns the state that the window has left, or would leave now; `None` if there never was one.
    pub fn take(&self) -> Option<LastState> {
        self.left.take().or_else(|| {
            let app = self.window.borrow().upgrade()?;
            app.try_borrow().ok().map(|app| LastState::from_app(&app))
        })
    }
}

/// The window, whose state outlives it.
pub struct RecoverableApp {
    app: Rc<RefCell<App>>,
    state_slot: StateSlot,
}

impl RecoverableApp {
    /// `app`, which leaves its state to the `state_slot`.
    pub fn new(app: App, state_slot: StateSlot) -> Self {
        let app = Rc::new(RefCell::new(app));
        state_slot.window.replace(Rc::downgrade(&app));
        Self { app, state_slot }
    }
}

impl eframe::App for RecoverableApp {
    fn logic(&mut self, ctx: &Context, frame: &mut eframe::Frame) {
        self.app.borrow_mut().logic(ctx, frame);
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.app.borrow_mut().ui(ui, frame);
    }

    fn on_exit(&mut self) {
        self.app.borrow_mut().on_exit();
    }
}

impl Drop for RecoverableApp {
    fn drop(&mut self) {
        self.state_slot.leave(LastState::from_app(&self.app.borrow()));
    }
}

/// The reason why a window ended without its user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Break {
    /// A window that could not be had, or could not go on, with the windowing library's reason.
    Window(String),
    /// The display of the window is gone.
    Display,
    /// A system library ended the program.
    Exit,
    /// A graphics device that is of no use any more, with its library's reason.
    Device(String),
}

impl fmt::Display for Break {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Window(reason) => f.write_str(reason),
            Self::Display => f.write_str("the display is gone"),
            Self::Exit => {
                f.write_str("a system library ended it, as that of X11 does where the display is gone")
            }
            Self::Device(reason) => write!(f, "the graphics device was lost ({reason})"),
        }
    }
}

impl Break {
    /// Returns the reason behind a panic of one of the libraries below the window, if it is none of its
    /// defects: a `message` from the source `file`. Any other panic is a defect of this program or of theirs.
    fn parse(message: &str, file: &str) -> Option<Self> {
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

/// Runs the event loop. Where a system library is missing, where the display goes away and where the graphics
/// device is lost the libraries below the window panic; that becomes an error. Any other panic is a defect
/// and is reported as usual.
///
/// # Errors
/// What ended it.
pub fn guarded(run: impl FnOnce() -> eframe::Result) -> Result<(), Break> {
    let default = Arc::new(panic::take_hook());
    let (found, hook) = (Arc::new(Mutex::new(None)), Arc::clone(&default));
    let noted = Arc::clone(&found);
    panic::set_hook(Box::new(move |info| match broken(info) {
        Some(reason) => {
            noted.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(reason);
        }
        None => hook(info),
    }));
    let outcome = panic::catch_unwind(AssertUnwindSafe(run));
    panic::set_hook(Box::new(move |info| default(info)));
    let found = found.lock().unwrap_or_else(PoisonError::into_inner).take();
    match (outcome, found) {
        (Ok(result), _) => result.map_err(|error| Break::Window(error.to_string())),
        (Err(_), Some(reason)) => Err(reason),
        (Err(payload), None) => panic::resume_unwind(payload),
    }
}

fn broken(info: &PanicHookInfo<'_>) -> Option<Break> {
    let file = info.location().map_or("", |place| place.file());
    Break::parse(info.payload_as_str().unwrap_or_default(), file)
}

/// The end of a window that was not ended by its user.
#[derive(Debug)]
pub enum Ended {
    /// A window that never opened.
    Unopened(Break),
    /// A window that could not go on, with the state it showed.
    Broken(Break, Box<State>),
}

/// Has windows open, the first in the state that `open` finds, until one is closed by its user. One that
/// loses its device is followed by another, which begins in the state of the one before, unless that was
/// itself the other one a minute ago.
///
/// # Errors
/// The window that was not to be had, or did not go on.
pub fn kept_open(
    mut open: impl FnMut(Option<State>, &StateSlot) -> Result<(), Break>,
    mut since: impl FnMut(&Instant) -> Duration,
) -> Result<(), Ended> {
    let mut begin: Option<State> = None;
    loop {
        let opened = Instant::now();
        let state_slot = StateSlot::default();
        let result = open(begin.clone(), &state_slot);
        let (state, loss) = match (state_slot.take(), &begin) {
            (Some(LastState { state, loss }), _) => (state, loss),
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
        let scratch = Scratch { notice: Some(Notice::error(text)), ..state.scratch };
        begin = Some(State { scratch, ..state });
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::settings::Settings;

    const LONG: Duration = Duration::from_hours(1);

    fn state(time: f64) -> State {
        State::open(Settings { time: Some(time), ..Settings::default() }).expect("a preset")
    }

    /// Opens windows that end one after the other with the results `ends`, each after its time; returns the
    /// final result, and the times at which they began.
    fn opened(ends: &[(Result<(), Break>, Option<&str>, Duration)]) -> (Result<(), Ended>, Vec<Option<f64>>) {
        let (mut began, lasted) = (Vec::new(), Cell::new(Duration::ZERO));
        let mut ends = ends.iter().cloned();
        let ended = kept_open(
            |begin, state_slot| {
                let (result, loss, time) = ends.next().expect("no further window");
                began.push(begin.as_ref().map(|state| state.document.time));
                lasted.set(time);
                // Those that cannot be had leave nothing.
                if !matches!(&result, Err(Break::Window(_))) {
                    let mut left = begin.unwrap_or_else(|| state(1.0));
                    left.document.time += 1.0;
                    let left = LastState { state: left, loss: loss.map(str::to_owned) };
                    state_slot.leave(left);
                }
                result
            },
            |_| lasted.get(),
        );
        (ended, began)
    }

    #[test]
    fn a_lost_device_is_followed_by_another_window_in_the_same_state() {
        let lost = Err(Break::Device("wgpu error".to_owned()));
        let now = Duration::from_secs(1);
        for first in [(Ok(()), Some("gone"), now), (lost.clone(), None, now)] {
            let (ended, began) = opened(&[first.clone(), (Ok(()), None, now)]);
            assert!(ended.is_ok());
            assert_eq!(began, [None, Some(2.0)]);
            // Soon again: that is the end.
            let (ended, began) = opened(&[first.clone(), first.clone()]);
            assert!(
                matches!(ended, Err(Ended::Broken(Break::Device(_), state)) if state.document.time == 3.0)
            );
            assert_eq!(began.len(), 2);
            // Long after, it is not.
            let later = (first.0.clone(), first.1, LONG);
            assert!(opened(&[first, later.clone(), later, (Ok(()), None, now)]).0.is_ok());
        }
    }

    #[test]
    fn a_window_that_cannot_go_on_leaves_its_state() {
        let now = Duration::from_secs(1);
        let (ended, _) = opened(&[(Err(Break::Display), Some("with it"), now)]);
        assert!(matches!(ended, Err(Ended::Broken(Break::Display, state)) if state.document.time == 2.0));
        let none = Err(Break::Window("no adapter".to_owned()));
        let (ended, _) = opened(&[(none.clone(), None, now)]);
        assert!(matches!(ended, Err(Ended::Unopened(_))));
        // The second is not to be had: what the first showed is not lost.
        let (ended, _) = opened(&[(Ok(()), Some("gone"), now), (none, None, now)]);
        assert!(matches!(ended, Err(Ended::Broken(Break::Window(_), state)) if state.document.time == 2.0));
    }

    #[test]
    fn only_what_is_known_is_taken_for_a_lost_display_or_device() {
        let winit = "/home/x/.cargo/registry/src/index/winit-0.30.13/src/platform_impl/linux/x11/window.rs";
        let connection =
            "called `Result::unwrap()` on an `Err` value: Connection(IoError(Custom { kind: Other }))";
        assert_eq!(Break::parse(connection, winit), Some(Break::Display));
        assert_eq!(Break::parse(connection, "src/app/mod.rs"), None);
        assert_eq!(Break::parse("index out of bounds", winit), None);
        let painter = "C:\\registry\\src\\egui-wgpu-0.37.0\\src\\renderer.rs";
        let staging = "Failed to create staging buffer for index data.";
        assert!(matches!(Break::parse(staging, painter), Some(Break::Device(_))));
        assert_eq!(Break::parse(staging, "src/app/eyes.rs"), None);
        assert_eq!(Break::parse("called `Option::unwrap()` on a `None` value", painter), None);
        assert!(matches!(Break::parse("libX11 could not be loaded", "xlib.rs"), Some(Break::Window(_))));
    }
}
