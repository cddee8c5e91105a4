//! The selection of points by a click, and by going through the bodies.

use crate::app::state::State;
use crate::app::state::notice::Notice;
use crate::app::state::pointer::{Pick, Select};

/// A command about the followed points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointsCommand {
    /// Selects the point of the scene at a pixel of an eye's picture.
    Pick(Pick),
    /// Selects a point of the scene.
    Choose(Select),
    /// Follows the body that is this many further in the list, or back.
    FollowNext(isize),
    /// Selects the followed point of this number.
    Select(usize),
    /// No longer follows the point of this number.
    Remove(usize),
}

impl State {
    /// Performs a command about the followed points.
    pub(super) fn perform_points(&mut self, command: PointsCommand) {
        let points = &mut self.document.points;
        match command {
            PointsCommand::Pick(pick) => self.of_picture(pick.is_second, |state| state.pick(pick)),
            PointsCommand::Choose(Select { track, body, add }) => points.choose(track, body, add),
            PointsCommand::FollowNext(steps) => self.follow_next(steps),
            PointsCommand::Select(index) => points.select(index),
            PointsCommand::Remove(index) => points.remove(index),
        }
    }

    pub(in crate::app) fn pick(&mut self, pick: Pick) {
        if self.predicts_by(&pick) {
            return;
        }
        if self.sees_as_published(pick.eye) {
            // The published right eye is defined point by point: no ray leads back.
            self.scratch.notice =
                Some(Notice::error("With the right eye as published, click in the left eye's view."));
            return;
        }
        let meant = self.meant(pick.eye, pick.pixel, pick.size);
        match meant.and_then(|pixel| self.point_at(pick.eye, pixel, pick.size)) {
            Some((track, body)) => {
                self.document.points.choose(track, body, pick.add);
                self.session.hint = false;
            }
            None => self.scratch.missed = Some(pick),
        }
    }

    fn follow_next(&mut self, steps: isize) {
        let scene = &self.document.scene;
        let body = self.document.points.selected().body.or_else(|| scene.tracked_body());
        let next = body.unwrap_or(0).wrapping_add_signed(steps);
        // Before the first comes the last.
        let count = scene.bodies.len();
        let next = if next >= count { if steps > 0 { 0 } else { count - 1 } } else { next };
        if let Some(track) = scene.track_on(next) {
            self.document.points.choose(track, next, false);
        }
    }
}
