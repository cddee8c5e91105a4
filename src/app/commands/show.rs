//! Presets and scenes, shown in place of the document.

use std::path::Path;

use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::notice::Notice;
use crate::app::state::stage::next_to_show;
use crate::settings::{Preset, Settings};

/// Something to show in place of the document.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShowCommand {
    /// The scene of this name, with the present settings.
    Scene(&'static str),
    /// This preset, with defaults for all else but the parts of the window.
    Preset(&'static Preset),
    /// Shows the street from the saddle of a resting bicycle.
    Ride,
    /// Goes this many steps on from what is shown, in the presenter's own sequence if there is one; a lesson
    /// goes on, or back.
    Next(i32),
    /// Ends the presenter's own sequence: the keys go through all presets again.
    EndSequence,
}

impl State {
    /// Shows something in place of the document.
    pub(super) fn perform_show(&mut self, command: ShowCommand) {
        match command {
            ShowCommand::Scene(name) => {
                self.show(Settings::clone(&self.document.settings).with_scene(name.to_owned()));
            }
            ShowCommand::Preset(preset) => self.show_preset(preset),
            ShowCommand::Ride => self.ride_through_the_street(),
            ShowCommand::Next(steps) => self.show_next(steps),
            ShowCommand::EndSequence => self.session.sequence = None,
        }
    }

    fn show_next(&mut self, steps: i32) {
        if self.show_next_in_sequence(steps) {
            return;
        }
        if self.session.lesson.is_some() {
            let command = if steps > 0 { LessonCommand::Forward } else { LessonCommand::Back };
            self.perform_lesson(command);
        } else if let Some(preset) = next_to_show(self.document.preset, steps) {
            self.show_preset(preset);
        }
    }

    pub(super) fn show_preset(&mut self, preset: &Preset) {
        self.session.stage.audience.panel = None;
        self.show(preset.settings.clone().in_place_of(&self.document.settings));
    }

    /// Shows what `settings` say; where their scene cannot be had, a message. T runs on unless they give one.
    pub(in crate::app) fn show(&mut self, settings: Settings) {
        match settings.opened_scene() {
            Ok(scene) => self.show_in(settings, scene.into()),
            Err(error) => {
                self.tell(Notice::error(error).about(Path::new(&settings.scene)));
            }
        }
    }
}
