//! Everything that can be done in the window, and the one place where it is done.

pub(in crate::app) mod actions;
mod by_name;
mod digits;
pub mod file_dialog;
mod files;
mod gaze;
mod lesson;
mod plots;
mod points;
pub mod riding;
mod ruler;
pub(in crate::app) mod saving;
mod stopwatch;
mod switch;
mod time;
mod undo;

use std::path::{Path, PathBuf};

use relativity_render::Geometry;

use crate::app::state::defaults::Section;
use crate::app::state::files::purpose::Purpose;
use crate::app::state::files::reader::ReadFile;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::measuring::angle_ruler::{AngleRuler, RulerCommand};
use crate::app::state::measuring::stopwatch::StopwatchCommand;
use crate::app::state::notice::Notice;
use crate::app::state::orders::{Copied, Order, Saving};
use crate::app::state::overlay::Overlay;
use crate::app::state::plots::look::PlotCommand;
use crate::app::state::pointer::{Pick, Select};
use crate::app::state::riding::saddle::RideCommand;
use crate::app::state::stage::{WindowPart, next_to_show};
use crate::app::state::{Scratch, Session, State};
use crate::app::tools::clock;
use crate::comfort::comfortable_separation;
use crate::map::Viewpoint;
use crate::settings::{
    Daylight, FitSettings, LightSettings, LookSettings, MapSettings, MotionSettings, PictureSettings,
    PlaybackSettings, PlotSettings, Preset, QualitySettings, ScreenSettings, Settings, WindowSettings,
};

pub use gaze::{GazeCommand, LOOK_STEP};
pub use switch::Switch;

/// A command of the user.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// New speed, separation or path.
    Motion(MotionSettings),
    /// Get on the bicycle, ride, get off.
    Ride(RideCommand),
    /// New geometry, gaze or field of view.
    Look(LookSettings),
    /// Another layout of the eyes' pictures, or another way to make files of them.
    Picture(PictureSettings),
    /// Gives a setting its next value.
    Switch(Switch),
    /// Sets the light.
    Light(LightSettings),
    /// Another renderer, or another bound of it.
    Quality(QualitySettings),
    /// New rate, range or looping.
    Playback(PlaybackSettings),
    /// New choice of curves.
    Plots(PlotSettings),
    /// Look at another part of the plots, or mark or keep something in them.
    Plotting(PlotCommand),
    /// Another face or frame of the map.
    Map(MapSettings),
    /// Look at another part of the map.
    MapView(Viewpoint),
    /// New samples, or another way to fit them.
    Fit(FitSettings),
    /// New layout or theme.
    Window(WindowSettings),
    /// Another screen, or another place before it.
    Screen(ScreenSettings),
    /// Gives the setting of this name this value, in the spelling of its flag.
    Value {
        /// Name of the setting.
        name: &'static str,
        /// New value of the setting.
        value: String,
    },
    /// Narrow the separation of the eyes until the views can be fused in comfort.
    Narrow,
    /// Go to this T.
    Time(f64),
    /// Steps of the scrubber, forwards or back.
    Step(i32),
    /// To the first (0) or the last (1) T, or in between.
    TimeInRange(f64),
    /// Plays or pauses.
    TogglePlaying,
    /// Hundredths of the speed slider, up or down.
    NudgeSpeed(i32),
    /// Shows this geometry.
    Geometry(Geometry),
    /// Turn or widen what the views show.
    Gaze(GazeCommand),
    /// Select the point of the scene at a pixel of an eye's picture.
    Pick(Pick),
    /// Select a point of the scene.
    Select(Select),
    /// Lay a ruler into a view, or remove the ruler.
    Ruler(RulerCommand),
    /// Start, stop, show or hide the stopwatch.
    Stopwatch(StopwatchCommand),
    /// Follows the body that is this many further in the list, or back.
    FollowNext(isize),
    /// Select a followed point.
    SelectPoint(usize),
    /// No longer follow a point.
    RemovePoint(usize),
    /// Shows another preset.
    Preset(&'static str),
    /// Shows this state, with defaults for all else but the parts of the window.
    State(&'static Preset),
    /// Shows what comes this many steps after what is shown; a lesson goes on, or back.
    ShowNext(i32),
    /// Show what is in a file: a scene, settings, or a picture with which settings it was made.
    Open(PathBuf),
    /// Shows the present contents of a file that is shown.
    Reload(PathBuf),
    /// Show a file that was read.
    ShowFile(Box<ReadFile>),
    /// Give up the file that is being read.
    StopReading,
    /// Begin a lesson, or do something in the one that is gone through.
    Lesson(LessonCommand),
    /// Ask which file to open or to write.
    Choose(Purpose),
    /// Undo the last step.
    Undo,
    /// Make the step again that was undone.
    Redo,
    /// Resets everything but the parts of the window, its units and the screen to defaults.
    Reset,
    /// Resets the settings of a section to defaults.
    ResetSection(Section),
    /// Fit the measured disparities in a file.
    OpenData(PathBuf),
    /// Fit simulated disparities again.
    Simulate,
    /// Writes a file.
    Save(Saving),
    /// Copies something to the clipboard.
    Copy(Copied),
    /// Give up what is being saved.
    StopSaving,
    /// Shows or hides an overlay.
    Toggle(Overlay),
    /// Take the whole screen, or leave it.
    ToggleFullScreen,
    /// Start or end the presentation to an audience.
    TogglePresenting,
    /// Show the views and a lesson's words in a window for a projector, too, or no longer.
    ToggleProjector,
    /// Have the window as the screen of a stereoscope, or no longer.
    ToggleStereoscope,
    /// Have a part alone in the window, or all others again.
    ToggleMaximised(WindowPart),
    /// Closes the message.
    CloseNotice,
    /// Close what is on top, else leave what the window was made.
    Close,
}

impl Command {
    /// Whether the command sets T or the speed, which a lesson may be playing.
    const fn sets_what_runs(&self) -> bool {
        matches!(
            self,
            Self::Motion(_)
                | Self::Ride(_)
                | Self::NudgeSpeed(_)
                | Self::Time(_)
                | Self::Step(_)
                | Self::TimeInRange(_)
                | Self::TogglePlaying
        )
    }

    /// Whether the command changes what is shown, so that a page over the window must close.
    const fn shows_another(&self) -> bool {
        matches!(
            self,
            Self::Preset(_)
                | Self::State(_)
                | Self::ShowNext(_)
                | Self::Open(_)
                | Self::OpenData(_)
                | Self::Undo
                | Self::Redo
                | Self::Reset
        )
    }
}

impl State {
    /// Performs a command.
    pub(super) fn perform(&mut self, command: Command) {
        self.make_way_for(&command);
        let settings = &mut self.document.settings;
        match command {
            Command::Motion(motion) => settings.motion = motion,
            Command::Ride(command) => self.perform_ride(command),
            Command::Look(look) => settings.look = look,
            Command::Picture(picture) => settings.picture = picture,
            Command::Value { name, value } => self.set_by_name(name, &value),
            Command::Switch(switch) => self.perform_switch(switch),
            Command::Light(light) => self.set_light(light),
            Command::Quality(quality) => settings.quality = quality,
            Command::Playback(playback) => settings.playback = playback,
            Command::Plots(plots) => settings.plots = plots,
            Command::Plotting(command) => self.perform_plots(command),
            Command::Map(map) => self.set_map(map),
            Command::MapView(viewpoint) => self.scratch.map_view = viewpoint,
            Command::Fit(fit) => settings.fit = fit,
            Command::Window(window) => self.set_window(window),
            Command::Screen(screen) => settings.screen = screen,
            Command::Narrow => self.narrow(),
            Command::Time(time) => self.document.time = clock::bounded(time),
            Command::Step(steps) => self.step_in_time(steps),
            Command::TimeInRange(fraction) => self.go_within_range(fraction),
            Command::TogglePlaying => self.toggle_playing(),
            Command::NudgeSpeed(steps) => settings.motion.speed = settings.motion.speed.nudged(steps),
            Command::Geometry(geometry) => settings.look.geometry = geometry,
            Command::Gaze(command) => self.perform_gaze(command),
            Command::Pick(pick) => self.of_picture(pick.is_second, |state| state.pick(pick)),
            Command::Select(Select { track, body, add }) => self.document.points.choose(track, body, add),
            Command::Ruler(command) => self.perform_ruler(command),
            Command::Stopwatch(command) => self.perform_stopwatch(command),
            Command::FollowNext(steps) => self.follow_next(steps),
            Command::SelectPoint(index) => self.document.points.select(index),
            Command::RemovePoint(index) => self.document.points.remove(index),
            Command::Preset(name) => self.show_named_scene(name),
            Command::State(preset) => self.show_preset(preset),
            Command::ShowNext(steps) => self.show_next(steps),
            Command::Open(_) | Command::OpenData(_) | Command::Reload(_) => self.read_and_show(&command),
            Command::ShowFile(file) => self.show_file(*file),
            Command::Lesson(command) => self.perform_lesson(command),
            Command::Choose(purpose) => self.scratch.chooser = Some(purpose),
            // Not done here, but by who goes through the steps or reads.
            Command::Undo | Command::Redo | Command::StopReading => {}
            Command::Reset => self.show(self.with_defaults()),
            Command::ResetSection(section) => self.reset(section),
            Command::Simulate => self.session.data = None,
            Command::Save(saving) => self.save(saving),
            Command::Copy(copied) => self.session.orders.push(Order::Copy(copied)),
            Command::StopSaving => self.session.orders.push(Order::Stop),
            Command::Toggle(overlay) => self.toggle(overlay),
            Command::ToggleFullScreen => self.session.stage.full_screen = !self.session.stage.full_screen,
            Command::TogglePresenting => self.session.stage.toggle_presenting(),
            Command::ToggleProjector => self.session.stage.projector = !self.session.stage.projector,
            Command::ToggleStereoscope => self.session.stage.toggle_stereoscope(),
            Command::ToggleMaximised(part) => self.session.stage.toggle_maximised(part),
            Command::CloseNotice => self.scratch.notice = None,
            Command::Close => self.close(),
        }
    }

    /// Ends what a command ends besides what it does.
    fn make_way_for(&mut self, command: &Command) {
        self.scratch.missed = None;
        if command.sets_what_runs() {
            self.stop_run();
        }
        if command.shows_another() && self.session.overlay == Some(Overlay::Start) {
            self.session.overlay = None;
        }
    }

    fn show_next(&mut self, steps: i32) {
        if self.session.lesson.is_some() {
            let command = if steps > 0 { LessonCommand::Forward } else { LessonCommand::Back };
            self.perform_lesson(command);
        } else if let Some(preset) = next_to_show(self.document.preset, steps) {
            self.perform(Command::State(preset));
        }
    }

    fn show_named_scene(&mut self, name: &str) {
        self.show(Settings::clone(&self.document.settings).with_scene(name.to_owned()));
    }

    fn show_preset(&mut self, preset: &Preset) {
        self.show(preset.settings.clone().in_place_of(&self.document.settings));
    }

    fn save(&mut self, saving: Saving) {
        self.scratch.chooser = None;
        self.session.orders.push(Order::Save(saving));
    }

    fn toggle(&mut self, overlay: Overlay) {
        self.session.overlay = Some(overlay).filter(|_| self.session.overlay != Some(overlay));
    }

    fn close(&mut self) {
        let Scratch { notice, chooser, angle_ruler, .. } = &mut self.scratch;
        let Session { overlay, stage, .. } = &mut self.session;
        if *overlay == Some(Overlay::Palette) {
            *overlay = None;
        } else if chooser.is_some() {
            *chooser = None;
        } else if notice.is_some() {
            *notice = None;
        } else if overlay.is_some() {
            *overlay = None;
        } else if *angle_ruler != AngleRuler::Off {
            *angle_ruler = AngleRuler::Off;
        } else {
            stage.leave();
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

    fn set_light(&mut self, light: LightSettings) {
        if let Err(error) = self.set(Settings { light, ..Settings::clone(&self.document.settings) }) {
            self.tell(Notice::error(error));
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
    fn set_map(&mut self, map: MapSettings) {
        if map != self.document.settings.map {
            self.scratch.map_view = Viewpoint::default();
        }
        self.document.settings.map = map;
    }

    /// Shows what `settings` say; where their scene cannot be had, a message. T runs on unless they give one.
    pub(super) fn show(&mut self, settings: Settings) {
        match settings.opened_scene() {
            Ok(scene) => self.show_in(settings, scene.into()),
            Err(error) => {
                self.tell(Notice::error(error).about(Path::new(&settings.scene)));
            }
        }
    }
}
