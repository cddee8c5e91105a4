//! Flags for a picture that does not record its settings: a photograph, or a picture by another program.

use clap::Args;

use super::all::Settings;
use crate::flags::choices::{Form, GazeChoice, Layout, ProjectionChoice, Size, ZeroParallax};
use crate::flags::{FieldOfView, HeadArgs, field_of_view};

/// The cameras that took a picture, as far as a file does not record them.
#[derive(Debug, Clone, Args)]
pub struct CameraArgs {
    /// Horizontal field of view of each eye's picture, degrees [default: as the file records it]
    #[arg(long, value_name = "DEG", value_parser = field_of_view)]
    fov: Option<f64>,
    /// Gaze of the cameras: azimuth (from +x towards +y; 90 is straight ahead) and elevation in degrees
    /// [default: as the file records it]
    #[arg(long, value_name = "AZ,EL", value_parser = fixed_gaze, allow_hyphen_values = true)]
    gaze: Option<GazeChoice>,
    /// Projection of the pictures [default: as the file records it, else gaze, which is what a camera
    /// does]
    #[arg(long, value_enum)]
    projection: Option<ProjectionChoice>,
    /// Layout in which the pictures of both eyes are put together [default: as the file records it]
    #[arg(long, value_enum)]
    layout: Option<Layout>,
    #[command(flatten)]
    head: HeadArgs,
}

impl CameraArgs {
    /// The settings of a picture in a file of `file_size`, pixels: as `recorded`, with what the flags say in
    /// their stead; and the flags that are missing. Without a record the layout is the `default`.
    #[must_use]
    pub fn settings(
        &self,
        recorded: Option<Settings>,
        file_size: [u32; 2],
        default: Option<Layout>,
    ) -> (Settings, Vec<&'static str>) {
        let is_recorded = recorded.is_some();
        let mut settings = recorded.unwrap_or_default();
        let mut missing = Vec::new();
        if !is_recorded {
            settings.look.projection = ProjectionChoice::Gaze;
            // Cameras side by side have no image shift.
            settings.look.zero_parallax = ZeroParallax::Infinity;
            let layout = self.layout.or(default).unwrap_or_else(|| {
                missing.push("--layout");
                Layout::default()
            });
            settings.picture.size = Size(eye_size(layout, file_size));
            settings.picture.layout = layout;
        }
        let look = &mut settings.look;
        look.gaze = self.gaze.unwrap_or(look.gaze);
        look.fov = self.fov.map_or(look.fov, |fov| FieldOfView(Some(fov)));
        look.projection = self.projection.unwrap_or(look.projection);
        if look.gaze.fixed().is_none() {
            missing.push("--gaze");
        }
        if !is_recorded && self.fov.is_none() && look.projection != ProjectionChoice::Vr180 {
            missing.push("--fov");
        }
        settings.picture.layout = self.layout.unwrap_or(settings.picture.layout);
        let [roll, turn] = self.head.degrees();
        settings.motion.roll = roll.unwrap_or(settings.motion.roll);
        settings.motion.turn = turn.unwrap_or(settings.motion.turn);
        (settings, missing)
    }
}

/// Size of each eye's picture in a file of this size without bar and letters.
const fn eye_size(layout: Layout, [width, height]: [u32; 2]) -> [u32; 2] {
    match layout.form() {
        Form::Beside => [width / 2, height],
        Form::Above => [width, height / 2],
        Form::One(_) | Form::Composed(_) | Form::InTurn => [width, height],
    }
}

fn fixed_gaze(text: &str) -> Result<GazeChoice, String> {
    let gaze: GazeChoice = text.parse()?;
    gaze.fixed()
        .map(|_| gaze)
        .ok_or_else(|| "a picture has one gaze; write azimuth and elevation like 90,0".to_owned())
}

#[cfg(test)]
mod tests {
    use clap::{Command, FromArgMatches as _};

    use super::*;

    fn camera(flags: &str) -> CameraArgs {
        let command = CameraArgs::augment_args(Command::new("of a photograph").no_binary_name(true));
        let matches = command.try_get_matches_from(flags.split_whitespace()).expect("they are flags");
        CameraArgs::from_arg_matches(&matches).expect("they are flags")
    }

    #[test]
    fn what_is_missing_is_told_all_at_once() {
        let (_, missing) = camera("").settings(None, [640, 240], None);
        assert_eq!(missing, ["--layout", "--gaze", "--fov"]);
        let (_, missing) = camera("--fov 50").settings(None, [640, 240], Some(Layout::Left));
        assert_eq!(missing, ["--gaze"]);
    }

    #[test]
    fn flags_take_the_place_of_a_record_or_of_what_it_lacks() {
        let flags = "--fov 50 --gaze 90,10 --layout over-under --roll 5";
        let (settings, missing) = camera(flags).settings(None, [320, 480], None);
        assert!(missing.is_empty());
        assert_eq!(settings.picture.size, Size([320, 240]));
        assert_eq!(settings.look.projection, ProjectionChoice::Gaze);
        let cameras = settings.recorded_cameras([320, 240]).expect("nothing is missing");
        assert!((cameras[0].horizontal_fov.to_degrees() - 50.0).abs() < 1e-12);
        let mut recorded = Settings::default();
        recorded.look.gaze = GazeChoice::Ahead;
        recorded.look.fov = FieldOfView(Some(40.0));
        let (settings, missing) = camera("--roll 5").settings(Some(recorded.clone()), [320, 480], None);
        assert!(missing.is_empty());
        recorded.motion.roll = 5.0;
        assert_eq!(settings, recorded);
    }
}
