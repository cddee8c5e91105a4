//! The answers of a class to one question, as a part of a page.

use std::fmt::Write as _;

use relativity_core::math::{cos, sin};
use relativity_render::Gaze;

use super::number_strip;
use super::tally::Chosen;
use crate::files::html::{HtmlPage, escaped};
use crate::lesson::answer::{Answer, Record};
use crate::lesson::plan::{AnswerKind, CurveAnswer, Options, PointAt};
use crate::lesson::truth::{NEAR, Sight};
use crate::lesson::{curve_plot, sketch};
use crate::plot::{self, BLACK, BLUE, Line, Panel};

/// Width of the longest bar, and height of all, pixels.
const BAR: [f64; 2] = [180.0, 13.0];
/// Opacity of a bar's parts: sure, fairly sure, a guess, not given.
const OPACITIES: [f64; Chosen::PARTS] = [1.0, 0.6, 0.3, 0.6];
/// Colour of drawn curves: light, as there are many.
const GREY: &str = "#8c8c8c";

/// Adds the predictions in `records` of a question of this `kind`, as seen after the reveal in `sight`.
pub(super) fn predictions(
    page: &mut HtmlPage,
    kind: &AnswerKind,
    records: &[&Record],
    sight: Option<&Sight<'_>>,
) -> anyhow::Result<()> {
    let answers = || records.iter().filter_map(|record| record.answer());
    match (kind, sight) {
        (AnswerKind::Choice(options), _) => {
            let mut chosen = Chosen::new(options.texts.len());
            for record in records {
                chosen.add_prediction(record);
            }
            choices(page, options, &chosen)?;
        }
        (AnswerKind::Number(asked), _) => {
            let number =
                |answer: &Answer| if let Answer::Number(number) = answer { Some(*number) } else { None };
            let numbers: Vec<f64> = answers().filter_map(number).collect();
            let (svg, beyond) = number_strip::svg(asked, &numbers);
            figure(page, &svg);
            if !beyond.is_empty() {
                page.html(&format!("<p>{}</p>\n", escaped(&beyond)));
            }
        }
        (AnswerKind::Point(point), Some(sight)) => {
            let direction =
                |answer: &Answer| if let Answer::Direction(gaze) = answer { Some(*gaze) } else { None };
            let clicked: Vec<Gaze> = answers().filter_map(direction).collect();
            if let Some(svg) = places(point, &clicked, sight) {
                figure(page, &svg);
            }
        }
        (AnswerKind::Curve(curve), Some(sight)) => {
            let drawn = answers().filter_map(|answer| {
                if let Answer::Curve(points) = answer { Some(points.as_slice()) } else { None }
            });
            figure(page, &curves(curve, drawn, sight));
        }
        (AnswerKind::Point(_) | AnswerKind::Curve(_), None) => {}
    }
    Ok(())
}

/// Adds the answers in `records` to the question of what was seen, which has these `options`.
pub(super) fn observations(
    page: &mut HtmlPage,
    options: &Options,
    records: &[&Record],
) -> anyhow::Result<()> {
    let mut chosen = Chosen::new(options.texts.len());
    records.iter().filter_map(|record| record.observed).for_each(|choice| chosen.add_observation(choice));
    choices(page, options, &chosen)
}

fn figure(page: &mut HtmlPage, svg: &str) {
    page.html(&format!("<figure class=\"plot\">\n{svg}</figure>\n"));
}

/// Adds a bar for each of `options`; the right one is ticked.
fn choices(page: &mut HtmlPage, options: &Options, chosen: &Chosen) -> anyhow::Result<()> {
    page.html("<table class=\"distribution\">\n");
    let all = chosen.all();
    for (number, (text, parts)) in options.texts.iter().zip(chosen.parts()).enumerate() {
        let is_right = number == options.right;
        page.html(&format!("<tr><td>{}</td><td>", if is_right { "☒" } else { "☐" }));
        page.text(&text.markdown)?;
        let count = chosen.count(number);
        let bar = bar(parts, all, if is_right { BLUE } else { BLACK });
        page.html(&format!("</td><td>{bar}</td><td class=\"count\">{count}</td></tr>\n"));
    }
    page.html("</table>\n");
    Ok(())
}

/// A bar of `parts` of `all`, which together are as long as a bar can be.
fn bar(parts: &[usize; Chosen::PARTS], all: usize, colour: &str) -> String {
    let [width, height] = BAR;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" aria-hidden=\"true\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">\
         <path d=\"M0 {height}H{width}\" stroke=\"#bbb\"/>"
    );
    let mut left = 0.0;
    for (part, opacity) in parts.iter().zip(OPACITIES).filter(|(part, _)| **part > 0) {
        let long = width * *part as f64 / all.max(1) as f64;
        let _ = write!(
            svg,
            "<rect x=\"{left:.1}\" width=\"{long:.1}\" height=\"{height}\" fill=\"{colour}\" fill-opacity=\"{opacity}\" stroke=\"white\" stroke-width=\"0.5\"/>"
        );
        left += long;
    }
    svg + "</svg>"
}

/// The clicked places around the one where the body is seen, in degrees; `None` where it is out of sight.
fn places(point: &PointAt, clicked: &[Gaze], sight: &Sight<'_>) -> Option<String> {
    let seen = sight.direction(&point.body)?;
    let offset = |gaze: &Gaze| {
        let turn = std::f64::consts::TAU;
        let right = seen.azimuth - gaze.azimuth;
        let right = right - turn * (right / turn).round();
        [right * cos(seen.elevation), gaze.elevation - seen.elevation].map(f64::to_degrees)
    };
    let offsets: Vec<[f64; 2]> = clicked.iter().map(offset).collect();
    let farthest = offsets.iter().flatten().fold(2.0 * NEAR.to_degrees(), |most, part| most.max(part.abs()));
    let arm = 0.012 * farthest;
    let cross = |[x, y]: &[f64; 2]| {
        [[1.0, 1.0], [1.0, -1.0]].map(|[a, b]| vec![[x - a * arm, y - b * arm], [x + a * arm, y + b * arm]])
    };
    let ring = (0..=48).map(|part| {
        let angle = std::f64::consts::TAU * f64::from(part) / 48.0;
        [cos(angle), sin(angle)].map(|side| NEAR.to_degrees() * side)
    });
    let lines = vec![
        Line::in_pieces("a pupil’s place", BLACK, offsets.iter().flat_map(cross).collect()),
        Line::solid(format!("2° around where the {} is seen", point.body), BLUE, ring.collect()),
    ];
    let labels = ["degrees further right", "degrees higher"];
    let [width, height] = [640.0, 300.0];
    let panel = Panel { equal_scales: true, width, height, ..Panel::new("", labels, lines) };
    Some(plot::svg(&[panel]))
}

/// The `drawn` curves on top of each other, below the true one.
fn curves<'a>(curve: &CurveAnswer, drawn: impl Iterator<Item = &'a [[f64; 2]]>, sight: &Sight<'_>) -> String {
    let times = sight.settings.time_range(&sight.track);
    let pieces: Vec<_> = drawn.flat_map(|points| sketch::pieces(points, times)).collect();
    let truth = curve.over(sight.settings, &sight.track, times);
    let lines =
        vec![Line::in_pieces("drawn curves", GREY, pieces), Line::in_pieces("true curve", BLUE, truth)];
    let unit = sight.settings.window.units.measures(sight.scene).time;
    curve_plot::svg(curve, times, unit, lines)
}
