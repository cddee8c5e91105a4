//! The gaze and the field of view, as the pointer and keys change them.

use relativity_render::{Camera, Gaze};

use crate::app::state::State;
use crate::app::state::pointer::{Turn, Zoom};
use crate::eye::Eye;
use crate::flags::FieldOfView;
use crate::flags::choices::GazeChoice;
use crate::settings::Canvas;

/// Turn of the gaze for a press of a key, widths of a view.
pub const LOOK_STEP: f64 = 0.05;

/// A change of the gaze or of the field of view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GazeCommand {
    /// Turns the gaze so that what is seen at a place is seen at another, and keeps it there.
    Turn(Turn),
    /// Multiplies the field of view; what is seen at a place stays there.
    Zoom(Zoom),
    /// Multiplies the field of view; what is seen in the middle stays there.
    Magnify(f64),
    /// Looks aside: to the right and up, in widths of a view.
    Aside([f64; 2]),
    /// Has the whole scene in the views.
    Whole,
    /// Has the whole scene in the views after a double click, whose first click may have picked a point:
    /// running it takes that back.
    WholeAgain,
}

impl State {
    /// Performs a change of the gaze or of the field of view.
    pub(super) fn perform_gaze(&mut self, command: GazeCommand) {
        match command {
            GazeCommand::Turn(turn) => self.turn(turn),
            GazeCommand::Zoom(zoom) => self.zoom(zoom),
            GazeCommand::Magnify(factor) => self.magnify(factor),
            GazeCommand::Aside(aside) => self.look_aside(aside),
            GazeCommand::Whole | GazeCommand::WholeAgain => {
                let look = &mut self.document.settings.look;
                (look.gaze, look.fov) = (GazeChoice::Whole, FieldOfView(None));
            }
        }
    }

    fn magnify(&mut self, factor: f64) {
        let size = self.frame.picture.size;
        let pixel = size.map(|side| 0.5 * f64::from(side));
        self.zoom(Zoom { eye: Eye::Left, is_second: false, pixel, size, factor });
    }

    fn turn(&mut self, turn: Turn) {
        let camera = self.of_picture(turn.is_second, |state| state.view(turn.eye, turn.size).camera);
        self.stay_at(camera.gaze_with(camera.line_of_sight(turn.from), turn.to));
    }

    fn look_aside(&mut self, [across, up]: [f64; 2]) {
        let size = self.frame.picture.size;
        let [width, height] = size.map(f64::from);
        let from = [0.5 * width, 0.5 * height];
        let to = [from[0] - across * width, from[1] + up * width];
        self.turn(Turn { eye: Eye::Left, is_second: false, from, to, size });
    }

    fn zoom(&mut self, zoom: Zoom) {
        let camera = self.of_picture(zoom.is_second, |state| state.view(zoom.eye, zoom.size).camera);
        let direction = camera.line_of_sight(zoom.pixel);
        let fov = camera.horizontal_fov.to_degrees() * zoom.factor;
        let range = self.document.settings.look.fov_range();
        let fov = fov.clamp(*range.start(), *range.end());
        self.set_shown_fov(fov);
        let zoomed = Camera { horizontal_fov: fov.to_radians(), ..camera };
        self.stay_at(zoomed.gaze_with(direction, zoom.pixel));
    }

    /// Sets the field of view that the pictures show.
    fn set_shown_fov(&mut self, shown: f64) {
        let settings = &mut self.document.settings;
        let Canvas { size, keeps_height } = self.frame.picture;
        let fov = if keeps_height { settings.narrowed_fov(shown, size) } else { shown };
        settings.look.fov = FieldOfView(Some(fov));
    }

    /// Both eyes look there, in the observer's axes, from now on, with the present field of view.
    fn stay_at(&mut self, gaze: Gaze) {
        let gaze = self.rider().gaze_to_head(gaze);
        if let Some(fov) = self.look().fov.0 {
            self.set_shown_fov(fov);
        }
        let azimuth = gaze.azimuth.rem_euclid(std::f64::consts::TAU);
        self.document.settings.look.gaze = GazeChoice::fixed_at(Gaze { azimuth, ..gaze });
    }
}
