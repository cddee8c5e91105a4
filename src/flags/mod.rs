//! Types of flags that several commands and the window share.

pub mod choices;
mod numbers;
mod speed;
pub mod words;

pub use numbers::{
    FieldOfView, MAX_TIME, NumberOrOff, OnOff, TimeRange, coordinates, field_of_view, finite_number,
    positive, switch, whole_number, within,
};
pub use speed::{SpeedArgs, SpeedParameter, SpeedSetting};
