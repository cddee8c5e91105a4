//! Measured disparities from a CSV file, for `gamow fit` and for the window.
//!
//! Instruments and spreadsheets write more than names and numbers: comments, units, and words for a reading
//! that was not taken. What of that is understood is said in one line, see [`Data::treatment`].

mod headings;
mod treatment;

use std::io::Read;

use anyhow::Context as _;
use csv::ByteRecord;
use gamow_platform::sizes;
use relativity_core::{Baseline, Curves, FitError, MAX_COORDINATE, Observations, Reading, Sample};

use crate::columns::{CLOCK, ROLL, TURN};
use crate::files::csv_in::{COMMENTS, CsvReader, Names, RowError, text};
use headings::Column;
use treatment::Treatment;

pub use headings::{Kind, Unit};

const NEEDED: &str = "T, dphi or dtheta, and d unless --d gives it";
const NEEDED_OF_RIDER: &str = "clock, dphi or dtheta, and d unless --d gives it";

/// The permitted separation of eyes that measure, in words: see [`is_separation`].
pub const SEPARATION: &str = "above 0 and at most 1e60";

/// Whether two eyes so far apart can measure disparities.
#[must_use]
pub fn is_separation(value: f64) -> bool {
    value > 0.0 && value <= MAX_COORDINATE
}

/// The measured disparities of a file.
#[derive(Debug)]
pub struct Data {
    /// The samples, and the pairs of apertures that took them.
    pub observations: Observations,
    /// Whether there are columns dphi and dtheta.
    pub has: [bool; 2],
    /// Whether there is a column with their standard deviations.
    pub has_sigmas: bool,
    /// Whether the file contains the separation of the eyes.
    pub has_separation: bool,
    /// The line of the file in which each sample stands.
    pub lines: Vec<u64>,
    /// Units that the file says.
    pub said: AssumedUnits,
    /// What was done to the file before it was fitted; `None` where it is as it stands.
    pub treatment: Option<String>,
}

/// Units of a file's columns.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct AssumedUnits {
    /// Unit of the times.
    pub times: Option<Unit>,
    /// Unit of the disparities and their sigmas.
    pub angles: Option<Unit>,
}

/// The place of the eyes: their separation, and roll and turn of the head, radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eyes {
    /// Numbers that hold whatever the file contains.
    pub given: [Option<f64>; 3],
    /// Numbers that hold where the file has no such column.
    pub default: [Option<f64>; 3],
    /// Whether they ride past a point at rest, along x, and time it by a clock of their own.
    pub ride: bool,
}

impl Eyes {
    /// Returns the eyes of all samples where given, else those of the columns d, roll and turn; of the last
    /// two 0 where there are none.
    #[must_use]
    pub const fn given(separation: Option<f64>, [roll, turn]: [Option<f64>; 2]) -> Self {
        Self { given: [separation, roll, turn], default: [None, Some(0.0), Some(0.0)], ride: false }
    }

    /// Returns the eyes of the columns d, roll and turn, and of `baseline` where there are none.
    #[must_use]
    pub const fn unless_told(Baseline { separation, roll, turn }: Baseline) -> Self {
        Self { given: [None; 3], default: [Some(separation), Some(roll), Some(turn)], ride: false }
    }
}

/// The places of the inputs in each row.
struct DataHeader {
    time: Column,
    /// Sources of d, roll and turn.
    eyes: [EyesSource; 3],
    curves: [Option<DataCurve>; 2],
    /// Whether the eyes ride, so that rows are mirrored: see [`DataHeader::sample`].
    ride: bool,
    names: Names,
}

/// The source of a number that places the eyes.
#[derive(Clone, Copy)]
enum EyesSource {
    Given(f64),
    Column(Column),
}

#[derive(Clone, Copy)]
struct DataCurve {
    value: Column,
    sigma: Option<Column>,
}

/// Names of the eyes' columns, and of the curves' with their sigmas.
const EYES: [&str; 3] = ["d", ROLL, TURN];
const CURVES: [[&str; 2]; 2] = [["dphi", "sigma_dphi"], ["dtheta", "sigma_dtheta"]];

/// Returns the error for what a fit cannot use in the file `name`, whose samples stand in these `lines`.
fn unusable(error: FitError, name: &str, lines: &[u64], has_unit: bool) -> anyhow::Error {
    let FitError::Sample { index, quantity, value } = error else {
        return anyhow::Error::from(error).context(name.to_owned());
    };
    let is_angle = CURVES.iter().any(|[curve, _]| *curve == quantity);
    let hint =
        if is_angle && !has_unit { ": angles in another unit than radians need --angle-unit" } else { "" };
    anyhow::anyhow!("{name}:{}: column {quantity}: {value} is not usable{hint}", lines[index])
}

impl Data {
    /// Reads `input`, called `name` in errors, of `eyes` there, in `assumed` units where it says none.
    ///
    /// # Errors
    ///
    /// One line that names the file, the line in it, and what is wrong there.
    pub fn read(name: &str, input: impl Read, eyes: Eyes, assumed: AssumedUnits) -> anyhow::Result<Self> {
        let is_header = |names: &Names| DataHeader::is_in(names, eyes.ride);
        let mut input = CsvReader::new(input, is_header).with_context(|| name.to_owned())?;
        let mut row = ByteRecord::new();
        input.read(&mut row).with_context(|| name.to_owned())?;
        let place = |line: u64| format!("{name}:{line}");
        let mut header = DataHeader::new(row.clone(), eyes).with_context(|| place(input.line(&row)))?;
        let mut treatment = Treatment::default();
        treatment.note_preamble(input.preamble);
        let mut said = AssumedUnits::default();
        let (mut baselines, mut samples, mut lines) = (Vec::new(), Vec::new(), Vec::new());
        let mut is_first = true;
        while input.read(&mut row).with_context(|| name.to_owned())? {
            let line = input.line(&row);
            input.check_closed(&row).with_context(|| place(line))?;
            if is_passed_over(&row, &mut treatment) {
                continue;
            }
            let is_of_units = is_first && header.learn(&row, &mut treatment).with_context(|| place(line))?;
            if is_first {
                treatment.note_units(header.columns_mut().map(|(name, column)| (name, *column)));
                said = header.assume(assumed).with_context(|| place(line))?;
            }
            is_first = false;
            if is_of_units {
                continue;
            }
            anyhow::ensure!(
                samples.len() < sizes::FITTED_ROWS,
                "{}: it has more than {} rows, the limit for a fit",
                place(line),
                sizes::FITTED_ROWS
            );
            let sample = header.sample(&mut row, &mut baselines).with_context(|| place(line))?;
            let Some(sample) = sample else {
                treatment.timeless += 1;
                continue;
            };
            treatment.missing += header.missing(&sample);
            samples.push(sample);
            lines.push(line);
        }
        let pairs = baselines.iter().map(Baseline::apertures).collect();
        let observations = Observations::new(pairs, samples)
            .map_err(|error| unusable(error, name, &lines, said.angles.is_some()))?;
        Ok(Self {
            observations,
            has: header.curves.map(|curve| curve.is_some()),
            has_sigmas: header.curves.iter().flatten().any(|curve| curve.sigma.is_some()),
            has_separation: matches!(header.eyes[0], EyesSource::Column(_)),
            lines,
            said,
            treatment: treatment.sentence(),
        })
    }

    /// Returns the curves that are fitted if these are requested; those in the data if none is.
    #[must_use]
    pub const fn curves(&self, asked: Option<Curves>) -> Curves {
        match (asked, self.has) {
            (Some(curves), _) => curves,
            (None, [true, false]) => Curves::Azimuth,
            (None, [false, true]) => Curves::Polar,
            (None, _) => Curves::Both,
        }
    }
}

/// Whether `row` has no sample: a comment, or empty fields alone.
fn is_passed_over(row: &ByteRecord, treatment: &mut Treatment) -> bool {
    let is_empty = row.iter().all(|field| field.trim_ascii().is_empty());
    let first = row[0].trim_ascii();
    let is_comment = first.first().is_some_and(|byte| COMMENTS.contains(byte)) && !is_missing(first);
    treatment.empty_rows += usize::from(is_empty);
    treatment.comments += usize::from(is_comment);
    is_empty || is_comment
}

/// Whether a field says that nothing was measured, as spreadsheets, R and `NumPy` write it.
fn is_missing(field: &[u8]) -> bool {
    const WORDS: [&str; 18] = [
        "", "-", "--", "---", "\u{2013}", "\u{2014}", "?", "NaN", "NA", "N/A", "null", "none", "#N/A", "#NV",
        "#DIV/0!", "#VALUE!", "#NUM!", "#REF!",
    ];
    let field = field.trim_ascii();
    // Numbers are most of what there is.
    let is_number = field.last().is_some_and(u8::is_ascii_digit);
    !is_number && WORDS.iter().any(|word| field.eq_ignore_ascii_case(word.as_bytes()))
}

impl DataHeader {
    /// Whether a row of `names` names a time and a curve.
    fn is_in(names: &Names, ride: bool) -> bool {
        let has = |name, kind| !matches!(Column::find(names, name, kind), Ok(None));
        let has_curve = CURVES.iter().any(|[value, _]| has(value, Kind::Angle));
        has_curve && has(if ride { CLOCK } else { "T" }, Kind::Time)
    }

    fn new(row: ByteRecord, eyes: Eyes) -> anyhow::Result<Self> {
        let names = Names::new(row)?;
        let (time, needed) = if eyes.ride { (CLOCK, NEEDED_OF_RIDER) } else { ("T", NEEDED) };
        let time = Column::find(&names, time, Kind::Time)?.ok_or_else(|| names.missing(time, needed))?;
        let ride = eyes.ride;
        let source = |index: usize| {
            if let Some(number) = eyes.given[index] {
                return Ok(EyesSource::Given(number));
            }
            let (name, kind) = (EYES[index], if index == 0 { Kind::Length } else { Kind::HeadAngle });
            let column = Column::find(&names, name, kind)?.map(EyesSource::Column);
            let source = column.or(eyes.default[index].map(EyesSource::Given));
            source.ok_or_else(|| anyhow::Error::from(names.missing(name, needed)))
        };
        let eyes = [source(0)?, source(1)?, source(2)?];
        let curve = |[value, sigma]: [&'static str; 2]| -> anyhow::Result<_> {
            let value = Column::find(&names, value, Kind::Angle)?;
            let sigma = Column::find(&names, sigma, Kind::Angle)?;
            Ok(value.map(|value| DataCurve { value, sigma }))
        };
        let curves = [curve(CURVES[0])?, curve(CURVES[1])?];
        if curves.iter().all(Option::is_none) {
            return Err(names.missing("dphi or dtheta", needed).into());
        }
        let header = Self { time, eyes, curves, ride, names };
        header.check_units()?;
        Ok(header)
    }

    /// Takes the `assumed` units where the file says none; returns those that it says.
    fn assume(&mut self, assumed: AssumedUnits) -> anyhow::Result<AssumedUnits> {
        let curves = self.curves.iter_mut().flatten();
        let angles: Vec<&mut Column> =
            curves.flat_map(|curve| [Some(&mut curve.value), curve.sigma.as_mut()]).flatten().collect();
        let said =
            AssumedUnits { times: self.time.unit, angles: angles.iter().find_map(|column| column.unit) };
        self.time.unit = self.time.unit.or(assumed.times);
        for column in angles {
            column.unit = column.unit.or(assumed.angles);
        }
        self.check_units()?;
        Ok(said)
    }

    /// Every column that is read, with its name.
    fn columns_mut(&mut self) -> impl Iterator<Item = (&'static str, &mut Column)> {
        let time = if self.ride { CLOCK } else { "T" };
        let eyes = EYES.into_iter().zip(&mut self.eyes).filter_map(|(name, source)| match source {
            EyesSource::Column(column) => Some((name, column)),
            EyesSource::Given(_) => None,
        });
        let curves = CURVES
            .into_iter()
            .zip(&mut self.curves)
            .filter_map(|(names, curve)| Some((names, curve.as_mut()?)));
        let curves = curves.flat_map(|([value, sigma], curve)| {
            [Some((value, &mut curve.value)), curve.sigma.as_mut().map(|column| (sigma, column))]
        });
        [(time, &mut self.time)].into_iter().chain(eyes).chain(curves.flatten())
    }

    /// Learns from the first row below the header what the header leaves open, and returns whether it is a
    /// row of units: whether rows begin with names, as R writes them below quoted names of columns.
    fn learn(&mut self, row: &ByteRecord, treatment: &mut Treatment) -> anyhow::Result<bool> {
        let has_names =
            row.len() == self.names.len() + 1 && row.iter().all(|field| !field.trim_ascii().is_empty());
        if has_names && row[0].trim_ascii().iter().all(u8::is_ascii_digit) {
            treatment.notes.push("the first field of each row is its name".to_owned());
            self.names = self.names.after_row_names();
            self.columns_mut().for_each(|(_, column)| column.place += 1);
            return Ok(false);
        }
        let cell = |column: &Column| row.get(column.place).map(text).unwrap_or_default();
        let is_number = |column: &Column| cell(column).replace(',', ".").parse::<f64>().is_ok();
        let mut columns = self.columns_mut();
        let is_of_units = columns.any(|(_, column)| column.is_unit(&cell(column)));
        drop(columns);
        if !is_of_units || self.columns_mut().any(|(_, column)| is_number(column)) {
            return Ok(false);
        }
        for (name, column) in self.columns_mut() {
            column.take_unit(name, &cell(column))?;
        }
        self.check_units()?;
        Ok(true)
    }

    /// Refuses a time and a separation of the eyes whose units go with different speeds of light.
    fn check_units(&self) -> anyhow::Result<()> {
        let EyesSource::Column(Column { unit: Some(length), .. }) = self.eyes[0] else { return Ok(()) };
        let Some(time) = self.time.unit.filter(|time| time.base != length.base) else { return Ok(()) };
        let (time, length) = (time.name, length.name);
        anyhow::bail!(
            "column d: it is in {length} and the time in {time}, where c is not 1; both should be times or both lengths, as \
             T (m) and d (m), or T (s) and d (ls)"
        )
    }

    /// The sample that `row` describes, if it has a time; its pair is a place in `baselines`.
    ///
    /// Eyes that ride towards +x past a point at rest see what resting eyes see of a point that moves towards
    /// -x: in a mirror across x, where left and right are exchanged and the head is held the other way, it
    /// moves towards +x. There dphi is the same, and dtheta has the other sign.
    fn sample(
        &self,
        row: &mut ByteRecord,
        baselines: &mut Vec<Baseline>,
    ) -> Result<Option<Sample>, RowError> {
        self.names.fit_length(row)?;
        if is_missing(&row[self.time.place]) {
            return Ok(None);
        }
        let number = |source| match source {
            EyesSource::Given(number) => Ok(number),
            EyesSource::Column(column) => self.number(row, column),
        };
        let [separation, roll, turn] = self.eyes.map(number);
        let mirrored = if self.ride { -1.0 } else { 1.0 };
        let baseline = Baseline { separation: separation?, roll: mirrored * roll?, turn: mirrored * turn? };
        if let (EyesSource::Column(column), false) = (self.eyes[0], is_separation(baseline.separation)) {
            return Err(self.names.out_of_range(row, column.place, SEPARATION));
        }
        let known = baselines.iter().position(|&other| other == baseline);
        let pair = known.unwrap_or_else(|| {
            baselines.push(baseline);
            baselines.len() - 1
        });
        let [dphi, dtheta] = self.curves.map(|curve| self.reading(row, curve));
        let dtheta = dtheta?.map(|reading| Reading { value: mirrored * reading.value, ..reading });
        Ok(Some(Sample { time: self.number(row, self.time)?, pair, dphi: dphi?, dtheta }))
    }

    /// The reading in `row`; none if it was not taken.
    fn reading(&self, row: &ByteRecord, curve: Option<DataCurve>) -> Result<Option<Reading>, RowError> {
        let Some(DataCurve { value, sigma }) = curve.filter(|curve| !is_missing(&row[curve.value.place]))
        else {
            return Ok(None);
        };
        let sigma = sigma.map(|column| self.number(row, column)).transpose()?;
        Ok(Some(Reading { value: self.number(row, value)?, sigma }))
    }

    /// The number in `row`, in the program's own units.
    fn number(&self, row: &ByteRecord, column: Column) -> Result<f64, RowError> {
        Ok(column.factor() * self.names.number(row, column.place)?)
    }

    /// Number of readings that `sample` lacks.
    fn missing(&self, sample: &Sample) -> usize {
        self.curves
            .iter()
            .zip(sample.readings())
            .filter(|(curve, reading)| curve.is_some() && reading.is_none())
            .count()
    }
}
