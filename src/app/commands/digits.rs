//! Digit keys while a lesson shows choices: they pick an answer, or are typed into the fields for votes.

use eframe::egui::{Event, Key};

use crate::app::commands::Command;
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::lesson::{Answer, AnswerKind, Phase};

/// The keys of the choices, in their order.
const KEYS: [Key; 9] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

/// Returns the key of the choice of this number, from 0, that `event` presses by itself.
fn pressed(event: &Event) -> Option<(Key, usize)> {
    let Event::Key { key, pressed: true, modifiers, .. } = event else { return None };
    let is_alone = !modifiers.command && !modifiers.alt;
    // No choice has the 0; it is a digit of a count.
    let number = if *key == Key::Num0 { Some(usize::MAX) } else { KEYS.iter().position(|of| of == key) };
    number.filter(|_| is_alone).map(|number| (*key, number))
}

/// Returns whether `event` presses a digit of a count of votes, which is left to its field.
#[must_use]
pub fn counts(state: &State, event: &Event) -> bool {
    pressed(event).is_some() && state.course().is_some_and(crate::lesson::Course::counts_hands)
}

/// Returns the digit that `event` presses and the answer that it gives where the lesson has choices on
/// screen.
#[must_use]
pub fn answered(state: &State, event: &Event) -> Option<(Key, Command)> {
    let (key, number) = pressed(event)?;
    let (course, running) = (state.course()?, state.session.lesson.as_ref()?);
    let (count, command) = match course.asked().map(|asked| &asked.kind) {
        Some(AnswerKind::Choice(options)) => {
            (options.texts.len(), LessonCommand::Draft(Some(Answer::Choice(number))))
        }
        Some(_) => return None,
        None => {
            let is_shown = course.place().phase == Phase::Shown && !running.is_running();
            let observation = course.step()?.observation.as_ref().filter(|_| is_shown)?;
            (observation.options.texts.len(), LessonCommand::Observe(number))
        }
    };
    // A digit beyond the choices does nothing else either.
    let command = if number < count { command } else { LessonCommand::Draft(course.draft.clone()) };
    Some((key, Command::Lesson(command)))
}
