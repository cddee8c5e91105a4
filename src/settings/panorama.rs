//! The panorama: the whole passage in one conformal strip, or in one for each eye, the left eye's above the
//! right eye's.

use super::{LookSettings, PictureSettings, Settings};
use crate::flags::FieldOfView;
use crate::flags::choices::{Form, GazeChoice, Layout, ProjectionChoice, ZeroParallax};

impl Settings {
    /// Whether the pictures are strips of the whole passage, one alone or one above the other.
    #[must_use]
    pub fn is_panorama(&self) -> bool {
        self.projection() == ProjectionChoice::Mercator
            && self.look.gaze == GazeChoice::Passage
            && matches!(self.picture.layout.form(), Form::Above | Form::One(_))
    }

    /// Changes from any other pictures to the panorama, and from that to these `defaults`.
    ///
    /// The strips are not shifted for what lies in the screen, so that a point's disparity is the difference
    /// of its columns.
    pub(crate) fn toggle_panorama(&mut self, defaults: &Self) {
        let (look, picture) = (self.look, self.picture);
        if self.is_panorama() {
            let default = Self::default();
            let default = if defaults.is_panorama() { &default } else { defaults };
            let (LookSettings { gaze, fov, zero_parallax, .. }, layout) =
                (default.look, default.picture.layout);
            self.look = LookSettings { gaze, fov, zero_parallax, ..look };
            self.picture = PictureSettings { layout, ..picture };
        } else {
            let (gaze, zero_parallax) = (GazeChoice::Passage, ZeroParallax::Infinity);
            let (projection, fov) = (ProjectionChoice::Mercator, FieldOfView(None));
            self.look = LookSettings { gaze, fov, projection, zero_parallax, ..look };
            self.picture = PictureSettings { layout: Layout::OverUnder, ..picture };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Preset;

    #[test]
    fn a_panorama_is_left_as_it_was_entered() {
        let before = Settings::default();
        let mut settings = before.clone();
        settings.toggle_panorama(&before);
        assert!(settings.is_panorama());
        settings.toggle_panorama(&before);
        assert_eq!(settings, before);
    }

    #[test]
    fn the_panorama_among_the_presets_is_one_and_can_be_left() {
        let preset = Preset::all().iter().find(|preset| preset.name == "panorama").expect("it is listed");
        let mut settings = preset.settings.clone();
        assert!(settings.is_panorama());
        assert_eq!(settings.look.zero_parallax, ZeroParallax::Infinity);
        settings.toggle_panorama(&preset.settings);
        assert!(!settings.is_panorama());
    }
}
