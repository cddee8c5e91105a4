//! The lab of a lesson on paper: its task, its picture, or the readings that are taken in it.

use std::fmt::Write as _;

use relativity_core::{DEFAULT_REPLICATES, bootstrap, fit, math};

use super::common::{head, name_and_date};
use crate::caption::decimal;
use crate::estimate::samples::{SamplesWithTruth, samples_of};
use crate::estimate::{Estimate, estimate};
use crate::files::html::{HtmlPage, answer_lines, data_uri, escaped};
use crate::lesson::error::LessonError;
use crate::lesson::picture;
use crate::lesson::plan::{Lab, Lesson};
use crate::settings::Settings;

/// Lines for what was found.
const LINES: usize = 6;
/// At most this many readings stand in the table; longer series are strided.
const MOST_ROWS: usize = 24;
/// Decimals of a reading in the table.
const DIGITS: u8 = 5;

/// Adds the sheet of `lab`.
pub fn write(page: &mut HtmlPage, lesson: &Lesson, lab: &Lab) -> anyhow::Result<()> {
    let settings = lesson.lab_settings(&Settings::default())?;
    name_and_date(page);
    head(page, lesson, "Lab: ");
    page.text(&lab.text.markdown)?;
    if has_readings(&settings) {
        let wrong = |problem: anyhow::Error| wrong(lesson, lab, &problem);
        let taken = taken(&settings).map_err(wrong)?;
        page.html(&data(lesson, &taken.csv()));
        page.html(&results(lesson, &settings, &taken, false).map_err(wrong)?);
    } else if lab.state.is_some() {
        page.html(&format!("<figure>\n{}</figure>\n", picture::figure(&settings, "Lab")?));
    }
    page.html(&answer_lines(LINES));
    Ok(())
}

/// Adds what should be found in `lab`, for whoever teaches.
pub fn answers(page: &mut HtmlPage, lesson: &Lesson, lab: &Lab) -> anyhow::Result<()> {
    let settings = lesson.lab_settings(&Settings::default())?;
    page.html("<h2>Lab</h2>\n");
    page.text(&lab.text.markdown)?;
    if has_readings(&settings) {
        let results = taken(&settings).and_then(|taken| results(lesson, &settings, &taken, true));
        page.html(&results.map_err(|problem| wrong(lesson, lab, &problem))?);
    }
    Ok(())
}

/// The `problem` of the readings of `lab`, in the line of the file in which its state begins.
fn wrong(lesson: &Lesson, lab: &Lab, problem: &anyhow::Error) -> LessonError {
    lesson.wrong(lab.state.as_ref().map_or(1, |state| state.line), format!("the lab: {problem:#}"))
}

/// Returns whether the lab's state sets how readings are taken.
fn has_readings(settings: &Settings) -> bool {
    settings.fit != Settings::default().fit
}

fn taken(settings: &Settings) -> anyhow::Result<SamplesWithTruth> {
    samples_of(settings, &settings.opened_scene()?).map_err(anyhow::Error::msg)
}

/// Returns the expected result of a fit of the readings: standard errors, and `with_answers` the values
/// beside the true ones.
fn results(
    lesson: &Lesson,
    settings: &Settings,
    taken: &SamplesWithTruth,
    with_answers: bool,
) -> anyhow::Result<String> {
    let found = fit(&taken.fittable.observations, &taken.fittable.options)?;
    let spread = bootstrap(&found, DEFAULT_REPLICATES, settings.fit.seed)?;
    let mut expected = String::new();
    for parameter in found.parameters() {
        let Estimate { value, scatter: uncertainty, .. } = estimate(&found, Some(&spread), *parameter);
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
    Ok(format!(
        "<p>A fit of these readings, <code>{command}</code>, tells, with its standard errors:</p>\n<ul>\n{expected}</ul>\n"
    ))
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
