//! Sets a setting that is given by its name and its value, as they are typed into the palette.

use crate::app::commands::{Command, SettingsCommand};
use crate::app::state::State;
use crate::app::state::notice::Notice;
use crate::app::state::riding::saddle::RideCommand;
use crate::settings::Settings;

impl State {
    /// Gives the setting of this name another value, as its control does.
    pub(super) fn set_by_name(&mut self, name: &str, value: &str) {
        let before = Settings::clone(&self.document.settings);
        match before.clone().with_value(name, value) {
            Ok(settings) => changes(&before, settings).for_each(|command| self.perform(command)),
            Err(problem) => self.tell(Notice::error(problem)),
        }
    }
}

/// Returns the commands of the controls that make these settings of those `before`: one, where one setting
/// differs.
fn changes(before: &Settings, settings: Settings) -> impl Iterator<Item = Command> {
    // What belongs to a scene is chosen there.
    let Settings {
        scene: _,
        time: _,
        point: _,
        points: _,
        motion,
        ride,
        look,
        light,
        quality,
        picture,
        screen,
        playback,
        map,
        plots,
        fit,
        window,
    } = settings;
    let changed = [
        (motion != before.motion, SettingsCommand::Motion(motion).into()),
        (ride != before.ride, RideCommand::Set(ride).into()),
        (look != before.look, SettingsCommand::Look(look).into()),
        (light != before.light, SettingsCommand::Light(light).into()),
        (quality != before.quality, SettingsCommand::Quality(quality).into()),
        (picture != before.picture, SettingsCommand::Picture(picture).into()),
        (screen != before.screen, SettingsCommand::Screen(screen).into()),
        (playback != before.playback, SettingsCommand::Playback(playback).into()),
        (map != before.map, SettingsCommand::Map(map).into()),
        (plots != before.plots, SettingsCommand::Plots(plots).into()),
        (fit != before.fit, SettingsCommand::Fit(fit).into()),
        (window != before.window, SettingsCommand::Window(window).into()),
    ];
    changed.into_iter().filter_map(|(is_changed, command)| is_changed.then_some(command))
}
