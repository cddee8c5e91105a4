//! The score of a course: the number of right predictions, and how far off the others were.

use super::answer::{Answer, Outcome};
use super::course::Course;
use super::plan::AnswerKind;
use super::truth::Sight;
use super::verdict::{difference, verdict};
use crate::settings::Settings;

/// Summary of a lesson's predictions.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Score {
    /// Number of choices, numbers and places that were predicted, and of predictions that were skipped.
    pub asked: usize,
    /// Number of right predictions among these.
    pub right: usize,
    /// Number of predictions that were skipped.
    pub skipped: usize,
    /// Remarks, a sentence each, on predictions for which right or wrong is not enough: curves, clicked
    /// places, votes.
    pub others: Vec<String>,
}

impl Course {
    /// Sums up the predictions so far; each step's state falls back on `base`. Drawn curves and counted votes
    /// are neither right nor wrong.
    #[must_use]
    pub fn score(&self, base: &Settings) -> Score {
        let mut score = Score::default();
        for (number, (step, record)) in self.lesson().steps.iter().zip(self.records()).enumerate() {
            let Some((prediction, outcome)) = step.prediction.as_ref().zip(record.outcome.as_ref()) else {
                continue;
            };
            let Outcome::Made { answer, .. } = outcome else {
                score.asked += 1;
                score.skipped += 1;
                continue;
            };
            let mut right = answer.is_right(&prediction.kind);
            let other = match (&prediction.kind, answer) {
                (AnswerKind::Choice(options), Answer::Votes(votes)) => {
                    let all: u32 = votes.iter().fold(0, |sum, votes| sum.saturating_add(*votes));
                    let count = votes.get(options.right).copied().unwrap_or(0);
                    Some(format!("{count} of {all} hands were right"))
                }
                (AnswerKind::Point(point), Answer::Direction(direction)) => {
                    let settings = self.lesson().settings(number, true, base);
                    let found = settings.ok().and_then(|settings| {
                        with_sight(&settings, |sight| {
                            let right = verdict(step, record, sight)?.right;
                            Some((right, sight.degrees_to(*direction, &point.body)?))
                        })
                    });
                    right = found.as_ref().and_then(|(right, _)| *right);
                    found.map(|(_, off)| format!("the place was {off} away"))
                }
                (AnswerKind::Curve(curve), Answer::Curve(points)) => {
                    let settings = self.lesson().settings(number, true, base);
                    let off = settings
                        .ok()
                        .and_then(|settings| with_sight(&settings, |sight| difference(curve, points, sight)));
                    Some(format!(
                        "a curve was drawn{}",
                        off.map(|off| format!(", {off}")).unwrap_or_default()
                    ))
                }
                _ => None,
            };
            if let Some(right) = right {
                score.asked += 1;
                score.right += usize::from(right);
            }
            score.others.extend(other.map(|other| format!("Step {}: {other}.", number + 1)));
        }
        score
    }
}

/// Calls `get` with what is shown of `settings`; `None` where they cannot be shown.
pub(super) fn with_sight<T>(settings: &Settings, get: impl FnOnce(&Sight<'_>) -> Option<T>) -> Option<T> {
    let scene = settings.opened_scene().ok()?;
    let (track, prepared) = (settings.track(&scene), scene.prepared());
    let time = settings.time.unwrap_or_else(|| settings.time_of_approach(&track));
    get(&Sight { settings, scene: &scene, prepared: &prepared, track, time })
}
