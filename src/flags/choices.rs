//! Choices among named values, and their spelling in flags and files.

use std::fmt;
use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;

use clap::ValueEnum;
use relativity_render::Gaze;
use serde::Serialize;

pub use super::compare::Compare;
pub use super::layout::{Form, Layout, Swapped};
use super::within;

/// Returns the choice `steps` further than `choice` in the list of all, or back; after the last comes the
/// first.
#[must_use]
pub fn further<C: ValueEnum + PartialEq>(choice: &C, steps: isize) -> C {
    let all = C::value_variants();
    let place = all.iter().position(|one| one == choice).unwrap_or_default();
    all[(place.cast_signed() + steps).rem_euclid(all.len().cast_signed()).cast_unsigned()].clone()
}

/// The choice of a renderer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RendererChoice {
    /// The cheapest method that keeps a bound of the error (`--error`), or the most accurate that keeps a
    /// frame's budget of time (`--budget`).
    #[default]
    Auto,
    /// A ray test per pixel on the GPU, in 32-bit floats.
    Rays,
    /// A ray test per pixel on the CPU, in 32-bit floats, eight pixels at a time.
    Packets,
    /// Triangles on the GPU. Only these draw the geometry published, and one-cone there.
    Mesh,
    /// A ray test per pixel on the CPU, in 64-bit floats: the truth that the others are compared with. In the
    /// window it draws in the background when nothing moves; until it is done, the rays do.
    Reference,
}

/// The kind of a file, by its extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A picture (PNG).
    Png,
    /// Measurements of every pixel.
    Exr,
}

impl FileKind {
    /// The extension of such files.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Exr => "exr",
        }
    }

    /// The kind of file that `path` names.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
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

/// Longest side of one eye's picture, pixels.
const MAX_SIDE: u32 = 16_384;

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        sides(text, 1..=MAX_SIDE).map(Self)
    }
}

/// Parses width and height, each inside `range`.
pub fn sides(text: &str, range: RangeInclusive<u32>) -> Result<[u32; 2], String> {
    let side = |text: &str| text.trim().parse().ok().filter(|side| range.contains(side));
    let sides = text.split_once('x').and_then(|(width, height)| Some([side(width)?, side(height)?]));
    let (least, most) = range.clone().into_inner();
    sides.ok_or_else(|| format!("write it like 960x540, each side from {least} to {most}"))
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height] = self.0;
        write!(f, "{width}x{height}")
    }
}

/// The gaze of both eyes, in parallel.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum GazeChoice {
    /// At the apparent middle of all that moves.
    #[default]
    Whole,
    /// At the tracked point, as in the paper: along the bisector of its two apparent directions.
    Point,
    /// Straight ahead, along +y.
    Ahead,
    /// Abreast, as high as all that moves: in conformal pictures the whole passage, from far left to far
    /// right.
    Passage,
    /// Fixed: azimuth and elevation, degrees.
    #[serde(untagged)]
    Fixed([f64; 2]),
}

/// The map from an eye's lines of sight to places in its picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProjectionChoice {
    /// Conformal: Mercator's projection with its poles at the ends of the line between the eyes. Small things
    /// keep their shape everywhere: a globe stays round. Motion along that line only slides the picture, by
    /// the rapidity, and two eyes can fuse it. Things far aside are enlarged.
    #[default]
    Mercator,
    /// Camera: a flat picture across the gaze, as a photograph and in the paper. Straight lines stay
    /// straight, and what is far from the middle is stretched. A point then has two heights in the two
    /// pictures, which differ by more than eyes can fuse.
    Gaze,
    /// Flat screens: both pictures on planes along the line between the eyes, as two screens side by side
    /// would show them. Two eyes can fuse them; what is aside is stretched.
    Parallel,
    /// Everything ahead, 180 x 180 degrees, for headsets. Drawn by the reference renderer; the field of view
    /// and the gaze's elevation are not used.
    Vr180,
}

/// The distance at which something is in the same place in both eyes' pictures, which an image shift sets.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ZeroParallax {
    /// The distance at which two eyes place the tracked point, or the hub that it turns about.
    #[default]
    Point,
    /// Without end: the pictures are not shifted.
    Infinity,
    /// A given distance, perpendicular to the picture plane.
    #[serde(untagged)]
    Distance(f64),
}

impl ProjectionChoice {
    /// Whether both eyes' pictures can be fused, and are shifted for what lies in the screen.
    #[must_use]
    pub const fn is_fused(self) -> bool {
        matches!(self, Self::Mercator | Self::Parallel)
    }

    /// Returns the camera's projection for the conformal one, and the conformal one for any other.
    #[must_use]
    pub const fn toggled(self) -> Self {
        match self {
            Self::Mercator => Self::Gaze,
            Self::Gaze | Self::Parallel | Self::Vr180 => Self::Mercator,
        }
    }
}

impl ZeroParallax {
    /// The distance at which a point would lie that is in these columns of the left and the right eye's
    /// unshifted picture, focal lengths to the right along the line between two eyes `separation` apart;
    /// infinity where that is not in front.
    #[must_use]
    pub fn of_columns(separation: f64, [left, right]: [f64; 2]) -> Self {
        let distance = separation / (left - right);
        let (nearest, furthest) = PARALLAX_DISTANCE.into_inner();
        if distance > 0.0 && distance <= furthest {
            Self::Distance(distance.max(nearest))
        } else {
            Self::Infinity
        }
    }

    /// Returns the difference of columns in the pictures of two eyes `separation` apart at that distance,
    /// focal lengths; `None` where the distance is not known yet.
    #[must_use]
    pub fn shift(self, separation: f64) -> f64 {
        match self {
            Self::Point | Self::Infinity => 0.0,
            Self::Distance(distance) => (separation / distance).min(MAX_SHIFT),
        }
    }
}

/// Nearest and furthest that what has no parallax can be set to be.
pub const PARALLAX_DISTANCE: RangeInclusive<f64> = 1e-9..=1e12;

/// The widest shift of two pictures, focal lengths: it takes anything out of any picture.
const MAX_SHIFT: f64 = 1e4;

impl FromStr for ZeroParallax {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "point" => Ok(Self::Point),
            "infinity" => Ok(Self::Infinity),
            _ => within(PARALLAX_DISTANCE)(text)
                .map(Self::Distance)
                .map_err(|reason| format!("{reason}; write `point`, `infinity`, or a distance")),
        }
    }
}

/// Azimuths that a gaze can have, degrees: twice round.
pub const AZIMUTH: RangeInclusive<f64> = -720.0..=720.0;
/// Elevations that it can have, degrees.
pub const ELEVATION: RangeInclusive<f64> = -89.999..=89.999;

impl GazeChoice {
    /// The gaze in radians, if it follows nothing.
    #[must_use]
    pub fn fixed(self) -> Option<Gaze> {
        match self {
            Self::Whole | Self::Point | Self::Passage => None,
            Self::Ahead => Some(Gaze::STRAIGHT_AHEAD),
            Self::Fixed(degrees) => {
                let [azimuth, elevation] = degrees.map(f64::to_radians);
                Some(Gaze { azimuth, elevation })
            }
        }
    }

    /// Fixed at `gaze`, or as close to straight up or down as [`ELEVATION`] goes.
    #[must_use]
    pub const fn fixed_at(gaze: Gaze) -> Self {
        let elevation = gaze.elevation.to_degrees().clamp(*ELEVATION.start(), *ELEVATION.end());
        Self::Fixed([gaze.azimuth.to_degrees(), elevation])
    }
}

impl FromStr for GazeChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "whole" => return Ok(Self::Whole),
            "point" => return Ok(Self::Point),
            "ahead" => return Ok(Self::Ahead),
            "passage" => return Ok(Self::Passage),
            _ => (),
        }
        let Some((azimuth, elevation)) = text.split_once(',') else {
            let choices =
                "write `whole`, `point`, `ahead`, `passage`, or azimuth and elevation in degrees like 90,0";
            return Err(choices.to_owned());
        };
        let azimuth = within(AZIMUTH)(azimuth).map_err(|reason| format!("azimuth: {reason} degrees"))?;
        let elevation = within(ELEVATION)(elevation)
            .map_err(|reason| format!("elevation: {reason} degrees, so that the horizon is level"))?;
        Ok(Self::Fixed([azimuth, elevation]))
    }
}
