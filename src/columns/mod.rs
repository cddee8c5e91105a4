//! The columns that `eval` and `curve` read and append, and the models that fill them.

mod batch;
mod error;
mod header;
mod model;
mod names;
mod observation;
mod observer;

pub use self::batch::{Batch, BatchRowError, Column, WantedColumns};
pub use self::error::ObservationError;
pub use self::header::{Header, InputError};
pub use self::model::{HELP, ModelArgs};
pub use self::names::{
    ANGLES, CLOCK, OBSERVER_DIRECTION, OBSERVER_PLACE, OBSERVER_PREFIX, OBSERVER_SPEED, ROLL, TURN, WHEEL,
    degrees, observer_speed, unit,
};
pub use self::observation::{GivenInputs, Observation};
