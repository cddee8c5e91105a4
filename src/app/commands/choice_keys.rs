//! Keys while a lesson shows choices: letters and digits pick an answer; digits are typed into the fields for
//! votes.

use eframe::egui::{Event, Key};

use crate::app::commands::Command;
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::lesson::{Answer, AnswerKind, Course, Phase};

/// The letters and the digits of the choices, in their order.
const LETTERS: [Key; 9] = [Key::A, Key::B, Key::C, Key::D, Key::E, Key::F, Key::G, Key::H, Key::I];
const DIGITS: [Key; 9] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

/// Returns the key that `event` presses without Ctrl or Alt.
fn pressed(event: &Event) -> Option<Key> {
    let Event::Key { key, pressed: true, modifiers, .. } = event else { return None };
    Some(*key).filter(|_| !modifiers.command && !modifiers.alt)
}

/// Returns the number of the choice with this digit, from 0. No choice has the 0; it is a digit of a count.
fn digit(key: Key) -> Option<usize> {
    if key == Key::Num0 { Some(usize::MAX) } else { DIGITS.iter().position(|of| *of == key) }
}

/// Returns the number of the choice on screen with this letter, from 0.
fn letter(state: &State, key: Key) -> Option<usize> {
    LETTERS.iter().take(count(state)).position(|of| *of == key)
}

/// The choices on screen.
struct ChoicesOnScreen {
    count: usize,
    /// Whether they are of the question of what was seen.
    is_observation: bool,
}

/// Returns the choices that the lesson has on screen.
fn choices(state: &State) -> Option<ChoicesOnScreen> {
    let (course, running) = (state.course()?, state.session.lesson.as_ref()?);
    match course.asked().map(|asked| &asked.kind) {
        Some(AnswerKind::Choice(options)) => {
            Some(ChoicesOnScreen { count: options.texts.len(), is_observation: false })
        }
        Some(_) => None,
        None => {
            let is_shown = course.place().phase == Phase::Shown && !running.is_running();
            let observation = course.step()?.observation.as_ref().filter(|_| is_shown)?;
            Some(ChoicesOnScreen { count: observation.options.texts.len(), is_observation: true })
        }
    }
}

/// Returns how many choices the lesson has on screen.
#[must_use]
pub fn count(state: &State) -> usize {
    choices(state).map_or(0, |choices| choices.count)
}

/// Returns the letter of the choice with this number, from 0; nothing of one that has none.
#[must_use]
pub fn letter_of(number: usize) -> &'static str {
    LETTERS.get(number).map_or("", |key| key.name())
}

/// Returns whether `event` presses a digit of a count of votes, which is left to its field.
#[must_use]
pub fn counts(state: &State, event: &Event) -> bool {
    pressed(event).and_then(digit).is_some() && state.course().is_some_and(Course::counts_hands)
}

/// Returns whether this key is the letter of a choice on screen.
#[must_use]
pub fn takes(state: &State, key: Key) -> bool {
    letter(state, key).is_some()
}

/// Returns the letter or digit that `event` presses and the answer that it gives where the lesson has choices
/// on screen.
#[must_use]
pub fn answered(state: &State, event: &Event) -> Option<(Key, Command)> {
    let key = pressed(event)?;
    let number = letter(state, key).or_else(|| digit(key))?;
    let (course, ChoicesOnScreen { count, is_observation }) = (state.course()?, choices(state)?);
    // A digit beyond the choices, or a letter while hands are counted, does nothing else either.
    let command = match number {
        number if number >= count || course.counts_hands() => LessonCommand::Draft(course.draft.clone()),
        number if is_observation => LessonCommand::Observe(number),
        number => LessonCommand::Draft(Some(Answer::Choice(number))),
    };
    Some((key, Command::Lesson(command)))
}
