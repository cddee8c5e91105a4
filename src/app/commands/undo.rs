//! Undo and redo: commands are run as steps.

use std::path::PathBuf;

use eframe::egui::InputState;

use crate::app::commands::{Command, GazeCommand, PointsCommand, SettingsCommand};
use crate::app::state::State;
use crate::app::state::history::{Run, UndoDirection, UndoStep};
use crate::app::state::notice::Notice;
use crate::app::state::riding::saddle::RideCommand;
use crate::lesson::Course;

impl State {
    /// Notes from what `input` the next commands come.
    pub(in crate::app) fn hear(&mut self, input: &InputState) {
        self.session.history.hear(input);
    }

    /// Runs a command, so that it can be undone.
    pub fn run(&mut self, command: impl Into<Command>) {
        let before = self.course().cloned();
        match command.into() {
            Command::Undo => self.travel(UndoDirection::Back),
            Command::Redo => self.travel(UndoDirection::Forwards),
            // A scene that is written anew is no setting: who writes it has a way back of their own.
            Command::File(file) if self.renews_the_scene(&file) => self.perform(Command::File(file)),
            command => self.record_undo(command),
        }
        self.follow_lesson();
        if let Some(before) = before {
            self.note_answers(&before);
        }
    }

    /// Performs a command, and records what it changed as an undo step.
    fn record_undo(&mut self, command: Command) {
        if command == Command::Gaze(GazeCommand::WholeAgain)
            && let Some(before) = self.session.history.taken_pick()
        {
            self.document.points = before.points;
        }
        if matches!(command, Command::Ride(RideCommand::Push(..))) && self.scratch.saddle.push.is_none() {
            self.session.history.end_run();
        }
        let (kept, is_pick, time) =
            (self.kept(), matches!(command, Command::Points(PointsCommand::Pick(_))), self.document.time);
        let run = self.session.history.run(nudge(&command));
        self.perform(command);
        let kept = UndoStep { time: Some(time).filter(|time| *time != self.document.time), ..kept };
        let now = self.kept();
        self.session.history.note(run, is_pick, kept, &now);
    }

    fn kept(&self) -> UndoStep {
        let preset = self.document.preset;
        let (settings, points) = (self.document.settings.clone(), self.document.points.clone());
        UndoStep { settings, points, preset, place: self.course().map(Course::place), time: None }
    }

    fn travel(&mut self, direction: UndoDirection) {
        let Some(kept) = self.session.history.next(direction) else { return };
        let scene = PathBuf::from(&kept.settings.scene);
        let left = UndoStep { time: kept.time.map(|_| self.document.time), ..self.kept() };
        if let Err(error) = self.set(kept.settings) {
            self.tell(Notice::error(error).about(&scene));
            return;
        }
        self.document.points = kept.points.in_scene(&self.document.scene);
        self.document.preset = kept.preset;
        if let Some((running, place)) = self.session.lesson.as_mut().zip(kept.place) {
            running.course.go_to(place);
        }
        self.stop_run();
        if let Some(time) = kept.time {
            (self.document.time, self.document.opened) = (time, None);
        }
        self.session.history.leave(direction, left);
    }
}

/// The kind of nudge that it is, if it is one.
const fn nudge(command: &Command) -> Option<Run> {
    match command {
        Command::Settings(SettingsCommand::NudgeSpeed(_)) => Some(Run::Speed),
        Command::Ride(RideCommand::Push(..)) => Some(Run::Pedals),
        Command::Gaze(GazeCommand::Zoom(_) | GazeCommand::Magnify(_)) => Some(Run::Zoom),
        _ => None,
    }
}
