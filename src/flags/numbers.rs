//! Numbers as flags and files have them: what is none, or out of range, is refused with what would be right.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use relativity_core::MAX_COORDINATE;
use relativity_core::doppler::{
    BOLOMETRIC_INTENSITY_EXPONENT, PAPER_INTENSITY_EXPONENT, SPECIFIC_INTENSITY_EXPONENT,
};
use serde::{Serialize, Serializer};

use crate::number_text;

/// Parses a number, which may have a decimal comma: f64's own parser also takes "nan" and "inf", which nobody
/// means. A comma that may as well group thousands is refused.
pub fn finite_number(text: &str) -> Result<f64, String> {
    if let Some((thousands, units)) = grouped(text) {
        return Err(format!("may mean {thousands}.{units} or {thousands}{units}: write one of them"));
    }
    match number_text::with_point(text.trim()).parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err("not a finite number".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// The digits before and after the one comma of a number such as 1,000, where half of the world groups
/// thousands: 0,999 and 1,5 have a decimal comma.
fn grouped(text: &str) -> Option<(&str, &str)> {
    let (before, after) = text.trim().split_once(',')?;
    let are_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let digits = before.trim_start_matches(['-', '+']);
    let is_group = are_digits(digits) && digits.len() <= 3 && !digits.starts_with('0');
    (is_group && after.len() == 3 && are_digits(after)).then_some((before, after))
}

/// Coordinates and times for which everything is finite.
pub const COORDINATES: RangeInclusive<f64> = -MAX_COORDINATE..=MAX_COORDINATE;

/// A parser of numbers inside `range`.
pub fn within(range: RangeInclusive<f64>) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    move |text| {
        let value = finite_number(text)?;
        if range.contains(&value) {
            return Ok(value);
        }
        Err(format!("must be between {} and {}", short(*range.start()), short(*range.end())))
    }
}

/// Parses a whole number inside `range`.
pub fn whole_number<T>(text: &str, range: RangeInclusive<T>) -> Result<T, String>
where
    T: FromStr + PartialOrd + fmt::Display,
{
    let value = text.trim().parse().ok().filter(|value| range.contains(value));
    value.ok_or_else(|| format!("must be a whole number between {} and {}", range.start(), range.end()))
}

/// Writes `value` as briefly as possible.
fn short(value: f64) -> String {
    let [plain, powers] = [value.to_string(), format!("{value:e}")];
    if powers.len() < plain.len() { powers } else { plain }
}

/// Narrowest and widest field of view of a picture, degrees.
pub const FIELD_OF_VIEW: RangeInclusive<f64> = 1e-9..=179.999;

/// Parses a field of view, degrees.
pub fn field_of_view(text: &str) -> Result<f64, String> {
    within(FIELD_OF_VIEW)(text).map_err(|reason| reason + " degrees")
}

/// Narrowest and widest screen, cm.
pub const SCREEN_CM: RangeInclusive<f64> = 1.0..=100_000.0;

/// Defines values in whose place a word may stand, each with its parser.
macro_rules! values_or_word {
    ($($(#[$doc:meta])* $name:ident($value:ty): $parser:expr, or $word:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Default)]
        pub struct $name(pub Option<$value>);

        impl FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                if text == $word { Ok(Self(None)) } else { $parser(text).map(|value| Self(Some(value))) }
            }
        }

        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                match self.0 {
                    Some(value) => value.serialize(serializer),
                    None => serializer.serialize_str($word),
                }
            }
        }
    )*};
}

values_or_word! {
    /// A horizontal field of view, degrees, or `auto`.
    FieldOfView(f64): field_of_view, or "auto";
    /// The width of a screen, cm, or `auto`.
    ScreenWidth(f64): within(SCREEN_CM), or "auto";
    /// A part of a whole, from 0 to 1, or `auto`.
    Share(f64): within(0.0..=1.0), or "auto";
    /// An exposure, factors of 2, or `auto`.
    Exposure(f64): within(EXPOSURE_EV), or "auto";
    /// Exponent n of the received intensity D^n: a number, a word for what it means, or `off`.
    IntensityExponent(f64): exponent, or "off";
    /// A first and a last T, or `auto`.
    TimeRange([f64; 2]): time_range, or "auto";
}

/// Coordinates of a place: no body of a scene reaches further.
pub const PLACE: RangeInclusive<f64> = -1e7..=1e7;

/// Parses a place of three coordinates.
pub fn coordinates(text: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> = text.split(',').map(within(PLACE)).collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| "write three numbers like 0,3,2".to_owned())
}

/// Whether something is so: `on` or `off`. (By this name `clap` takes it for a value like any other.)
pub type OnOff = bool;

/// Parses `on` or `off`.
pub fn switch(text: &str) -> Result<OnOff, String> {
    match text {
        "on" => Ok(true),
        "off" => Ok(false),
        _ => Err("must be on or off".to_owned()),
    }
}

/// Exponents for which the intensity is a number at any speed.
pub const EXPONENT: RangeInclusive<f64> = -10.0..=10.0;

/// The exponents that have a name.
fn named_exponent(name: &str) -> Option<f64> {
    match name {
        "paper" => Some(PAPER_INTENSITY_EXPONENT),
        "photons" => Some(SPECIFIC_INTENSITY_EXPONENT),
        "surface" => Some(BOLOMETRIC_INTENSITY_EXPONENT),
        _ => None,
    }
}

/// Parses the exponent of a column of intensities: a name, or any finite number. A row in which the power
/// overflows is refused later, with its number.
pub fn column_exponent(text: &str) -> Result<f64, String> {
    let explained = |reason| format!("{reason}; or write surface, photons or paper");
    named_exponent(text).map_or_else(|| finite_number(text).map_err(explained), Ok)
}

/// Parses the exponent of a picture's intensities: a name, or a number within [`EXPONENT`].
fn exponent(text: &str) -> Result<f64, String> {
    let explained = |reason| format!("{reason}; or write surface, photons, paper or off");
    named_exponent(text).map_or_else(|| within(EXPONENT)(text).map_err(explained), Ok)
}

impl fmt::Display for IntensityExponent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(value) => write!(f, "{value}"),
            None => f.write_str("off"),
        }
    }
}

/// Dimmest and brightest exposure, factors of 2.
pub const EXPOSURE_EV: RangeInclusive<f64> = -100.0..=100.0;

/// Lowest and highest temperature of what glows, K.
pub const TEMPERATURE_K: RangeInclusive<f64> = 300.0..=100_000.0;

/// Parses a temperature in kelvin, or in degrees Celsius if it ends in C.
pub fn temperature(text: &str) -> Result<f64, String> {
    /// Melting point of ice, K.
    const MELTING_K: f64 = 273.15;
    match text.strip_suffix('C') {
        Some(celsius) => within(TEMPERATURE_K)(&(finite_number(celsius)? + MELTING_K).to_string()),
        None => within(TEMPERATURE_K)(text),
    }
}

/// Largest magnitude of a T: beyond it a step would round away.
pub const MAX_TIME: f64 = 1e12;

/// Parses an observation time T.
pub fn time(text: &str) -> Result<f64, String> {
    within(-MAX_TIME..=MAX_TIME)(text)
}

/// Parses a first and a last T.
fn time_range(text: &str) -> Result<[f64; 2], String> {
    let Some((from, to)) = text.split_once(',') else {
        return Err("write `auto`, or the first and the last T like -2,5".to_owned());
    };
    let [from, to] = [time(from)?, time(to)?];
    if from <= to { Ok([from, to]) } else { Err("the first T must not be above the last".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exponent_is_a_number_or_a_word_for_what_it_means() {
        let exponent = |text: &str| text.parse::<IntensityExponent>().map(|exponent| exponent.0);
        assert_eq!(
            ["surface", "photons", "paper"].map(exponent),
            [Ok(Some(4.0)), Ok(Some(3.0)), Ok(Some(2.0))]
        );
        assert_eq!([exponent("2.5"), exponent("off")], [Ok(Some(2.5)), Ok(None)]);
        assert_eq!(
            exponent("bright"),
            Err("not a number; or write surface, photons, paper or off".to_owned())
        );
    }

    #[test]
    fn a_temperature_may_be_in_degrees_celsius() {
        assert_eq!((temperature("1273.15"), temperature("1000C")), (Ok(1273.15), Ok(1273.15)));
        assert_eq!(temperature("0"), Err("must be between 300 and 1e5".to_owned()));
    }

    #[test]
    fn a_number_may_have_a_decimal_comma_and_a_list_is_none() {
        assert_eq!(["0,9", " -1,5e3", "2.5"].map(finite_number), [Ok(0.9), Ok(-1500.0), Ok(2.5)]);
        assert_eq!(["0,999", "1,0000", "1000,125"].map(finite_number), [Ok(0.999), Ok(1.0), Ok(1000.125)]);
        let refused = |text: &str| Err(format!("may mean {text}: write one of them"));
        assert_eq!(finite_number("1,000"), refused("1.000 or 1000"));
        assert_eq!(finite_number("-12,500"), refused("-12.500 or -12500"));
        assert_eq!(within(0.0..=1.0)("0,25"), Ok(0.25));
        for text in ["1, 2", "1,2,3", "1,234.5", ","] {
            assert!(finite_number(text).is_err(), "{text}");
        }
        assert_eq!(coordinates("1,2,3"), Ok([1.0, 2.0, 3.0]));
    }

    #[test]
    fn places_are_three_numbers() {
        assert_eq!(coordinates("-0.5,3, 2"), Ok([-0.5, 3.0, 2.0]));
        assert!(coordinates("1,2").is_err() && coordinates("1,2,x").is_err());
    }

    #[test]
    fn ends_of_a_range_are_named_as_short_as_they_can_be() {
        assert_eq!(within(-0.01..=1e12)("2e12"), Err("must be between -0.01 and 1e12".to_owned()));
    }
}
