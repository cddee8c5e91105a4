//! The ruler for angles, which a drag lays into a view.

use crate::app::state::State;
use crate::app::state::measuring::angle_ruler::{AngleRuler, Laid, RulerCommand, laid};

impl State {
    /// Performs a command about the ruler.
    pub(super) fn perform_ruler(&mut self, command: RulerCommand) {
        self.scratch.angle_ruler = match (command, self.scratch.angle_ruler) {
            (RulerCommand::Toggle, AngleRuler::Off) => AngleRuler::Armed,
            (RulerCommand::Toggle, _) => AngleRuler::Off,
            (RulerCommand::Settle, AngleRuler::Laid(laid)) => {
                AngleRuler::Laid(Laid { is_held: false, ..laid })
            }
            (RulerCommand::Settle, ruler) => ruler,
            (RulerCommand::Lay(lay), ruler) => {
                let camera = self.of_picture(lay.is_second, |state| state.view(lay.eye, lay.size).camera);
                laid(&camera, lay).map_or(ruler, AngleRuler::Laid)
            }
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::state::measuring::angle_ruler::Lay;
    use crate::eye::Eye;
    use crate::flags::FieldOfView;
    use crate::flags::choices::ProjectionChoice;
    use crate::settings::Settings;

    const SIZE: [u32; 2] = [800, 600];

    fn state(projection: ProjectionChoice) -> State {
        let mut settings = Settings { scene: "globe".to_owned(), time: Some(-1.0), ..Settings::default() };
        settings.look.projection = projection;
        settings.look.fov = FieldOfView(Some(90.0));
        State::open(settings).expect("a preset")
    }

    fn lay(state: &mut State, ends: [[f64; 2]; 2]) -> Laid {
        state.perform_ruler(RulerCommand::Lay(Lay { eye: Eye::Left, is_second: false, ends, size: SIZE }));
        let AngleRuler::Laid(laid) = state.scratch.angle_ruler else { panic!("it is laid") };
        laid
    }

    /// A ruler that is laid by `state` is the same one where the picture has another projection or gaze, and
    /// its error is half a pixel of the picture that it was laid in, twice.
    #[test]
    fn it_keeps_its_directions_and_its_angle() {
        let mut state = state(ProjectionChoice::Gaze);
        let camera = state.view(Eye::Left, SIZE).camera;
        let ends = [[400.0, 300.0], [560.0, 300.0]];
        let laid = lay(&mut state, ends);
        // A flat picture 90 degrees wide: its plane is half a width ahead.
        let expected = (160.0_f64 / 400.0).atan();
        assert!((laid.angle() - expected).abs() < 1e-12, "{}", laid.angle());
        // Along the row 1 / 400 in the middle, and cos^2 of that at the other end.
        let error = 0.5 / 400.0 * (1.0 + expected.cos().powi(2));
        assert!((laid.error / error - 1.0).abs() < 1e-4, "{} for {error}", laid.error);
        state.document.settings.look.projection = ProjectionChoice::Mercator;
        let other = state.view(Eye::Left, SIZE).camera;
        for (end, pixel) in laid.ends.into_iter().zip(ends) {
            let before = camera.pixel(end).expect("in front");
            assert!((before[0] - pixel[0]).abs() + (before[1] - pixel[1]).abs() < 1e-9);
            let now = other.pixel(end).expect("in front");
            assert!((now[0] - pixel[0]).abs() > 1.0 && other.line_of_sight(now).distance(end) < 1e-12);
        }
        assert_eq!(state.scratch.angle_ruler, AngleRuler::Laid(laid));
    }

    #[test]
    fn a_toggle_arms_it_and_takes_it_away() {
        let mut state = state(ProjectionChoice::Mercator);
        state.perform_ruler(RulerCommand::Toggle);
        assert!(state.scratch.angle_ruler.takes_drags());
        // A press without a movement lays none.
        let still = Lay { eye: Eye::Left, is_second: false, ends: [[5.0, 5.0]; 2], size: SIZE };
        state.perform_ruler(RulerCommand::Lay(still));
        assert_eq!(state.scratch.angle_ruler, AngleRuler::Armed);
        lay(&mut state, [[5.0, 5.0], [6.0, 5.0]]);
        assert!(state.scratch.angle_ruler.takes_drags(), "it is being laid");
        state.perform_ruler(RulerCommand::Settle);
        assert!(!state.scratch.angle_ruler.takes_drags());
        state.perform_ruler(RulerCommand::Toggle);
        assert_eq!(state.scratch.angle_ruler, AngleRuler::Off);
    }
}
