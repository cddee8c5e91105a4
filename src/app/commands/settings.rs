//! The settings: each section, single ones by their names, and the ways back to the defaults.

use relativity_render::Geometry;

use super::switch::Switch;
use crate::app::state::State;
use crate::app::state::defaults::Section;
use crate::app::state::notice::Notice;
use crate::comfort::comfortable_separation;
use crate::map::Viewpoint;
use crate::settings::{
    Daylight, FitSettings, LightSettings, LookSettings, MapSettings, MotionSettings, PictureSettings,
    PlaybackSettings, PlotSettings, QualitySettings, ScreenSettings, Settings, WindowSettings,
};

/// A change of the settings.
#[derive(Debug, Clone, PartialEq)]
pub enum SettingsCommand {
    /// New speed, separation or path.
    Motion(MotionSettings),
    /// New geometry, gaze or field of view.
    Look(LookSettings),
    /// Another layout of the eyes' pictures, or another way to make files of them.
    Picture(PictureSettings),
    /// Sets the light.
    Light(LightSettings),
    /// Another renderer, or another bound of it.
    Quality(QualitySettings),
    /// New rate, range or looping.
    Playback(PlaybackSettings),
    /// New choice of curves.
    Plots(PlotSettings),
    /// Another face or frame of the map.
    Map(MapSettings),
    /// New samples, or another way to fit them.
    Fit(FitSettings),
    /// New layout or theme.
    Window(WindowSettings),
    /// Another screen, or another place before it.
    Screen(ScreenSettings),
    /// Gives a setting its next value.
    Switch(Switch),
    /// Gives the setting of this name this value, in the spelling of its flag.
    Value {
        /// Name of the setting.
        name: &'static str,
        /// New value of the setting.
        value: String,
    },
    /// Moves the speed slider by hundredths, up or down.
    NudgeSpeed(i32),
    /// Shows this geometry.
    Geometry(Geometry),
    /// Narrows the separation of the eyes until the views can be fused in comfort.
    Narrow,
    /// Resets everything but the parts of the window, its units and the screen to defaults.
    Reset,
    /// Resets the settings of a section to defaults.
    ResetSection(Section),
}

impl State {
    /// Performs a change of the settings.
    pub(super) fn perform_settings(&mut self, command: SettingsCommand) {
        let settings = &mut self.document.settings;
        match command {
            SettingsCommand::Motion(motion) => settings.motion = motion,
            SettingsCommand::Look(look) => settings.look = look,
            SettingsCommand::Picture(picture) => settings.picture = picture,
            SettingsCommand::Light(light) => {
                self.set_or_tell(Settings { light, ..Settings::clone(&self.document.settings) });
            }
            SettingsCommand::Quality(quality) => settings.quality = quality,
            SettingsCommand::Playback(playback) => settings.playback = playback,
            SettingsCommand::Plots(plots) => settings.plots = plots,
            SettingsCommand::Map(map) => self.set_map(map),
            SettingsCommand::Fit(fit) => settings.fit = fit,
            SettingsCommand::Window(window) => self.set_window(window),
            SettingsCommand::Screen(screen) => settings.screen = screen,
            SettingsCommand::Switch(switch) => self.perform_switch(switch),
            SettingsCommand::Value { name, value } => self.set_by_name(name, &value),
            SettingsCommand::NudgeSpeed(steps) => self.nudge_speed(steps),
            SettingsCommand::Geometry(geometry) => settings.look.geometry = geometry,
            SettingsCommand::Narrow => self.narrow(),
            SettingsCommand::Reset => self.show(self.with_defaults()),
            SettingsCommand::ResetSection(section) => self.reset(section),
        }
    }

    /// Nudges the speed that is written large: the rider's own on a ride.
    fn nudge_speed(&mut self, steps: i32) {
        if !self.document.settings.ride.is_on() {
            let speed = &mut self.document.settings.motion.speed;
            *speed = speed.nudged(steps);
        } else if let Some(velocity) = self.throttled(self.throttle().nudged(steps)) {
            self.pedal_to(velocity);
        }
    }

    fn narrow(&mut self) {
        let wide = self.document.settings.motion.d;
        match comfortable_separation(wide, |d| self.comfort(d)) {
            Some(d) if d < wide => {
                self.document.settings.motion.d = d;
                self.scratch.narrowed = Some([wide, d]);
            }
            Some(_) => {}
            None => {
                self.tell(Notice::error("No separation of the eyes makes these views comfortable."));
            }
        }
    }

    fn set_window(&mut self, window: WindowSettings) {
        if window.theme != self.document.settings.window.theme {
            // Whatever a picture was made with: who changes the theme wants to see it.
            self.document.settings.light.light = Daylight::Theme;
        }
        self.document.settings.window = window;
    }

    /// Sets the map; another map is shown as a whole first.
    pub(super) fn set_map(&mut self, map: MapSettings) {
        if map != self.document.settings.map {
            self.scratch.map_view = Viewpoint::default();
        }
        self.document.settings.map = map;
    }
}
