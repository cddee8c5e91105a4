//! Presets: states with a name, a title and a caption, compiled in.

use std::sync::LazyLock;

use gamow_platform::shipped::ShippedFile;
use gamow_platform::shipped_file;

use super::all::Settings;
use super::file::Heading;

/// A state that has something to show.
#[derive(Debug, Clone, PartialEq)]
pub struct Preset {
    /// Group on the page of presets.
    pub group: PresetGroup,
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
    /// Picture on its card, a JPEG.
    pub card: ShippedFile,
}

/// The groups of presets, in the order of their page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PresetGroup {
    /// What is seen of a body that passes.
    See,
    /// Rides through the street.
    Ride,
    /// Measurements with two eyes.
    Measure,
    /// The states of the paper's figures.
    Paper,
}

impl PresetGroup {
    /// All groups, in order.
    pub const ALL: [Self; 4] = [Self::See, Self::Ride, Self::Measure, Self::Paper];

    /// Returns the title of the group.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::See => "See",
            Self::Ride => "Ride",
            Self::Measure => "Measure",
            Self::Paper => "From the paper",
        }
    }
}

macro_rules! files {
    ($($group:ident: $($name:literal),+;)+) => {
        [$($((
            PresetGroup::$group,
            $name,
            include_str!(concat!("../../assets/presets/", $name, ".toml")),
            shipped_file!("assets/cards/", $name, ".jpg"),
        )),+),+]
    };
}

/// The groups, names, files and cards of all, best first in each group; the first is the start.
const FILES: [(PresetGroup, &str, &str, ShippedFile); 28] = files![
    See: "real-light", "street", "gamow-1938", "rolling-wheel", "tram", "globe", "die", "vienna-cube", "vienna-sphere",
        "beaming", "lattice", "panorama", "train", "extreme-gamma";
    Ride: "ride-seasons", "ride-post-office", "ride-lamps", "ride-overtaking", "ride-twins", "ride-tunnel";
    Measure: "measuring", "missing-parallax";
    Paper: "abreast", "abreast-0.6", "approaching", "receding", "overhead", "disparity-curve";
];

static ALL: LazyLock<Vec<Preset>> = LazyLock::new(|| {
    let preset = |(group, name, text, card)| {
        Preset::read(group, name, text, card).unwrap_or_else(|| unreachable!("tests read every preset"))
    };
    FILES.map(preset).into()
});

impl Preset {
    /// Returns every preset; the first is the start.
    #[must_use]
    pub fn all() -> &'static [Self] {
        &ALL
    }

    /// Returns the preset to start from.
    #[must_use]
    pub fn start() -> &'static Self {
        &ALL[0]
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
                if own.is_in_one_picture() {
                    shown.picture.layout = settings.picture.layout;
                }
                shown == *settings
            })
        };
        with(settings).or_else(|| with(&Settings { time: None, ..settings.clone() }))
    }

    fn read(group: PresetGroup, name: &'static str, text: &'static str, card: ShippedFile) -> Option<Self> {
        let Heading { title, caption } = Heading::in_toml(text)?;
        let settings = Settings::default().with_toml(text, name).ok()?;
        Some(Self { group, name, title, caption, settings, toml: text, card })
    }
}
