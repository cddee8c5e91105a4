//! Presets: states with a name, a title and a caption, compiled in.

use std::sync::LazyLock;

use super::all::Settings;
use super::file::Heading;

/// A state that has something to show.
#[derive(Debug, Clone, PartialEq)]
pub struct Preset {
    /// Name on the command line.
    pub name: &'static str,
    /// Title on its card of the start page and in the palette.
    pub title: String,
    /// Caption: what is seen, and why.
    pub caption: String,
    /// Its settings, with defaults for all that its file leaves out.
    pub settings: Settings,
    /// Text of the preset's file.
    pub toml: &'static str,
}

macro_rules! files {
    ($($name:literal),+ $(,)?) => {
        [$(($name, include_str!(concat!("../../assets/presets/", $name, ".toml")))),+]
    };
}

/// The names of all, and their files; the first is the start.
const FILES: [(&str, &str); 26] = files![
    "street",
    "overhead",
    "approaching",
    "abreast",
    "receding",
    "abreast-0.6",
    "disparity-curve",
    "gamow-1938",
    "die",
    "globe",
    "train",
    "tram",
    "rolling-wheel",
    "panorama",
    "lattice",
    "vienna-cube",
    "vienna-sphere",
    "beaming",
    "extreme-gamma",
    "measuring",
    "missing-parallax",
    "ride-lamps",
    "ride-post-office",
    "ride-tunnel",
    "ride-overtaking",
    "ride-twins",
];

static ALL: LazyLock<Vec<Preset>> = LazyLock::new(|| {
    let preset =
        |(name, text)| Preset::read(name, text).unwrap_or_else(|| unreachable!("tests read every preset"));
    FILES.map(preset).into()
});

impl Preset {
    /// Returns every preset; the first is the start.
    #[must_use]
    pub fn all() -> &'static [Self] {
        &ALL
    }

    /// The names of all, in a line.
    pub(super) fn names() -> String {
        Self::all().iter().map(|preset| preset.name).collect::<Vec<_>>().join(", ")
    }

    /// The one of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        ALL.iter().find(|preset| preset.name == name)
    }

    /// The one with these settings, whatever the parts of the window, the screen and the layout are. One that
    /// gives no T has them at any.
    #[must_use]
    pub fn matching(settings: &Settings) -> Option<&'static Self> {
        let with = |settings: &Settings| {
            ALL.iter().find(|Self { settings: own, .. }| {
                let mut shown = own.clone().in_place_of(settings);
                if own.ride.is_on() {
                    shown.picture.layout = settings.picture.layout;
                }
                shown == *settings
            })
        };
        with(settings).or_else(|| with(&Settings { time: None, ..settings.clone() }))
    }

    fn read(name: &'static str, text: &'static str) -> Option<Self> {
        let Heading { title, caption } = Heading::in_toml(text)?;
        let settings = Settings::default().with_toml(text, name).ok()?;
        Some(Self { name, title, caption, settings, toml: text })
    }
}
