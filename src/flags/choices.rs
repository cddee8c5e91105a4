//! The values of `gamow render`'s flags: what can be chosen, and how it is written.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use clap::ValueEnum;
use relativity_render::Gaze;

use crate::flags::finite_number;

/// Longest side of one eye's picture, pixels.
const MAX_SIDE: u32 = 16_384;

/// How the pictures of the two eyes share a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Layout {
    /// The left eye's picture on the left, the right eye's on the right (for parallel viewing).
    SideBySide,
    /// The other way round, for crossed eyes.
    CrossEyed,
    /// The left eye only.
    Left,
    /// The right eye only.
    Right,
    /// Brightness of the left eye in red, of the right eye in cyan, for red-cyan glasses.
    Anaglyph,
    /// The left eye in blue and the right eye in orange, added.
    Overlay,
}

/// An effect that is drawn or left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Switch {
    /// Yes.
    On,
    /// No.
    Off,
}

/// What a file can be, by its extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A picture.
    Png,
    /// Measurements.
    Exr,
}

impl FileKind {
    /// The end of its files' names.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Exr => "exr",
        }
    }

    /// The kind of file that `path` names.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?;
        match extension.to_ascii_lowercase().as_str() {
            "png" => Some(Self::Png),
            "exr" => Some(Self::Exr),
            _ => None,
        }
    }
}

/// Width and height of one eye's picture, pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size(pub [u32; 2]);

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |text: &str| text.trim().parse().ok().filter(|side| (1..=MAX_SIDE).contains(side));
        let sides = text.split_once('x').and_then(|(width, height)| Some([side(width)?, side(height)?]));
        sides.map(Self).ok_or_else(|| format!("write it like 960x540, each side from 1 to {MAX_SIDE}"))
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height] = self.0;
        write!(f, "{width}x{height}")
    }
}

/// Where both eyes look, in parallel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GazeChoice {
    /// Towards the mean of the two places where the tracked point appears.
    Track,
    /// Fixed: azimuth and elevation, degrees.
    Fixed([f64; 2]),
}

impl GazeChoice {
    /// The fixed gaze in radians, if it is one.
    #[must_use]
    pub fn fixed(self) -> Option<Gaze> {
        match self {
            Self::Track => None,
            Self::Fixed(degrees) => {
                let [azimuth, elevation] = degrees.map(f64::to_radians);
                Some(Gaze { azimuth, elevation })
            }
        }
    }
}

impl FromStr for GazeChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "track" {
            return Ok(Self::Track);
        }
        let Some((azimuth, elevation)) = text.split_once(',') else {
            return Err("write `track`, or azimuth and elevation in degrees like 90,0".to_owned());
        };
        let [azimuth, elevation] = [finite_number(azimuth)?, finite_number(elevation)?];
        if elevation.abs() >= 90.0 {
            return Err(
                "the elevation must be between -90 and 90 degrees, so that the horizon is level".to_owned()
            );
        }
        Ok(Self::Fixed([azimuth, elevation]))
    }
}

impl fmt::Display for GazeChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Track => f.write_str("track"),
            Self::Fixed([azimuth, elevation]) => write!(f, "{azimuth},{elevation}"),
        }
    }
}

/// A number, or `off`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumberOrOff(pub Option<f64>);

impl FromStr for NumberOrOff {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "off" { Ok(Self(None)) } else { finite_number(text).map(|value| Self(Some(value))) }
    }
}

impl fmt::Display for NumberOrOff {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(value) => write!(f, "{value}"),
            None => f.write_str("off"),
        }
    }
}

/// Parses a field of view, degrees.
pub fn field_of_view(text: &str) -> Result<f64, String> {
    let degrees = finite_number(text)?;
    if degrees > 0.0 && degrees < 180.0 {
        Ok(degrees)
    } else {
        Err("must be between 0 and 180 degrees".to_owned())
    }
}

/// The word that selects `choice` on the command line.
#[must_use]
pub fn word(choice: &impl ValueEnum) -> String {
    choice.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
}
