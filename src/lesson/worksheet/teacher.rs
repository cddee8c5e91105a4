//! The page of whoever teaches: the aim, the minutes, and for each step what to say, what pupils answer, and what goes wrong.

use std::fmt::Write as _;

use super::common::head;
use super::{answers, lab};
use crate::files::html::{HtmlPage, escaped};
use crate::lesson::plan::{AnswerKind, Lesson, Options, Step};
use crate::settings::Settings;

/// Adds the teacher's page to `page`.
pub fn write(page: &mut HtmlPage, lesson: &Lesson) -> anyhow::Result<()> {
    head(page, lesson, "Teacher\u{2019}s page: ");
    page.text(&lesson.introduction.markdown)?;
    if !lesson.sentence.is_empty() {
        page.text(&format!("**Aim.** Pupils can say, and give reasons for: {}", lesson.sentence.markdown))?;
    }
    page.text(&plan(lesson))?;
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
    said(page, "What to say.", &step.text.markdown)?;
    answers::step(page, step, settings)?;
    if step.teaching.is_empty() {
        wrong_answers(page, step)?;
    }
    said(page, "What pupils say.", &step.teaching.markdown)?;
    said(page, "Why.", &step.explanation.markdown)
}

/// Writes what pupils may answer, taken from the questions: for a step without advice of its author's.
fn wrong_answers(page: &mut HtmlPage, step: &Step) -> anyhow::Result<()> {
    if let Some(AnswerKind::Choice(options)) = step.prediction.as_ref().map(|asked| &asked.kind) {
        page.text(&format!("**What pupils also answer.**{}", wrong(options)?))?;
    }
    if let Some(observation) = &step.observation {
        let text = "Some see what they expected. Show it again (*Look again*) to those who answer:";
        page.text(&format!("**What can go wrong.** {text}{}", wrong(&observation.options)?))?;
    }
    Ok(())
}

fn said(page: &mut HtmlPage, name: &str, text: &str) -> anyhow::Result<()> {
    if text.is_empty() {
        return Ok(());
    }
    page.text(&format!("**{name}** {text}"))
}

/// The wrong ones of `options`, as a list.
fn wrong(options: &Options) -> anyhow::Result<String> {
    let mut list = String::from("\n\n");
    for (_, text) in options.texts.iter().enumerate().filter(|(number, _)| *number != options.right) {
        writeln!(list, "- {}", text.markdown.replace('\n', " "))?;
    }
    Ok(list)
}
