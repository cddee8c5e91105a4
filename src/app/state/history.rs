//! The way back: what the user set, as it was before each step, and steps that were undone.
//!
//! A step is a change of the settings, of the followed points or of the scene; T and playing are none. All
//! that changes while a button of the pointer is held is one step, and so is a run of nudges of one kind.

use eframe::egui::{Event, InputState, Key};

use crate::app::state::points::Points;
use crate::app::state::shared::Shared;
use crate::lesson::Place;
use crate::settings::{Preset, Settings};

/// Greatest number of steps that can be undone.
const MAX_STEPS: usize = 200;

/// A kept state: the user's settings at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct UndoStep {
    /// Settings at that time.
    pub settings: Shared<Settings>,
    /// Followed points at that time.
    pub points: Points,
    /// The preset that was shown.
    pub preset: Option<&'static Preset>,
    /// The place in the lesson that was gone through.
    pub place: Option<Place>,
    /// T, where the step that followed moved it too.
    pub time: Option<f64>,
}

impl UndoStep {
    /// Whether the user set nothing in between.
    #[must_use]
    pub fn is_as(&self, other: &Self) -> bool {
        self.settings == other.settings && self.points == other.points
    }
}

/// A run of changes that make one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Run {
    /// Changes while the button was held that was pressed at this time, seconds.
    Press(f64),
    /// Nudges of the speed.
    Speed,
    /// Turns of the wheel over a view.
    Zoom,
    /// A push of the pedals.
    Pedals,
    /// Nudges of a control by the arrow keys.
    Arrows,
}

/// The steps that were made, and those that were undone.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    past: Vec<UndoStep>,
    future: Vec<UndoStep>,
    /// Run that the last step belongs to.
    run: Option<Run>,
    /// Whether the last command was a pick that made a step.
    was_pick: bool,
    /// When the button that is held, or was let go just now, was pressed.
    press: Option<f64>,
    /// Whether the button is held.
    is_held: bool,
    /// Whether an arrow key was pressed just now.
    is_nudged: bool,
}

impl History {
    /// Whether there is a step to undo.
    #[must_use]
    pub const fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is a step to do again.
    #[must_use]
    pub const fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Notes from what `input` the next commands come.
    pub fn hear(&mut self, input: &InputState) {
        let pointer = &input.pointer;
        if pointer.any_pressed() {
            self.press = Some(input.time);
        }
        self.is_held = pointer.any_down() || pointer.any_released();
        self.is_nudged = input.events.iter().any(is_arrow);
        // Another key may have chosen another control. A push of the pedals ends when it is let go.
        let is_pushed = self.run == Some(Run::Pedals);
        if !is_pushed
            && input
                .events
                .iter()
                .any(|event| matches!(event, Event::Key { pressed: true, .. }) && !is_arrow(event))
        {
            self.run = None;
        }
    }

    /// The run that a change belongs to which came now; `nudge`, if it is one of a kind.
    #[must_use]
    pub fn run(&self, nudge: Option<Run>) -> Option<Run> {
        let press = self.press.filter(|_| self.is_held).map(Run::Press);
        press.or(nudge).or_else(|| self.is_nudged.then_some(Run::Arrows))
    }

    /// Has the next change begin a step of its own.
    pub const fn end_run(&mut self) {
        self.run = None;
    }

    /// Notes that something was done in this `run`, a pick or not, before which all was as `kept`, and is now
    /// as `now`.
    pub fn note(&mut self, run: Option<Run>, is_pick: bool, kept: UndoStep, now: &UndoStep) {
        let goes_on = run.is_some() && run == self.run;
        self.run = run;
        self.was_pick = is_pick && !kept.is_as(now);
        if kept.is_as(now) {
            return;
        }
        self.future.clear();
        let Some(first) = self.past.last_mut().filter(|_| goes_on) else {
            if self.past.len() == MAX_STEPS {
                self.past.remove(0);
            }
            return self.past.push(kept);
        };
        first.time = first.time.or(kept.time);
        // There and back is no step.
        if first.is_as(now) {
            self.past.pop();
            self.run = None;
        }
    }

    /// Takes back the step of the last command, if that was a pick.
    pub fn taken_pick(&mut self) -> Option<UndoStep> {
        if std::mem::take(&mut self.was_pick) { self.past.pop() } else { None }
    }

    /// Returns the state before the last step, or after the one that was undone last.
    pub fn next(&mut self, direction: UndoDirection) -> Option<UndoStep> {
        (self.run, self.was_pick) = (None, false);
        match direction {
            UndoDirection::Back => self.past.pop(),
            UndoDirection::Forwards => self.future.pop(),
        }
    }

    /// Keeps what was `left` by a step in this `direction`.
    pub fn leave(&mut self, direction: UndoDirection, left: UndoStep) {
        match direction {
            UndoDirection::Back => self.future.push(left),
            UndoDirection::Forwards => self.past.push(left),
        }
    }
}

/// A way through the steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UndoDirection {
    /// Back, by undoing.
    Back,
    /// Forwards, by redoing.
    Forwards,
}

fn is_arrow(event: &Event) -> bool {
    let arrows = [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown];
    matches!(event, Event::Key { key, pressed: true, .. } if arrows.contains(key))
}
