//! A place in a view in the words of a lesson: by the ticks of the ruler where that is on, else from straight
//! ahead.

use relativity_core::math::{atanh, cos, log10};
use relativity_render::Gaze;

use super::truth::angle_between;
use crate::caption::decimal;
use crate::flags::choices::ProjectionChoice;
use crate::number_text;
use crate::settings::Settings;

/// Distance from *abreast* on the ruler that still counts as there: half of its smallest ticks.
const ABREAST: f64 = 0.05;
/// A part of a difference is named from this share of the other part on.
const NAMED: f64 = 0.5;

/// Returns where `direction` is, to follow *it is seen*; `mark` is the mark that stands there.
#[must_use]
pub fn at(settings: &Settings, direction: Gaze, mark: &str) -> String {
    if has_ruler(settings) {
        return on_ruler(direction.axes().forward.x);
    }
    let left = turned(direction.azimuth - (0.5 * std::f64::consts::PI + settings.motion.turn.to_radians()));
    let side = if left < 0.0 { "right" } else { "left" };
    match degrees(left.abs()).as_str() {
        "0" => format!("at the {mark}, straight ahead"),
        degrees => format!("at the {mark}, {degrees} degrees {side} of straight ahead"),
    }
}

/// Returns how far `seen` is from the direction that was `clicked`, and to which side.
#[must_use]
pub fn from(clicked: Gaze, seen: Gaze) -> String {
    let left = turned(seen.azimuth - clicked.azimuth) * cos(seen.elevation);
    let up = seen.elevation - clicked.elevation;
    let across = (left.abs() >= NAMED * up.abs()).then_some(if left < 0.0 { "right" } else { "left" });
    let along = (up.abs() > NAMED * left.abs()).then_some(if up < 0.0 { "lower" } else { "higher" });
    let side = match (across, along) {
        (Some(across), Some(along)) => format!("further {across} and {along}"),
        (Some(across), None) => format!("further {across}"),
        (None, along) => along.unwrap_or("away").to_owned(),
    };
    match degrees(angle_between(clicked, seen)).as_str() {
        "0" => "less than a degree away".to_owned(),
        "1" => format!("1 degree {side}"),
        degrees => format!("{degrees} degrees {side}"),
    }
}

/// Whether the views have the ruler, whose ticks name places.
fn has_ruler(settings: &Settings) -> bool {
    let slides = settings.projection() == ProjectionChoice::Mercator && settings.baseline().is_along_motion();
    settings.window.ruler && slides && !settings.ride.is_on()
}

/// The tick of the column in which the angle from the motion has this `cosine`: what slides there from
/// *abreast* moves at that speed.
fn on_ruler(cosine: f64) -> String {
    let beta = cosine.abs();
    if atanh(beta) < ABREAST {
        return "at *abreast*".to_owned();
    }
    let more = (-log10(1.0 - beta)).clamp(0.0, 8.0) as u8;
    let speed = number_text::trimmed(beta.min(1.0 - 1e-9), 2 + more);
    if cosine < 0.0 { format!("at *{speed} c*") } else { format!("at *{speed} c* past *abreast*") }
}

/// `angle` as one between half a turn to the right and half a turn to the left.
fn turned(angle: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle - turn * (angle / turn).round()
}

fn degrees(angle: f64) -> String {
    decimal(angle.to_degrees(), 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gaze(azimuth: f64, elevation: f64) -> Gaze {
        Gaze { azimuth: azimuth.to_radians(), elevation: elevation.to_radians() }
    }

    #[test]
    fn places_are_told_by_the_ticks_of_the_ruler() {
        let settings = Settings::default();
        let at = |azimuth: f64| at(&settings, gaze(azimuth, 0.0), "ring");
        assert_eq!(at(90.0), "at *abreast*");
        assert_eq!(at(92.0), "at *abreast*");
        assert_eq!(at(120.0), "at *0.5 c*");
        // arccos 0.9
        assert_eq!(at(180.0 - 25.841_932_763), "at *0.9 c*");
        assert_eq!(at(60.0), "at *0.5 c* past *abreast*");
        assert_eq!(at(180.0 - 2.562_55), "at *0.999 c*");
    }

    #[test]
    fn without_a_ruler_they_are_told_from_straight_ahead() {
        let mut settings = Settings::default();
        settings.window.ruler = false;
        assert_eq!(
            at(&settings, gaze(154.2, 3.0), "cross"),
            "at the cross, 64 degrees left of straight ahead"
        );
        assert_eq!(
            at(&settings, gaze(-260.0, 0.0), "cross"),
            "at the cross, 10 degrees left of straight ahead"
        );
        assert_eq!(at(&settings, gaze(89.8, 0.0), "ring"), "at the ring, straight ahead");
        // Who rides looks along the street.
        settings.motion.turn = -90.0;
        assert_eq!(
            at(&settings, gaze(-26.0, 0.0), "ring"),
            "at the ring, 26 degrees right of straight ahead"
        );
    }

    #[test]
    fn a_difference_has_a_side() {
        assert_eq!(from(gaze(89.8, 0.0), gaze(120.0, 0.0)), "30 degrees further left");
        assert_eq!(from(gaze(170.0, 0.0), gaze(-170.0, 1.0)), "20 degrees further left");
        assert_eq!(from(gaze(90.0, 0.0), gaze(80.0, -10.0)), "14 degrees further right and lower");
        assert_eq!(from(gaze(90.0, 0.0), gaze(90.0, 20.0)), "20 degrees higher");
        assert_eq!(from(gaze(90.0, 0.0), gaze(90.1, 0.0)), "less than a degree away");
        assert_eq!(from(gaze(90.0, 0.0), gaze(90.0, 0.0)), "less than a degree away");
    }
}
