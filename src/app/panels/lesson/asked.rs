//! Requests of the parts of the panel.

use crate::app::command::Command;
use crate::app::lesson::session::LessonCommand;
use crate::app::panels::Commands;

/// Asks for something in the lesson.
pub fn ask(commands: &mut Commands, command: LessonCommand) {
    commands.push(Command::Lesson(command));
}
