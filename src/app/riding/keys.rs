//! The keys that belong to whoever rides.

use eframe::egui::{Context, Event, Key};

use super::saddle::Direction;
use crate::app::command::{Command, LOOK_STEP};
use crate::app::state::State;

/// Keys that push towards +x, and those that push back.
const FORWARDS: [Key; 2] = [Key::ArrowUp, Key::W];
const BACKWARDS: [Key; 2] = [Key::ArrowDown, Key::S];
/// Keys that look to the left, and to the right.
const LOOKS: [(Key, f64); 4] =
    [(Key::ArrowLeft, -1.0), (Key::A, -1.0), (Key::ArrowRight, 1.0), (Key::D, 1.0)];

/// Keys that belong to the ride, in words.
pub const TOLD: &str = "↑ W pedal   ↓ S brake   ← → A D look";

/// Returns whether `event` presses a key that belongs to the ride while one rides; what it asks for, where that is done at once.
#[must_use]
pub fn taken(state: &State, event: &Event) -> Option<Option<(Key, Command)>> {
    let Event::Key { key, pressed: true, modifiers, .. } = event else { return None };
    if !state.document.settings.ride.is_on() || modifiers.any() {
        return None;
    }
    let look = LOOKS.iter().find(|(look, _)| look == key);
    if let Some(&(key, side)) = look {
        return Some(Some((key, Command::LookAside([side * LOOK_STEP, 0.0]))));
    }
    [FORWARDS, BACKWARDS].as_flattened().contains(key).then_some(None)
}

/// The direction in which keys push just now, if they do.
#[must_use]
pub fn held(ctx: &Context, state: &State) -> Option<Direction> {
    if !state.document.settings.ride.is_on() || ctx.egui_wants_keyboard_input() {
        return None;
    }
    ctx.input(|input| {
        let holds = |keys: [Key; 2]| !input.modifiers.any() && keys.iter().any(|key| input.key_down(*key));
        match (holds(FORWARDS), holds(BACKWARDS)) {
            (true, false) => Some(Direction::Forwards),
            (false, true) => Some(Direction::Backwards),
            _ => None,
        }
    })
}
