//! Options of a fit: the curves, the model, and the parameters of the object that are free.

use crate::fit::loss::Loss;
use crate::fit::trial::Rolling;
use crate::model::Model;

/// The curves that are fitted.
///
/// Its [name](Self::name) stands for it as a flag's value and in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Curves {
    /// Δφ only: the differences in azimuth, which cannot tell up from down.
    #[cfg_attr(feature = "clap", value(name = "dphi"))]
    #[cfg_attr(feature = "serde", serde(rename = "dphi"))]
    Azimuth,
    /// Δθ only: the differences in elevation.
    #[cfg_attr(feature = "clap", value(name = "dtheta"))]
    #[cfg_attr(feature = "serde", serde(rename = "dtheta"))]
    Polar,
    /// Both curves at once, each weighed by its scatter.
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "both"))]
    Both,
}

impl Curves {
    /// Delta-phi and Delta-theta: whether each is fitted.
    #[must_use]
    pub const fn used(self) -> [bool; 2] {
        [matches!(self, Self::Azimuth | Self::Both), matches!(self, Self::Polar | Self::Both)]
    }

    /// Returns the name of the curves on the command line and in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Azimuth => "dphi",
            Self::Polar => "dtheta",
            Self::Both => "both",
        }
    }
}

/// Knowledge of the object's x0, its objective x at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Passage {
    /// Known: x0 is this number.
    Known(f64),
    /// x0 is to be fitted.
    Fitted,
}

/// Options of a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitOptions {
    /// Binocular model that is fitted.
    pub model: Model,
    /// Disparities that the fit uses: dphi, dtheta or both.
    pub curves: Curves,
    /// x0, known or not.
    pub passage: Passage,
    /// The wheel on which the point is that was seen; y, z and x0 are then its hub's. `None` for a point that
    /// does not turn.
    pub rolling: Option<Rolling>,
    /// The function by which residuals count.
    pub loss: Loss,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            model: Model::Exact,
            curves: Curves::Both,
            passage: Passage::Known(0.0),
            rolling: None,
            loss: Loss::default(),
        }
    }
}

/// A parameter of the fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Parameter {
    /// Speed over c, beta.
    Beta,
    /// Depth y: distance ahead, across the path.
    Y,
    /// Height z above the eyes.
    Z,
    /// Objective x at t = 0.
    X0,
}

impl Parameter {
    /// Every parameter, in the order of all arrays of the fit.
    pub const ALL: [Self; 4] = [Self::Beta, Self::Y, Self::Z, Self::X0];

    /// Returns the name of the parameter in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ["beta", "y", "z", "x0"][self as usize]
    }
}
