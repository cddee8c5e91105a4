//! The curve that a lesson asks to draw, and the time when it takes the place of the plots.

use crate::app::state::State;
use crate::lesson::{Answer, AnswerKind, CurveAnswer, Sight};
use crate::settings::{Presence, WindowSettings};

/// A curve that is drawn, or was.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sketched<'a> {
    /// The requested curve.
    pub curve: CurveAnswer,
    /// T and value of its points, T rising; none where it was skipped.
    pub points: &'a [[f64; 2]],
    /// Whether the curve is being drawn.
    pub is_asked: bool,
    /// Whether what it should be is shown.
    pub is_revealed: bool,
}

impl State {
    /// The curve that is drawn in the present step of the lesson.
    #[must_use]
    pub fn sketched(&self) -> Option<Sketched<'_>> {
        let course = self.course()?;
        let AnswerKind::Curve(curve) = course.step()?.prediction.as_ref()?.kind else { return None };
        let is_asked = course.asked().is_some();
        let answer = if is_asked { course.draft.as_ref() } else { course.record()?.answer() };
        let points = match answer {
            Some(Answer::Curve(points)) => points.as_slice(),
            _ => &[],
        };
        Some(Sketched { curve, points, is_asked, is_revealed: course.is_revealed() })
    }

    /// Returns whether the sketch takes the place of the plots.
    #[must_use]
    pub fn shows_sketch(&self) -> bool {
        let Some(sketched) = self.sketched() else { return false };
        let step = self.course().map(|course| course.place().step);
        let gave_way = self.session.lesson.as_ref().is_some_and(|running| running.plots_in == step);
        sketched.is_asked || !gave_way || self.session.stage.is_presented()
    }

    /// Returns the parts of the window: there is a place to draw in while a curve is requested, and to
    /// compare it.
    #[must_use]
    pub fn shown_window(&self) -> WindowSettings {
        let window = self.document.settings.window;
        if self.sketched().is_none() {
            return window;
        }
        // A map that is asked for takes the place of the plots where there is not room for both.
        let map = if window.map == Presence::On { Presence::Auto } else { window.map };
        WindowSettings { plots: true, map, ..window }
    }

    /// Returns the picture of the scene, for the truth of predictions.
    #[must_use]
    pub fn sight(&self) -> Sight<'_> {
        Sight {
            settings: &self.document.settings,
            scene: &self.document.scene,
            prepared: &self.document.prepared,
            track: self.document.points.selected().track,
            time: self.document.time,
        }
    }
}
