//! What is usual: what the shown preset says, or else a window that starts; and the ways back to it.

use super::clock;
use super::notice::Notice;
use super::points::Points;
use super::state::State;
use crate::settings::{Look, Motion, Picture, Settings};

/// A section of the controls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Section {
    /// Speed, separation and path.
    Motion,
    /// What the views show, where they look and what draws them.
    Look,
    /// How the head is held, and how two pictures make a pair.
    TwoEyes,
    /// What becomes of the light.
    Light,
}

impl Section {
    /// Its title.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Motion => "Motion",
            Self::Look => "Look",
            Self::TwoEyes => "Two eyes",
            Self::Light => "Light",
        }
    }

    /// `settings` with what is set in this section as in `usual`.
    fn as_in(self, usual: &Settings, settings: &Settings) -> Settings {
        let (kept, all) = (settings.clone(), usual);
        match self {
            Self::Motion => {
                let motion = Motion { roll: kept.motion.roll, turn: kept.motion.turn, ..all.motion };
                Settings { motion, ..kept }
            }
            Self::Look => {
                let Look { projection, zero_parallax, .. } = kept.look;
                let picture =
                    Picture { layout: all.picture.layout, swapped: all.picture.swapped, ..kept.picture };
                let look = Look { projection, zero_parallax, ..all.look };
                Settings { look, picture, quality: all.quality, ..kept }
            }
            Self::TwoEyes => {
                let motion = Motion { roll: all.motion.roll, turn: all.motion.turn, ..kept.motion };
                let Look { projection, zero_parallax, .. } = all.look;
                let look = Look { projection, zero_parallax, ..kept.look };
                Settings { motion, look, screen: all.screen, ..kept }
            }
            Self::Light => Settings { light: all.light, ..kept },
        }
    }
}

impl State {
    /// What is usual here: what the lesson or the shown preset says, else what a window starts with.
    #[must_use]
    pub fn usual(&self) -> Settings {
        let of_preset =
            || self.document.preset.map_or_else(Settings::default, |preset| preset.settings.clone());
        self.lesson_settings().cloned().unwrap_or_else(of_preset)
    }

    /// Where [`Self::usual`] is from, in words.
    #[must_use]
    pub fn usual_is(&self) -> String {
        match self.document.preset {
            _ if self.session.lesson.is_some() => "as the lesson has it here".to_owned(),
            Some(preset) => format!("as the preset “{}” has it", preset.title),
            None => "as in a new window".to_owned(),
        }
    }

    /// Whether nothing is otherwise than the lesson has it at its present place.
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

    /// All as usual, but for the scene, the parts of the window, its units and colours, and the screen.
    #[must_use]
    pub(super) fn as_usual(&self) -> Settings {
        let Settings { ref scene, screen, window, .. } = *self.document.settings;
        Settings { scene: scene.clone(), screen, window, ..self.usual() }
    }

    /// Whether there is anything to have as usual.
    #[must_use]
    pub fn is_usual(&self) -> bool {
        let as_usual = Settings { time: None, point: None, points: None, ..self.as_usual() };
        let has_own_point = self.document.points == Points::tracked(self.document.scene.track(None));
        as_usual == *self.document.settings && has_own_point
    }

    /// Whether what is set in `section` is as usual.
    #[must_use]
    pub fn is_usual_in(&self, section: Section) -> bool {
        section.as_in(&self.usual(), &self.document.settings) == *self.document.settings
    }

    /// Has what is set in `section` as usual.
    pub(super) fn reset(&mut self, section: Section) {
        if let Err(error) = self.set(section.as_in(&self.usual(), &self.document.settings)) {
            self.scratch.notice = Some(Notice::error(error));
        }
    }
}
