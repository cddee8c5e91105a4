//! Where the inputs are in the rows of `gamow eval`, and the observation that a row describes.

use csv::ByteRecord;
use relativity_core::{Baseline, SourcePoint, StereoError};
use thiserror::Error;

use crate::columns::{Observation, ObservationError, ROLL, TURN};
use crate::files::csv_in::{self, Names};
use crate::flags::SpeedParameter;

/// Where the inputs are in each row.
#[derive(Debug)]
pub struct Header {
    speed_parameter: SpeedParameter,
    speed: usize,
    d: usize,
    /// Of roll and turn.
    head: [Option<usize>; 2],
    y: usize,
    z: usize,
    time: usize,
    x0: Option<usize>,
    names: Names,
}

/// Input that describes no observations.
#[derive(Debug, PartialEq, Error)]
pub enum InputError {
    /// Columns that are missing or there twice.
    #[error(transparent)]
    Header(#[from] csv_in::HeaderError),
    /// The speed is given in two ways.
    #[error("columns {0} and {1} both give the speed; there should be one of beta, gamma, rapidity")]
    TwoSpeeds(&'static str, &'static str),
    /// A column has the name of one that will be appended.
    #[error("column {0} is there already, and would be appended again; it should be dropped or renamed")]
    Taken(&'static str),
    /// A row that is not as the header says.
    #[error(transparent)]
    Row(#[from] csv_in::RowError),
    /// A value is outside its domain.
    #[error("column {}: {}", .0.column(), .0)]
    Observation(ObservationError),
}

impl<E: Into<ObservationError>> From<E> for InputError {
    fn from(error: E) -> Self {
        Self::Observation(error.into())
    }
}

const NEEDED: &str = "d, y, z, T and one of beta, gamma, rapidity";

impl Header {
    /// Finds the inputs by the names in the first row, to which will be added what is `appended` to a head that is turned, or
    /// is not.
    pub fn new(
        row: ByteRecord,
        appended: impl Fn(bool) -> Result<&'static [&'static str], StereoError>,
    ) -> Result<Self, InputError> {
        let names = Names::new(row)?;
        let head = head_places(&names)?;
        let appended = appended(is_turned(head))?;
        for &name in appended {
            if names.place(name)?.is_some() {
                return Err(InputError::Taken(name));
            }
        }
        let (speed_parameter, speed) = speed_place(&names)?;
        Ok(Self {
            speed_parameter,
            speed,
            d: names.needed_place("d", NEEDED)?,
            head,
            y: names.needed_place("y", NEEDED)?,
            z: names.needed_place("z", NEEDED)?,
            time: names.needed_place("T", NEEDED)?,
            x0: names.place("x0")?,
            names,
        })
    }

    /// The observation that `row` describes.
    pub fn observation(&self, row: &ByteRecord) -> Result<Observation, InputError> {
        self.names.check_length(row)?;
        let number = |place| self.names.number(row, place);
        let speed = self.speed_parameter.speed(number(self.speed)?)?;
        let x0 = self.x0.map_or(Ok(0.0), number)?;
        let point = SourcePoint { x0, y: number(self.y)?, z: number(self.z)? };
        let [roll, turn] = self.head.map(|place| place.map_or(Ok(0.0), number));
        let baseline = Baseline { separation: number(self.d)?, roll: roll?, turn: turn? };
        Ok(Observation { speed, point, baseline, time: number(self.time)? })
    }

    /// Whether there are columns of a head that is tilted or turned.
    pub fn is_turned(&self) -> bool {
        is_turned(self.head)
    }
}

fn head_places(names: &Names) -> Result<[Option<usize>; 2], csv_in::HeaderError> {
    Ok([names.place(ROLL)?, names.place(TURN)?])
}

fn is_turned(head: [Option<usize>; 2]) -> bool {
    head.iter().any(Option::is_some)
}

fn speed_place(names: &Names) -> Result<(SpeedParameter, usize), InputError> {
    let mut found = None;
    for parameter in SpeedParameter::ALL {
        let Some(place) = names.place(parameter.name())? else { continue };
        if let Some((earlier, _)) = found.replace((parameter, place)) {
            return Err(InputError::TwoSpeeds(earlier.name(), parameter.name()));
        }
    }
    found.ok_or_else(|| names.missing("beta, gamma or rapidity", NEEDED).into())
}
