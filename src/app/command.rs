//! Everything that can be done in the window, and the one place where it is done.

use std::path::PathBuf;

use relativity_render::{Geometry, PreparedScene};

use super::clock;
use super::observer::{Eye, MAX_ELEVATION};
use super::points::Points;
use super::settings::{
    DEFAULT_FOV_DEGREES, FitSetup, GazeSetting, Light, Look, Motion, Playback, Plots, Quality, Window,
};
use super::state::State;
use crate::scene::Scene;

/// Narrowest and widest field of view, degrees.
pub const FOV_DEGREES: std::ops::RangeInclusive<f64> = 2.0..=150.0;

/// Something the user asked for.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// New speed, separation or path.
    Motion(Motion),
    /// New geometry, gaze or field of view.
    Look(Look),
    /// New colours.
    Light(Light),
    /// Another renderer, or another bound of it.
    Quality(Quality),
    /// New rate, range or looping.
    Playback(Playback),
    /// New choice of curves.
    Plots(Plots),
    /// New samples, or another way to fit them.
    Fit(FitSetup),
    /// New layout or theme.
    Window(Window),
    /// Go to this T.
    Time(f64),
    /// Steps of the scrubber, forwards or back.
    Step(i32),
    /// To the first (0) or the last (1) T, or in between.
    TimeInRange(f64),
    /// Play, or pause.
    TogglePlaying,
    /// Hundredths of the speed slider, up or down.
    NudgeSpeed(i32),
    /// Show this geometry.
    Geometry(Geometry),
    /// Turn the gaze by these angles (radians) and keep it there.
    Turn {
        /// Towards larger azimuth.
        azimuth: f64,
        /// Upwards.
        elevation: f64,
    },
    /// Multiply the field of view.
    Zoom(f64),
    /// Follow the selected point again, with the usual field of view.
    ResetLook,
    /// Select the point of the scene at a pixel of an eye's picture.
    Pick(Pick),
    /// Select a followed point.
    SelectPoint(usize),
    /// No longer follow a point.
    RemovePoint(usize),
    /// Show another preset.
    Preset(&'static str),
    /// Show the scene in a file.
    OpenScene(PathBuf),
    /// Show or hide the help.
    ToggleHelp,
    /// Close what can be closed.
    Close,
}

/// A click into a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pick {
    /// Whose picture.
    pub eye: Eye,
    /// Where, in pixels from the top left corner.
    pub pixel: [f64; 2],
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Whether to follow it beside the others.
    pub add: bool,
}

impl State {
    /// Does what was asked.
    pub fn apply(&mut self, command: Command) {
        match command {
            Command::Motion(motion) => self.set_motion(motion),
            Command::Look(look) => self.settings.look = look,
            Command::Light(light) => self.settings.light = light,
            Command::Quality(quality) => self.settings.quality = quality,
            Command::Playback(playback) => self.settings.playback = playback,
            Command::Plots(plots) => self.settings.plots = plots,
            Command::Fit(fit) => self.settings.fit = fit,
            Command::Window(window) => self.settings.window = window,
            Command::Time(time) => self.session.time = clock::bounded(time),
            Command::Step(steps) => self.step(steps),
            Command::TimeInRange(fraction) => self.go_to_fraction(fraction),
            Command::TogglePlaying => self.toggle_playing(),
            Command::NudgeSpeed(steps) => {
                self.settings.motion.speed = self.settings.motion.speed.nudged(steps);
            }
            Command::Geometry(geometry) => self.settings.look.geometry = geometry,
            Command::Turn { azimuth, elevation } => self.turn(azimuth, elevation),
            Command::Zoom(factor) => self.zoom(factor),
            Command::ResetLook => {
                self.settings.look.gaze = GazeSetting::Tracking;
                self.settings.look.fov_degrees = DEFAULT_FOV_DEGREES;
            }
            Command::Pick(pick) => self.pick(pick),
            Command::SelectPoint(index) => self.session.points.select(index),
            Command::RemovePoint(index) => self.session.points.remove(index),
            Command::Preset(name) => {
                if let Some(scene) = Scene::preset(name) {
                    self.show_scene(scene);
                }
            }
            Command::OpenScene(path) => match Scene::load(&path) {
                Ok(scene) => self.show_scene(scene),
                Err(error) => self.session.notice = Some(error.to_string()),
            },
            Command::ToggleHelp => self.session.help = !self.session.help,
            Command::Close => {
                self.session.help = false;
                self.session.notice = None;
            }
        }
    }

    fn set_motion(&mut self, motion: Motion) {
        self.settings.motion = motion;
        self.place_bodies();
    }

    fn step(&mut self, steps: i32) {
        let size = clock::step_size(self.time_range());
        // Onto the multiples of the step, so that stepping gives round times.
        let next = (self.session.time / size).round() + f64::from(steps);
        self.session.time = clock::bounded(next * size);
        self.session.playing = false;
    }

    fn go_to_fraction(&mut self, fraction: f64) {
        let [from, to] = self.time_range();
        self.session.time = clock::bounded(from * (1.0 - fraction) + to * fraction);
    }

    fn toggle_playing(&mut self) {
        let [from, to] = self.time_range();
        self.session.playing = !self.session.playing;
        // Play at the end means play again.
        if self.session.playing && self.session.time >= to {
            self.session.time = from;
        }
    }

    fn turn(&mut self, azimuth: f64, elevation: f64) {
        let gaze = self.gaze();
        self.settings.look.gaze = GazeSetting::Fixed {
            azimuth: (gaze.azimuth + azimuth).rem_euclid(std::f64::consts::TAU),
            elevation: (gaze.elevation + elevation).clamp(-MAX_ELEVATION, MAX_ELEVATION),
        };
    }

    fn zoom(&mut self, factor: f64) {
        let fov = self.settings.look.fov_degrees * factor;
        self.settings.look.fov_degrees = fov.clamp(*FOV_DEGREES.start(), *FOV_DEGREES.end());
    }

    fn pick(&mut self, pick: Pick) {
        if self.sees_as_published(pick.eye) {
            // The published right eye is defined point by point: no ray leads back.
            self.session.notice =
                Some("With the right eye as published, click in the left eye's view.".to_owned());
            return;
        }
        let view = self.view(pick.eye, pick.size, self.gaze());
        let line_of_sight = view.camera.line_of_sight(pick.pixel);
        let Some(hit) = PreparedScene::moving(&self.session.bodies).first_hit(&view, line_of_sight) else {
            return;
        };
        let [_, dy, dz] = self.shift();
        let [x, y, z] = hit.rest_position.to_array();
        let rest = [x, y - dy, z - dz];
        if pick.add {
            self.session.points.add(rest, hit.body);
        } else {
            self.session.points.replace_selected(rest, hit.body);
        }
    }

    fn show_scene(&mut self, scene: Scene) {
        self.session.points = Points::tracked(scene.tracked);
        self.session.scene = scene;
        self.session.notice = None;
        self.place_bodies();
        self.go_to_approach();
    }
}
