//! A presenter's own sequence in the window: its entries are shown one after the other.

use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::notice::Notice;
use crate::app::state::orders::Order;
use crate::app::state::sequence::RunningSequence;
use crate::lesson::{Lesson, Phase, Place, Sequence, SequenceEntry};

impl State {
    /// Begins `sequence` with its first entry.
    pub(in crate::app) fn begin_sequence(&mut self, sequence: Sequence) {
        let text = format!("{}: 1 of {}. Page Down goes on.", sequence.name, sequence.count());
        self.session.sequence = Some(RunningSequence { sequence: Arc::new(sequence), at: 0 });
        self.session.overlay = None;
        self.show_entry();
        if self.scratch.notice.is_none() {
            self.tell(Notice::done(text));
        }
    }

    /// Goes this many `steps` on in the sequence, within a lesson first; whether there is a sequence.
    pub(super) fn show_next_in_sequence(&mut self, steps: i32) -> bool {
        let Some(running) = &self.session.sequence else { return false };
        let last = running.sequence.count().saturating_sub(1);
        let next = running.at.saturating_add_signed(steps as isize).min(last);
        if let Some(command) = self.within_lesson(steps > 0) {
            self.perform_lesson(command);
        } else if next != running.at {
            if let Some(running) = &mut self.session.sequence {
                running.at = next;
            }
            self.show_entry();
        }
        true
    }

    /// Returns the command that goes on, or back, in the lesson of the present entry, unless that leads out
    /// of its steps.
    fn within_lesson(&self, is_forward: bool) -> Option<LessonCommand> {
        let SequenceEntry::Lesson(lesson, steps) = self.session.sequence.as_ref()?.entry()? else {
            return None;
        };
        let running =
            self.session.lesson.as_ref().filter(|running| running.course.lesson().name == lesson.name)?;
        let command = if is_forward { LessonCommand::Forward } else { LessonCommand::Back };
        if is_forward && running.is_running() {
            return Some(command);
        }
        let mut course = running.course.clone();
        if is_forward {
            course.forward();
        } else {
            course.back();
        }
        let is_another = course != running.course && steps.contains(&course.place().step);
        is_another.then_some(command)
    }

    /// Shows the present entry of the sequence, in place of a lesson that is open.
    fn show_entry(&mut self) {
        let Some(entry) = self.session.sequence.as_ref().and_then(RunningSequence::entry).cloned() else {
            return;
        };
        if self.session.lesson.is_some() {
            self.perform_lesson(LessonCommand::Close);
        }
        match entry {
            SequenceEntry::Preset(preset) => self.show_preset(preset),
            SequenceEntry::State(path) => self.session.orders.push(Order::Open(path)),
            SequenceEntry::Lesson(lesson, steps) => self.show_steps(&lesson, &steps),
        }
    }

    fn show_steps(&mut self, lesson: &Lesson, steps: &RangeInclusive<usize>) {
        if let Err(error) = self.begin_lesson(lesson) {
            return self.tell(Notice::error(error));
        }
        let before = self.course().cloned();
        if let Some(running) = &mut self.session.lesson {
            running.course.pass_over(*steps.start());
        }
        self.perform_lesson(LessonCommand::GoTo(Place { step: *steps.start(), phase: Phase::Ask }));
        if let Some(before) = before.filter(|before| Some(before) != self.course()) {
            self.note_answers(&before);
        }
    }
}
