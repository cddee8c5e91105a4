//! Measured disparities from a CSV file, for `gamow fit` and for the window.

use std::io::Read;

use anyhow::Context as _;
use csv::ByteRecord;
use gamow_platform::sizes;
use relativity_core::{Baseline, Curves, FitError, MAX_COORDINATE, Observations, Reading, Sample};

use crate::columns::{CLOCK, ROLL, TURN};
use crate::files::csv_in::{CsvReader, HeaderError, Names, RowError};

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
    time: usize,
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
    Column(usize),
}

#[derive(Clone, Copy)]
struct DataCurve {
    value: usize,
    sigma: Option<usize>,
}

impl Data {
    /// Reads `input`, called `name` in errors, of `eyes` there.
    ///
    /// # Errors
    ///
    /// One line that names the file, the line in it, and what is wrong there.
    pub fn read(name: &str, input: impl Read, eyes: Eyes) -> anyhow::Result<Self> {
        let mut input = CsvReader::new(input).with_context(|| name.to_owned())?;
        let mut row = ByteRecord::new();
        input.read(&mut row).with_context(|| name.to_owned())?;
        let place = |line: u64| format!("{name}:{line}");
        let header = DataHeader::new(row.clone(), eyes).with_context(|| place(input.line(&row)))?;
        let (mut baselines, mut samples, mut lines) = (Vec::new(), Vec::new(), Vec::new());
        while input.read(&mut row).with_context(|| name.to_owned())? {
            let line = input.line(&row);
            anyhow::ensure!(
                samples.len() < sizes::FITTED_ROWS,
                "{}: it has more than {} rows, the limit for a fit",
                place(line),
                sizes::FITTED_ROWS
            );
            let sample = input.check_closed(&row).and_then(|()| header.sample(&row, &mut baselines));
            samples.push(sample.with_context(|| place(line))?);
            lines.push(line);
        }
        let pairs = baselines.iter().map(Baseline::apertures).collect();
        let observations = Observations::new(pairs, samples).map_err(|error| match error {
            FitError::Sample { index, quantity, value } => {
                anyhow::anyhow!("{name}:{}: column {quantity}: {value} is not usable", lines[index])
            }
            other => anyhow::Error::from(other).context(name.to_owned()),
        })?;
        Ok(Self {
            observations,
            has: header.curves.map(|curve| curve.is_some()),
            has_sigmas: header.curves.iter().flatten().any(|curve| curve.sigma.is_some()),
            has_separation: matches!(header.eyes[0], EyesSource::Column(_)),
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

impl DataHeader {
    fn new(row: ByteRecord, eyes: Eyes) -> Result<Self, HeaderError> {
        let names = Names::new(row)?;
        let (time, needed) = if eyes.ride { (CLOCK, NEEDED_OF_RIDER) } else { ("T", NEEDED) };
        let time = names.needed_place(time, needed)?;
        let ride = eyes.ride;
        let source = |index: usize, column| {
            if let Some(number) = eyes.given[index] {
                return Ok(EyesSource::Given(number));
            }
            let place = names.place(column)?.map(EyesSource::Column);
            let source = place.or(eyes.default[index].map(EyesSource::Given));
            source.ok_or_else(|| names.missing(column, needed))
        };
        let eyes = [source(0, "d")?, source(1, ROLL)?, source(2, TURN)?];
        let curve = |value, sigma| {
            let value = names.place(value)?;
            let sigma = names.place(sigma)?;
            Ok(value.map(|value| DataCurve { value, sigma }))
        };
        let curves = [curve("dphi", "sigma_dphi")?, curve("dtheta", "sigma_dtheta")?];
        if curves.iter().all(Option::is_none) {
            return Err(names.missing("dphi or dtheta", needed));
        }
        Ok(Self { time, eyes, curves, ride, names })
    }

    /// The sample that `row` describes; its pair is a place in `baselines`.
    ///
    /// Eyes that ride towards +x past a point at rest see what resting eyes see of a point that moves towards
    /// -x: in a mirror across x, where left and right are exchanged and the head is held the other way, it
    /// moves towards +x. There dphi is the same, and dtheta has the other sign.
    fn sample(&self, row: &ByteRecord, baselines: &mut Vec<Baseline>) -> Result<Sample, RowError> {
        self.names.check_length(row)?;
        let number = |source| match source {
            EyesSource::Given(number) => Ok(number),
            EyesSource::Column(place) => self.names.number(row, place),
        };
        let [separation, roll, turn] = self.eyes.map(number);
        let mirrored = if self.ride { -1.0 } else { 1.0 };
        let baseline = Baseline { separation: separation?, roll: mirrored * roll?, turn: mirrored * turn? };
        if let (EyesSource::Column(place), false) = (self.eyes[0], is_separation(baseline.separation)) {
            return Err(self.names.out_of_range(row, place, SEPARATION));
        }
        let known = baselines.iter().position(|&other| other == baseline);
        let pair = known.unwrap_or_else(|| {
            baselines.push(baseline);
            baselines.len() - 1
        });
        let [dphi, dtheta] = self.curves.map(|curve| self.reading(row, curve));
        let dtheta = dtheta?.map(|reading| Reading { value: mirrored * reading.value, ..reading });
        Ok(Sample { time: self.names.number(row, self.time)?, pair, dphi: dphi?, dtheta })
    }

    /// The reading in `row`; none if its cell is empty.
    fn reading(&self, row: &ByteRecord, curve: Option<DataCurve>) -> Result<Option<Reading>, RowError> {
        let Some(DataCurve { value, sigma }) =
            curve.filter(|curve| !row[curve.value].trim_ascii().is_empty())
        else {
            return Ok(None);
        };
        let sigma = sigma.map(|place| self.names.number(row, place)).transpose()?;
        Ok(Some(Reading { value: self.names.number(row, value)?, sigma }))
    }
}
