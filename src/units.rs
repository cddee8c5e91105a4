//! Units in which the window shows lengths and times, and in which they are typed. Files, CSV and flags
//! always use the scene's own, in which c = 1.

use clap::ValueEnum;
use relativity_core::{Speed, math};
use serde::Serialize;

use crate::number_text;
use crate::scene::Scene;

/// The speed of light, m/s.
const METRES_PER_SECOND: f64 = 299_792_458.0;
/// Speed of light in Gamow's town, km/h.
const TOWN_KM_PER_HOUR: f64 = 30.0;
/// Greatest number of decimals of a speed in km/h.
const MOST_SPEED_DECIMALS: f64 = 6.0;

/// The units in which lengths and times are shown and typed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Units {
    /// The scene's own unit for lengths and times, c = 1: light travels one unit of length in one unit of
    /// time.
    #[default]
    Natural,
    /// Metres and nanoseconds: light takes 3.34 ns for a metre. The scene must say how many metres its unit
    /// is.
    Metric,
    /// Metres and seconds in Gamow's town, where c is 30 km/h and light takes 0.12 s for a metre. Nothing
    /// looks different: all that counts is v/c. The scene must say how many metres its unit is.
    Town,
}

/// A unit of length or time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Number of these in the scene's unit.
    pub factor: f64,
    /// Name of the unit; empty for the scene's own.
    pub name: &'static str,
}

/// The units that a scene is shown in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures {
    /// Choice that the units belong to.
    pub units: Units,
    /// Unit of lengths.
    pub length: Unit,
    /// Unit of times.
    pub time: Unit,
}

impl Units {
    /// Returns the measures in these units for `scene`: its own units where it does not say how long one is.
    #[must_use]
    pub fn measures(self, scene: &Scene) -> Measures {
        let Some(metres) = scene.metres.filter(|_| self != Self::Natural) else {
            return Measures::OWN;
        };
        let seconds_in_town = metres / (TOWN_KM_PER_HOUR / 3.6);
        let time = match self {
            Self::Town => Unit { factor: seconds_in_town, name: "s" },
            Self::Natural | Self::Metric => Unit { factor: 1e9 * metres / METRES_PER_SECOND, name: "ns" },
        };
        Measures { units: self, length: Unit { factor: metres, name: "m" }, time }
    }
}

impl Measures {
    /// The scene's own units.
    pub const OWN: Self = Self { units: Units::Natural, length: Unit::OWN, time: Unit::OWN };

    /// `speed` in the units of everyday life, where c is a speed of everyday life too.
    #[must_use]
    pub fn speed(&self, speed: &Speed) -> Option<String> {
        (self.units == Units::Town).then(|| {
            let lacking = TOWN_KM_PER_HOUR * speed.one_minus_beta();
            let decimals = (1.0 - math::log10(lacking).floor()).max(1.0);
            if decimals > MOST_SPEED_DECIMALS {
                return format!("just below {TOWN_KM_PER_HOUR} km/h");
            }
            format!("{} km/h", number_text::fixed(TOWN_KM_PER_HOUR * speed.beta(), decimals as u8))
        })
    }
}

impl Unit {
    /// The scene's own unit.
    pub const OWN: Self = Self { factor: 1.0, name: "" };

    /// `value`, in units of the scene, in this unit.
    #[must_use]
    pub fn shown(self, value: f64) -> f64 {
        value * self.factor
    }

    /// `shown`, in this unit, in units of the scene.
    #[must_use]
    pub fn in_scene(self, shown: f64) -> f64 {
        shown / self.factor
    }

    /// Returns the number of decimals that show as much of a value as `decimals` do in units of the scene.
    #[must_use]
    pub fn decimals(self, decimals: u8) -> u8 {
        (f64::from(decimals) - math::log10(self.factor).round()).clamp(0.0, 9.0) as u8
    }

    /// The digits of `value`, which is in units of the scene, as many as `decimals` are of that; a dash if it
    /// is not a number.
    #[must_use]
    pub fn number(self, value: f64, decimals: u8) -> String {
        number_text::fixed(self.shown(value), self.decimals(decimals))
    }

    /// Writes like [`Self::number`], with the unit.
    #[must_use]
    pub fn text(self, value: f64, decimals: u8) -> String {
        let number = self.number(value, decimals);
        if number == number_text::NONE { number } else { number + &self.suffix() }
    }

    /// The unit after a number: ` m`; nothing for the scene's own.
    #[must_use]
    pub fn suffix(self) -> String {
        if self.name.is_empty() { String::new() } else { format!(" {}", self.name) }
    }

    /// Returns the label of an axis: `T / ns`.
    #[must_use]
    pub fn label(self, symbol: &str) -> String {
        if self.name.is_empty() { symbol.to_owned() } else { format!("{symbol} / {}", self.name) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::PRESETS;

    fn cyclist() -> Scene {
        Scene::preset("cyclist").expect("a preset")
    }

    #[test]
    fn one_event_has_its_numbers_in_three_units() {
        let texts = |units: Units| {
            let measures = units.measures(&cyclist());
            [measures.length.text(3.0, 4), measures.time.text(3.605_551, 4)]
        };
        assert_eq!(texts(Units::Natural), ["3.0000", "3.6056"]);
        // 3 times 0.65 m; 0.65 m / c = 2.168166621 ns.
        assert_eq!(texts(Units::Metric), ["1.9500 m", "7.8174 ns"]);
        // 0.65 m at 30 km/h takes 0.078 s, of which a digit more is shown.
        assert_eq!(texts(Units::Town), ["1.9500 m", "0.28123 s"]);
    }

    #[test]
    fn light_is_as_fast_as_its_units_say() {
        let speed = |units: Units| {
            let Measures { length, time, .. } = units.measures(&cyclist());
            length.shown(1.0) / time.shown(1.0)
        };
        assert_eq!(speed(Units::Natural), 1.0);
        assert!((speed(Units::Metric) / 0.299_792_458 - 1.0).abs() < 1e-15);
        assert!((speed(Units::Town) * 3.6 / 30.0 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_is_shown_leads_back() {
        for units in [Units::Natural, Units::Metric, Units::Town] {
            let Measures { length, time, .. } = units.measures(&cyclist());
            for unit in [length, time] {
                assert!((unit.in_scene(unit.shown(-3.25)) + 3.25).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn a_scene_of_no_known_size_has_its_own_units_only() {
        let scene = Scene { metres: None, ..cyclist() };
        for units in [Units::Natural, Units::Metric, Units::Town] {
            assert_eq!(units.measures(&scene), Measures::OWN);
        }
        assert_eq!(Unit::OWN.text(-1.5, 2), "−1.50");
        assert_eq!((Unit::OWN.label("T"), Unit::OWN.suffix()), ("T".to_owned(), String::new()));
    }

    #[test]
    fn a_dash_has_no_unit() {
        assert_eq!(Units::Metric.measures(&cyclist()).time.text(f64::NAN, 3), number_text::NONE);
    }

    #[test]
    fn speeds_are_of_everyday_life_in_town() {
        let measures = Units::Town.measures(&cyclist());
        let text = |beta| measures.speed(&Speed::from_beta(beta).expect("a speed")).expect("in town");
        assert_eq!([0.0, 0.5, 0.9].map(text), ["0.0 km/h", "15.0 km/h", "27.0 km/h"]);
        assert_eq!(text(0.9999), "29.9970 km/h");
        assert_eq!(text(1.0 - 1e-9), "just below 30 km/h");
        assert_eq!(Units::Metric.measures(&cyclist()).speed(&Speed::REST), None);
    }

    #[test]
    fn scenes_whose_ground_is_a_street_have_a_size() {
        for scene in PRESETS.map(|name| Scene::preset(name).expect("a preset")) {
            assert_eq!(scene.metres.is_some(), scene.ground_z.is_some(), "{}", scene.name);
        }
    }
}
