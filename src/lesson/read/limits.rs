//! The limits of a lesson, which keep a frame of the window and the file of answers small.

use gamow_platform::{messages, sizes};

use super::wrong::Wrong;
use crate::lesson::plan::{AnswerKind, Choices, Lesson, Options, Prediction, Step, Text};

/// Whether a lesson's `text` is short enough to be read.
///
/// # Errors
/// Why it is not.
pub fn check_length(text: &str) -> Result<(), Wrong> {
    if text.len() > sizes::LESSON_BYTES {
        return Err((1, format!("a lesson has at most {} kB", sizes::LESSON_BYTES >> 10)));
    }
    Ok(())
}

/// Checks the length of the `name` given as `key`.
///
/// # Errors
/// What is wrong with it.
pub fn check_name(key: &str, name: &str) -> Result<(), String> {
    if sizes::is_too_long_for_a_name(name) {
        let (name, most) = (messages::excerpt(name), sizes::NAME_LETTERS);
        return Err(format!("{key} = {name}: must have at most {most} letters"));
    }
    Ok(())
}

/// Whether all that `lesson` shows and asks is short enough.
///
/// # Errors
/// What is too long, or too much.
pub fn check(lesson: &Lesson) -> Result<(), Wrong> {
    if let Some(step) = lesson.steps.get(sizes::STEPS) {
        return Err((step.text.line.max(1), format!("a lesson has at most {} steps", sizes::STEPS)));
    }
    let lab = lesson.lab.as_ref().map(|lab| &lab.text);
    let outside = [&lesson.introduction, &lesson.sentence].into_iter().chain(lab);
    outside.chain(lesson.steps.iter().flat_map(texts)).try_for_each(check_text)?;
    lesson.steps.iter().flat_map(all_options).try_for_each(check_options)?;
    let mut asked = 0;
    for text in lesson.steps.iter().flat_map(questions) {
        asked += text.markdown.source().len();
        if asked > sizes::QUESTION_BYTES {
            let most = sizes::QUESTION_BYTES >> 10;
            let problem = format!("all questions and choices of a lesson have at most {most} kB together");
            return Err((text.line, problem));
        }
    }
    Ok(())
}

fn check_text(text: &Text) -> Result<(), Wrong> {
    if text.markdown.source().len() > sizes::PASSAGE_BYTES {
        let most = sizes::PASSAGE_BYTES >> 10;
        return Err((text.line, format!("a text that is shown at once has at most {most} kB")));
    }
    Ok(())
}

fn check_options(options: &Options) -> Result<(), Wrong> {
    match options.texts.get(sizes::CHOICES) {
        Some(excess) => Err((excess.line, format!("a question has at most {} choices", sizes::CHOICES))),
        None => Ok(()),
    }
}

/// Every text that a step shows.
fn texts(step: &Step) -> impl Iterator<Item = &Text> {
    let reveal = step.reveal.as_ref().map(|reveal| &reveal.text);
    [&step.text, &step.explanation, &step.teaching].into_iter().chain(reveal).chain(questions(step))
}

/// The questions of a step and their choices.
fn questions(step: &Step) -> impl Iterator<Item = &Text> {
    let predicted = step.prediction.as_ref().map(|Prediction { question, .. }| question);
    let observed = step.observation.as_ref().map(|Choices { question, .. }| question);
    predicted.into_iter().chain(observed).chain(all_options(step).flat_map(|options| &options.texts))
}

/// The lists of choices of a step.
fn all_options(step: &Step) -> impl Iterator<Item = &Options> {
    let predicted = step.prediction.as_ref().and_then(|Prediction { kind, .. }| match kind {
        AnswerKind::Choice(options) => Some(options),
        AnswerKind::Number(_) | AnswerKind::Point(_) | AnswerKind::Curve(_) => None,
    });
    let observed = step.observation.as_ref().map(|Choices { options, .. }| options);
    predicted.into_iter().chain(observed)
}
