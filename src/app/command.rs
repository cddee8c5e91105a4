//! Everything that can be done in the window, and the one place where it is done.

use std::path::{Path, PathBuf};

use relativity_render::{Camera, Gaze, Geometry};

use crate::app::clock;
use crate::app::file_dialog::purpose::Purpose;
use crate::app::files::reader::ReadFile;
use crate::app::lesson::session::LessonCommand;
use crate::app::measuring::angle_ruler::{AngleRuler, RulerCommand};
use crate::app::measuring::stopwatch::StopwatchCommand;
use crate::app::notice::Notice;
use crate::app::orders::{Copied, Order, Saving};
use crate::app::overlay::Overlay;
use crate::app::plots::look::PlotCommand;
use crate::app::pointer::{Pick, Select, Turn, Zoom};
use crate::app::riding::saddle::RideCommand;
use crate::app::screens::stage::{Part, next_to_show};
use crate::app::state::defaults::Section;
use crate::app::state::{Scratch, Session, State};
use crate::comfort::comfortable_separation;
use crate::eye::Eye;
use crate::flags::FieldOfView;
use crate::flags::choices::GazeChoice;
use crate::map::Viewpoint;
use crate::settings::{
    Daylight, FitSetup, Frame, Light, Look, Map, Motion, Picture, Playback, Plots, Presence, Preset, Quality,
    Screen, Settings, Window,
};
use crate::time_range::time_within;

/// Turn of the gaze for a press of a key, widths of a view.
pub const LOOK_STEP: f64 = 0.05;

/// A command of the user.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// New speed, separation or path.
    Motion(Motion),
    /// Get on the bicycle, ride, get off.
    Ride(RideCommand),
    /// New geometry, gaze or field of view.
    Look(Look),
    /// Another layout of the eyes' pictures, or another way to make files of them.
    Picture(Picture),
    /// Layouts further in the list of them, or back.
    NextLayout(isize),
    /// Shows conformal pictures, or if these are shown camera pictures, which look at the same.
    ToggleProjection,
    /// Shows the whole passage in one strip for each eye, or if that is shown two views.
    TogglePanorama,
    /// Outlines in conformal views what moves where it would be seen at rest, or no longer.
    ToggleResting,
    /// Shows few controls, or all.
    ToggleSimple,
    /// Swap the eyes of the present layout.
    SwapEyes,
    /// Compare the left eye's picture with the next other picture of it that can be shown.
    NextComparison,
    /// Sets the light.
    Light(Light),
    /// Another renderer, or another bound of it.
    Quality(Quality),
    /// New rate, range or looping.
    Playback(Playback),
    /// New choice of curves.
    Plots(Plots),
    /// Look at another part of the plots, or mark or keep something in them.
    Plotting(PlotCommand),
    /// Another face or frame of the map.
    Map(Map),
    /// Look at another part of the map.
    MapView(Viewpoint),
    /// New samples, or another way to fit them.
    Fit(FitSetup),
    /// New layout or theme.
    Window(Window),
    /// Another screen, or another place before it.
    Screen(Screen),
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
    /// Turn the gaze so that what is seen at a place is seen at another, and keep it there.
    Turn(Turn),
    /// Multiply the field of view; what is seen at a place stays there.
    Zoom(Zoom),
    /// Look aside: to the right and up, in widths of a view.
    LookAside([f64; 2]),
    /// Multiply the field of view; what is seen in the middle stays there.
    Magnify(f64),
    /// Hold the whole scene in the views.
    Frame,
    /// Frames the whole scene after a double click, whose first click may have picked a point: [`crate::app::undo`] takes that back.
    FollowAgain,
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
    /// Show or hide the map.
    ToggleMap,
    /// Draw the map in the other frame.
    ToggleFrame,
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
    ToggleMaximised(Part),
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
        self.scratch.missed = None;
        if command.sets_what_runs() {
            self.stop_run();
        }
        if command.shows_another() && self.session.overlay == Some(Overlay::Start) {
            self.session.overlay = None;
        }
        let settings = &mut self.document.settings;
        match command {
            Command::Motion(motion) => settings.motion = motion,
            Command::Ride(command) => self.apply_to_ride(command),
            Command::Look(look) => settings.look = look,
            Command::Picture(picture) => settings.picture = picture,
            Command::Value { name, value } => self.set_by_name(name, &value),
            Command::ToggleProjection => {
                settings.look.projection = settings.look.projection.toggled();
            }
            Command::TogglePanorama => {
                let default = self.defaults();
                self.document.settings.toggle_panorama(&default);
            }
            Command::ToggleSimple => settings.window.simple = !settings.window.simple,
            Command::ToggleResting => settings.window.resting = !settings.window.resting,
            Command::NextLayout(steps) => {
                settings.picture.layout = settings.picture.layout.further(steps);
            }
            Command::SwapEyes => self.swap_eyes(),
            Command::NextComparison => settings.compare_next(),
            Command::Light(light) => self.set_light(light),
            Command::Quality(quality) => settings.quality = quality,
            Command::Playback(playback) => settings.playback = playback,
            Command::Plots(plots) => settings.plots = plots,
            Command::Plotting(command) => self.apply_to_plots(command),
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
            Command::NudgeSpeed(steps) => {
                settings.motion.speed = settings.motion.speed.nudged(steps);
            }
            Command::Geometry(geometry) => settings.look.geometry = geometry,
            Command::Turn(turn) => self.turn(turn),
            Command::Zoom(zoom) => self.zoom(zoom),
            Command::Frame | Command::FollowAgain => {
                settings.look.gaze = GazeChoice::Whole;
                settings.look.fov = FieldOfView(None);
            }
            Command::LookAside(aside) => self.look_aside(aside),
            Command::Magnify(factor) => self.magnify(factor),
            Command::Pick(pick) => self.of_picture(pick.is_second, |state| state.pick(pick)),
            Command::Select(Select { track, body, add }) => self.document.points.choose(track, body, add),
            Command::Ruler(command) => self.apply_to_ruler(command),
            Command::Stopwatch(command) => self.apply_to_stopwatch(command),
            Command::FollowNext(steps) => self.follow_next(steps),
            Command::SelectPoint(index) => self.document.points.select(index),
            Command::RemovePoint(index) => self.document.points.remove(index),
            Command::Preset(name) => {
                self.show(Settings::clone(&self.document.settings).with_scene(name.to_owned()));
            }
            Command::State(preset) => {
                self.show(preset.settings.clone().in_place_of(&self.document.settings));
            }
            Command::ShowNext(steps) => self.show_next(steps),
            Command::Open(_) | Command::OpenData(_) | Command::Reload(_) => self.read_and_show(&command),
            Command::ShowFile(file) => self.show_file(*file),
            Command::Lesson(command) => self.apply_to_lesson(command),
            Command::Choose(purpose) => self.scratch.chooser = Some(purpose),
            // Not done here, but by who goes through the steps or reads.
            Command::Undo | Command::Redo | Command::StopReading => {}
            Command::Reset => self.show(self.with_defaults()),
            Command::ResetSection(section) => self.reset(section),
            Command::Simulate => self.session.data = None,
            Command::Save(saving) => {
                self.scratch.chooser = None;
                self.session.orders.push(Order::Save(saving));
            }
            Command::Copy(copied) => self.session.orders.push(Order::Copy(copied)),
            Command::StopSaving => self.session.orders.push(Order::Stop),
            Command::ToggleMap => {
                let is_shown = self.frame.shows_map;
                settings.window.map = if is_shown { Presence::Off } else { Presence::On };
            }
            Command::ToggleFrame => self.toggle_frame(),
            Command::Toggle(overlay) => self.toggle(overlay),
            Command::ToggleFullScreen => self.session.stage.full_screen = !self.session.stage.full_screen,
            Command::TogglePresenting => self.session.stage.toggle_presenting(),
            Command::ToggleProjector => self.session.stage.projector = !self.session.stage.projector,
            Command::ToggleStereoscope => {
                let stage = &mut self.session.stage;
                stage.stereoscope = !stage.stereoscope;
            }
            Command::ToggleMaximised(part) => self.session.stage.toggle_maximised(part),
            Command::CloseNotice => self.scratch.notice = None,
            Command::Close => self.close(),
        }
    }

    fn swap_eyes(&mut self) {
        let picture = &mut self.document.settings.picture;
        picture.swapped = picture.swapped.toggled(picture.layout);
    }

    fn toggle_frame(&mut self) {
        let frame = match self.document.settings.map.frame {
            Frame::Ground => Frame::Bicycle,
            Frame::Bicycle if self.document.settings.ride.is_on() => Frame::Rider,
            Frame::Bicycle | Frame::Rider => Frame::Ground,
        };
        self.set_map(Map { frame, ..self.document.settings.map });
    }

    fn show_next(&mut self, steps: i32) {
        if self.session.lesson.is_some() {
            let command = if steps > 0 { LessonCommand::Forward } else { LessonCommand::Back };
            self.apply_to_lesson(command);
        } else if let Some(preset) = next_to_show(self.document.preset, steps) {
            self.perform(Command::State(preset));
        }
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
                self.scratch.notice =
                    Some(Notice::error("No separation of the eyes makes these views comfortable."));
            }
        }
    }

    fn set_light(&mut self, light: Light) {
        if let Err(error) = self.set(Settings { light, ..Settings::clone(&self.document.settings) }) {
            self.scratch.notice = Some(Notice::error(error));
        }
    }

    fn set_window(&mut self, window: Window) {
        if window.theme != self.document.settings.window.theme {
            // Whatever a picture was made with: who changes the theme wants to see it.
            self.document.settings.light.light = Daylight::Theme;
        }
        self.document.settings.window = window;
    }

    /// Sets the map; another map is shown as a whole first.
    fn set_map(&mut self, map: Map) {
        if map != self.document.settings.map {
            self.scratch.map_view = Viewpoint::default();
        }
        self.document.settings.map = map;
    }

    fn step_in_time(&mut self, steps: i32) {
        let size = clock::step_size(self.time_range());
        // Onto the multiples of the step, so that stepping gives round times.
        let next = (self.document.time / size).round() + f64::from(steps);
        self.document.time = clock::bounded(next * size);
        self.scratch.playing = false;
    }

    fn go_within_range(&mut self, fraction: f64) {
        self.document.time = clock::bounded(time_within(self.time_range(), fraction));
    }

    fn toggle_playing(&mut self) {
        let [from, to] = self.time_range();
        self.scratch.playing = !self.scratch.playing;
        // Play at the end means play again.
        if self.scratch.playing && self.document.time >= to {
            self.document.time = from;
        }
    }

    fn magnify(&mut self, factor: f64) {
        let size = self.frame.picture_size;
        let pixel = size.map(|side| 0.5 * f64::from(side));
        self.zoom(Zoom { eye: Eye::Left, is_second: false, pixel, size, factor });
    }

    fn turn(&mut self, turn: Turn) {
        let camera = self.of_picture(turn.is_second, |state| state.view(turn.eye, turn.size).camera);
        self.stay_at(camera.gaze_with(camera.line_of_sight(turn.from), turn.to));
    }

    fn look_aside(&mut self, [across, up]: [f64; 2]) {
        let size = self.frame.picture_size;
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
        self.document.settings.look.fov = FieldOfView(Some(fov));
        let zoomed = Camera { horizontal_fov: fov.to_radians(), ..camera };
        self.stay_at(zoomed.gaze_with(direction, zoom.pixel));
    }

    /// Both eyes look there, in the observer's axes, from now on, with the present field of view.
    fn stay_at(&mut self, gaze: Gaze) {
        let gaze = self.rider().gaze_to_head(gaze);
        self.document.settings.look.fov = self.look().fov;
        let azimuth = gaze.azimuth.rem_euclid(std::f64::consts::TAU);
        self.document.settings.look.gaze = GazeChoice::fixed_at(Gaze { azimuth, ..gaze });
    }

    fn pick(&mut self, pick: Pick) {
        if self.predicts_by(&pick) {
            return;
        }
        if self.sees_as_published(pick.eye) {
            // The published right eye is defined point by point: no ray leads back.
            self.scratch.notice =
                Some(Notice::error("With the right eye as published, click in the left eye's view."));
            return;
        }
        let meant = self.meant(pick.eye, pick.pixel, pick.size);
        match meant.and_then(|pixel| self.point_at(pick.eye, pixel, pick.size)) {
            Some((track, body)) => {
                self.document.points.choose(track, body, pick.add);
                self.session.hint = false;
            }
            None => self.scratch.missed = Some(pick),
        }
    }

    fn follow_next(&mut self, steps: isize) {
        let scene = &self.document.scene;
        let body = self.document.points.selected().body.or_else(|| scene.tracked_body());
        let next = body.unwrap_or(0).wrapping_add_signed(steps);
        // Before the first comes the last.
        let count = scene.bodies.len();
        let next = if next >= count { if steps > 0 { 0 } else { count - 1 } } else { next };
        if let Some(track) = scene.track_on(next) {
            self.document.points.choose(track, next, false);
        }
    }

    /// Shows what `settings` say; where their scene cannot be had, a message. T runs on unless they give one.
    pub(super) fn show(&mut self, settings: Settings) {
        match settings.opened_scene() {
            Ok(scene) => self.show_in(settings, scene.into()),
            Err(error) => {
                let notice = Notice::error(error).about(Path::new(&settings.scene));
                self.scratch.notice = Some(notice);
            }
        }
    }
}
