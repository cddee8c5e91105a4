//! The three times of an event, for hovering.

use crate::app::state::State;

/// Decimals of a time in the scene's unit.
const DECIMALS: u8 = 3;

/// When light is received, when it left, and what the own clock showed then, in units of the scene: a line
/// for each.
pub fn times(state: &State, values: [f64; 3]) -> String {
    state.clock().texts(values, state.measures().time, DECIMALS).join("\n")
}

/// A time in a label: two decimals of the scene's unit, and what is less than those show is 0.
pub fn labelled(state: &State, value: f64) -> String {
    let unit = state.measures().time;
    unit.number(if value.abs() < 0.005 { 0.0 } else { value }, 2)
}
