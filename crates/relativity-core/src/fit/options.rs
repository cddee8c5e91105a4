//! What is fitted: which curves, by which model, and which parameters of the object.

use crate::fit::trial::Rolling;
use crate::model::Model;

/// Which curves are fitted.
///
/// As a flag's value and in a file they are their [name](Self::name).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Curves {
    /// Delta-phi only: the azimuthal fit.
    #[cfg_attr(feature = "clap", value(name = "dphi"))]
    #[cfg_attr(feature = "serde", serde(rename = "dphi", alias = "Azimuth"))]
    Azimuth,
    /// Delta-theta only: the polar fit.
    #[cfg_attr(feature = "clap", value(name = "dtheta"))]
    #[cfg_attr(feature = "serde", serde(rename = "dtheta", alias = "Polar"))]
    Polar,
    /// Both at once.
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "both", alias = "Both"))]
    Both,
}

impl Curves {
    /// Delta-phi and Delta-theta: whether each is fitted.
    #[must_use]
    pub const fn used(self) -> [bool; 2] {
        [matches!(self, Self::Azimuth | Self::Both), matches!(self, Self::Polar | Self::Both)]
    }

    /// As the command line and the files call them.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Azimuth => "dphi",
            Self::Polar => "dtheta",
            Self::Both => "both",
        }
    }
}

/// What is known of the object's objective x at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Passage {
    /// x0 is this.
    Known(f64),
    /// x0 is to be fitted.
    Fitted,
}

/// What is to be fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitOptions {
    /// The binocular model.
    pub model: Model,
    /// Which curves.
    pub curves: Curves,
    /// x0, known or not.
    pub passage: Passage,
    /// The wheel on which the point is that was seen; y, z and x0 are then its hub's. `None` for a point that does not turn.
    pub rolling: Option<Rolling>,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self { model: Model::Exact, curves: Curves::Both, passage: Passage::Known(0.0), rolling: None }
    }
}

/// A parameter of the fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Parameter {
    /// Speed over c.
    Beta,
    /// Depth.
    Y,
    /// Height.
    Z,
    /// Objective x at t = 0.
    X0,
}

impl Parameter {
    /// Every parameter, in the order of all arrays of the fit.
    pub const ALL: [Self; 4] = [Self::Beta, Self::Y, Self::Z, Self::X0];

    /// Its name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        ["beta", "y", "z", "x0"][self as usize]
    }
}
