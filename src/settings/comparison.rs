//! Two pictures of one eye beside each other: what the second shows otherwise, and when there can be one.

use relativity_core::doppler::{
    BOLOMETRIC_INTENSITY_EXPONENT, PAPER_INTENSITY_EXPONENT, SPECIFIC_INTENSITY_EXPONENT,
};
use relativity_render::{Appearance, Colour, Geometry, View};
use thiserror::Error;

use super::all::Settings;
use super::sections::{LightSettings, LookSettings};
use super::views::Subject;
use crate::flags::choices::{Compare, Layout, ProjectionChoice, further};
use crate::flags::{Exposure, IntensityExponent};
use crate::number_text;
use crate::scene::Scene;

/// Reason why nothing is worked out from two pictures of one eye.
pub const NO_PAIR: &str = "it shows one eye twice (--compare), where this needs a picture made without";

/// Reasons why there is no second picture of one eye.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ComparisonError {
    /// The layout does not keep two pictures apart, or has one.
    #[error("--compare needs two pictures apart: --layout side-by-side or over-under, not {}", .0.name())]
    Layout(Layout),
    /// The two pictures of a headset are those of two eyes.
    #[error("--compare: a headset (--projection vr180) shows two eyes, and not one eye twice")]
    Headset,
    /// Nothing depends on the exponent with this light.
    #[error(
        "--compare paper needs light of one wavelength, --colour one-wavelength: no other has an exponent"
    )]
    Light,
    /// D is 1 everywhere.
    #[error("--compare paper needs the Doppler effect, --geometry seen: without it D is 1 everywhere")]
    NoDoppler,
    /// Eyes that do not ride stand already.
    #[error("--compare standing needs a ride, --ride coast or legs: these eyes stand already")]
    NoRide,
    /// The first picture is the same already.
    #[error("--compare: the first picture shows this already, so both would be alike")]
    Alike,
}

impl Settings {
    /// Whether the two pictures are of one eye.
    #[must_use]
    pub fn is_comparing(&self) -> bool {
        !self.look.compare.is_off() && self.check_comparison().is_ok()
    }

    /// Checks that the second picture of one eye, which these settings ask for, can be shown.
    ///
    /// # Errors
    /// A layout, a projection, a light or a geometry with which there is none.
    pub fn check_comparison(&self) -> Result<(), ComparisonError> {
        if self.look.compare.is_off() {
            return Ok(());
        }
        self.check_two_pictures()?;
        self.check_compared_with(self.look.compare)
    }

    /// Whether `compare` makes the second of two pictures another one than the first.
    ///
    /// # Errors
    /// A geometry or a light with which it does not.
    pub fn check_compared_with(&self, compare: Compare) -> Result<(), ComparisonError> {
        if compare == Compare::Paper {
            self.check_exponent()?;
        }
        if compare == Compare::Standing && !self.ride.is_on() {
            return Err(ComparisonError::NoRide);
        }
        let second = self.compared_with(compare);
        let is_same = (second.look.geometry, second.light, &second.ride)
            == (self.look.geometry, self.light, &self.ride);
        if is_same && !compare.is_off() { Err(ComparisonError::Alike) } else { Ok(()) }
    }

    /// Whether one eye can have two pictures.
    ///
    /// # Errors
    /// A layout or a projection with which it cannot.
    pub fn check_two_pictures(&self) -> Result<(), ComparisonError> {
        let layout = self.picture.layout;
        if !layout.shows_two_apart() {
            return Err(ComparisonError::Layout(layout));
        }
        if self.look.projection == ProjectionChoice::Vr180 { Err(ComparisonError::Headset) } else { Ok(()) }
    }

    /// Whether another exponent of the intensity makes another picture.
    ///
    /// # Errors
    /// A light or a geometry with which it does not.
    fn check_exponent(&self) -> Result<(), ComparisonError> {
        if self.light.colour != Colour::OneWavelength {
            return Err(ComparisonError::Light);
        }
        if self.geometry().has_doppler_effect() { Ok(()) } else { Err(ComparisonError::NoDoppler) }
    }

    /// Has the next choice of what a picture is compared with; in a layout that shows no two pictures apart,
    /// side by side. A ride that is compared with nothing is one picture again.
    pub(crate) fn compare_next(&mut self) {
        if self.check_two_pictures().is_err() {
            self.picture.layout = Layout::SideBySide;
        }
        self.look.compare = further(&self.look.compare, 1);
        while self.check_comparison().is_err() {
            self.look.compare = further(&self.look.compare, 1);
        }
        if self.look.compare.is_off() && self.ride.is_on() {
            self.picture.layout = Layout::Left;
        }
    }

    /// Compares what a rider sees with what is seen standing there, or no longer.
    pub(crate) fn compare_standing(&mut self) {
        if self.look.compare == Compare::Standing {
            self.look.compare = Compare::Off;
            self.picture.layout = Layout::Left;
        } else if self.ride.is_on() {
            self.look.compare = Compare::Off;
            self.compare_next();
        }
    }

    /// The settings of the second picture of one eye, as if it were alone but for what both have in common:
    /// `None` where there is no such picture.
    pub(super) fn second(&self) -> Option<Self> {
        self.is_comparing().then(|| self.compared_with(self.look.compare))
    }

    /// The settings of the second picture that `compare` makes.
    fn compared_with(&self, compare: Compare) -> Self {
        let geometry = match compare {
            Compare::Seen => Geometry::Seen,
            Compare::Contracted => Geometry::Contracted,
            Compare::Rest => Geometry::Rest,
            Compare::Off | Compare::Standing | Compare::Paper => self.look.geometry,
        };
        let light = match compare {
            Compare::Paper => LightSettings {
                intensity_exponent: IntensityExponent(Some(PAPER_INTENSITY_EXPONENT)),
                ..self.light
            },
            _ => self.light,
        };
        let look = LookSettings { geometry, compare: Compare::Off, ..self.look };
        let ride = if compare == Compare::Standing { self.ride.standing() } else { self.ride.clone() };
        Self { ride, look, light, ..self.clone() }
    }

    /// Returns the settings of the second picture with the field of view that both pictures of this `subject`
    /// share at `time`, `size` in pixels; and with the exposure of the first in `scene`, where the two differ
    /// in brightness.
    #[must_use]
    pub fn second_of(&self, subject: Subject, scene: &Scene, time: f64, size: [u32; 2]) -> Option<Self> {
        let mut second = self.second()?;
        second.look.fov = self.fixed_look(subject, time, size).fov;
        if self.look.compare == Compare::Paper {
            let of_first = || self.automatic_ev(scene, time);
            second.light.exposure = Exposure(Some(self.light.exposure.0.unwrap_or_else(of_first)));
        }
        Some(second)
    }

    /// Returns the views of both pictures at `time`, and the appearance of each: those of the left and the
    /// right eye, or two of the left one.
    #[must_use]
    pub fn pictures(&self, subject: Subject, scene: &Scene, time: f64) -> [(View, Appearance); 2] {
        let size = self.picture.size.0;
        let [left, right] = self.views(subject, time, size);
        let appearance = self.appearance(scene, time, false);
        let second = self.second_of(subject, scene, time, size).map(|second| {
            let [left, _] = second.views(subject, time, size);
            (left, second.appearance(scene, time, false))
        });
        [(left, appearance), second.unwrap_or((right, appearance))]
    }

    /// The names of the two pictures of one eye.
    #[must_use]
    pub fn compared_names(&self) -> Option<[String; 2]> {
        let second = self.second()?;
        if self.look.compare == Compare::Standing {
            return Some(["riding", "standing here"].map(str::to_owned));
        }
        let name = |settings: &Self| match self.look.compare {
            Compare::Paper => name_of_exponent(settings.light.intensity_exponent.0),
            _ => name_of(settings.geometry()).to_owned(),
        };
        Some([name(self), name(&second)])
    }
}

/// The name of a left eye's picture of this geometry.
const fn name_of(geometry: Geometry) -> &'static str {
    match geometry {
        Geometry::Seen | Geometry::Published => "as seen",
        Geometry::Contracted => "contracted only",
        Geometry::Rest => "at rest",
        Geometry::OneCone => "one light cone",
    }
}

/// The name of an intensity with this exponent.
fn name_of_exponent(exponent: Option<f64>) -> String {
    match exponent {
        None => "no D".to_owned(),
        Some(PAPER_INTENSITY_EXPONENT) => "D² paper".to_owned(),
        Some(SPECIFIC_INTENSITY_EXPONENT) => "D³ photons".to_owned(),
        Some(BOLOMETRIC_INTENSITY_EXPONENT) => "D⁴ surface".to_owned(),
        Some(exponent) => format!("D to {}", number_text::trimmed(exponent, 3)),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use relativity_render::Velocity;

    use super::super::ride::riding;
    use super::*;

    /// Whoever stands beside a rider is at the same event and at rest, and holds the head as the rider does.
    #[test]
    fn who_stands_beside_a_rider_is_at_the_same_event_and_at_rest() {
        for legs in ["coast", "2@1,3@0,1@-0.5", "1@0.5,2@0:1"] {
            let ride = riding(legs, "0.6");
            let standing = ride.standing();
            for time in [0.0, 1.5, 4.0, 9.0] {
                let [rider, beside] = [&ride, &standing].map(|ride| ride.rider(time));
                assert_eq!(
                    (beside.x, beside.aside, beside.street_time),
                    (rider.x, rider.aside, rider.street_time)
                );
                assert_eq!(beside.velocity, Velocity::REST);
                assert_eq!(beside.observer().velocity.speed().rapidity().to_bits(), 0);
                let ahead = DVec3::X;
                assert_eq!(beside.from_head(ahead), rider.from_head(ahead));
            }
        }
    }

    #[test]
    fn only_a_ride_is_compared_with_standing() {
        let mut settings = Settings::default();
        assert_eq!(settings.check_compared_with(Compare::Standing), Err(ComparisonError::NoRide));
        settings.ride = riding("coast", "0.9");
        assert_eq!(settings.check_compared_with(Compare::Standing), Ok(()));
        settings.picture.layout = Layout::Left;
        settings.compare_next();
        assert_eq!((settings.look.compare, settings.picture.layout), (Compare::Standing, Layout::SideBySide));
        while !settings.look.compare.is_off() {
            settings.compare_next();
        }
        assert_eq!(settings.picture.layout, Layout::Left);
        for expected in [Compare::Standing, Compare::Off] {
            settings.compare_standing();
            assert_eq!(settings.look.compare, expected);
        }
        assert_eq!(settings.picture.layout, Layout::Left);
    }
}
