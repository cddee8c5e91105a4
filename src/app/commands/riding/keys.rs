//! The keys that belong to whoever rides.

use eframe::egui::{Context, Event, InputState, Key};

use super::thumbs;
use crate::app::commands::choice_keys;
use crate::app::commands::{Command, GazeCommand, LOOK_STEP};
use crate::app::state::State;
use crate::app::state::riding::saddle::PushDirection;

/// Keys that look to the left, and to the right.
const LOOKS: [(Key, f64); 2] = [(Key::ArrowLeft, -1.0), (Key::ArrowRight, 1.0)];
/// Keys that pedal and brake.
const PEDALS: [(Key, PushDirection); 2] =
    [(Key::ArrowUp, PushDirection::Forwards), (Key::ArrowDown, PushDirection::Backwards)];
/// Keys that walk: which way each pushes, by how far to the right and how far ahead of where one looks.
const WALKS: [(Key, [i16; 2]); 4] =
    [(Key::W, [0, 1]), (Key::A, [-1, 0]), (Key::S, [0, -1]), (Key::D, [1, 0])];

/// Keys that belong to the ride, in words, a line each.
const TOLD: &[&str] = &[
    "hold ↑ to pedal, ↓ to brake",
    "← → or drag: look    shift I: face ahead",
    "W A S D: walk    H: this again",
];

/// The same for two thumbs.
const TOLD_TO_THUMBS: &[&str] = &["hold ▲ to pedal, ▼ to brake", "drag, also with the other thumb: look"];

/// Returns what belongs to the ride, in words, a line each: keys, or where the screen of `ctx` knows touches
/// what thumbs do.
#[must_use]
pub fn told(ctx: &Context) -> &'static [&'static str] {
    if thumbs::are_there(ctx) { TOLD_TO_THUMBS } else { TOLD }
}

/// Returns whether `event` presses a key that belongs to the ride while one rides; what it asks for, where
/// that is done at once.
#[must_use]
pub fn taken(state: &State, event: &Event) -> Option<Option<(Key, Command)>> {
    let Event::Key { key, pressed: true, modifiers, .. } = event else { return None };
    if !state.document.settings.ride.is_on() || modifiers.any() {
        return None;
    }
    let look = LOOKS.iter().find(|(look, _)| look == key);
    if let Some(&(key, side)) = look {
        return Some(Some((key, Command::Gaze(GazeCommand::Aside([side * LOOK_STEP, 0.0])))));
    }
    let mut pushes = PEDALS.iter().map(|(pedal, _)| pedal).chain(WALKS.iter().map(|(walk, _)| walk));
    pushes.any(|push| push == key).then_some(None)
}

/// The direction in which keys or thumbs push just now, if they do.
#[must_use]
pub fn held(ctx: &Context, state: &State) -> Option<PushDirection> {
    thumbs::hear(ctx);
    if !state.document.settings.ride.is_on() {
        return None;
    }
    thumbs::held(ctx).or_else(|| held_keys(ctx, state))
}

fn held_keys(ctx: &Context, state: &State) -> Option<PushDirection> {
    if ctx.egui_wants_keyboard_input() {
        return None;
    }
    let is_free = |key: Key| !choice_keys::takes(state, key);
    ctx.input(
        |input| {
            if input.modifiers.any() { None } else { pedalled(input).or_else(|| walked(input, is_free)) }
        },
    )
}

/// The one pedal that is pushed.
fn pedalled(input: &InputState) -> Option<PushDirection> {
    let mut held = PEDALS.iter().filter(|(key, _)| input.key_down(*key));
    held.next().map(|(_, direction)| *direction).filter(|_| held.next().is_none())
}

/// The direction in which the keys that walk push together, those that are free for it.
fn walked(input: &InputState, is_free: impl Fn(Key) -> bool) -> Option<PushDirection> {
    let held = WALKS.iter().filter(|(key, _)| input.key_down(*key) && is_free(*key)).map(|(_, push)| push);
    let [right, ahead] = held.fold([0, 0], |[right, ahead], [x, y]| [right + x, ahead + y]);
    match ([right, ahead], right.signum()) {
        ([0, 0], _) => None,
        ([0, ahead], _) => Some(if ahead > 0 { 0 } else { 180 }),
        ([_, 0], side) => Some(-90 * side),
        ([_, ahead], side) => Some(if ahead > 0 { -45 * side } else { -135 * side }),
    }
    .map(PushDirection::Beside)
}
