//! The names of the columns.

use crate::flags::SpeedParameter;

/// Every column but those of `--conformal`, in order, the last five with `--stereo` only, and the very last
/// of a head that is tilted or turned or a point that turns; [`TURNED`] come before those. Left and right are
/// the primary and the secondary aperture.
pub(super) const COLUMNS: [&str; 21] = [
    "x_left",
    "x_right",
    "t_left",
    "t_right",
    "doppler_left",
    "doppler_right",
    "intensity_left",
    "intensity_right",
    "phi_left",
    "phi_right",
    "theta_left",
    "theta_right",
    "dphi",
    "dtheta",
    "tau_left",
    "tau_right",
    "stereo_gain",
    "stereo_x",
    "stereo_y",
    "stereo_z",
    "stereo_miss",
];
/// The column of the head's tilt, degrees.
pub const ROLL: &str = "roll";
/// The column of the head's turn, degrees.
pub const TURN: &str = "turn";
/// The columns of where on a wheel a point is.
pub const WHEEL: [&str; 3] = ["wheel_radius", "rho", "angle"];
/// Number of columns without `--stereo`.
pub(super) const USUAL: usize = 16;
/// The columns of how far a wheel has turned, for its points only.
pub(super) const TURNED: [&str; 2] = ["angle_left", "angle_right"];
/// The columns of where a moving observer's eyes see the point, in their own frame, but for x.
pub(super) const MOVING: [&str; 6] =
    ["y_left", "y_right", "z_left", "z_right", "distance_left", "distance_right"];
/// The columns of `--conformal`, after all others.
pub(super) const CONFORMAL: [&str; 4] = ["u_left", "u_right", "v_left", "v_right"];
/// The columns of angles.
pub const ANGLES: &[&str] = COLUMNS.split_at(14).0.split_at(8).1;

/// The columns of an observer's speed, in the order of [`SpeedParameter::ALL`].
pub const OBSERVER_SPEED: [&str; 3] = ["observer_beta", "observer_gamma", "observer_rapidity"];
/// The columns of where the observer moves, degrees: from +x towards +y, and up from the x-y plane.
pub const OBSERVER_DIRECTION: [&str; 2] = ["observer_azimuth", "observer_elevation"];
/// The columns of where the middle between the eyes is at T.
pub const OBSERVER_PLACE: [&str; 3] = ["observer_x", "observer_y", "observer_z"];
/// The column of what the observer's clock shows.
pub const CLOCK: &str = "clock";
/// Beginning of the names of an observer's columns.
pub const OBSERVER_PREFIX: &str = "observer_";

/// Returns the unit of the values in the `column` of this name, as tables in JSON give it: `1` for a ratio,
/// `rad` or `deg`, and `length` or `time`, which have one unit, with c = 1. `None` of a column that is not
/// known.
#[must_use]
pub fn unit(column: &str) -> Option<&'static str> {
    let column = column.trim_start_matches("sigma_");
    let column = column.strip_suffix("_left").or_else(|| column.strip_suffix("_right")).unwrap_or(column);
    Some(match column {
        "T" | "t" | "tau" | CLOCK => "time",
        "phi" | "theta" | "dphi" | "dtheta" | "angle" | "v" => "rad",
        ROLL | TURN | "observer_azimuth" | "observer_elevation" => "deg",
        "d" | "x" | "y" | "z" | "x0" | "distance" | "wheel_radius" | "stereo_x" | "stereo_y" | "stereo_z"
        | "stereo_miss" | "observer_x" | "observer_y" | "observer_z" => "length",
        "beta" | "gamma" | "rapidity" | "rho" | "u" | "doppler" | "intensity" | "stereo_gain"
        | "observer_beta" | "observer_gamma" | "observer_rapidity" => "1",
        _ => return None,
    })
}

/// Returns the degrees that lead back to just these radians, with as few digits as that takes.
#[must_use]
pub fn degrees(radians: f64) -> f64 {
    let all = radians.to_degrees();
    let short = format!("{all:.14e}").parse().unwrap_or(all);
    if f64::to_radians(short) == radians { short } else { all }
}

/// The column of an observer's speed in this `parameter`.
#[must_use]
pub const fn observer_speed(parameter: SpeedParameter) -> &'static str {
    match parameter {
        SpeedParameter::Beta => OBSERVER_SPEED[0],
        SpeedParameter::Gamma => OBSERVER_SPEED[1],
        SpeedParameter::Rapidity => OBSERVER_SPEED[2],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::{Dimension, Quantity};

    #[test]
    fn degrees_lead_back() {
        for tenths in -1800..=1800 {
            let given = f64::from(tenths) / 10.0;
            assert_eq!(degrees(given.to_radians()), given);
        }
    }

    /// The plots know the dimensions of quantities, most of which are columns' too.
    #[test]
    fn units_are_those_of_quantities() {
        let quantities = Quantity::READ_OUT.into_iter().chain(Quantity::DISPARITIES);
        let others = [Quantity::U, Quantity::V, Quantity::StereoGain, Quantity::Distance];
        let is_column = |quantity: &Quantity| unit(quantity.row().id).is_some();
        for quantity in quantities.chain(others).filter(is_column) {
            let expected = match quantity.row().dimension {
                Dimension::Angle => "rad",
                Dimension::Length => "length",
                Dimension::Time => "time",
                Dimension::Ratio => "1",
            };
            assert_eq!(unit(quantity.row().id), Some(expected), "{quantity:?}");
        }
        let inputs =
            [ROLL, TURN, CLOCK].iter().chain(&WHEEL).chain(&OBSERVER_SPEED).chain(&OBSERVER_DIRECTION);
        let all = COLUMNS
            .iter()
            .chain(&TURNED)
            .chain(&MOVING)
            .chain(&CONFORMAL)
            .chain(&OBSERVER_PLACE)
            .chain(inputs);
        for column in all {
            assert!(unit(column).is_some(), "{column}");
        }
        assert_eq!(["name", "", "sigma", "x_middle"].map(unit), [None; 4]);
    }

    #[test]
    fn columns_are_named_by_the_identifiers_of_quantities() {
        let columns = COLUMNS.iter().chain(&MOVING).chain(&CONFORMAL);
        let columns: Vec<&str> = columns.map(|column| column.trim_end_matches("_left")).collect();
        // All but the differences of u and v, which are those of two columns.
        let quantities = [
            Quantity::DeltaPhi,
            Quantity::DeltaTheta,
            Quantity::Doppler,
            Quantity::EmissionTime,
            Quantity::ProperTime,
            Quantity::X,
            Quantity::Y,
            Quantity::Z,
            Quantity::Phi,
            Quantity::Theta,
            Quantity::U,
            Quantity::V,
            Quantity::StereoGain,
            Quantity::Distance,
        ];
        for quantity in quantities {
            assert!(columns.contains(&quantity.row().id), "{quantity:?}");
        }
    }
}
