//! The state in the fragment of the page's address: `#beta=0.99&scene=globe`, `#lesson=rods`, `#present`,
//! `#stereoscope`, `#start`, `#answers=TOKEN`; with `data=NAME` for a table of one's own.

use std::path::{Path, PathBuf};

use gamow_platform::files;
use percent_encoding::{NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

use crate::app::state::State;
use crate::app::state::notice::Notice;
use crate::app::state::overlay::Overlay;
use crate::lesson::class::{KEY, link_pair};
use crate::settings::{Settings, link_of_pairs};

/// The fragment of an address.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Fragment {
    /// The name of a lesson to begin.
    pub lesson: Option<String>,
    /// Whether the window is shown to an audience.
    pub presents: bool,
    /// Whether the window is the screen of a stereoscope.
    pub stereoscope: bool,
    /// Whether the start page lies over the window.
    pub start: bool,
    /// The token of a pupil's answers.
    pub answers: Option<String>,
    /// The name of the table with own data that is fitted. The address cannot carry the table itself.
    pub data: Option<String>,
    /// The settings that differ from the defaults, as in a link.
    pairs: String,
}

impl Fragment {
    /// Parses the text behind the `#`.
    pub fn parse(text: &str) -> Self {
        let mut fragment = Self::default();
        let mut pairs = Vec::new();
        for part in text.split('&').filter(|part| !part.is_empty()) {
            match part.split_once('=') {
                Some(("lesson", name)) => fragment.lesson = Some(name.to_owned()),
                Some((KEY, token)) => fragment.answers = Some(token.to_owned()),
                Some(("data", name)) => {
                    fragment.data = Some(percent_decode_str(name).decode_utf8_lossy().into_owned())
                }
                None if part == "present" => fragment.presents = true,
                None if part == "stereoscope" => fragment.stereoscope = true,
                None if part == "start" => fragment.start = true,
                _ => pairs.push(part),
            }
        }
        fragment.pairs = pairs.join("&");
        fragment
    }

    /// Returns the fragment of what `state` shows; `None` for a lesson in a file. Files are named: they are
    /// the browser's to keep.
    pub fn from_state(state: &State) -> Option<Self> {
        let lesson = match state.course() {
            Some(course) if course.lesson().path.is_some() => return None,
            course => course.map(|course| course.lesson().name.clone()),
        };
        let pairs = if lesson.is_some() { String::new() } else { state.shown().pairs() };
        let stage = &state.session.stage;
        let start = is_start_page(state);
        let data = fitted_table(state).map(str::to_owned);
        Some(Self {
            lesson,
            presents: stage.is_presented(),
            stereoscope: stage.stereoscope,
            start,
            answers: followed_answers(state).map(str::to_owned),
            data,
            pairs,
        })
    }

    /// Returns the text behind the `#`.
    pub fn to_text(&self) -> String {
        let data = |name: &String| format!("data={}", utf8_percent_encode(name, NON_ALPHANUMERIC));
        let parts = [
            self.lesson.as_ref().map(|name| format!("lesson={name}")),
            self.presents.then(|| "present".to_owned()),
            self.stereoscope.then(|| "stereoscope".to_owned()),
            self.start.then(|| "start".to_owned()),
            self.answers.as_deref().map(link_pair),
            self.data.as_ref().map(data),
            (!self.pairs.is_empty()).then(|| self.pairs.clone()),
        ];
        parts.into_iter().flatten().collect::<Vec<_>>().join("&")
    }

    /// Whether the address leaves open what is shown, so that a newcomer may be welcomed.
    pub fn welcomes(&self) -> bool {
        *self == Self::default()
    }

    /// Returns the table that the address names, unless `state` fits it already.
    pub fn wanted_data(&self, state: &State) -> Option<&Path> {
        let name = self.data.as_ref()?;
        let is_fitted = state.session.data.as_ref().is_some_and(|file| file.name == *name);
        (!is_fitted).then_some(Path::new(name))
    }

    /// Returns the link that its settings make, with defaults for all others.
    fn link(&self) -> PathBuf {
        PathBuf::from(link_of_pairs(&self.pairs))
    }

    /// Returns the link to what is shown at this address. `None` for a lesson, which has its own, and for
    /// `#start` and its like alone, which leave open what is shown behind them.
    pub fn link_to_follow(&self) -> Option<PathBuf> {
        let leaves_open = self.pairs.is_empty() && !self.welcomes();
        (self.lesson.is_none() && !leaves_open).then(|| self.link())
    }

    /// Returns the link with a pupil's answers, if it has some.
    pub fn link_with_answers(&self) -> Option<PathBuf> {
        self.answers.as_ref().map(|token| PathBuf::from(link_of_pairs(&link_pair(token))))
    }

    /// Returns the settings that it leads to, and a message if there is something wrong with it. What it does
    /// not name is as it was `left`, or for what is shown the default.
    pub fn settings(&self, left: Settings) -> (Settings, Option<String>) {
        if self.pairs.is_empty() {
            return (left, None);
        }
        match Settings::default().in_place_of(&left).with_file(&self.link()) {
            Ok(settings) => (settings, None),
            Err(error) => (left, Some(error.to_string())),
        }
    }
}

/// Returns the token of the answers that a link has led to, while they are shown.
pub fn followed_answers(state: &State) -> Option<&str> {
    state.session.class.followed.as_deref().filter(|_| state.session.overlay == Some(Overlay::Class))
}

/// Whether the start page, or one of those behind it, lies over the window.
fn is_start_page(state: &State) -> bool {
    state.session.overlay.is_some_and(Overlay::is_page)
}

/// Returns the name of the table with own data that is fitted, but in a lesson, which has its own address.
pub fn fitted_table(state: &State) -> Option<&str> {
    state.session.data.as_ref().filter(|_| state.course().is_none()).map(|file| file.name.as_str())
}

/// Returns the message that the page does not have the table at `path`, which an address names.
pub fn missing_data(path: &Path) -> Notice {
    Notice::error(format!(
        "{} is not here: the page comes from a link, or its browser has not kept the table. Until you open your data again \
        (File, Fit own data), simulated ones are fitted.",
        files::shown(path)
    ))
}

/// A place that a reader opens, and comes back to by the browser's Back.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Opened {
    /// The start page, or a page that it leads to.
    Start,
    /// The lesson, or the preset, of this name.
    Lesson(String),
}

impl Opened {
    /// Returns the opened place of `state`, if any.
    pub fn from_state(state: &State) -> Option<Self> {
        if is_start_page(state) {
            return Some(Self::Start);
        }
        state.course().map(|course| Self::Lesson(course.lesson().name.clone()))
    }
}
