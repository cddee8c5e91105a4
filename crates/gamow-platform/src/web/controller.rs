//! A game controller at the browser.
//!
//! Source: W3C, *Gamepad*, where the axes of the standard layout are those of both sticks, down and to the right above 0.

use wasm_bindgen::JsCast as _;
use web_sys::{Gamepad, window};

use crate::sticks::Sticks;

/// Both sticks as they are held now; `None` without a controller.
pub fn sticks() -> Option<Sticks> {
    let found = window()?.navigator().get_gamepads().ok()?;
    let controller =
        found.iter().find_map(|there| there.dyn_into::<Gamepad>().ok().filter(Gamepad::connected))?;
    let axes = controller.axes();
    let [left, down, right, turned_down] = std::array::from_fn(|axis| {
        axes.get(axis as u32).as_f64().filter(|axis| axis.is_finite()).unwrap_or(0.0)
    });
    Some(Sticks { left: [left, 0.0 - down], right: [right, 0.0 - turned_down] })
}
