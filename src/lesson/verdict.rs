//! Verdicts: the answer of a step and the truth, in words, for every place that shows them.

use relativity_render::Gaze;

use super::answer::{Answer, Record};
use super::plan::{AnswerKind, CurveAnswer, Number, Options, Step};
use super::seen_place as place;
use super::truth::{NEAR, Sight, angle_between, rms};
use crate::caption::decimal;
use crate::number_text;
use crate::settings::Settings;
use crate::units::Measures;

/// The verdict on a prediction. The texts are Markdown, without a full stop at the end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    /// Whether the prediction is right; `None` for curves and raised hands.
    pub right: Option<bool>,
    /// Answer that was given.
    pub said: String,
    /// True answer.
    pub is: String,
}

/// Returns the verdict on the prediction of `step` in its `record`, by what is shown after its reveal; `None`
/// before that was opened, and where nothing is predicted.
#[must_use]
pub fn verdict(step: &Step, record: &Record, sight: &Sight<'_>) -> Option<Verdict> {
    let kind = &step.prediction.as_ref()?.kind;
    record.outcome.as_ref()?;
    let answer = record.answer();
    let said = answer.map_or_else(|| "nothing".to_owned(), |answer| said(kind, answer, sight.settings));
    let right = answer.and_then(|answer| match (kind, answer) {
        (AnswerKind::Point(point), Answer::Direction(direction)) => {
            let seen = sight.direction(&point.body)?;
            Some(angle_between(*direction, seen) <= NEAR || sight.is_on(*direction, &point.body))
        }
        _ => answer.is_right(kind),
    });
    let is = match kind {
        AnswerKind::Choice(options) => option(options, options.right),
        AnswerKind::Number(number) => {
            number.truth.map_or_else(|| number_text::NONE.to_owned(), |it| number.text(it))
        }
        AnswerKind::Point(point) => match (answer, sight.direction(&point.body)) {
            (Some(Answer::Direction(direction)), Some(seen)) => {
                format!("{}, {}", place::at(sight.settings, seen, "ring"), place::from(*direction, seen))
            }
            (_, Some(seen)) => place::at(sight.settings, seen, "ring"),
            (_, None) => format!("nowhere: the {} is out of sight", point.body),
        },
        AnswerKind::Curve(curve) => {
            let off = match answer {
                Some(Answer::Curve(points)) => difference(curve, points, sight),
                _ => None,
            };
            ["the solid curve".to_owned()].into_iter().chain(off).collect::<Vec<_>>().join("; ")
        }
    };
    Some(Verdict { right, said, is })
}

fn said(kind: &AnswerKind, answer: &Answer, settings: &Settings) -> String {
    match (kind, answer) {
        (AnswerKind::Choice(options), Answer::Choice(choice)) => option(options, *choice),
        (AnswerKind::Choice(options), Answer::Votes(votes)) => {
            let of = |(number, votes)| format!("{votes} × {}", option(options, number));
            votes.iter().enumerate().map(of).collect::<Vec<_>>().join(", ")
        }
        (AnswerKind::Number(asked), Answer::Number(number)) => asked.text(*number),
        (_, Answer::Direction(direction)) => place::at(settings, *direction, "cross"),
        (_, Answer::Curve(_)) => "the dashed curve".to_owned(),
        _ => "nothing".to_owned(),
    }
}

fn option(options: &Options, number: usize) -> String {
    options.texts.get(number).map(|text| text.markdown.source().to_owned()).unwrap_or_default()
}

impl Sight<'_> {
    /// The angle between `direction` and where the left eye sees `body`, in degrees with its sign.
    #[must_use]
    pub fn degrees_to(&self, direction: Gaze, body: &str) -> Option<String> {
        Some(number_text::degrees(angle_between(direction, self.direction(body)?)))
    }
}

impl Number {
    /// Writes `number` with the decimals and the unit of the question.
    #[must_use]
    pub fn text(&self, number: f64) -> String {
        let number = decimal(number, self.decimals);
        if self.unit.is_empty() { number } else { format!("{number} {}", self.unit) }
    }
}

/// Describes the difference of the drawn `points` from the true `curve`, and the range of T; `None` where the
/// curve does not exist.
#[must_use]
pub fn difference(curve: &CurveAnswer, points: &[[f64; 2]], sight: &Sight<'_>) -> Option<String> {
    let ([first, ..], [.., last]) = (points, points) else { return None };
    let off = rms(points, |time| curve.at(sight.settings, &sight.track, time))?;
    let unit = curve.quantity.unit(&Measures::OWN).suffix();
    let time = sight.settings.window.units.measures(sight.scene).time;
    let [from, to] = [first, last].map(|[at, _]| time.number(*at, 1));
    let off = number_text::with_minus(&number_text::significant(off, 2));
    Some(format!("rms difference {off}{unit} over T = {from} to {to}{}", time.suffix()))
}
