//! The sheet of answers: what is right in each step, what is then shown, and why.

use super::common::{choices, head, picture_beside, truth};
use super::lab;
use crate::files::html::{HtmlPage, escaped};
use crate::lesson::plan::{Choices, Lesson, Prediction, Step};
use crate::settings::Settings;

/// Adds the answer sheet to `page`, and calls `on_step` after each step.
pub fn write(page: &mut HtmlPage, lesson: &Lesson, mut on_step: impl FnMut()) -> anyhow::Result<()> {
    head(page, lesson, "Answers: ");
    if !lesson.is_a_preset() {
        page.text(&lesson.introduction.markdown)?;
    }
    for (number, told) in lesson.steps.iter().enumerate() {
        page.html(&format!(
            "<div class=\"question opening\">\n<h2>{}. {}</h2>\n",
            number + 1,
            escaped(&told.title)
        ));
        let settings = lesson.settings(number, true, &Settings::default())?;
        picture_beside(page, &settings, &told.title)?;
        step(page, told, &settings)?;
        page.html("</div>\n");
        page.text(&told.explanation.markdown)?;
        on_step();
    }
    if !lesson.sentence.is_empty() {
        page.html("<h2>In a sentence</h2>\n");
        page.text(&lesson.sentence.markdown)?;
    }
    if let Some(done) = &lesson.lab {
        lab::answers(page, lesson, done)?;
    }
    Ok(())
}

/// Adds the questions of a step with their answers, revealed in `settings`.
pub fn step(page: &mut HtmlPage, step: &Step, settings: &Settings) -> anyhow::Result<()> {
    if let Some(Prediction { question, kind }) = &step.prediction {
        page.text(&question.markdown)?;
        truth(page, kind, settings)?;
    }
    if let Some(reveal) = &step.reveal {
        page.text(&reveal.text.markdown)?;
    }
    if let Some(Choices { question, options }) = &step.observation {
        page.text(&question.markdown)?;
        choices(page, options, Some(options.right))?;
    }
    Ok(())
}
