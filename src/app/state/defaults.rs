//! Defaults: those of the shown preset, or else the program's own; and the ways back to them.

use crate::app::state::State;
use crate::app::state::points::Points;
use crate::app::tools::clock;
use crate::settings::{LookSettings, MotionSettings, PictureSettings, Settings};

/// A section of the controls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Section {
    /// Speed, separation and path.
    Motion,
    /// Ride of the observer.
    Ride,
    /// Geometry, gaze and renderer of the views.
    Look,
    /// Head and eyes, and how two pictures make a pair.
    TwoEyes,
    /// Light of the bodies.
    Light,
}

impl Section {
    /// Returns the title of the section.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Motion => "Motion",
            Self::Ride => "Ride",
            Self::Look => "Look",
            Self::TwoEyes => "Two eyes",
            Self::Light => "Light",
        }
    }

    /// Returns `settings` with this section as in `default`.
    fn as_in(self, default: &Settings, settings: &Settings) -> Settings {
        let (kept, all) = (settings.clone(), default);
        match self {
            Self::Motion => {
                let motion = MotionSettings { roll: kept.motion.roll, turn: kept.motion.turn, ..all.motion };
                Settings { motion, ..kept }
            }
            Self::Ride => Settings { ride: all.ride.clone(), ..kept },
            Self::Look => {
                let LookSettings { projection, zero_parallax, .. } = kept.look;
                let picture = PictureSettings {
                    layout: all.picture.layout,
                    swapped: all.picture.swapped,
                    ..kept.picture
                };
                let look = LookSettings { projection, zero_parallax, ..all.look };
                Settings { look, picture, quality: all.quality, ..kept }
            }
            Self::TwoEyes => {
                let motion = MotionSettings { roll: all.motion.roll, turn: all.motion.turn, ..kept.motion };
                let LookSettings { projection, zero_parallax, .. } = all.look;
                let look = LookSettings { projection, zero_parallax, ..kept.look };
                Settings { motion, look, screen: all.screen, ..kept }
            }
            Self::Light => Settings { light: all.light, ..kept },
        }
    }
}

impl State {
    /// Returns the defaults: those of the lesson or the shown preset, else the program's own.
    #[must_use]
    pub fn defaults(&self) -> Settings {
        let of_preset =
            || self.document.preset.map_or_else(Settings::default, |preset| preset.settings.clone());
        self.lesson_settings().cloned().unwrap_or_else(of_preset)
    }

    /// Returns the source of the defaults, in words.
    #[must_use]
    pub fn defaults_source(&self) -> String {
        match self.document.preset {
            _ if self.session.lesson.is_some() => "those of the lesson here".to_owned(),
            Some(preset) => format!("those of the preset “{}”", preset.title),
            None => "the program's own".to_owned(),
        }
    }

    /// Returns whether the settings are those of the lesson's current step.
    #[must_use]
    pub fn is_as_in_lesson(&self) -> bool {
        let Some(mut told) = self.lesson_settings().cloned() else { return true };
        if told.scene != self.document.settings.scene {
            return false;
        }
        let scene = &self.document.scene;
        let selected = told.track(scene);
        let points = Points::tracked(scene.track(None)).with_followed(scene, told.points.take());
        let time = told.time.take().unwrap_or_else(|| told.time_of_approach(&selected));
        told.point = None;
        told == *self.document.settings
            && points.with_selected(selected) == self.document.points
            && clock::bounded(time) == self.document.time
    }

    /// Returns the defaults with the present scene, the parts of the window, its units and colours, and the
    /// screen.
    #[must_use]
    pub(in crate::app) fn with_defaults(&self) -> Settings {
        let Settings { ref scene, screen, window, .. } = *self.document.settings;
        Settings { scene: scene.clone(), screen, window, ..self.defaults() }
    }

    /// Returns whether everything has its default.
    #[must_use]
    pub fn is_default(&self) -> bool {
        let with_defaults = Settings { time: None, point: None, points: None, ..self.with_defaults() };
        let has_own_point = self.document.points == Points::tracked(self.document.scene.track(None));
        with_defaults == *self.document.settings && has_own_point
    }

    /// Returns whether the settings in `section` have their defaults.
    #[must_use]
    pub fn is_default_in(&self, section: Section) -> bool {
        section.as_in(&self.defaults(), &self.document.settings) == *self.document.settings
    }

    /// Resets the settings in `section` to their defaults.
    pub(in crate::app) fn reset(&mut self, section: Section) {
        self.set_or_tell(section.as_in(&self.defaults(), &self.document.settings));
    }
}
