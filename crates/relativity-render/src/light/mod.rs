//! Light on its way from a body to the screen: daylight, what of it eyes see, how bright it is shown, and the
//! tables of its colours.

pub(crate) mod daylight;
pub mod exposure;
pub(crate) mod falling;
pub(crate) mod hatch;
pub(crate) mod palette;
pub mod received;
pub(crate) mod screen_light;
pub(crate) mod shade;
pub(crate) mod sky;
pub(crate) mod street_light;
pub mod tone;
