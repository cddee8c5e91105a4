//! A lesson as a page to print: the pictures, the questions, room for answers, and for whoever teaches, the answers.

use std::fmt::Write as _;

use relativity_core::{DEFAULT_REPLICATES, bootstrap, fit, math};

use super::plan::{Animated, Choices, Curve, Kind, Lesson, Options, Prediction, Reveal, Step, Text};
use super::{curve_plot, picture};
use crate::caption::decimal;
use crate::estimate::samples::samples_of;
use crate::estimate::{Estimate, estimate};
use crate::figures;
use crate::files::html::{Page, Style, answer_lines, data_uri, escaped};
use crate::plot::{BLUE, Line};
use crate::settings::Settings;
use crate::units::Unit;

/// Lines for an answer in words, and for a sentence to take away.
const LINES: [usize; 2] = [4, 2];
/// Most readings that stand in the table; of more, some.
const MOST_ROWS: usize = 40;
/// Decimals of a reading in the table.
const DIGITS: u8 = 5;

/// The worksheet of `lesson`, which is worked out; `with_answers`, for whoever teaches.
///
/// # Errors
/// Those of the renderer, and of what is fitted in the lab.
pub fn page(lesson: &Lesson, with_answers: bool) -> anyhow::Result<String> {
    let mut page = Page::new(&lesson.title, Style::Print);
    page.html(&format!("<h1>{}</h1>\n", escaped(&lesson.title)));
    if !lesson.is_a_preset() {
        let concept = if lesson.concept.is_empty() { String::new() } else { format!("{}. ", lesson.concept) };
        page.html(&format!("<p>{}{} minutes.</p>\n", escaped(&concept), lesson.minutes));
    }
    if !with_answers {
        page.html("<p>Name: ____________________ &emsp; Date: ____________</p>\n");
    }
    if !lesson.is_a_preset() {
        page.text(&lesson.introduction.markdown)?;
    }
    for number in 0..lesson.steps.len() {
        step(&mut page, lesson, number, with_answers)?;
    }
    if !lesson.sentence.is_empty() {
        page.html("<h2>In a sentence</h2>\n");
        if with_answers {
            page.text(&lesson.sentence.markdown)?;
        } else {
            page.html(&answer_lines(LINES[1]));
        }
    }
    if let Some(done) = &lesson.lab {
        lab(&mut page, lesson, &done.text, with_answers)?;
    }
    Ok(page.finish())
}

/// What is measured by hand: the picture of its state, if it has one of its own; and where it says how readings are taken,
/// these, as a table and as a file to be taken from the page, and how well they can tell.
fn lab(page: &mut Page, lesson: &Lesson, task: &Text, with_answers: bool) -> anyhow::Result<()> {
    let settings = lesson.lab_settings(&Settings::default())?;
    page.html("<h2>Lab</h2>\n");
    page.text(&task.markdown)?;
    if settings.fit == Settings::default().fit {
        if lesson.lab.as_ref().is_some_and(|lab| lab.state.is_some()) {
            page.html(&format!("<figure>\n{}</figure>\n", picture::figure(&settings, "Lab")?));
        }
    } else {
        readings(page, lesson, &settings, with_answers)?;
    }
    if !with_answers {
        page.html(&answer_lines(LINES[0]));
    }
    Ok(())
}

/// Readings of both eyes, and what a fit of them tells.
fn readings(page: &mut Page, lesson: &Lesson, settings: &Settings, with_answers: bool) -> anyhow::Result<()> {
    let taken = samples_of(settings, &settings.opened_scene()?).map_err(anyhow::Error::msg)?;
    let csv = taken.csv();
    page.html(&data(lesson, &csv));
    let found = fit(&taken.fittable.observations, &taken.fittable.options)?;
    let spread = bootstrap(&found, DEFAULT_REPLICATES, settings.fit.seed)?;
    let mut expected = String::new();
    for parameter in found.parameters() {
        let Estimate { value, uncertainty, .. } = estimate(&found, Some(&spread), *parameter);
        let decimals = (1.0 - math::log10(uncertainty).floor()).clamp(0.0, 9.0) as u8;
        let [value, uncertainty] = [value, uncertainty].map(|value| decimal(value, decimals));
        let truth = decimal(taken.true_value(*parameter), decimals);
        let name = parameter.name();
        if with_answers {
            writeln!(expected, "<li>{name} = {value} ± {uncertainty}; it is {truth}</li>")?;
        } else {
            writeln!(expected, "<li>{name} ± {uncertainty}</li>")?;
        }
    }
    let command = escaped(&taken.fittable.command(&format!("{}.csv", lesson.name)));
    page.html(&format!(
        "<p>A fit of these readings, <code>{command}</code>, tells, with its standard errors:</p>\n<ul>\n{expected}</ul>\n"
    ));
    Ok(())
}

/// The rows of `csv` as a table in columns side by side, and the file itself.
fn data(lesson: &Lesson, csv: &str) -> String {
    let cell =
        |field: &str| field.parse::<f64>().map_or_else(|_| field.to_owned(), |value| decimal(value, DIGITS));
    let row = |line: &str, tag: &str| {
        let cells = line.split(',').map(cell).collect::<Vec<_>>().join(&format!("</{tag}><{tag}>"));
        format!("<tr><{tag}>{cells}</{tag}></tr>\n")
    };
    let mut lines = csv.lines();
    let head = row(lines.next().unwrap_or_default(), "th");
    let count = csv.lines().count() - 1;
    let rows: String = lines.step_by(count.div_ceil(MOST_ROWS)).map(|line| row(line, "td")).collect();
    let (name, file) = (escaped(&lesson.name), data_uri("text/csv", csv.as_bytes()));
    format!(
        "<table>\n{head}{rows}</table>\n<p>All {count} readings as a file: <a download=\"{name}.csv\" href=\"{file}\">{name}.csv</a>. \
         Angles are in radians, lengths and times in one unit.</p>\n"
    )
}

fn step(page: &mut Page, lesson: &Lesson, number: usize, with_answers: bool) -> anyhow::Result<()> {
    let Step { title, text: said, prediction, reveal, observation, explanation, .. } = &lesson.steps[number];
    let settings = |is_revealed| lesson.settings(number, is_revealed, &Settings::default());
    page.html(&format!("<h2>{}. {}</h2>\n", number + 1, escaped(title)));
    page.text(&said.markdown)?;
    let shown = settings(false)?;
    page.html(&format!("<figure>\n{}</figure>\n", picture::figure(&shown, title)?));
    if let Some(Prediction { question, kind }) = prediction {
        page.html("<div class=\"question\">\n<h3>Predict</h3>\n");
        page.text(&question.markdown)?;
        ask(page, kind, &shown, with_answers)?;
        page.html("<p>How sure are you? &emsp; 1 &ensp; 2 &ensp; 3 &ensp; 4 &ensp; 5</p>\n</div>\n");
    }
    if let Some(reveal) = reveal {
        page.html("<h3>See</h3>\n");
        page.html(&format!("<p>{}</p>\n", escaped(&what_happens(reveal))));
        page.text(&reveal.text.markdown)?;
        if with_answers {
            page.html(&format!("<figure>\n{}</figure>\n", picture::figure(&settings(true)?, title)?));
        }
    }
    if let Some(Choices { question, options }) = observation {
        page.html("<div class=\"question\">\n");
        page.text(&question.markdown)?;
        choices(page, options, with_answers)?;
        page.html("</div>\n");
    }
    if !explanation.is_empty() {
        page.html("<h3>Explain</h3>\n");
        if with_answers {
            page.text(&explanation.markdown)?;
        } else {
            page.html(&answer_lines(LINES[0]));
        }
    }
    Ok(())
}

/// What a reveal does, in a sentence.
fn what_happens(reveal: &Reveal) -> String {
    match reveal.animation.map(|animation| animation.to) {
        Some(Animated::Time(time)) => format!("Let T run to {}.", decimal(time, 2)),
        Some(Animated::Speed(speed)) => {
            format!("Let the speed run to {} c.", figures::beta(&speed.speed()))
        }
        None => "Have it revealed in the window.".to_owned(),
    }
}

fn ask(page: &mut Page, kind: &Kind, settings: &Settings, with_answers: bool) -> anyhow::Result<()> {
    match kind {
        Kind::Choice(options) => choices(page, options, with_answers)?,
        Kind::Number(number) => {
            let truth = number.truth.filter(|_| with_answers);
            let answer = truth.map_or("____________".to_owned(), |truth| decimal(truth, number.decimals));
            page.html(&format!("<p>{answer} {}</p>\n", escaped(&number.unit)));
        }
        Kind::Point(point) if with_answers => {
            page.html(&format!("<p>Where the {} is seen below.</p>\n", escaped(&point.body)));
        }
        Kind::Point(_) => page.html("<p>Mark the place with a cross in the left picture.</p>\n"),
        Kind::Curve(curve) => {
            page.html(&format!("<figure>\n{}</figure>\n", plot(curve, settings, with_answers)?));
        }
    }
    Ok(())
}

fn choices(page: &mut Page, options: &Options, with_answers: bool) -> anyhow::Result<()> {
    let mut list = String::new();
    for (number, option) in options.texts.iter().enumerate() {
        let mark = if with_answers && number == options.right { '☒' } else { '☐' };
        writeln!(list, "{mark} {}\n", option.markdown)?;
    }
    page.text(&list)
}

/// A plot to draw a curve into; `with_answers`, with the curve.
fn plot(curve: &Curve, settings: &Settings, with_answers: bool) -> anyhow::Result<String> {
    let track = settings.track(&settings.opened_scene()?);
    let range = settings.time_range(&track);
    let pieces = if with_answers { curve.quantity.over(settings, &track, range) } else { Vec::new() };
    Ok(curve_plot::svg(curve, range, Unit::OWN, vec![Line::in_pieces("", BLUE, pieces)]))
}
