//! The page of whoever teaches: the aim, the minutes, and for each step what to say, what pupils answer, and
//! what goes wrong.

use super::common::head;
use super::{answers, lab};
use crate::files::html::{HtmlPage, escaped};
use crate::formula::markdown::Markdown;
use crate::lesson::plan::{AnswerKind, Lesson, Options, Step, Text};
use crate::settings::Settings;

/// Adds the teacher's page to `page`.
pub fn write(page: &mut HtmlPage, lesson: &Lesson) -> anyhow::Result<()> {
    head(page, lesson, "Teacher\u{2019}s page: ");
    page.text(&lesson.introduction.markdown)?;
    if !lesson.sentence.is_empty() {
        page.text_behind("**Aim.** Pupils can say, and give reasons for:", &lesson.sentence.markdown)?;
    }
    page.text(&Markdown::new(plan(lesson)))?;
    for (number, told) in lesson.steps.iter().enumerate() {
        page.html(&format!("<div class=\"opening\">\n<h2>{}. {}</h2>\n", number + 1, escaped(&told.title)));
        step(page, told, &lesson.settings(number, true, &Settings::default())?)?;
        page.html("</div>\n");
    }
    if let Some(done) = &lesson.lab {
        lab::answers(page, lesson, done)?;
    }
    Ok(())
}

/// The minutes, and how a class goes through the steps.
fn plan(lesson: &Lesson) -> String {
    let steps = lesson.steps.len();
    let each = f64::from(lesson.minutes) / steps.max(1) as f64;
    let lab = if lesson.lab.is_some() { ", without the lab" } else { "" };
    format!(
        "**Minutes.** {} in all{lab}: {steps} steps of about {each:.0}. In each: everybody predicts, alone and in silence; count \
         hands (*Count hands*); let neighbours convince each other; reveal; ask what was seen before anybody tells the truth; \
         then let pupils explain.",
        lesson.minutes
    )
}

fn step(page: &mut HtmlPage, step: &Step, settings: &Settings) -> anyhow::Result<()> {
    said(page, "**What to say.**", &step.text)?;
    answers::step(page, step, settings)?;
    if step.teaching.is_empty() {
        wrong_answers(page, step)?;
    }
    said(page, "**What pupils say.**", &step.teaching)?;
    said(page, "**Why.**", &step.explanation)
}

/// Writes what pupils may answer, taken from the questions: for a step without advice of its author's.
fn wrong_answers(page: &mut HtmlPage, step: &Step) -> anyhow::Result<()> {
    if let Some(AnswerKind::Choice(options)) = step.prediction.as_ref().map(|asked| &asked.kind) {
        wrong(page, "**What pupils also answer.**", options)?;
    }
    if let Some(observation) = &step.observation {
        let text = "**What can go wrong.** Some see what they expected. Show it again (*Look again*) to those who answer:";
        wrong(page, text, &observation.options)?;
    }
    Ok(())
}

/// Adds `text` behind its `name`, if there is one.
fn said(page: &mut HtmlPage, name: &str, text: &Text) -> anyhow::Result<()> {
    if text.is_empty() { Ok(()) } else { page.text_behind(name, &text.markdown) }
}

/// Adds the wrong ones of `options`, as a list below `lead`.
fn wrong(page: &mut HtmlPage, lead: &str, options: &Options) -> anyhow::Result<()> {
    page.text(&Markdown::new(lead))?;
    let wrong = options.texts.iter().enumerate().filter(|(number, _)| *number != options.right);
    page.list(wrong.map(|(_, text)| &text.markdown))
}
