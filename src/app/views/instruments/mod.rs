//! The instruments on the handlebar: a dial with the rider's speed between two clocks; and on request two
//! odometers, the place, and the keys.

mod dial;
mod paint;
mod places;
mod values;

pub use paint::show;
pub use values::Instruments;
