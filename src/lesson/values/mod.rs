//! The values that lessons quote: each has a name, and is computed by the program for the state of a step, so
//! that no number in a text is typed.
//!
//! A text asks for one as `{NAME:.2}` (two decimals), `{NAME of BODY:.2}` or `{NAME at T:.2}`. Without a body
//! it is that of the selected point, without a T that of the state.

mod ends;
mod fits;
mod fitted;
mod here;
mod light;
mod optics;
mod pairs;
mod places;
mod riding;
mod rolling;

use gamow_platform::messages;

use self::fitted::CachedFit;
use self::here::{Here, Value};
use super::error::LessonError;
use super::plan::{AnswerKind, Choices, Lesson, Prediction, StateBlock, Text};
use crate::formula::markdown::Markdown;
use crate::scene::{Scene, Track};
use crate::settings::Settings;
use crate::similar::nearest;

/// Returns every value, in the order of the documentation.
pub fn all() -> impl Iterator<Item = &'static Value> {
    [
        optics::VALUES,
        light::VALUES,
        pairs::VALUES,
        ends::VALUES,
        rolling::VALUES,
        riding::VALUES,
        fits::VALUES,
    ]
    .into_iter()
    .flatten()
}

/// A value as a text asks for it.
#[derive(Debug, PartialEq)]
struct ValueRequest<'a> {
    name: &'a str,
    body: Option<&'a str>,
    time: Option<f64>,
}

impl<'a> ValueRequest<'a> {
    /// Parses a request: `NAME`, `NAME of BODY`, `NAME at T`, or both.
    fn parse(text: &'a str) -> Result<Self, String> {
        let (rest, time) = match text.rsplit_once(" at ") {
            Some((rest, time)) => {
                let number = time.trim().parse::<f64>().ok().filter(|time| time.is_finite());
                (
                    rest,
                    Some(number.ok_or_else(|| format!("at {}: must be a number", messages::excerpt(time)))?),
                )
            }
            None => (text, None),
        };
        let (name, body) = match rest.split_once(" of ") {
            Some((name, body)) => (name, Some(body.trim())),
            None => (rest, None),
        };
        Ok(Self { name: name.trim(), body, time })
    }

    fn value(&self) -> Result<&'static Value, String> {
        all().find(|value| value.name == self.name).ok_or_else(|| {
            format!(
                "no value is called `{}`: there are {}; the nearest are {}; `assets/lessons/README.md` lists all",
                messages::excerpt(self.name),
                all().count(),
                nearest(all().map(|value| value.name), self.name)
            )
        })
    }
}

/// Whether `text` asks for a value that there is.
///
/// # Errors
/// What is wrong, and which there are.
pub fn check(text: &str) -> Result<(), String> {
    ValueRequest::parse(text)?.value().map(|_| ())
}

/// Returns the value that `text` requests, in `scene` with `settings`.
///
/// # Errors
/// Why there is none.
pub fn value(text: &str, settings: &Settings, scene: &Scene) -> Result<f64, String> {
    value_with(text, settings, scene, &CachedFit::new())
}

/// Returns the value of `text` with a `fit` of the state, which is made at most once.
fn value_with(text: &str, settings: &Settings, scene: &Scene, fit: &CachedFit) -> Result<f64, String> {
    let asked = ValueRequest::parse(text)?;
    let value = asked.value()?;
    let own = || {
        let track = settings.track(scene);
        Ok((track, scene.body_at(track.rest)))
    };
    let (track, body) = asked.body.map_or_else(own, |name| followed(scene, name))?;
    let time = asked.time.or(settings.time).unwrap_or_else(|| settings.time_of_approach(&track));
    let here = Here { settings, scene, track, body, time, fit };
    let worked_out = (value.work_out)(&here).filter(|value| value.is_finite());
    worked_out.ok_or_else(|| format!("`{}` does not exist in this state", messages::excerpt(text)))
}

/// The point that is followed on the body called `name`, and the number of that.
fn followed(scene: &Scene, name: &str) -> Result<(Track, Option<usize>), String> {
    let body = scene.body_called(name)?;
    let track = scene.track_on(body).ok_or_else(|| format!("`{name}` has no point to follow"))?;
    Ok((track, Some(body)))
}

impl Lesson {
    /// Returns the lesson with all values in their places, and with the truth of every number that is
    /// predicted.
    ///
    /// # Errors
    /// A setting, a scene or a value that cannot be had, with its line.
    pub fn worked_out(&self) -> Result<Self, LessonError> {
        let mut lesson = self.clone();
        let default = Settings::default();
        lesson.introduction = self.filled(&self.introduction, &self.state(0, false, &default)?)?;
        for (number, step) in lesson.steps.iter_mut().enumerate() {
            let [before, after] = [self.state(number, false, &default)?, self.state(number, true, &default)?];
            step.text = self.filled(&step.text, &before)?;
            if let Some(Prediction { question, kind }) = &mut step.prediction {
                *question = self.filled(question, &before)?;
                match kind {
                    AnswerKind::Choice(options) => self.fill_all(&mut options.texts, &before)?,
                    AnswerKind::Number(number) => {
                        let truth = value(&number.value, &after.0, &after.1);
                        number.truth = Some(truth.map_err(|problem| self.wrong(number.line, problem))?);
                    }
                    AnswerKind::Point(point) => {
                        let body = after.1.body_called(&point.body);
                        body.map_err(|problem| self.wrong(point.line, problem))?;
                    }
                    AnswerKind::Curve(_) => {}
                }
            }
            if let Some(reveal) = &mut step.reveal {
                reveal.text = self.filled(&reveal.text, &after)?;
            }
            if let Some(Choices { question, options }) = &mut step.observation {
                *question = self.filled(question, &after)?;
                self.fill_all(&mut options.texts, &after)?;
            }
            step.explanation = self.filled(&step.explanation, &after)?;
            step.teaching = self.filled(&step.teaching, &after)?;
        }
        let last = self.state(self.steps.len().saturating_sub(1), true, &default)?;
        lesson.sentence = self.filled(&self.sentence, &last)?;
        if let Some(lab) = &mut lesson.lab {
            let settings = self.lab_settings(&default)?;
            let last = self.state_blocks_until(self.steps.len().saturating_sub(1), true);
            let scene = self.scene(&settings, lab.state.iter().chain(last))?;
            lab.text = self.filled(&lab.text, &(settings, scene))?;
        }
        Ok(lesson)
    }

    fn state(
        &self,
        step: usize,
        is_revealed: bool,
        base: &Settings,
    ) -> Result<(Settings, Scene), LessonError> {
        let settings = self.settings(step, is_revealed, base)?;
        let scene = self.scene(&settings, self.state_blocks_until(step, is_revealed))?;
        Ok((settings, scene))
    }

    /// Returns all settings given up to the step of this number, after its reveal if it `is_revealed`, last
    /// first.
    fn state_blocks_until(&self, step: usize, is_revealed: bool) -> impl Iterator<Item = &StateBlock> {
        let passed = self.steps.iter().enumerate().take(step + 1);
        let told = passed.flat_map(move |(number, passed)| {
            let reveal = passed.reveal.as_ref().filter(|_| number < step || is_revealed);
            [passed.state.as_ref(), reveal.and_then(|reveal| reveal.state.as_ref())]
        });
        told.flatten().collect::<Vec<_>>().into_iter().rev()
    }

    /// Returns the scene of `settings`, which the first of those in `told` that names one has chosen.
    fn scene<'a>(
        &self,
        settings: &Settings,
        mut told: impl Iterator<Item = &'a StateBlock>,
    ) -> Result<Scene, LessonError> {
        settings.opened_scene().map_err(|error| {
            let line = told.find_map(|told| told.line_of("scene")).unwrap_or(1);
            self.wrong(line, error.to_string())
        })
    }

    fn fill_all(&self, texts: &mut [Text], state: &(Settings, Scene)) -> Result<(), LessonError> {
        for text in texts {
            *text = self.filled(text, state)?;
        }
        Ok(())
    }

    /// `text` with its values in their places, as they are in this state.
    fn filled(&self, text: &Text, (settings, scene): &(Settings, Scene)) -> Result<Text, LessonError> {
        let fit = CachedFit::new();
        let source = places::filled(text.markdown.source(), |asked| value_with(asked, settings, scene, &fit));
        let is_value = |asked: &str| check(asked).is_ok();
        let markdown = source.and_then(|source| places::checked(Markdown::new(source), is_value));
        let markdown = markdown.map_err(|(line, problem)| self.wrong(text.line + line, problem))?;
        Ok(Text { markdown, line: text.line })
    }
}

#[cfg(test)]
mod tests;
