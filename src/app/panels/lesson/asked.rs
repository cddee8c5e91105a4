//! Requests of the parts of the panel.

use crate::app::command::Command;
use crate::app::lesson::session::LessonCommand;
use crate::app::panels::Asks;

/// Asks for something in the lesson.
pub fn ask(asks: &mut Asks, command: LessonCommand) {
    asks.push(Command::Lesson(command));
}
