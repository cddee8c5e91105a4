//! The report of a lesson, as a page to keep or to print.

use super::answer::{Answer, Outcome, Record};
use super::class::{PupilAnswers, QrCode, link_pair};
use super::course::Course;
use super::plan::{AnswerKind, Choices, CurveAnswer, Prediction, Step};
use super::truth::Sight;
use super::verdict::{Verdict, verdict};
use super::{curve_plot, picture, sketch};
use crate::files::html::{HtmlPage, PageStyle, escaped};
use crate::formula::markdown::Markdown;
use crate::plot::{BLACK, BLUE, Dash, Line, LineStroke};
use crate::settings::{Settings, link_of_pairs};

/// Side of a module of the code, millimetres.
const MODULE: f64 = 0.6;

/// Returns the report of `course`, whose states are shown on top of `base`; with a `fit` that was made,
/// as a table. It ends with the answers as a link and a code, by the pupil called `name`, which may be empty.
///
/// # Errors
/// A state of the lesson that cannot be had, those of the renderer, and a text that cannot be drawn.
pub fn page(course: &Course, base: &Settings, fit: Option<&str>, name: &str) -> anyhow::Result<String> {
    let lesson = course.lesson();
    let mut page = HtmlPage::new(&lesson.title, PageStyle::Print);
    page.html(&format!("<h1>{}</h1>\n", escaped(&lesson.title)));
    page.text(&lesson.introduction.markdown)?;
    for (number, (told, record)) in lesson.steps.iter().zip(course.records()).enumerate() {
        page.html(&format!("<h2>{}. {}</h2>\n", number + 1, escaped(&told.title)));
        // What was not asked for is not told.
        if !course.is_done(number) {
            page.html("<p>Not done.</p>\n");
            continue;
        }
        let settings = lesson.settings(number, true, base)?;
        step(&mut page, told, record, &settings)?;
    }
    if course.place().step >= lesson.steps.len() && !lesson.sentence.is_empty() {
        page.html("<h2>In a sentence</h2>\n");
        page.text(&lesson.sentence.markdown)?;
    }
    if let Some(fit) = fit {
        page.html(&format!("<h2>Fit</h2>\n<pre>{}</pre>\n", escaped(fit)));
    }
    handed_in(&mut page, course, name);
    Ok(page.finish())
}

/// Adds the answers for the class's page, if there are any. The link has no address of a page: who reads the
/// report knows where the program is.
fn handed_in(page: &mut HtmlPage, course: &Course, name: &str) {
    let answers = PupilAnswers::new(course.lesson(), course.records(), name);
    if course.lesson().is_a_preset() || !answers.has_any() {
        return;
    }
    let link = link_of_pairs(&link_pair(&answers.token()));
    let code = QrCode::new(&link).map(|code| code.svg("QR code of the link", MODULE)).unwrap_or_default();
    page.html(&format!(
        "<div class=\"question\">\n<h2>Hand in</h2>\n<p>These answers as a link, for the class\u{2019}s page:</p>\n\
         <p><code>{link}</code></p>\n<figure>\n{code}</figure>\n</div>\n"
    ));
}

/// A step that was done, whose state after the reveal is that of `settings`.
fn step(page: &mut HtmlPage, step: &Step, record: &Record, settings: &Settings) -> anyhow::Result<()> {
    let scene = settings.opened_scene()?;
    let (track, prepared) = (settings.track(&scene), scene.prepared());
    let time = settings.time.unwrap_or_else(|| settings.time_of_approach(&track));
    let sight = Sight { settings, scene: &scene, prepared: &prepared, track, time };
    if let Some(Prediction { question, kind }) = &step.prediction {
        page.text(&question.markdown)?;
        if let Some(verdict) = verdict(step, record, &sight) {
            page.text(&Markdown::new(outcome_text(&verdict, record)))?;
        }
        if let AnswerKind::Curve(curve) = kind {
            page.html(&format!("<figure>\n{}</figure>\n", curves(curve, record, &sight)));
        }
    }
    page.html(&format!("<figure>\n{}</figure>\n", picture::figure(settings, &step.title)?));
    if let Some(reveal) = &step.reveal {
        page.text(&reveal.text.markdown)?;
    }
    if let Some(Choices { question, options }) = &step.observation {
        page.text(&question.markdown)?;
        let option = |number: usize| options.texts.get(number).map(|text| &text.markdown);
        let nothing = Markdown::new("nothing");
        page.text_behind("**Observed:**", record.observed.and_then(option).unwrap_or(&nothing))?;
        if let Some(right) = option(options.right).filter(|_| record.observed != Some(options.right)) {
            page.text_behind("**What there was to observe:**", right)?;
        }
    }
    page.text(&step.explanation.markdown)
}

/// Returns the prediction, its confidence, the truth, and whether they agree.
fn outcome_text(verdict: &Verdict, record: &Record) -> String {
    let Verdict { right, said, is } = verdict;
    let (who, sure) = match &record.outcome {
        Some(Outcome::Made { answer: Answer::Votes(_), .. }) => ("Hands raised", String::new()),
        Some(Outcome::Made { confidence: Some(sure), .. }) => ("Predicted", format!(" ({})", sure.name())),
        Some(Outcome::Made { .. }) => ("Predicted", String::new()),
        Some(Outcome::Skipped) | None => ("Predicted", " (skipped)".to_owned()),
    };
    let right = match right {
        Some(true) => " — right",
        Some(false) => " — not right",
        None => "",
    };
    format!("**{who}:** {said}{sure}{right}\n\n**It is:** {is}")
}

/// The true curve, and the one that was drawn.
fn curves(curve: &CurveAnswer, record: &Record, sight: &Sight<'_>) -> String {
    let drawn = match record.answer() {
        Some(Answer::Curve(points)) => points.as_slice(),
        _ => &[],
    };
    let [from, to] = sight.settings.time_range(&sight.track);
    let ends = [drawn.first(), drawn.last()].map(|point| point.map(|[time, _]| *time));
    let times = [ends[0].map_or(from, |first| first.min(from)), ends[1].map_or(to, |last| last.max(to))];
    let truth = curve.over(sight.settings, &sight.track, times);
    let mut lines = vec![Line::in_pieces("true curve", BLUE, truth)];
    if !drawn.is_empty() {
        let pieces = sketch::pieces(drawn, times);
        lines.push(Line::in_pieces("drawn curve", BLACK, pieces).with(LineStroke::Line(Dash::Dashed(7))));
    }
    let unit = sight.settings.window.units.measures(sight.scene).time;
    curve_plot::svg(curve, times, unit, lines)
}
