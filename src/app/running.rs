//! A lesson that is gone through in the window, and what can be asked for in it.

use crate::flags::{SpeedParameter, SpeedSetting};
use crate::lesson::{Animated, Animation, Answer, Confidence, Course, Place, Score};
use crate::settings::{Settings, Window};

/// Something asked for in a lesson.
#[derive(Debug, Clone, PartialEq)]
pub enum LessonCommand {
    /// Begin the lesson of this name.
    Open(String),
    /// Enter this for the prediction.
    Draft(Option<Answer>),
    /// Be this sure of it.
    Confidence(Option<Confidence>),
    /// Make the prediction that was entered.
    Predict,
    /// Go on without.
    Skip,
    /// Tell what was seen: the answer of this number.
    Observe(usize),
    /// Go on; what is predicted and not entered is skipped.
    Forward,
    /// Go back.
    Back,
    /// Go there, or as far as one can.
    GoTo(Place),
    /// Have the state as the lesson has it at this place, and run its reveal again.
    SetUp,
    /// Count hands, or no longer.
    ToggleClass,
    /// Show the usual plots beside a curve that was predicted, or the curve again.
    ShowPlots(bool),
    /// Fold its panel to a strip, or have all of it.
    ToggleFolded,
    /// Begin it anew: the answers that were given in it are forgotten.
    BeginAnew,
    /// End the lesson: its answers are kept, and opening it again takes it up where it was.
    Close,
}

/// A lesson that is gone through.
#[derive(Debug, Clone, PartialEq)]
pub struct Running {
    /// How far.
    pub course: Course,
    /// Whether its panel is folded to a strip.
    pub is_folded: bool,
    /// The parts of the window before it began.
    pub(super) before: Window,
    /// The number of the step whose predicted curve gave its place to the usual plots.
    pub(super) plots_in: Option<usize>,
    /// What runs.
    pub(super) run: Option<Run>,
    /// The settings that it has at its present place.
    pub(super) told: Option<Told>,
    /// The score of the predictions, once the end is reached.
    pub score: Option<Score>,
}

/// The settings that a lesson has at a place, in somebody's window.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Told {
    pub place: Place,
    pub base: Settings,
    pub settings: Settings,
}

/// An animation that runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    pub from: Animated,
    pub animation: Animation,
    /// Seconds since it began.
    pub passed: f64,
}

impl Run {
    /// Where it is, and whether that is its end. Speeds change by equal rapidities in equal times.
    pub fn now(&self) -> (Animated, bool) {
        let part = self.passed / self.animation.seconds;
        let between = |from: f64, to: f64| from + part * (to - from);
        let now = match (self.from, self.animation.to) {
            _ if part >= 1.0 => return (self.animation.to, true),
            (Animated::Time(from), Animated::Time(to)) => Animated::Time(between(from, to)),
            (Animated::Speed(from), Animated::Speed(to)) => {
                let [from, to] = [from, to].map(|speed| speed.speed().rapidity());
                let speed = SpeedSetting::new(SpeedParameter::Rapidity, between(from, to));
                speed.map_or(self.animation.to, Animated::Speed)
            }
            _ => return (self.animation.to, true),
        };
        (now, false)
    }
}

impl Running {
    /// Whether a reveal runs.
    #[must_use]
    pub const fn is_running(&self) -> bool {
        self.run.is_some()
    }
}
