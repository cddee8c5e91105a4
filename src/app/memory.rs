//! What the window remembers from one time to the next.

use std::collections::BTreeMap;

use eframe::Storage;
use eframe::egui::Context;

use super::recent::Recent;
use super::state::State;
use super::toolkit;
use crate::lesson::KeptCourse;
use crate::platform::files;
use crate::settings::{Legacy, Settings};

/// Where the settings are kept, as the text of a file of settings.
const KEY: &str = "settings";
/// Where the files that were opened are kept.
const RECENT: &str = "recent";

/// The settings as they were left; as usual if there are none, and where one cannot be.
#[must_use]
pub fn remembered(storage: &dyn Storage) -> Settings {
    settings_in(|key| storage.get_string(key)).0
}

/// The settings that are kept under the key for which there is one; and what of them cannot be, a line each.
fn settings_in(text_of: impl Fn(&str) -> Option<String>) -> (Settings, Vec<String>) {
    if let Some(text) = text_of(KEY) {
        return Settings::as_far_as_told(&text);
    }
    let Some(text) = text_of(eframe::APP_KEY) else { return (Settings::default(), Vec::new()) };
    match ron::from_str::<Legacy>(&text) {
        Ok(legacy) => legacy.settings(),
        Err(error) => (Settings::default(), vec![format!("the settings cannot be read ({error})")]),
    }
}

/// Has what is `kept` be such that all of it can be: the settings, and the ways through lessons; what could not, a line each.
pub fn mend(kept: &mut BTreeMap<String, String>) -> Vec<String> {
    let (settings, mut problems) = settings_in(|key| kept.get(key).cloned());
    if !problems.is_empty() {
        kept.remove(eframe::APP_KEY);
        kept.insert(KEY.to_owned(), settings.to_toml());
    }
    if let Some(problem) = kept.get(BEGUN).and_then(|text| begun_in(text).err()) {
        kept.remove(BEGUN);
        problems.push(problem);
    }
    problems
}

/// Keeps what the windowing library is to know again.
pub fn remember_toolkit(storage: &mut dyn Storage, ctx: &Context) {
    if let Ok(text) = ctx.memory(ron::to_string) {
        storage.set_string(toolkit::KEY, toolkit::kept(&text).0);
    }
}

/// The files that were opened.
#[must_use]
pub fn recent(storage: &dyn Storage) -> Recent {
    storage.get_string(RECENT).map(|text| Recent::of_text(&text)).unwrap_or_default()
}

/// Keeps all that the next start begins with.
pub fn keep(storage: &mut dyn Storage, state: &State) {
    if !state.session.hint {
        remember_a_click(storage);
    }
    remember(storage, state);
}

/// Keeps what is shown, and which files were opened. A scene's file is found again wherever the program starts next.
pub fn remember(storage: &mut dyn Storage, state: &State) {
    // A lesson's parts of the window are its own.
    let mut settings = Settings { window: state.lesson_base().window, ..state.shown() };
    if let Some(path) = state.scene_file().and_then(|path| files::canonical(path).ok()) {
        settings.scene = path.to_string_lossy().into_owned();
    }
    storage.set_string(KEY, settings.to_toml());
    storage.set_string(RECENT, state.session.recent.to_text());
    if let Some(name) = &state.session.next_lesson {
        storage.set_string(LESSON, name.clone());
    }
    match serde_json::to_string(&state.begun()) {
        Ok(begun) => storage.set_string(BEGUN, begun),
        Err(error) => log::warn!("the answers in lessons: {error}"),
    }
}

/// Where the ways through lessons are kept.
const BEGUN: &str = "begun";

/// The ways through lessons as they were left; none if there are none that can be read.
#[must_use]
pub fn begun(storage: &dyn Storage) -> Vec<KeptCourse> {
    storage.get_string(BEGUN).and_then(|text| begun_in(&text).ok()).unwrap_or_default()
}

fn begun_in(text: &str) -> Result<Vec<KeptCourse>, String> {
    serde_json::from_str(text).map_err(|error| format!("the answers in lessons cannot be read ({error})"))
}

/// Where the name of the lesson to go on with is kept.
const LESSON: &str = "lesson";

/// The name of the lesson to go on with, once one was begun.
pub fn next_lesson(storage: &dyn Storage) -> Option<String> {
    storage.get_string(LESSON)
}

/// Where it is kept that the user once followed a point by a click.
const CLICKED: &str = "clicked";

/// Whether nobody has yet followed a point by a click.
pub fn lacks_a_click(storage: &dyn Storage) -> bool {
    storage.get_string(CLICKED).is_none()
}

/// Keeps that somebody has.
pub fn remember_a_click(storage: &mut dyn Storage) {
    storage.set_string(CLICKED, "yes".to_owned());
}
