//! The quantities of a point that is seen, a row each. Plots, the readout and lessons take names, units and
//! values from here; the columns of tables are named by the same identifiers.

use relativity_core::{Conformal, ConformalDisparity, Disparity, Sighting, Stereo};
use serde::{Deserialize, Serialize};

use crate::units::{Measures, Unit};

/// A quantity of a point that is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Quantity {
    /// The difference of both eyes' azimuths.
    DeltaPhi,
    /// The difference of both eyes' elevations.
    DeltaTheta,
    /// Difference of columns of conformal pictures.
    DeltaU,
    /// Difference of rows of conformal pictures.
    DeltaV,
    /// The Doppler factor D.
    Doppler,
    /// When the light left.
    EmissionTime,
    /// The proper time that the clock of the body showed as the light left.
    ProperTime,
    /// Apparent position along the motion, from the eye.
    X,
    /// Apparent position in depth.
    Y,
    /// Apparent height above the eye.
    Z,
    /// The azimuth of the direction in which it is seen.
    Phi,
    /// The elevation of the direction in which it is seen.
    Theta,
    /// Column of a conformal picture.
    U,
    /// Row of a conformal picture.
    V,
    /// The stereo gain of both eyes.
    StereoGain,
    /// The distance, as one eye or both have it, or as it is measured.
    Distance,
}

/// The names, the unit and the formula of a quantity.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// The name of the quantity in files, as of a lesson's curve.
    pub id: &'static str,
    /// The symbol of the quantity, or its name where it has none.
    pub symbol: &'static str,
    /// The name of the quantity, with its symbol.
    pub name: &'static str,
    /// An explanation of the quantity, with its formula.
    pub about: &'static str,
    /// The dimension that the quantity is counted in.
    pub dimension: Dimension,
    /// Decimals that are shown of it, in units of the scene.
    pub decimals: u8,
    /// Whether its axes are logarithmic.
    pub is_logarithmic: bool,
    /// The function of what is seen that gives the quantity.
    pub of: Of,
}

/// The dimension of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// An angle, in radians.
    Angle,
    /// A length, in the scene's unit.
    Length,
    /// A time, in the scene's unit.
    Time,
    /// No unit: a ratio, or a rapidity.
    Ratio,
}

/// The function of what is seen that gives a quantity.
#[derive(Debug, Clone, Copy)]
pub enum Of {
    /// A function of what both eyes see.
    Pair(fn(&Disparity) -> f64),
    /// A function of what one eye sees.
    Sighting(fn(&Sighting) -> f64),
    /// A function of the places in both eyes' conformal pictures.
    ConformalPair(fn(&ConformalDisparity) -> f64),
    /// A function of the place in one eye's conformal picture.
    Conformal(fn(&Conformal) -> f64),
    /// A function of the stereo position.
    Stereo(fn(&Stereo) -> f64),
}

const RADIANS: Unit = Unit { factor: 1.0, name: "rad" };

impl Quantity {
    /// The quantities of which a lesson can have a curve drawn.
    pub const DRAWN: [Self; 5] = [Self::DeltaPhi, Self::DeltaTheta, Self::Doppler, Self::Phi, Self::Theta];
    /// The rows of the readout, from the top.
    pub const READ_OUT: [Self; 8] = [
        Self::Doppler,
        Self::EmissionTime,
        Self::ProperTime,
        Self::X,
        Self::Y,
        Self::Z,
        Self::Phi,
        Self::Theta,
    ];
    /// The rows of the readout below these for conformal pictures.
    pub const READ_OUT_OF_CONFORMAL: [Self; 2] = [Self::U, Self::V];
    /// The disparities: of the readout, and of their plots.
    pub const DISPARITIES: [Self; 2] = [Self::DeltaPhi, Self::DeltaTheta];
    /// The plots of disparities of conformal pictures.
    pub const CONFORMAL_DISPARITIES: [Self; 2] = [Self::DeltaU, Self::DeltaV];
    /// The plots of directions against T.
    pub const ANGLE_PLOTS: [Self; 2] = [Self::Phi, Self::Theta];
    /// The plot of received light.
    pub const DOPPLER_PLOT: [Self; 1] = [Self::Doppler];
    /// The plots of what two eyes make of a place.
    pub const STEREO_PLOTS: [Self; 2] = [Self::StereoGain, Self::Distance];

    /// Returns the quantity's row.
    #[must_use]
    pub const fn row(self) -> &'static Row {
        match self {
            Self::DeltaPhi => &DELTA_PHI,
            Self::DeltaTheta => &DELTA_THETA,
            Self::DeltaU => &DELTA_U,
            Self::DeltaV => &DELTA_V,
            Self::Doppler => &DOPPLER,
            Self::EmissionTime => &EMISSION_TIME,
            Self::ProperTime => &PROPER_TIME,
            Self::X => &X,
            Self::Y => &Y,
            Self::Z => &Z,
            Self::Phi => &PHI,
            Self::Theta => &THETA,
            Self::U => &U,
            Self::V => &V,
            Self::StereoGain => &STEREO_GAIN,
            Self::Distance => &DISTANCE,
        }
    }

    /// Whether the quantity is a difference between what both eyes see.
    #[must_use]
    pub const fn is_disparity(self) -> bool {
        matches!(self.row().of, Of::Pair(_) | Of::ConformalPair(_))
    }

    /// Returns the unit of the quantity where lengths and times are shown in these `measures`.
    #[must_use]
    pub const fn unit(self, measures: &Measures) -> Unit {
        match self.row().dimension {
            Dimension::Angle => RADIANS,
            Dimension::Length => measures.length,
            Dimension::Time => measures.time,
            Dimension::Ratio => Unit::OWN,
        }
    }

    /// Returns the quantity of what is `seen`: of one that each eye has, the left eye's. `None` of one that
    /// needs more than the disparity.
    #[must_use]
    pub fn seen(self, seen: &Disparity) -> Option<f64> {
        match self.row().of {
            Of::Pair(of) => Some(of(seen)),
            Of::Sighting(of) => Some(of(&seen.primary)),
            Of::ConformalPair(_) | Of::Conformal(_) | Of::Stereo(_) => None,
        }
    }
}

const DELTA_PHI: Row = Row {
    id: "dphi",
    symbol: "Δφ",
    name: "Δφ, left − right",
    about: "Azimuth as the left eye sees the point, less that of the right eye.\nΔφ = φ left − φ right",
    dimension: Dimension::Angle,
    decimals: 5,
    is_logarithmic: false,
    of: Of::Pair(|both| both.dphi),
};

const DELTA_THETA: Row = Row {
    id: "dtheta",
    symbol: "Δθ",
    name: "Δθ, left − right",
    about: "Elevation as the left eye sees the point, less that of the right eye.\nΔθ = θ left − θ right",
    of: Of::Pair(|both| both.dtheta),
    ..DELTA_PHI
};

const DELTA_U: Row = Row {
    id: "du",
    symbol: "Δu",
    name: "Δu, left − right",
    about: "u as the left eye sees the point, less that of the right eye. u = arsinh(X/√(Y² + Z²)), along the line between the eyes, \
        is a rapidity: motion slides it for both eyes alike, which drops out.\nDashed: the same point at rest, where it is in its own \
        frame, for eyes γd apart.",
    dimension: Dimension::Ratio,
    of: Of::ConformalPair(|both| both.du),
    ..DELTA_PHI
};

const DELTA_V: Row = Row {
    id: "dv",
    symbol: "Δv",
    name: "Δv, left − right",
    about: "v as the left eye sees the point, less that of the right eye. v = atan2(Z, Y) is the angle about the line between the eyes, \
        up from straight ahead: the vertical parallax of a conformal picture.",
    of: Of::ConformalPair(|both| both.dv),
    ..DELTA_PHI
};

const DOPPLER: Row = Row {
    id: "doppler",
    symbol: "D",
    name: "Doppler factor D",
    about: "Received over emitted frequency; above 1 is bluer. The clock at the point is seen to run D times as fast as one beside the \
        eye.\nD = 1/(γ(1 + β X/R))",
    dimension: Dimension::Ratio,
    decimals: 4,
    is_logarithmic: true,
    of: Of::Sighting(|seen| seen.doppler_factor),
};

const EMISSION_TIME: Row = Row {
    id: "t",
    symbol: "t",
    name: "happened t",
    about: "When what is seen happened: when the light left, on the ground's clock there. Eyes that rest receive it at T, R being how \
        far it came.\nt = T − R",
    dimension: Dimension::Time,
    is_logarithmic: false,
    of: Of::Sighting(|seen| seen.retarded_time),
    ..DOPPLER
};

const PROPER_TIME: Row = Row {
    id: "tau",
    symbol: "τ",
    name: "proper time τ",
    about: "What the clock at that point of the body showed when the light left it. All clocks of the body agree in its own frame, and \
        show 0 as its origin passes the eyes. An eye sees it run D times as fast as its own.\nτ = γ(t − βx)\nOf a point that turns with a \
        wheel it is the clock of the axle.",
    of: Of::Sighting(|seen| seen.proper_time),
    ..EMISSION_TIME
};

const X: Row = Row {
    id: "x",
    symbol: "X",
    name: "apparent X",
    about: "Apparent position along the motion, from this eye.",
    dimension: Dimension::Length,
    of: Of::Sighting(|seen| seen.position[0]),
    ..EMISSION_TIME
};

const Y: Row = Row {
    id: "y",
    symbol: "Y",
    name: "apparent Y",
    about: "Apparent position in depth.",
    of: Of::Sighting(|seen| seen.position[1]),
    ..X
};

const Z: Row = Row {
    id: "z",
    symbol: "Z",
    name: "apparent Z",
    about: "Apparent height.",
    of: Of::Sighting(|seen| seen.position[2]),
    ..X
};

const PHI: Row = Row {
    id: "phi",
    symbol: "φ",
    name: "azimuth φ",
    about: "The direction the point is seen in, from the direction of motion (+x) towards straight ahead (+y).\nφ = atan2(Y, X)",
    of: Of::Sighting(Sighting::phi),
    ..DELTA_PHI
};

const THETA: Row = Row {
    id: "theta",
    symbol: "θ",
    name: "elevation θ",
    about: "How high above the level of the eyes the point is seen.\nθ = atan2(Z, √(X² + Y²))",
    of: Of::Sighting(Sighting::theta),
    ..DELTA_PHI
};

const U: Row = Row {
    id: "u",
    symbol: "u",
    name: "conformal u",
    about: "Column of the conformal picture, in units of rapidity, to the right.\nu = arsinh(X/√(Y² + Z²)), X along the line between the \
        eyes. Motion along that line slides u back by the rapidity. A point seen along the line itself has no u.",
    dimension: Dimension::Ratio,
    of: Of::Conformal(|seen| seen.u),
    ..DELTA_PHI
};

const V: Row = Row {
    id: "v",
    symbol: "v",
    name: "conformal v",
    about: "Row of the conformal picture: the angle about the line between the eyes, up from straight ahead.\nv = atan2(Z, Y). Motion \
        along that line does not change it.",
    of: Of::Conformal(|seen| seen.v),
    ..DELTA_PHI
};

const STEREO_GAIN: Row = Row {
    id: "stereo_gain",
    symbol: "stereo gain",
    name: "stereo gain",
    about: "A resting point in the same place would look as different to eyes this many times as far apart.\n(X left − X right)/d, near \
        γD; with the head tilted or turned: the component of the parallax along that of a resting point, divided by that.",
    of: Of::Stereo(|found| found.gain),
    ..DOPPLER
};

const DISTANCE: Row = Row {
    id: "distance",
    symbol: "distance",
    name: "distance",
    about: "How far away the point is: as seen, as two eyes place it, and as measured.",
    dimension: Dimension::Length,
    decimals: 2,
    of: Of::Sighting(|seen| seen.distance),
    ..DOPPLER
};
