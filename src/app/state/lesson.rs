//! The lesson that is under way in the window, and its commands.

use crate::app::state::stage::SidePanel;
use crate::flags::choices::Layout;
use crate::flags::{SpeedParameter, SpeedSetting};
use crate::lesson::{Animated, Animation, Answer, Confidence, Course, Place, Score};
use crate::settings::{Settings, WindowSettings};

/// A command of a lesson.
#[derive(Debug, Clone, PartialEq)]
pub enum LessonCommand {
    /// Begins the lesson of this name.
    Open(String),
    /// Enters this for the prediction.
    Draft(Option<Answer>),
    /// Sets how sure the prediction is.
    Confidence(Option<Confidence>),
    /// Makes the prediction that was entered.
    Predict,
    /// Goes on without an answer.
    Skip,
    /// Tells what was seen: the answer of this number.
    Observe(usize),
    /// Goes on; a prediction that was not made is skipped.
    Forward,
    /// Goes back to the place before.
    Back,
    /// Goes there, or as far as one can.
    GoTo(Place),
    /// Restores the state that the lesson has at this place, and plays its reveal again.
    SetUp,
    /// Starts or ends counting raised hands.
    ToggleClass,
    /// Shows the usual plots in place of a curve that was predicted, or the curve again.
    ShowPlots(bool),
    /// Folds the lesson's panel to a strip, or unfolds it.
    ToggleFolded,
    /// Starts the lesson again, with its answers forgotten.
    BeginAnew,
    /// Ends the lesson: its answers are kept, and opening it again takes it up where it was.
    Close,
}

/// A lesson that is gone through.
#[derive(Debug, Clone, PartialEq)]
pub struct Running {
    /// Course through the lesson.
    pub course: Course,
    /// Whether the lesson's panel is folded to a strip.
    pub is_folded: bool,
    /// The parts of the window before the lesson began.
    pub(in crate::app) before: WindowSettings,
    /// The layout before the lesson began, or the one that was chosen since.
    pub(in crate::app) layout: Layout,
    /// The number of the step whose predicted curve gave its place to the usual plots.
    pub(in crate::app) plots_in: Option<usize>,
    /// Animation that is playing.
    pub(in crate::app) run: Option<RunningAnimation>,
    /// The settings of the lesson at the present place.
    pub(in crate::app) told: Option<LessonSettings>,
    /// The score of the predictions, once the end is reached.
    pub score: Option<Score>,
}

/// The settings that a lesson has at a place, in somebody's window.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::app) struct LessonSettings {
    pub place: Place,
    pub base: Settings,
    pub settings: Settings,
    /// The panel beside the picture for an audience in any phase of the step.
    pub panel: SidePanel,
}

/// An animation that runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::app) struct RunningAnimation {
    pub from: Animated,
    pub animation: Animation,
    /// Seconds since the run began.
    pub passed: f64,
}

impl RunningAnimation {
    /// Returns the present value, and whether it is the last. Speeds change by equal rapidities in equal
    /// times.
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
