//! Numbers as flags and files have them: what is none, or out of range, is refused with what would be right.

use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;

use serde::{Serialize, Serializer};

/// Parses a number: f64's own parser also takes `nan` and `inf`, which nobody means.
pub fn finite_number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err("not a finite number".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// Parses a number above 0.
pub fn positive(text: &str) -> Result<f64, String> {
    let value = finite_number(text)?;
    if value > 0.0 { Ok(value) } else { Err("must be above 0".to_owned()) }
}

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

/// As short as it can be written.
fn short(value: f64) -> String {
    let [plain, powers] = [value.to_string(), format!("{value:e}")];
    if powers.len() < plain.len() { powers } else { plain }
}

/// Parses a field of view, degrees.
pub fn field_of_view(text: &str) -> Result<f64, String> {
    let degrees = finite_number(text)?;
    if degrees > 0.0 && degrees < 180.0 {
        Ok(degrees)
    } else {
        Err("must be between 0 and 180 degrees".to_owned())
    }
}

/// A horizontal field of view, degrees, or `auto`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FieldOfView(pub Option<f64>);

impl FromStr for FieldOfView {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "auto" { Ok(Self(None)) } else { field_of_view(text).map(|degrees| Self(Some(degrees))) }
    }
}

impl Serialize for FieldOfView {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Some(degrees) => serializer.serialize_f64(degrees),
            None => serializer.serialize_str("auto"),
        }
    }
}

/// Parses a place.
pub fn coordinates(text: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> = text.split(',').map(finite_number).collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| "write three numbers like 0,3,2".to_owned())
}

/// Whether something is so: `on` or `off`. (By this name `clap` takes it for a value like any other.)
pub type OnOff = bool;

/// Parses a switch.
pub fn switch(text: &str) -> Result<OnOff, String> {
    match text {
        "on" => Ok(true),
        "off" => Ok(false),
        _ => Err("must be on or off".to_owned()),
    }
}

/// A number, or `off`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumberOrOff(pub Option<f64>);

impl FromStr for NumberOrOff {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "off" { Ok(Self(None)) } else { finite_number(text).map(|value| Self(Some(value))) }
    }
}

impl fmt::Display for NumberOrOff {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(value) => write!(f, "{value}"),
            None => f.write_str("off"),
        }
    }
}

impl Serialize for NumberOrOff {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Some(value) => serializer.serialize_f64(value),
            None => serializer.serialize_str("off"),
        }
    }
}

/// A first and a last T, or `auto`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TimeRange(pub Option<[f64; 2]>);

/// Largest magnitude of the ends of a range of T: beyond it a step would round away.
pub const MAX_TIME: f64 = 1e12;

impl FromStr for TimeRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "auto" {
            return Ok(Self(None));
        }
        let Some((from, to)) = text.split_once(',') else {
            return Err("write `auto`, or the first and the last T like -2,5".to_owned());
        };
        let time = within(-MAX_TIME..=MAX_TIME);
        let [from, to] = [time(from)?, time(to)?];
        if from <= to {
            Ok(Self(Some([from, to])))
        } else {
            Err("the first T must not be above the last".to_owned())
        }
    }
}

impl Serialize for TimeRange {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Some(range) => range.serialize(serializer),
            None => serializer.serialize_str("auto"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
