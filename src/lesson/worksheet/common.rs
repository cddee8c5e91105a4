//! Parts that several sheets of a lesson share.

use crate::caption::decimal;
use crate::files::html::{HtmlPage, escaped};
use crate::lesson::curve_plot;
use crate::lesson::picture;
use crate::lesson::plan::{AnswerKind, CurveAnswer, Lesson, Options};
use crate::plot::{BLUE, Line};
use crate::settings::Settings;
use crate::units::Unit;

/// Adds the title after `kind` of sheet, the concept and the time it takes.
pub fn head(page: &mut HtmlPage, lesson: &Lesson, kind: &str) {
    page.html(&format!("<h1>{kind}{}</h1>\n", escaped(&lesson.title)));
    if !lesson.is_a_preset() {
        let concept = if lesson.concept.is_empty() { String::new() } else { format!("{}. ", lesson.concept) };
        page.html(&format!("<p>{}{} minutes.</p>\n", escaped(&concept), lesson.minutes));
    }
}

/// Adds room for a name and a date.
pub fn name_and_date(page: &mut HtmlPage) {
    page.html("<p class=\"name\">Name: ____________________ &emsp; Date: ____________</p>\n");
}

/// Adds the picture of `settings`, small, with the text flowing around it.
pub fn picture_beside(page: &mut HtmlPage, settings: &Settings, title: &str) -> anyhow::Result<()> {
    page.html(&format!("<figure class=\"beside\">\n{}</figure>\n", picture::figure(settings, title)?));
    Ok(())
}

/// Adds boxes to tick; that of the `right` choice is ticked.
pub fn choices(page: &mut HtmlPage, options: &Options, right: Option<usize>) -> anyhow::Result<()> {
    page.html("<div class=\"choices\">\n");
    for (number, option) in options.texts.iter().enumerate() {
        page.text_behind(if right == Some(number) { "☒" } else { "☐" }, &option.markdown)?;
    }
    page.html("</div>\n");
    Ok(())
}

/// Adds the right answer to a question of this `kind`, after the reveal in `settings`.
pub fn truth(page: &mut HtmlPage, kind: &AnswerKind, settings: &Settings) -> anyhow::Result<()> {
    match kind {
        AnswerKind::Choice(options) => choices(page, options, Some(options.right))?,
        AnswerKind::Number(number) => {
            let truth = number.truth.map_or_else(String::new, |truth| decimal(truth, number.decimals));
            page.html(&format!("<p>{truth} {}</p>\n", escaped(&number.unit)));
        }
        AnswerKind::Point(point) => {
            page.html(&format!("<p>Where the {} is seen in the picture.</p>\n", escaped(&point.body)));
        }
        AnswerKind::Curve(curve) => {
            page.html(&format!("<figure class=\"plot\">\n{}</figure>\n", plot(curve, settings, true)?));
        }
    }
    Ok(())
}

/// A plot to draw a curve into; `with_answers`, with the curve.
pub fn plot(curve: &CurveAnswer, settings: &Settings, with_answers: bool) -> anyhow::Result<String> {
    let track = settings.track(&settings.opened_scene()?);
    let range = settings.time_range(&track);
    let truth = || Line::in_pieces("true curve", BLUE, curve.over(settings, &track, range));
    Ok(curve_plot::svg(curve, range, Unit::OWN, with_answers.then(truth).into_iter().collect()))
}
