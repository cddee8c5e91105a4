//! The way back: what the user set, as it was before each step, and steps that were undone.
//!
//! A step is a change of the settings, of the followed points or of the scene; T and playing are none. All that changes
//! while a button of the pointer is held is one step, and so is a run of nudges of one kind.

use std::mem::{Discriminant, discriminant};

use eframe::egui::{Event, InputState, Key};

use super::command::Command;
use super::notice::Notice;
use super::points::Points;
use super::state::State;
use crate::settings::{Preset, Settings};

/// Most steps that can be undone.
const MAX_STEPS: usize = 200;

/// What the user set, at one time.
#[derive(Debug, Clone, PartialEq)]
struct Kept {
    settings: Settings,
    points: Points,
    preset: Option<&'static Preset>,
    /// T, where the step that followed moved it too.
    time: Option<f64>,
}

impl Kept {
    /// Whether the user set nothing in between.
    fn is_as(&self, other: &Self) -> bool {
        self.settings == other.settings && self.points == other.points
    }
}

/// What makes several changes one step.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Run {
    /// They came while the button was held that was pressed at this time, seconds.
    Press(f64),
    /// They were nudges of one kind.
    Nudges(Discriminant<Command>),
}

/// The steps that were made, and those that were undone.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    past: Vec<Kept>,
    future: Vec<Kept>,
    /// What the last step goes on with.
    run: Option<Run>,
    /// Whether the last thing that was asked for was a pick that made a step.
    was_pick: bool,
    /// When the button that is held, or was let go just now, was pressed.
    press: Option<f64>,
    /// Whether it is.
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
    }

    /// What `command` goes on with, or begins.
    fn run_of(&self, command: &Command) -> Option<Run> {
        let press = self.press.filter(|_| self.is_held).map(Run::Press);
        let is_nudge = self.is_nudged || matches!(command, Command::NudgeSpeed(_) | Command::Zoom(_));
        press.or_else(|| is_nudge.then(|| Run::Nudges(discriminant(command))))
    }

    /// Notes that something was done in this `run`, before which all was as `kept`, and is now as `now`.
    fn note(&mut self, run: Option<Run>, kept: Kept, now: &Kept) {
        let goes_on = run.is_some() && run == self.run;
        self.run = run;
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
}

fn is_arrow(event: &Event) -> bool {
    let arrows = [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown];
    matches!(event, Event::Key { key, pressed: true, .. } if arrows.contains(key))
}

impl State {
    /// Does what was asked, so that it can be undone.
    pub fn apply(&mut self, command: Command) {
        match command {
            Command::Undo => self.travel(|history| (&mut history.past, &mut history.future)),
            Command::Redo => self.travel(|history| (&mut history.future, &mut history.past)),
            command => {
                if command == Command::FollowAgain {
                    self.take_pick_back();
                }
                let (mut kept, run) = (self.kept(), self.session.history.run_of(&command));
                let (time, is_pick) = (self.session.time, matches!(command, Command::Pick(_)));
                self.perform(command);
                let now = self.kept();
                kept.time = Some(time).filter(|time| *time != self.session.time);
                self.session.history.was_pick = is_pick && !kept.is_as(&now);
                self.session.history.note(run, kept, &now);
            }
        }
    }

    /// Takes the pick back that was the last thing done, if it was, as if it had never been.
    fn take_pick_back(&mut self) {
        let history = &mut self.session.history;
        if std::mem::take(&mut history.was_pick)
            && let Some(kept) = history.past.pop()
        {
            self.session.points = kept.points;
        }
    }

    fn kept(&self) -> Kept {
        let preset = self.session.preset;
        Kept { settings: self.settings.clone(), points: self.session.points.clone(), preset, time: None }
    }

    /// A step along one of the lists of a history; what is left goes onto the other.
    fn travel(&mut self, lists: fn(&mut History) -> (&mut Vec<Kept>, &mut Vec<Kept>)) {
        let history = &mut self.session.history;
        (history.run, history.was_pick) = (None, false);
        let Some(kept) = lists(history).0.pop() else { return };
        let left = Kept { time: kept.time.map(|_| self.session.time), ..self.kept() };
        if let Err(error) = self.set(kept.settings) {
            self.session.notice = Some(Notice::error(error));
            return;
        }
        (self.session.points, self.session.preset) = (kept.points, kept.preset);
        self.session.time = kept.time.unwrap_or(self.session.time);
        lists(&mut self.session.history).1.push(left);
    }
}
