//! The plan of a lesson: its steps, questions and reveals.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::error::LessonError;
use crate::flags::choices::Layout;
use crate::flags::{SpeedSetting, given_speed};
use crate::formula::markdown::Markdown;
use crate::quantity::Quantity;
use crate::settings::{Preset, Settings};

/// A text in Markdown, with formulas in TeX, and where it begins in its file. Working a lesson out makes new
/// texts with the values in their places; the check, the window and all pages share the events of these.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Text {
    /// The Markdown; before a lesson is worked out, with places for values such as `{gain:.2}`.
    pub markdown: Markdown,
    /// Number of the text's first line in the file, from 1.
    pub line: usize,
}

impl Text {
    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.markdown.source().is_empty()
    }
}

/// Settings that differ, as TOML, and the line in the file at which that begins.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct StateBlock {
    /// The settings as in a state file.
    pub toml: String,
    /// Number of the state block's first line in the file, from 1.
    pub line: usize,
}

impl StateBlock {
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

/// The picture on the card of a lesson.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum CardPicture {
    /// The preset of this name.
    Preset(String),
    /// The step of this number, from 0, after its reveal.
    Step(usize),
}

/// A lesson, as its file describes it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Lesson {
    /// Name on the command line: that of its file without the ending.
    pub name: String,
    /// Name of the file in error messages.
    pub source_name: String,
    /// The file that it was read from, if it is not one of the program's own.
    pub path: Option<PathBuf>,
    /// Title, as on its card of the start page.
    pub title: String,
    /// Place among the lessons.
    pub order: u32,
    /// Title of its chapter on the start page; empty for a preset.
    pub chapter: String,
    /// The picture on its card.
    pub card: CardPicture,
    /// The concept of the Relativity Concept Inventory that it serves; empty for a state that only shows
    /// something.
    pub concept: String,
    /// Minutes that it takes in front of a class.
    pub minutes: u32,
    /// What it is about, before the first step.
    pub introduction: Text,
    /// Steps of the lesson, at least one.
    pub steps: Vec<Step>,
    /// The sentence to take away.
    pub sentence: Text,
    /// Lab with measurements by hand.
    pub lab: Option<Lab>,
}

/// A step of a lesson.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Step {
    /// Title above its text.
    pub title: String,
    /// Changes of the state from the step before.
    pub state: Option<StateBlock>,
    /// Text before the prediction.
    pub text: Text,
    /// The prediction that the step requests.
    pub prediction: Option<Prediction>,
    /// Reveal after the prediction.
    pub reveal: Option<Reveal>,
    /// Question about what was seen, after the reveal.
    pub observation: Option<Choices>,
    /// Why that is so.
    pub explanation: Text,
    /// Advice for whoever teaches, on their page alone.
    pub teaching: Text,
}

/// A requested prediction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Prediction {
    /// Question in words.
    pub question: Text,
    /// How it is answered, and what is right.
    pub kind: AnswerKind,
}

/// The kind of an answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum AnswerKind {
    /// A choice among several.
    Choice(Options),
    /// A number with a tolerance.
    Number(Number),
    /// A place clicked in a view.
    Point(PointAt),
    /// A curve drawn over T.
    Curve(CurveAnswer),
}

/// Several answers, one of which is right.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Options {
    /// The answers, in the order of the file.
    pub texts: Vec<Text>,
    /// The number of the right one.
    pub right: usize,
}

/// A question with several answers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Choices {
    /// Question in words.
    pub question: Text,
    /// Answers to choose from.
    pub options: Options,
}

/// A number that is predicted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Number {
    /// The value that it should be, as texts ask for it, such as `gain`.
    pub value: String,
    /// Number of the block's line in the file.
    pub line: usize,
    /// Unit behind the number; may be empty.
    pub unit: String,
    /// Decimals with which the truth is written.
    pub decimals: u8,
    /// Tolerance, as a fraction of the true number.
    pub within: f64,
    /// True value after the reveal, once the lesson is worked out.
    pub truth: Option<f64>,
}

/// A place in a view: where a body is seen after the reveal.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PointAt {
    /// The name of the body in its scene.
    pub body: String,
    /// Number of the block's line in the file.
    pub line: usize,
}

/// A curve over T that is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CurveAnswer {
    /// Quantity that is drawn, for the selected point: one of [`Quantity::DRAWN`], linearly; of those that
    /// each eye has, the left eye's.
    pub quantity: Quantity,
    /// The least and the greatest value that can be drawn.
    pub range: [f64; 2],
}

/// The reveal of a step, after the prediction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Reveal {
    /// Changes of the state from the step's.
    pub state: Option<StateBlock>,
    /// Animation from the settings of the step to those of the reveal, if there is one.
    pub animation: Option<Animation>,
    /// What to look for.
    pub text: Text,
}

/// The animation of a reveal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Animation {
    /// End of the animation.
    pub to: Animated,
    /// Seconds that it takes.
    pub seconds: f64,
}

/// The end of an animation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Animated {
    /// Stops at this T.
    Time(f64),
    /// Stops at this speed.
    Speed(#[serde(with = "given_speed")] SpeedSetting),
}

/// A lab: measurements by hand, from data on the worksheet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Lab {
    /// Task in words.
    pub text: Text,
    /// Changes of the state from that of the last step.
    pub state: Option<StateBlock>,
}

impl Settings {
    /// Returns the layout of a step of a lesson with these settings, for somebody who otherwise has the
    /// `usual` one: two pictures apart where they are compared, and one wide picture for one eye or for two
    /// in one place, which would give the same picture twice. Whoever looks through glasses keeps them on.
    fn layout_of_step(&self, usual: Layout) -> Layout {
        let is_one = self.picture.layout == Layout::Left || self.motion.d == 0.0;
        match self.picture.layout {
            _ if !self.look.compare.is_off() && self.check_two_pictures().is_err() => Layout::SideBySide,
            layout if !self.look.compare.is_off() || !is_one => layout,
            Layout::Left | Layout::SideBySide if usual == Layout::SideBySide => Layout::Left,
            Layout::Left => usual,
            layout => layout,
        }
    }
}

impl Lesson {
    /// `preset` as a lesson of one step.
    #[must_use]
    pub fn of_preset(preset: &Preset) -> Self {
        let text = |markdown: &str| Text { markdown: Markdown::new(markdown), line: 1 };
        let step = Step {
            title: preset.title.clone(),
            state: Some(StateBlock { toml: preset.toml.to_owned(), line: 1 }),
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
            chapter: String::new(),
            card: CardPicture::Step(0),
            concept: String::new(),
            minutes: 1,
            introduction: text(&preset.caption),
            steps: vec![step],
            sentence: Text::default(),
            lab: None,
        }
    }

    /// Whether the lesson is a preset: a state without steps.
    #[must_use]
    pub const fn is_a_preset(&self) -> bool {
        self.order == u32::MAX
    }

    /// Returns the settings of the step of this number, after its reveal if it `is_revealed`, on top of
    /// `base`: default settings in a user's window.
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
        settings.picture.layout = settings.layout_of_step(base.picture.layout);
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

    /// Returns `settings` with those in `told` on top. Settings that belong to a scene do not go over to
    /// another.
    pub(super) fn with(
        &self,
        settings: Settings,
        told: Option<&StateBlock>,
    ) -> Result<Settings, LessonError> {
        let Some(told) = told else { return Ok(settings) };
        let StateBlock { toml, line } = told;
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
