//! The pupil's sheet, two pages at most: questions and room to answer, but no solutions: it can be read
//! ahead.

use super::common::{choices, head, name_and_date, picture_beside, plot};
use crate::files::html::{HtmlPage, answer_lines, escaped};
use crate::lesson::answer::Confidence;
use crate::lesson::plan::{AnswerKind, Choices, Lesson, Prediction, Step};
use crate::settings::Settings;

/// Lines for an explanation, and for a sentence to take away.
const LINES: [usize; 2] = [2, 2];

/// Adds the pupil's sheet to `page`, and calls `on_step` after each step.
pub fn write(page: &mut HtmlPage, lesson: &Lesson, mut on_step: impl FnMut()) -> anyhow::Result<()> {
    name_and_date(page);
    head(page, lesson, "");
    if !lesson.is_a_preset() {
        page.text(&lesson.introduction.markdown)?;
    }
    for number in 0..lesson.steps.len() {
        step(page, lesson, number)?;
        on_step();
    }
    if !lesson.sentence.is_empty() {
        page.html("<div class=\"question\">\n<h2>In a sentence</h2>\n");
        page.html(&answer_lines(LINES[1]));
        page.html("</div>\n");
    }
    Ok(())
}

fn step(page: &mut HtmlPage, lesson: &Lesson, number: usize) -> anyhow::Result<()> {
    let Step { title, text, prediction, reveal, observation, explanation, .. } = &lesson.steps[number];
    let shown = lesson.settings(number, false, &Settings::default())?;
    page.html("<div class=\"question opening\">\n");
    page.html(&format!("<h2>{}. {}</h2>\n", number + 1, escaped(title)));
    if has_picture(lesson, number, &shown)? {
        picture_beside(page, &shown, title)?;
    }
    page.text(&text.markdown)?;
    if let Some(Prediction { question, kind }) = prediction {
        page.html("<h3>Predict</h3>\n");
        page.text(&question.markdown)?;
        ask(page, kind, &shown)?;
        let scale = Confidence::ALL.map(|level| format!("☐ {}", level.name())).join(" &ensp; ");
        page.html(&format!("<p>How sure? &ensp; {scale}</p>\n"));
    }
    page.html("</div>\n");
    if reveal.is_some() || observation.is_some() {
        page.html("<div class=\"question\">\n<h3>See</h3>\n");
        if reveal.is_some() {
            page.html("<p>Reveal it in the window.</p>\n");
        }
        if let Some(Choices { question, options }) = observation {
            page.text(&question.markdown)?;
            choices(page, options, None)?;
        }
        page.html("</div>\n");
    }
    if !explanation.is_empty() {
        page.html("<div class=\"question closing\">\n<h3>Explain</h3>\n");
        page.html(&answer_lines(LINES[0]));
        page.html("</div>\n");
    }
    Ok(())
}

/// Whether a step has a picture: where a place is to be marked, and where a scene is new. The first picture
/// of a scene that was there before is often the reveal of the step before, and would answer its question.
fn has_picture(lesson: &Lesson, number: usize, shown: &Settings) -> anyhow::Result<bool> {
    let kind = lesson.steps[number].prediction.as_ref().map(|prediction| &prediction.kind);
    let Some(before) = number.checked_sub(1) else { return Ok(true) };
    let is_new = lesson.settings(before, true, &Settings::default())?.scene != shown.scene;
    Ok(is_new || matches!(kind, Some(AnswerKind::Point(_))))
}

fn ask(page: &mut HtmlPage, kind: &AnswerKind, settings: &Settings) -> anyhow::Result<()> {
    match kind {
        AnswerKind::Choice(options) => choices(page, options, None)?,
        AnswerKind::Number(number) => {
            page.html(&format!("<p>____________ {}</p>\n", escaped(&number.unit)));
        }
        AnswerKind::Point(_) => page.html("<p>Mark the place with a cross in the left picture.</p>\n"),
        AnswerKind::Curve(curve) => {
            page.html(&format!("<figure class=\"plot\">\n{}</figure>\n", plot(curve, settings, false)?));
        }
    }
    Ok(())
}
