//! The names of input columns: places of the inputs in a row, and the observation that a row describes.

use csv::ByteRecord;
use relativity_core::{Baseline, Observer, ObserverVelocity, SourcePoint, StereoError};
use thiserror::Error;

use super::error::{ObservationError, half_turn};
use super::names::{
    OBSERVER_DIRECTION, OBSERVER_PLACE, OBSERVER_PREFIX, OBSERVER_SPEED, ROLL, TURN, WHEEL, observer_speed,
};
use super::observation::{GivenInputs, Observation};
use crate::files::csv_in::{self, Names};
use crate::flags::{GivenObserver, SpeedParameter, rolling};

/// The places of the inputs in each row.
#[derive(Debug)]
pub struct Header {
    /// Parameter that the speed is given as.
    pub speed_parameter: SpeedParameter,
    speed: usize,
    d: usize,
    /// Places of roll and turn.
    head: [Option<usize>; 2],
    /// Places of the radius, rho and angle of a point on a wheel.
    wheel: Option<[usize; 3]>,
    observer: Option<ObserverPlaces>,
    y: usize,
    z: usize,
    time: usize,
    x0: Option<usize>,
    names: Names,
}

/// The places of how the observer moves.
#[derive(Debug)]
struct ObserverPlaces {
    speed: Option<(SpeedParameter, usize)>,
    direction: [Option<usize>; 2],
    place: [Option<usize>; 3],
}

/// Input that describes no observations.
#[derive(Debug, PartialEq, Error)]
pub enum InputError {
    /// Columns that are missing or there twice.
    #[error(transparent)]
    Header(#[from] csv_in::HeaderError),
    /// A speed is given in two ways.
    #[error("columns {0} and {1} both give the speed; there should be one of beta, gamma, rapidity")]
    TwoSpeeds(&'static str, &'static str),
    /// A column that could be meant for one of the observer's.
    #[error(
        "column {0} is none of the observer's: observer_beta, observer_gamma or observer_rapidity; observer_azimuth, \
             observer_elevation; observer_x, observer_y, observer_z"
    )]
    UnknownObserver(String),
    /// A point on a wheel is given in part.
    #[error("column {there} is given, and {missing} is not; wheel_radius, rho and angle go together")]
    PartOfWheel {
        /// One of the three that the header names.
        there: &'static str,
        /// One of the three that it does not.
        missing: &'static str,
    },
    /// A column has the name of one that will be appended.
    #[error("column {0} is there already, and would be appended again; it should be dropped or renamed")]
    Taken(&'static str),
    /// A row that disagrees with the header.
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
    /// Finds the inputs by the names in the first row, to which the columns in `appended` will be added.
    ///
    /// # Errors
    ///
    /// A column that is missing, there twice, or about to be appended; a speed that is given in two ways.
    pub fn new(
        row: ByteRecord,
        appended: impl Fn(GivenInputs) -> Result<Vec<&'static str>, StereoError>,
    ) -> Result<Self, InputError> {
        let names = Names::new(row)?;
        let head = head_places(&names)?;
        let wheel = wheel_places(&names)?;
        let observer = observer_places(&names)?;
        let given = given(head, wheel, observer.as_ref());
        for name in appended(given)? {
            if names.place(name)?.is_some() {
                return Err(InputError::Taken(name));
            }
        }
        let speed = speed_place(&names, SpeedParameter::name)?;
        let (speed_parameter, speed) =
            speed.ok_or_else(|| names.missing("beta, gamma or rapidity", NEEDED))?;
        Ok(Self {
            speed_parameter,
            speed,
            d: names.needed_place("d", NEEDED)?,
            head,
            wheel,
            observer,
            y: names.needed_place("y", NEEDED)?,
            z: names.needed_place("z", NEEDED)?,
            time: names.needed_place("T", NEEDED)?,
            x0: names.place("x0")?,
            names,
        })
    }

    /// The observation that `row` describes.
    ///
    /// # Errors
    ///
    /// A row of another length, a field that is no number, or one that is out of range.
    pub fn observation(&self, row: &ByteRecord) -> Result<Observation, InputError> {
        self.names.check_length(row)?;
        self.observation_of(|place| self.names.number(row, place))
    }

    /// The observation that the `value` of each place describes.
    ///
    /// # Errors
    ///
    /// A number that is not finite, or that is out of range.
    pub fn observation_with(&self, value: impl Fn(usize) -> f64) -> Result<Observation, InputError> {
        self.observation_of(|place| self.names.finite(value(place), place))
    }

    fn observation_of(
        &self,
        number: impl Fn(usize) -> Result<f64, csv_in::RowError>,
    ) -> Result<Observation, InputError> {
        let speed = self.speed_parameter.speed(number(self.speed)?)?;
        let x0 = self.x0.map_or(Ok(0.0), &number)?;
        let point = SourcePoint { x0, y: number(self.y)?, z: number(self.z)? };
        let source = match self.wheel {
            None => point.into(),
            Some([radius, rho, angle]) => rolling(point, [number(radius)?, number(rho)?, number(angle)?]),
        };
        let [roll, turn] = self.head.map(|place| place.map_or(Ok(0.0), &number));
        let [roll, turn] = [half_turn(ROLL, roll?)?, half_turn(TURN, turn?)?];
        let baseline = Baseline { separation: number(self.d)?, roll, turn };
        let time = number(self.time)?;
        let observer = match &self.observer {
            None => Observer { velocity: ObserverVelocity::REST, place: [0.0; 3], time },
            Some(places) => places.given(number)?.observer(time)?,
        };
        Ok(Observation { speed, source, baseline, observer, clock: 0.0 })
    }

    /// The places of the speed, x0, y, z and T, of which x0 may be missing.
    #[must_use]
    pub const fn places(&self) -> [Option<usize>; 5] {
        [Some(self.speed), self.x0, Some(self.y), Some(self.z), Some(self.time)]
    }

    /// Returns what the columns determine.
    #[must_use]
    pub fn given(&self) -> GivenInputs {
        given(self.head, self.wheel, self.observer.as_ref())
    }
}

impl ObserverPlaces {
    /// The motion of the observer in a row.
    fn given(
        &self,
        number: impl Fn(usize) -> Result<f64, csv_in::RowError>,
    ) -> Result<GivenObserver, csv_in::RowError> {
        let or_zero = |place: Option<usize>| place.map_or(Ok(0.0), &number);
        let [azimuth, elevation] = self.direction.map(or_zero);
        let [x, y, z] = self.place.map(or_zero);
        let speed = self.speed.map(|(parameter, place)| Ok((parameter, number(place)?))).transpose()?;
        Ok(GivenObserver { speed, direction: [azimuth?, elevation?], place: [x?, y?, z?] })
    }
}

/// Returns the places of the observer's columns; `None` without any.
fn observer_places(names: &Names) -> Result<Option<ObserverPlaces>, InputError> {
    let known = [&OBSERVER_SPEED[..], &OBSERVER_DIRECTION, &OBSERVER_PLACE].concat();
    if let Some(unknown) = names.that_begin_with(OBSERVER_PREFIX).find(|name| !known.contains(&name.as_str()))
    {
        return Err(InputError::UnknownObserver(unknown));
    }
    let [azimuth, elevation] = OBSERVER_DIRECTION.map(|name| names.place(name));
    let [x, y, z] = OBSERVER_PLACE.map(|name| names.place(name));
    let places = ObserverPlaces {
        speed: speed_place(names, observer_speed)?,
        direction: [azimuth?, elevation?],
        place: [x?, y?, z?],
    };
    let is_given =
        places.speed.is_some() || places.direction.iter().chain(&places.place).any(Option::is_some);
    Ok(is_given.then_some(places))
}

fn head_places(names: &Names) -> Result<[Option<usize>; 2], csv_in::HeaderError> {
    Ok([names.place(ROLL)?, names.place(TURN)?])
}

/// Returns the places of a point on a wheel: all or none.
fn wheel_places(names: &Names) -> Result<Option<[usize; 3]>, InputError> {
    let mut places = [None; 3];
    for (place, name) in places.iter_mut().zip(WHEEL) {
        *place = names.place(name)?;
    }
    if let [Some(radius), Some(rho), Some(angle)] = places {
        return Ok(Some([radius, rho, angle]));
    }
    let first =
        |is_there: bool| places.iter().position(|place| place.is_some() == is_there).map(|i| WHEEL[i]);
    match (first(true), first(false)) {
        (Some(there), Some(missing)) => Err(InputError::PartOfWheel { there, missing }),
        _ => Ok(None),
    }
}

fn given(
    head: [Option<usize>; 2],
    wheel: Option<[usize; 3]>,
    observer: Option<&ObserverPlaces>,
) -> GivenInputs {
    GivenInputs {
        is_turned: head.iter().any(Option::is_some),
        on_wheel: wheel.is_some(),
        is_riding: observer.is_some(),
    }
}

/// The one column that gives a speed, the columns having these names; `None` without one.
fn speed_place(
    names: &Names,
    name: impl Fn(SpeedParameter) -> &'static str,
) -> Result<Option<(SpeedParameter, usize)>, InputError> {
    let mut found = None;
    for parameter in SpeedParameter::ALL {
        let Some(place) = names.place(name(parameter))? else { continue };
        if let Some((earlier, _)) = found.replace((parameter, place)) {
            return Err(InputError::TwoSpeeds(name(earlier), name(parameter)));
        }
    }
    Ok(found)
}
