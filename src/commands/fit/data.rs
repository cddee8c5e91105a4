//! Measured disparities from a CSV file.

use std::io::Read;

use anyhow::Context as _;
use csv::ByteRecord;
use relativity_core::{Baseline, FitError, Observations, Reading, Sample};

use crate::columns::{ROLL, TURN};
use crate::files::csv_in::{HeaderError, Names, RowError, Rows};

const NEEDED: &str = "T, dphi or dtheta, and d unless --d gives it";

/// Measured disparities.
#[derive(Debug)]
pub struct Data {
    /// The samples, and the pairs of apertures that took them.
    pub observations: Observations,
    /// Whether there are columns dphi and dtheta.
    pub has: [bool; 2],
}

/// Where the inputs are in each row.
struct Header {
    time: usize,
    separation: Source,
    /// Of roll and turn.
    head: [Source; 2],
    curves: [Option<Curve>; 2],
    names: Names,
}

/// Where a number comes from that says where the eyes are.
#[derive(Clone, Copy)]
enum Source {
    Given(f64),
    Column(usize),
}

#[derive(Clone, Copy)]
struct Curve {
    value: usize,
    sigma: Option<usize>,
}

impl Data {
    /// Reads `input`, called `name` in errors. `separation`, and `roll` and `turn`, are those of all
    /// samples, or else the columns d, roll and turn; of the last two 0 where there are none.
    pub fn read(
        name: &str,
        input: impl Read,
        separation: Option<f64>,
        head: [Option<f64>; 2],
    ) -> anyhow::Result<Self> {
        let mut input = Rows::new(input);
        let mut row = ByteRecord::new();
        input.read(&mut row).with_context(|| name.to_owned())?;
        let place = |line: u64| format!("{name}:{line}");
        let header = Header::new(row.clone(), separation, head).with_context(|| place(input.line(&row)))?;
        let (mut baselines, mut samples, mut lines) = (Vec::new(), Vec::new(), Vec::new());
        while input.read(&mut row).with_context(|| name.to_owned())? {
            let line = input.line(&row);
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
        Ok(Self { observations, has: header.curves.map(|curve| curve.is_some()) })
    }
}

impl Header {
    fn new(row: ByteRecord, separation: Option<f64>, head: [Option<f64>; 2]) -> Result<Self, HeaderError> {
        let names = Names::new(row)?;
        let time = names.needed_place("T", NEEDED)?;
        let separation = match separation {
            Some(separation) => Source::Given(separation),
            None => Source::Column(names.needed_place("d", NEEDED)?),
        };
        let angle = |given: Option<f64>, name| match given {
            Some(angle) => Ok(Source::Given(angle)),
            None => Ok(names.place(name)?.map_or(Source::Given(0.0), Source::Column)),
        };
        let head = [angle(head[0], ROLL)?, angle(head[1], TURN)?];
        let curve = |value, sigma| {
            let value = names.place(value)?;
            let sigma = names.place(sigma)?;
            Ok(value.map(|value| Curve { value, sigma }))
        };
        let curves = [curve("dphi", "sigma_dphi")?, curve("dtheta", "sigma_dtheta")?];
        if curves.iter().all(Option::is_none) {
            return Err(names.missing("dphi or dtheta", NEEDED));
        }
        Ok(Self { time, separation, head, curves, names })
    }

    /// The sample that `row` describes; its pair is a place in `baselines`.
    fn sample(&self, row: &ByteRecord, baselines: &mut Vec<Baseline>) -> Result<Sample, RowError> {
        self.names.check_length(row)?;
        let number = |source| match source {
            Source::Given(number) => Ok(number),
            Source::Column(place) => self.names.number(row, place),
        };
        let [roll, turn] = self.head;
        let baseline =
            Baseline { separation: number(self.separation)?, roll: number(roll)?, turn: number(turn)? };
        let known = baselines.iter().position(|&other| other == baseline);
        let pair = known.unwrap_or_else(|| {
            baselines.push(baseline);
            baselines.len() - 1
        });
        let [dphi, dtheta] = self.curves.map(|curve| self.reading(row, curve));
        Ok(Sample { time: self.names.number(row, self.time)?, pair, dphi: dphi?, dtheta: dtheta? })
    }

    /// The reading in `row`; none if its cell is empty.
    fn reading(&self, row: &ByteRecord, curve: Option<Curve>) -> Result<Option<Reading>, RowError> {
        let Some(Curve { value, sigma }) = curve.filter(|curve| !row[curve.value].trim_ascii().is_empty())
        else {
            return Ok(None);
        };
        let sigma = sigma.map(|place| self.names.number(row, place)).transpose()?;
        Ok(Some(Reading { value: self.names.number(row, value)?, sigma }))
    }
}
