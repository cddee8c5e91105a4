//! Doing what was asked as a step that can be undone, and undoing it.

use super::command::Command;
use super::history::{Direction, Kept, Run};
use super::notice::Notice;
use super::state::State;

impl State {
    /// Does what was asked, so that it can be undone.
    pub fn apply(&mut self, command: Command) {
        match command {
            Command::Undo => self.travel(Direction::Back),
            Command::Redo => self.travel(Direction::Forwards),
            command => self.step(command),
        }
    }

    fn step(&mut self, command: Command) {
        if command == Command::FollowAgain
            && let Some(before) = self.session.history.taken_pick()
        {
            self.session.points = before.points;
        }
        let (kept, is_pick, time) = (self.kept(), matches!(command, Command::Pick(_)), self.session.time);
        let run = self.session.history.run(nudge(&command));
        self.perform(command);
        let kept = Kept { time: Some(time).filter(|time| *time != self.session.time), ..kept };
        let now = self.kept();
        self.session.history.note(run, is_pick, kept, &now);
    }

    fn kept(&self) -> Kept {
        let preset = self.session.preset;
        Kept { settings: self.settings.clone(), points: self.session.points.clone(), preset, time: None }
    }

    fn travel(&mut self, direction: Direction) {
        let Some(kept) = self.session.history.next(direction) else { return };
        let left = Kept { time: kept.time.map(|_| self.session.time), ..self.kept() };
        if let Err(error) = self.set(kept.settings) {
            self.session.notice = Some(Notice::error(error));
            return;
        }
        (self.session.points, self.session.preset) = (kept.points, kept.preset);
        self.session.time = kept.time.unwrap_or(self.session.time);
        self.session.history.leave(direction, left);
    }
}

/// The kind of nudge that it is, if it is one.
const fn nudge(command: &Command) -> Option<Run> {
    match command {
        Command::NudgeSpeed(_) => Some(Run::Speed),
        Command::Zoom(_) => Some(Run::Zoom),
        _ => None,
    }
}
