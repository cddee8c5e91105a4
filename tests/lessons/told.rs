//! What a lesson says, step by step.

use gamow::caption::decimal;
use gamow::lesson::{AnswerKind, Lesson, Options};
use gamow::settings::Settings;

/// All words of the step of this number.
pub fn words(lesson: &Lesson, step: usize) -> String {
    let step = &lesson.steps[step];
    let revealed = step.reveal.as_ref().map(|reveal| reveal.text.markdown.source());
    [Some(step.text.markdown.source()), revealed, Some(step.explanation.markdown.source())]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join("\n")
}

/// Asserts that the step says `text` with this value in the place of its `{}`.
#[track_caller]
pub fn says(lesson: &Lesson, step: usize, text: &str, value: f64, decimals: u8) {
    let wanted = text.replace("{}", &decimal(value, decimals));
    let words = words(lesson, step);
    assert!(words.contains(&wanted), "no `{wanted}` in step {step} of {}:\n{words}", lesson.name);
}

/// The right choice of the step's prediction.
#[track_caller]
pub fn right(lesson: &Lesson, step: usize) -> &str {
    let prediction = lesson.steps[step].prediction.as_ref().expect("a prediction");
    let AnswerKind::Choice(options) = &prediction.kind else { panic!("no choices") };
    right_of(options)
}

/// What is seen, of the choices after the step's reveal.
#[track_caller]
pub fn observed(lesson: &Lesson, step: usize) -> &str {
    right_of(&lesson.steps[step].observation.as_ref().expect("a question").options)
}

fn right_of(options: &Options) -> &str {
    options.texts[options.right].markdown.source()
}

/// The number that is to be predicted.
#[track_caller]
pub fn number(lesson: &Lesson, step: usize) -> f64 {
    let prediction = lesson.steps[step].prediction.as_ref().expect("a prediction");
    let AnswerKind::Number(number) = &prediction.kind else { panic!("no number") };
    number.truth.expect("worked out")
}

/// The settings of a step, before or after its reveal.
pub fn settings(lesson: &Lesson, step: usize, is_revealed: bool) -> Settings {
    lesson.settings(step, is_revealed, &Settings::default()).expect("settings")
}
