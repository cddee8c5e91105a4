//! Types of flags that several commands and the window share.

pub mod choices;
mod compare;
mod followed;
mod goal;
mod head;
mod layout;
mod numbers;
mod observer;
mod ride;
mod speed;
mod wheel;
pub mod words;

pub use followed::{Followed, FollowedPoint};
pub use goal::{BUDGET_MS, ERROR_PX, Goal};
pub use head::{HEAD_DEGREES, HeadArgs};
pub use numbers::{
    COORDINATES, EXPONENT, EXPOSURE_EV, Exposure, FIELD_OF_VIEW, FieldOfView, IntensityExponent, MAX_TIME,
    OnOff, PLACE, SCREEN_CM, ScreenWidth, Share, TEMPERATURE_K, TimeRange, column_exponent, coordinates,
    field_of_view, finite_number, switch, temperature, time, whole_number, within,
};
pub use observer::{GivenObserver, ObserverArgs};
pub use ride::{RideLegs, StreetVelocity};
pub use speed::{SpeedArgs, SpeedParameter, SpeedSetting, given_speed};
pub use wheel::{WheelArgs, rolling};

/// Has values written into files as flags have them.
macro_rules! written_as_flags {
    ($($name:ty),+) => {
        $(impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        })+
    };
}

written_as_flags!(choices::Size, Followed, RideLegs, StreetVelocity);
