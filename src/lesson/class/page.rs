//! The page of a class: how its pupils have answered each question of their lessons.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use anyhow::Context as _;
use gamow_platform::messages;

use super::collected::Collected;
use super::distribution;
use super::pupil::PupilAnswers;
use super::tally::{Judgement, Tally};
use super::token::KEY;
use crate::files::html::{HtmlPage, PageStyle, escaped};
use crate::lesson::answer::Record;
use crate::lesson::plan::{AnswerKind, Choices, Lesson, Prediction, Step};
use crate::lesson::score::with_sight;
use crate::lesson::truth::Sight;
use crate::settings::Settings;

/// Greatest number of links that could not be read and are named on the page.
const MOST_NAMED: usize = 20;

/// Returns the page of the answers in `collected` to these `lessons`, as they were read, one after the other.
/// `on_step` is called after each step of a lesson that was answered.
///
/// # Errors
/// No answers to any of these lessons, what cannot be worked out of a lesson, and a text that cannot be
/// drawn.
pub fn page(lessons: &[&Lesson], collected: &Collected, mut on_step: impl FnMut()) -> anyhow::Result<String> {
    let answered: Vec<_> =
        lessons.iter().filter(|lesson| collected.of(&lesson.name).next().is_some()).collect();
    let Some(first) = answered.first() else { anyhow::bail!(nothing(lessons, collected)) };
    let title = if answered.len() == 1 { first.title.as_str() } else { "Lessons" };
    let mut page = HtmlPage::new(&format!("Class: {title}"), PageStyle::Print);
    page.html("<div class=\"sheet class\">\n");
    for (number, lesson) in answered.iter().enumerate() {
        of_lesson(&mut page, &lesson.worked_out()?, collected, number == 0, &mut on_step)?;
    }
    let others = others(lessons, collected);
    if !others.is_empty() {
        page.html(&format!("<p>{}</p>\n", escaped(&others)));
    }
    page.html("</div>\n");
    Ok(page.finish())
}

/// The message that there are no answers to any of `lessons`.
fn nothing(lessons: &[&Lesson], collected: &Collected) -> String {
    let what = match lessons {
        [lesson] => format!("no answers to the lesson `{}` were found", lesson.name),
        _ => "no answers were found".to_owned(),
    };
    if let Some(unread) = collected.unread.first() {
        return format!("{what}; {unread}");
    }
    let others = others(lessons, collected);
    if others.is_empty() {
        format!("{what}: links with answers contain {KEY}=")
    } else {
        format!("{what}. {others}")
    }
}

/// The sentence on answers to other lessons than these; empty if there are none.
fn others(lessons: &[&Lesson], collected: &Collected) -> String {
    let mut counts = BTreeMap::<&str, usize>::new();
    for answers in &collected.answers {
        if !lessons.iter().any(|lesson| lesson.name == answers.lesson) {
            *counts.entry(&answers.lesson).or_default() += 1;
        }
    }
    if counts.is_empty() {
        return String::new();
    }
    let told: Vec<_> =
        counts.iter().map(|(name, count)| format!("{} ({count})", messages::excerpt(name))).collect();
    format!("Answers to other lessons: {}.", told.join(", "))
}

/// Adds the answers to `lesson`, which is worked out.
fn of_lesson(
    page: &mut HtmlPage,
    lesson: &Lesson,
    collected: &Collected,
    is_first: bool,
    on_step: &mut impl FnMut(),
) -> anyhow::Result<()> {
    let class: Vec<Pupil<'_>> =
        collected.of(&lesson.name).map(|answers| Pupil::new(answers, lesson)).collect();
    let break_before = if is_first { "" } else { " class=\"next\"" };
    page.html(&format!("<h1{break_before}>Class: {}</h1>\n", escaped(&lesson.title)));
    let judgements = judged(lesson, &class)?;
    let mut whole = Tally::default();
    for (number, judged) in judgements.iter().enumerate() {
        let records = class.iter().map(|pupil| &pupil.records[number]);
        records.zip(judged).for_each(|(record, judgement)| whole.add(record, *judgement));
    }
    page.html(&summary(&class, collected, &whole, is_first));
    for (number, judged) in judgements.iter().enumerate() {
        step(page, lesson, number, &class, judged)?;
        on_step();
    }
    pupils(page, lesson, &class, &judgements);
    Ok(())
}

/// Returns the judgement of each pupil's prediction in each step of `lesson`.
fn judged(lesson: &Lesson, class: &[Pupil<'_>]) -> anyhow::Result<Vec<Vec<Judgement>>> {
    let of_step = |(number, step): (usize, &Step)| {
        // Places alone are judged by what is seen.
        let needs_sight = matches!(step.prediction, Some(Prediction { kind: AnswerKind::Point(_), .. }));
        revealed(lesson, number, needs_sight, |sight| {
            class.iter().map(|pupil| Judgement::new(step, &pupil.records[number], sight)).collect()
        })
    };
    lesson.steps.iter().enumerate().map(of_step).collect()
}

/// Calls `get` with what is seen after the reveal of the step of this `number`, if it `needs_sight`.
fn revealed<T>(
    lesson: &Lesson,
    number: usize,
    needs_sight: bool,
    get: impl FnOnce(Option<&Sight<'_>>) -> T,
) -> anyhow::Result<T> {
    if !needs_sight {
        return Ok(get(None));
    }
    let settings = lesson.settings(number, true, &Settings::default())?;
    let got = with_sight(&settings, |sight| Some(get(Some(sight))));
    got.with_context(|| format!("{}: the scene of step {} cannot be opened", lesson.source_name, number + 1))
}

/// Returns the number of right predictions of one pupil's `answers` to `lesson`, as it was read, and that of
/// those that are right, wrong or skipped.
///
/// # Errors
/// What cannot be worked out of the lesson.
pub fn right_of(lesson: &Lesson, answers: &PupilAnswers) -> anyhow::Result<[usize; 2]> {
    let lesson = lesson.worked_out()?;
    let judgements = judged(&lesson, &[Pupil::new(answers, &lesson)])?.concat();
    let count = |meant: Judgement| judgements.iter().filter(|judgement| **judgement == meant).count();
    let right = count(Judgement::Right);
    Ok([right, right + count(Judgement::Wrong) + count(Judgement::Skipped)])
}

/// A pupil with the answers to each step.
struct Pupil<'a> {
    answers: &'a PupilAnswers,
    records: Vec<Record>,
    outdated: usize,
}

impl<'a> Pupil<'a> {
    fn new(answers: &'a PupilAnswers, lesson: &Lesson) -> Self {
        Self { answers, records: answers.records(lesson), outdated: answers.outdated(lesson) }
    }
}

/// The sentences above the questions.
fn summary(class: &[Pupil<'_>], collected: &Collected, whole: &Tally, is_first: bool) -> String {
    let mut text = format!("<p>{}", counted(class.len(), "pupil"));
    if whole.judged > 0 {
        let _ = write!(text, ". Predictions: {}", whole.text());
    } else {
        text.push('.');
    }
    text.push_str("</p>\n");
    let outdated: usize = class.iter().map(|pupil| pupil.outdated).sum();
    if outdated > 0 {
        let _ = writeln!(
            text,
            "<p>Left out: {} to questions that the lesson asks otherwise now.</p>",
            counted(outdated, "answer")
        );
    }
    if is_first {
        let Collected { unread, replaced, beyond, .. } = collected;
        if *replaced > 0 {
            let _ =
                writeln!(text, "<p>Handed in again: {replaced}. Of each pupil the last answers count.</p>");
        }
        if *beyond > 0 {
            let _ = writeln!(text, "<p>Left out, as there are too many: {}.</p>", counted(*beyond, "pupil"));
        }
        if !unread.is_empty() {
            let _ = writeln!(text, "<p>Not read: {}.</p>\n<ul>", counted(unread.len(), "link"));
            for link in unread.iter().take(MOST_NAMED) {
                let _ = writeln!(text, "<li>{}</li>", escaped(&link.to_string()));
            }
            text.push_str("</ul>\n");
        }
    }
    text.push_str(
        "<p class=\"key\">☒ marks the right answer. Bars show how sure pupils were: dark for sure, medium for fairly sure \
         or not asked, light for a guess.</p>\n",
    );
    text
}

/// Adds the questions of the step of this `number`, with how the `class` has answered and was `judged`.
fn step(
    page: &mut HtmlPage,
    lesson: &Lesson,
    number: usize,
    class: &[Pupil<'_>],
    judged: &[Judgement],
) -> anyhow::Result<()> {
    let Step { title, prediction, observation, .. } = &lesson.steps[number];
    if prediction.is_none() && observation.is_none() {
        return Ok(());
    }
    let records: Vec<&Record> = class.iter().map(|pupil| &pupil.records[number]).collect();
    page.html(&format!("<div class=\"question\">\n<h2>{}. {}</h2>\n", number + 1, escaped(title)));
    if let Some(Prediction { question, kind }) = prediction {
        page.text(&question.markdown)?;
        let needs_sight = matches!(kind, AnswerKind::Point(_) | AnswerKind::Curve(_));
        revealed(lesson, number, needs_sight, |sight| {
            distribution::predictions(page, kind, &records, sight)
        })??;
        let mut tally = Tally::default();
        records.iter().zip(judged).for_each(|(record, judgement)| tally.add(record, *judgement));
        page.html(&format!("<p>{}</p>\n", tally.text()));
    }
    page.html("</div>\n");
    if let Some(Choices { question, options }) = observation {
        page.html("<div class=\"question\">\n");
        page.text(&question.markdown)?;
        distribution::observations(page, options, &records)?;
        page.html("</div>\n");
    }
    Ok(())
}

/// Adds, on a sheet of its own, the table of the pupils by name, with the judgement of each prediction.
fn pupils(page: &mut HtmlPage, lesson: &Lesson, class: &[Pupil<'_>], judgements: &[Vec<Judgement>]) {
    let is_asked = |number: &usize| lesson.steps[*number].prediction.is_some();
    let asked: Vec<usize> = (0..lesson.steps.len()).filter(is_asked).collect();
    let mut text = "<h2 class=\"next\">Pupils</h2>\n<table class=\"pupils\">\n<tr><th>Name</th>".to_owned();
    for number in &asked {
        let _ = write!(text, "<th>{}</th>", number + 1);
    }
    text.push_str("<th>right</th></tr>\n");
    let mut rows: Vec<_> = class.iter().enumerate().collect();
    rows.sort_by_key(|(_, pupil)| (pupil.answers.name.is_empty(), pupil.answers.name.to_lowercase()));
    for (row, pupil) in rows {
        let name = if pupil.answers.name.is_empty() { "no name" } else { &pupil.answers.name };
        let _ = write!(text, "<tr><td>{}</td>", escaped(name));
        let judged: Vec<Judgement> = asked.iter().map(|number| judgements[*number][row]).collect();
        for judgement in &judged {
            let _ = write!(text, "<td>{}</td>", judgement.mark());
        }
        let right = judged.iter().filter(|judgement| **judgement == Judgement::Right).count();
        let _ = writeln!(text, "<td>{right}</td></tr>");
    }
    text.push_str(
        "</table>\n<p class=\"key\">✓ right, ✗ not right, – skipped, · a curve or raised hands.</p>\n",
    );
    page.html(&text);
}

/// Returns `count` with its noun.
fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests;
