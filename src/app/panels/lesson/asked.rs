//! Requests of the parts of the panel.

use crate::app::commands::Command;
use crate::app::panels::Commands;
use crate::app::state::lesson::LessonCommand;

/// Asks for something in the lesson.
pub fn ask(commands: &mut Commands, command: LessonCommand) {
    commands.push(Command::Lesson(command));
}
