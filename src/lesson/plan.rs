//! What a lesson consists of.

use std::path::PathBuf;

use super::error::LessonError;
use crate::flags::SpeedSetting;
use crate::flags::choices::Layout;
use crate::settings::{Preset, Settings};

/// A text in Markdown, with formulas in TeX, and where it begins in its file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Text {
    /// The Markdown; before a lesson is worked out, with places for values such as `{gain:.2}`.
    pub markdown: String,
    /// Its first line in the file, from 1.
    pub line: usize,
}

impl Text {
    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.markdown.is_empty()
    }
}

/// Settings that differ, as TOML, and the line in the file at which that begins.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Told {
    /// The TOML.
    pub toml: String,
    /// Its first line in the file, from 1.
    pub line: usize,
}

impl Told {
    /// The line of the file in which it gives `key`, if it does.
    #[must_use]
    pub fn line_of(&self, key: &str) -> Option<usize> {
        Some(self.line + line_giving(key, &self.toml)?)
    }
}

/// The line, from 0, in which `toml` gives `key`, if it does.
pub(super) fn line_giving(key: &str, toml: &str) -> Option<usize> {
    toml.lines().position(|line| {
        line.trim_start().strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='))
    })
}

/// A lesson.
#[derive(Debug, Clone, PartialEq)]
pub struct Lesson {
    /// Its name on the command line: that of its file without the ending.
    pub name: String,
    /// What errors call its file.
    pub source_name: String,
    /// The file that it was read from, if it is not one of the program's own.
    pub path: Option<PathBuf>,
    /// Its title.
    pub title: String,
    /// Its place among the others.
    pub order: u32,
    /// The concept of the Relativity Concept Inventory that it serves; empty for a state that only shows something.
    pub concept: String,
    /// How long it takes.
    pub minutes: u32,
    /// What it is about.
    pub introduction: Text,
    /// Its steps, at least one.
    pub steps: Vec<Step>,
    /// The sentence to take away.
    pub sentence: Text,
    /// What is measured by hand.
    pub lab: Option<Lab>,
}

/// A step of a lesson.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Its title.
    pub title: String,
    /// How its state differs from that before.
    pub state: Option<Told>,
    /// What is said before the prediction.
    pub text: Text,
    /// What is to be predicted.
    pub prediction: Option<Prediction>,
    /// What then happens.
    pub reveal: Option<Reveal>,
    /// What was seen: asked after the reveal.
    pub observation: Option<Choices>,
    /// Why that is so.
    pub explanation: Text,
    /// Advice for whoever teaches, on their page alone.
    pub teaching: Text,
}

/// What is to be predicted.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// The question.
    pub question: Text,
    /// How it is answered.
    pub kind: Kind,
}

/// How a prediction is made.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// One of several.
    Choice(Options),
    /// A number.
    Number(Number),
    /// A place clicked in a view.
    Point(PointAt),
    /// A curve drawn over T.
    Curve(Curve),
}

/// Several answers, one of which is right.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// The answers.
    pub texts: Vec<Text>,
    /// The number of the right one.
    pub right: usize,
}

/// A question with several answers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choices {
    /// The question.
    pub question: Text,
    /// The answers.
    pub options: Options,
}

/// A number that is predicted.
#[derive(Debug, Clone, PartialEq)]
pub struct Number {
    /// The value that it should be, as texts ask for it, such as `gain`.
    pub value: String,
    /// The line in which that stands.
    pub line: usize,
    /// What stands behind the number; may be empty.
    pub unit: String,
    /// Decimals with which the truth is told.
    pub decimals: u8,
    /// By how much it may be off, as a part of the truth.
    pub within: f64,
    /// What it is after the reveal, once the lesson is worked out.
    pub truth: Option<f64>,
}

/// A place in a view: where a body is seen after the reveal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointAt {
    /// The name of the body in its scene.
    pub body: String,
    /// The line in which that stands.
    pub line: usize,
}

/// What a drawn curve is of; of the selected point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The disparity across, radians.
    Dphi,
    /// The disparity in elevation, radians.
    Dtheta,
    /// The Doppler factor at the left eye.
    Doppler,
    /// The azimuth at the left eye, radians.
    Phi,
}

/// A curve over T that is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// What it is of.
    pub quantity: Quantity,
    /// The least and the greatest value that can be drawn.
    pub range: [f64; 2],
}

/// What happens once the prediction is made.
#[derive(Debug, Clone, PartialEq)]
pub struct Reveal {
    /// How its state differs from that of the step.
    pub state: Option<Told>,
    /// What runs.
    pub animation: Option<Animation>,
    /// What is said to it.
    pub text: Text,
}

/// What runs in a reveal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Animation {
    /// Where to.
    pub to: Animated,
    /// How long it takes, seconds.
    pub seconds: f64,
}

/// Where an animation ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Animated {
    /// At this T.
    Time(f64),
    /// At this speed.
    Speed(SpeedSetting),
}

/// What is measured by hand, from data that the worksheet carries.
#[derive(Debug, Clone, PartialEq)]
pub struct Lab {
    /// What is to be done.
    pub text: Text,
    /// How the state in which the data are taken differs from that of the last step.
    pub state: Option<Told>,
}

impl Lesson {
    /// `preset` as a lesson of one step.
    #[must_use]
    pub fn of_preset(preset: &Preset) -> Self {
        let text = |markdown: &str| Text { markdown: markdown.to_owned(), line: 1 };
        let step = Step {
            title: preset.title.clone(),
            state: Some(Told { toml: preset.toml.to_owned(), line: 1 }),
            text: text(&preset.caption),
            prediction: None,
            reveal: None,
            observation: None,
            explanation: Text::default(),
            teaching: Text::default(),
        };
        Self {
            name: preset.name.to_owned(),
            source_name: preset.name.to_owned(),
            path: None,
            title: preset.title.clone(),
            order: u32::MAX,
            concept: String::new(),
            minutes: 1,
            introduction: text(&preset.caption),
            steps: vec![step],
            sentence: Text::default(),
            lab: None,
        }
    }

    /// Whether it is a state that only shows something.
    #[must_use]
    pub const fn is_a_preset(&self) -> bool {
        self.order == u32::MAX
    }

    /// The settings of the step of this number, after its reveal if it `is_revealed`, in the place of what `base` says
    /// otherwise: usual settings in somebody's window.
    ///
    /// # Errors
    /// A setting that cannot be.
    pub fn settings(&self, step: usize, is_revealed: bool, base: &Settings) -> Result<Settings, LessonError> {
        let mut settings = base.clone();
        for (number, passed) in self.steps.iter().enumerate().take(step + 1) {
            settings = self.with(settings, passed.state.as_ref())?;
            let Some(reveal) = passed.reveal.as_ref().filter(|_| number < step || is_revealed) else {
                continue;
            };
            settings = self.with(settings, reveal.state.as_ref())?;
            match reveal.animation.map(|animation| animation.to) {
                Some(Animated::Time(time)) => settings.time = Some(time),
                Some(Animated::Speed(speed)) => settings.motion.speed = speed,
                None => {}
            }
        }
        // What is to be compared is seen in two pictures apart.
        if !settings.look.compare.is_off() && settings.check_two_pictures().is_err() {
            settings.picture.layout = Layout::SideBySide;
        }
        Ok(settings)
    }

    /// The settings in which the data of the lab are taken.
    ///
    /// # Errors
    /// A setting that cannot be.
    pub fn lab_settings(&self, base: &Settings) -> Result<Settings, LessonError> {
        let last = self.settings(self.steps.len().saturating_sub(1), true, base)?;
        self.with(last, self.lab.as_ref().and_then(|lab| lab.state.as_ref()))
    }

    /// `settings` with what is `told` in their stead. What belongs to a scene does not go over to another.
    pub(super) fn with(&self, settings: Settings, told: Option<&Told>) -> Result<Settings, LessonError> {
        let Some(told) = told else { return Ok(settings) };
        let Told { toml, line } = told;
        // Empty lines before it make the errors name the lines of the file.
        let text = "\n".repeat(line - 1) + toml;
        let read = |settings: Settings| {
            let before = settings.scene.clone();
            let read = settings.with_toml(&text, &self.source_name);
            let mut read = read.map_err(|error| LessonError::Settings(error.to_string()))?;
            // What was found before is no name in the file.
            if let Some(path) = self.path.as_ref().filter(|_| read.scene != before) {
                read.find_scene_beside(path)
                    .map_err(|problem| self.wrong(told.line_of("scene").unwrap_or(*line), problem))?;
            }
            Ok(read)
        };
        let scene = read(settings.clone())?.scene;
        let is_another = scene != settings.scene;
        read(if is_another { settings.with_scene(scene) } else { settings })
    }

    /// An error in the line of this number.
    pub(super) fn wrong(&self, line: usize, problem: impl Into<String>) -> LessonError {
        LessonError::Content { source_name: self.source_name.clone(), line, problem: problem.into() }
    }
}
