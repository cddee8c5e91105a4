//! The section of the look: geometry, gaze, field of view and projection of the views.

use std::ops::RangeInclusive;

use clap::Args;
use relativity_render::Geometry;
use serde::Serialize;

use crate::flags::FieldOfView;
use crate::flags::choices::{Compare, GazeChoice, ProjectionChoice, ZeroParallax};

/// Narrowest and widest field of view that can be set in the window, degrees.
const FOV_DEGREES: RangeInclusive<f64> = 2.0..=150.0;
/// The widest of them in conformal pictures: u from -5.4 to 5.4.
const WIDEST_CONFORMAL: f64 = 179.5;

/// Geometry, gaze, field of view and projection.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Look")]
pub struct LookSettings {
    /// Geometry of the views: each point where it is seen, where it is measured to be at T, or as if all were
    /// at rest.
    #[arg(long, value_enum)]
    pub geometry: Geometry,
    /// Two pictures of the left eye in place of both eyes': the first follows all other settings, the second
    /// is this one. A gaze that follows does so in each; both have one field of view. The layout must be side
    /// by side or over-under.
    #[arg(long, value_enum)]
    #[serde(skip_serializing_if = "Compare::is_off")]
    pub compare: Compare,
    /// Gaze of both eyes, in parallel: at the middle of all that moves (`whole`), at the selected point,
    /// straight ahead along y, abreast at the whole passage, or fixed: azimuth (from +x towards +y; 90 is
    /// straight ahead) and elevation in degrees.
    #[arg(long, value_name = "whole|point|ahead|passage|AZ,EL", allow_hyphen_values = true)]
    pub gaze: GazeChoice,
    /// Horizontal field of view of each eye, degrees, as it would be straight ahead; `auto` fits it to all
    /// that moves with the scene (usually 42 to 150, wider in conformal pictures), or to the whole passage,
    /// from 81 degrees left to 81 right or further; with the gaze ahead it is 110, with any other 60.
    #[arg(long, value_name = "auto|DEG", allow_hyphen_values = true)]
    pub fov: FieldOfView,
    /// Projection of lines of sight into a picture. What is measured does not depend on it.
    ///
    /// In conformal pictures and on flat screens, both eyes see a point in one row if the head is held along
    /// the motion, or the point rests; else in two: of the paper's cyclist at 0.9 c up to 25 arcmin apart as
    /// it comes to eyes turned by 20 degrees, 42 if they are tilted by 10, 65 if one is above the other.
    #[arg(long, value_enum)]
    pub projection: ProjectionChoice,
    /// Zero parallax: what has the same place in both pictures, and so appears in the plane of the screen:
    /// the selected point (or the hub that it turns about), what is infinitely far away, or what is this far
    /// ahead, 1e-9 to 1e12. Each picture is shifted as a whole; measured values do not change.
    ///
    /// It takes pictures that two eyes can fuse: not those of --projection gaze.
    #[arg(long, value_name = "point|infinity|DISTANCE", allow_hyphen_values = true)]
    pub zero_parallax: ZeroParallax,
}

/// The field of view that is used to show a point or a direction, degrees.
pub const USUAL_FOV: f64 = 60.0;
/// Field of view straight ahead, degrees: wide enough for a passing scene to be seen coming and going.
pub const FOV_AHEAD: f64 = 110.0;

impl LookSettings {
    /// The fields of view that can be set in the window, degrees.
    #[must_use]
    pub const fn fov_range(&self) -> RangeInclusive<f64> {
        let conformal = matches!(self.projection, ProjectionChoice::Mercator);
        *FOV_DEGREES.start()..=if conformal { WIDEST_CONFORMAL } else { *FOV_DEGREES.end() }
    }

    /// The field of view, degrees, unless what is to be seen decides it.
    #[must_use]
    pub fn set_fov(&self) -> Option<f64> {
        self.fov.0.or(match self.gaze {
            GazeChoice::Whole | GazeChoice::Passage => None,
            GazeChoice::Ahead => Some(FOV_AHEAD),
            GazeChoice::Point | GazeChoice::Fixed(_) => Some(USUAL_FOV),
        })
    }
}
