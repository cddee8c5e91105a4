//! Questions about the window, each answered from the state alone.

pub(in crate::app) mod audience;
pub(in crate::app) mod compared;
pub(in crate::app) mod drawn_curve;
mod lesson;
mod looks;
pub(in crate::app) mod observer;
pub(in crate::app) mod on_wheel;
mod plots;
mod riding;
pub(in crate::app) mod spectrum;
pub(in crate::app) mod told_speed;
