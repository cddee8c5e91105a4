//! What the window remembers from one time to the next.

use eframe::Storage;

use crate::settings::{Legacy, Settings};

/// Where the settings are kept, as the text of a file of settings.
const KEY: &str = "settings";

/// The settings as they were left; as usual if there are none that can be read.
#[must_use]
pub fn remembered(storage: &dyn Storage) -> Settings {
    let Some(text) = storage.get_string(KEY) else {
        return eframe::get_value(storage, eframe::APP_KEY)
            .as_ref()
            .map(Legacy::settings)
            .unwrap_or_default();
    };
    Settings::default().with_toml(&text, "what was remembered").unwrap_or_else(|error| {
        log::warn!("{error}");
        Settings::default()
    })
}

/// Keeps `settings`.
pub fn remember(storage: &mut dyn Storage, settings: &Settings) {
    storage.set_string(KEY, settings.to_toml());
}

/// Where it is kept that the user once followed a point by a click.
const CLICKED: &str = "clicked";

/// Whether nobody has yet followed a point by a click.
pub fn is_of_a_newcomer(storage: &dyn Storage) -> bool {
    storage.get_string(CLICKED).is_none()
}

/// Keeps that somebody has.
pub fn remember_a_click(storage: &mut dyn Storage) {
    storage.set_string(CLICKED, "yes".to_owned());
}
