//! Headings of columns as instruments and spreadsheets write them: a name, and the unit of what stands below.

use std::f64::consts::PI;

use anyhow::Context as _;

use crate::files::csv_in::{HeaderError, Names};

/// A column of measured values, and what turns one into the program's unit.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Its place in a row, from 0.
    pub place: usize,
    /// What it measures.
    pub kind: Kind,
    /// Unit in which it is written; `None` where nothing says one.
    pub unit: Option<Unit>,
}

/// What a column measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A time, which may be written as the length that light goes in it.
    Time,
    /// A length, which may be written as the time that light takes for it.
    Length,
    /// An angle, in radians where no unit is written.
    Angle,
    /// An angle of the head, in degrees where no unit is written.
    HeadAngle,
}

/// A unit that a column may be written in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its name in messages.
    pub name: &'static str,
    /// What it is turned into.
    pub base: &'static str,
    /// Number of these in it.
    pub factor: f64,
}

const SECONDS: &str = "s";
const METRES: &str = "m";
const RADIANS: &str = "rad";

/// The ways to write a unit, its base, and how many of these it has.
type Row = (&'static [&'static str], &'static str, f64);

const ANGLES: &[Row] = &[
    (&["rad", "radian", "radians"], RADIANS, 1.0),
    (&["mrad", "millirad", "milliradian", "milliradians"], RADIANS, 1e-3),
    (&["urad", "µrad", "μrad", "microrad", "microradians"], RADIANS, 1e-6),
    (&["deg", "°", "degree", "degrees"], RADIANS, PI / 180.0),
    (&["arcmin", "'", "′"], RADIANS, PI / 10_800.0),
    (&["arcsec", "\"", "″"], RADIANS, PI / 648_000.0),
];
const TIMES: &[Row] = &[
    (&["s", "sec", "second", "seconds"], SECONDS, 1.0),
    (&["ms", "msec", "millisecond", "milliseconds"], SECONDS, 1e-3),
    (&["us", "µs", "μs", "microsecond", "microseconds"], SECONDS, 1e-6),
    (&["ns", "nanosecond", "nanoseconds"], SECONDS, 1e-9),
    (&["min", "minute", "minutes"], SECONDS, 60.0),
];
const LENGTHS: &[Row] = &[
    (&["m", "metre", "metres", "meter", "meters"], METRES, 1.0),
    (&["cm", "centimetre", "centimetres", "centimeter", "centimeters"], METRES, 1e-2),
    (&["mm", "millimetre", "millimetres", "millimeter", "millimeters"], METRES, 1e-3),
    (&["km", "kilometre", "kilometres", "kilometer", "kilometers"], METRES, 1e3),
];
/// Lengths by the time that light takes for them.
const LIGHT_TIMES: &[Row] = &[
    (&["ls", "light-second", "light-seconds", "light seconds"], SECONDS, 1.0),
    (&["light-ms", "light-milliseconds"], SECONDS, 1e-3),
    (&["light-us", "light-µs", "light-microseconds"], SECONDS, 1e-6),
    (&["light-ns", "light-nanoseconds"], SECONDS, 1e-9),
];

impl Kind {
    const fn tables(self) -> &'static [&'static [Row]] {
        match self {
            Self::Time => &[TIMES, LENGTHS],
            Self::Length => &[LENGTHS, LIGHT_TIMES],
            Self::Angle | Self::HeadAngle => &[ANGLES],
        }
    }

    /// The unit that is written like this.
    #[must_use]
    pub fn unit(self, written: &str) -> Option<Unit> {
        let rows = self.tables().iter().copied().flatten();
        let found = rows.into_iter().find(|(names, ..)| names.contains(&written));
        found.map(|&(names, base, factor)| Unit { name: names[0], base, factor })
    }

    /// The names of all its units.
    fn known(self) -> String {
        let rows = self.tables().iter().copied().flatten();
        rows.map(|(names, ..)| names[0]).collect::<Vec<_>>().join(", ")
    }
}

impl Column {
    /// Finds the column `name`, in which something of this kind is measured, if it is there.
    ///
    /// # Errors
    ///
    /// Two such columns; a unit that is not known.
    pub fn find(names: &Names, name: &'static str, kind: Kind) -> anyhow::Result<Option<Self>> {
        if let Some(place) = names.place(name)? {
            return Ok(Some(Self { place, kind, unit: None }));
        }
        let headings: Vec<Heading> = names.texts().map(|text| Heading::of(&text)).collect();
        let others = if kind == Kind::Time && name == "T" { TIME_NAMES } else { &[] };
        for wanted in [name].iter().chain(others) {
            let mut places = (0..headings.len()).filter(|&place| headings[place].name == *wanted);
            let Some(place) = places.next() else { continue };
            if let Some(second) = places.next() {
                return Err(HeaderError::Duplicate { name, first: place + 1, second: second + 1 }.into());
            }
            let unit = headings[place].unit.as_deref();
            let unit = unit.map(|unit| known(name, kind, unit)).transpose()?;
            return Ok(Some(Self { place, kind, unit }));
        }
        Ok(None)
    }

    /// Takes the unit that stands in a row of units, where the heading has none.
    ///
    /// # Errors
    ///
    /// A unit that is not known.
    pub fn take_unit(&mut self, name: &'static str, cell: &str) -> anyhow::Result<()> {
        let written = in_brackets(cell).unwrap_or(cell).trim();
        if self.unit.is_none() && !written.is_empty() {
            self.unit = Some(known(name, self.kind, written)?);
        }
        Ok(())
    }

    /// What a number of the column is multiplied by.
    #[must_use]
    pub fn factor(&self) -> f64 {
        let default = if self.kind == Kind::HeadAngle { PI / 180.0 } else { 1.0 };
        self.unit.map_or(default, |unit| unit.factor)
    }

    /// Whether `cell` is a unit of what the column measures, and no number.
    #[must_use]
    pub fn is_unit(&self, cell: &str) -> bool {
        self.kind.unit(in_brackets(cell).unwrap_or(cell).trim()).is_some()
    }
}

/// What the time is also called, by programs that log measurements.
const TIME_NAMES: &[&str] = &["t", "Time", "time", "TIME"];

fn known(name: &str, kind: Kind, unit: &str) -> anyhow::Result<Unit> {
    kind.unit(unit).with_context(|| {
        let unit = gamow_platform::messages::excerpt(unit);
        format!("column {name}: the unit \"{unit}\" is not known; these are: {}", kind.known())
    })
}

/// A heading in its parts.
struct Heading {
    name: String,
    unit: Option<String>,
}

impl Heading {
    /// Takes `T (s)`, `T [s]`, `T / s`, `T in s` and `Latest: T (s)` apart.
    fn of(text: &str) -> Self {
        let text = text.rsplit_once(": ").map_or(text, |(_, text)| text).trim();
        let of = |name: &str, unit: &str| {
            let unit = Some(unit.trim().to_owned()).filter(|unit| !unit.is_empty());
            Self { name: name.trim().to_owned(), unit }
        };
        let bracket = text.find(['(', '[']).filter(|&place| in_brackets(&text[place..]).is_some());
        if let Some(place) = bracket {
            return of(&text[..place], in_brackets(&text[place..]).unwrap_or_default());
        }
        let divided = text.rsplit_once('/').or_else(|| text.rsplit_once(" in "));
        divided.map_or_else(|| of(text, ""), |(name, unit)| of(name, unit))
    }
}

fn in_brackets(text: &str) -> Option<&str> {
    let text = text.trim();
    let round = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
    round.or_else(|| text.strip_prefix('[').and_then(|text| text.strip_suffix(']')))
}
