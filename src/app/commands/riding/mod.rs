//! Riding in the window: getting on and off, pedals and brakes.

pub mod keys;
pub mod thumbs;

use relativity_core::math;
use relativity_render::Colour;

use crate::app::state::State;
use crate::app::state::notice::Notice;
use crate::app::state::riding::comfort::RideComfort;
use crate::app::state::riding::saddle::{Push, PushDirection, RideCommand, Saddle};
use crate::app::tools::clock;
use crate::flags::choices::{Compare, GazeChoice, Layout};
use crate::flags::{FieldOfView, RideLegs, SpeedParameter, SpeedSetting, StreetVelocity};
use crate::settings::{LookSettings, MotionSettings, Riding, Settings};

/// The view ahead from the saddle, degrees.
const FOV: f64 = 90.0;
/// Speed of the cyclist ahead, in c.
const BETA_AHEAD: f64 = 0.5;
/// Place x where one gets on: what passes x = 0 at T = 0 is still ahead.
const START: f64 = -20.0;

impl State {
    /// Performs a command of the rider.
    pub(super) fn perform_ride(&mut self, command: RideCommand) {
        match command {
            RideCommand::Toggle if self.document.settings.ride.is_on() => self.get_off(),
            RideCommand::Toggle => self.get_on(),
            RideCommand::Set(ride) => {
                if ride.is_on() != self.document.settings.ride.is_on() {
                    self.scratch.saddle = Saddle::default();
                }
                self.set_or_tell(Settings { ride, ..Settings::clone(&self.document.settings) });
            }
            RideCommand::Reach(velocity) => self.pedal_to(velocity),
            RideCommand::Face => self.face(),
            RideCommand::Remind => {
                let requests = &mut self.scratch.saddle.requests;
                *requests = requests.wrapping_add(1);
            }
            RideCommand::Push(direction, step) => self.push(direction, step),
        }
    }

    /// Opens the street in daylight, with a cyclist who can be overtaken, and seats the observer on a bicycle
    /// there.
    pub(super) fn ride_through_the_street(&mut self) {
        let mut settings = Settings::default().in_place_of(&self.document.settings);
        settings.motion.speed =
            SpeedSetting::new(SpeedParameter::Beta, BETA_AHEAD).unwrap_or(SpeedSetting::REST);
        settings.light.colour = Colour::White;
        self.show(settings);
        self.get_on();
    }

    /// Seats the observer on a bicycle at rest in the middle of the road, facing +x, with one large picture
    /// in place of two apart.
    fn get_on(&mut self) {
        let across = self.document.scene.street.map_or(0.0, |[near, far, _]| 0.5 * (near + far));
        let mut settings = Settings::clone(&self.document.settings);
        let legs = RideLegs::from_legs(Vec::new()).expect("it has no legs");
        let push = settings.ride.push;
        settings.ride = Riding { ride: legs, ride_from: START, push, ..Riding::default() };
        settings.motion = MotionSettings {
            roll: 0.0,
            turn: -90.0,
            depth_shift: -across,
            height_shift: 0.0,
            ..settings.motion
        };
        let (gaze, fov) = (GazeChoice::Fixed([0.0, -12.0]), FieldOfView(Some(FOV)));
        settings.look = LookSettings { gaze, fov, ..settings.look };
        let layout_before = Some(settings.picture.layout);
        if settings.picture.layout.shows_two_apart() {
            settings.picture.layout = Layout::Left;
        }
        self.set_or_tell(settings);
        self.document.time = 0.0;
        self.scratch.saddle = Saddle { is_taken: true, layout_before, ..Saddle::default() };
        self.scratch.playing = true;
    }

    /// Turns head and gaze to where the rider moves, level; at rest along the line of the ride.
    fn face(&mut self) {
        let (rider, elevation) = (self.rider(), self.gaze().elevation.to_degrees());
        let settings = &mut self.document.settings;
        if !settings.ride.is_on() {
            return;
        }
        let [ahead, left, _] =
            rider.ahead.map(|part| if rider.velocity.is_backward { 0.0 - part } else { part });
        let azimuth = settings.ride.ride_azimuth + math::atan2(left, ahead).to_degrees();
        settings.motion.turn = (azimuth + 90.0).rem_euclid(360.0) - 180.0;
        settings.look.gaze = GazeChoice::Fixed([azimuth.rem_euclid(360.0), elevation]);
    }

    /// Puts the observer back beside the street.
    fn get_off(&mut self) {
        let default = self.defaults();
        let default = if default.ride.is_on() { Settings::default() } else { default };
        let mut settings = Settings::clone(&self.document.settings);
        settings.ride = Riding { push: settings.ride.push, ..Riding::default() };
        let MotionSettings { roll, turn, depth_shift, height_shift, .. } = default.motion;
        settings.motion = MotionSettings { roll, turn, depth_shift, height_shift, ..settings.motion };
        settings.look = LookSettings { gaze: default.look.gaze, fov: default.look.fov, ..settings.look };
        if settings.look.compare == Compare::Standing {
            settings.look.compare = Compare::Off;
        }
        if settings.picture.layout == Layout::Left {
            settings.picture.layout = self.scratch.saddle.layout_before.unwrap_or(default.picture.layout);
        }
        self.set_or_tell(settings);
        self.scratch.saddle = Saddle::default();
        let tracked = self.document.points.selected().track;
        self.document.time = clock::bounded(self.document.settings.time_of_approach(&tracked));
    }

    /// Pedals or brakes until this speed is reached, for which T runs; who has not started yet starts with
    /// it.
    pub(super) fn pedal_to(&mut self, velocity: StreetVelocity) {
        let ride = &self.document.settings.ride;
        let has_legs = ride.turns().next().is_some();
        if !has_legs && self.document.time <= 0.0 {
            self.document.settings.ride.ride_speed = velocity;
            return;
        }
        let rider = self.rider();
        let gained = velocity.rapidity() - rider.velocity.rapidity();
        if gained != 0.0 {
            let acceleration = rider.ahead.map(|part| part * ride.push.copysign(gained));
            self.record(ride.pushed(self.document.time, gained.abs() / ride.push, acceleration));
            self.scratch.saddle.is_taken = true;
            self.scratch.playing = true;
        }
    }

    fn push(&mut self, direction: PushDirection, step: f64) {
        let (rider, time) = (self.rider(), self.document.time);
        let held = self.scratch.saddle.push.filter(|push| push.direction == direction);
        let looks = |ride: &Riding| self.gaze().azimuth.to_degrees() - ride.ride_azimuth;
        let ride = &self.document.settings.ride;
        let begun = Push::new(direction, looks(ride), &rider);
        // Who walks pushes elsewhere as the head turns; pedals push along the motion that they began with.
        let is_held =
            |held: &Push| !matches!(direction, PushDirection::Beside(_)) || held.towards == begun.towards;
        let push = held.filter(is_held).unwrap_or(begun);
        let duration = push.duration(step, ride.push, &rider);
        // The ride starts at 0, and before that it moves as it starts.
        let ridden = (time >= 0.0 && duration > 0.0)
            .then(|| ride.pushed(time, duration, push.towards.map(|part| part * ride.push)));
        self.scratch.saddle = Saddle { is_taken: true, push: Some(push), ..self.scratch.saddle };
        if let Some(ridden) = ridden {
            self.record(ridden);
        }
        self.document.time = clock::bounded(time + step);
    }

    /// Has the ride that was ridden on, unless that cannot be. Who leaves the street leaves the bicycle
    /// there.
    fn record(&mut self, ride: Result<Riding, String>) {
        match ride {
            Ok(ride) if ride.has_bicycle() == self.document.settings.ride.has_bicycle() => {
                self.document.settings.ride = ride;
            }
            Ok(ride) => self.set_or_tell(Settings { ride, ..Settings::clone(&self.document.settings) }),
            Err(reason) => self.tell(Notice::error(format!("No further push: {reason}."))),
        }
    }

    /// Lets exposure and vignette follow the ride for this many `seconds`; whether they are still on their
    /// way.
    pub(in crate::app) fn follow_for_comfort(&mut self, seconds: f64) -> bool {
        let settings = &self.document.settings;
        if !settings.ride.is_on() {
            self.scratch.comfort = RideComfort::default();
            return false;
        }
        let target = settings.automatic_ev(&self.document.scene, self.document.time);
        let (gaze, has_vignette) = (settings.look.gaze, settings.window.vignette);
        self.scratch.comfort = self.scratch.comfort.after(seconds, target, gaze, has_vignette);
        self.scratch.comfort.is_on_its_way(target)
    }
}
