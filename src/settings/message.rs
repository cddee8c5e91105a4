//! Settings in a message to another instance of the program: the text of their file.

use serde::de::Error as _;
use serde::{Deserialize as _, Deserializer, Serializer};

use super::all::Settings;

/// The text of all settings, which may be in a box.
pub mod all {
    use super::{Deserializer, Serializer, Settings};

    /// Writes the text of the settings.
    pub fn serialize<S: Serializer>(settings: &Settings, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&settings.to_toml())
    }

    /// Reads the settings from their text.
    pub fn deserialize<'de, D: Deserializer<'de>, T: From<Settings>>(deserializer: D) -> Result<T, D::Error> {
        super::read(deserializer).map(T::from)
    }
}

/// The text of the fit's settings alone.
pub mod fit {
    use super::{Deserializer, Serializer, Settings};
    use crate::settings::FitSettings;

    /// Writes the text of the settings.
    pub fn serialize<S: Serializer>(fit: &FitSettings, serializer: S) -> Result<S::Ok, S::Error> {
        super::all::serialize(&Settings { fit: *fit, ..Settings::default() }, serializer)
    }

    /// Reads the settings from their text.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<FitSettings, D::Error> {
        super::read(deserializer).map(|settings| settings.fit)
    }
}

fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Settings, D::Error> {
    let text = String::deserialize(deserializer)?;
    Settings::default().with_toml(&text, "the message").map_err(D::Error::custom)
}
