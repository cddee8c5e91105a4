//! What the window shows: settings that are remembered, and the session they are applied to.

use std::sync::Arc;

use relativity_core::Speed;
use relativity_render::{Appearance, Body};

use super::clock;
use super::points::{Point, Points};
use super::settings::Settings;
use crate::scene::Scene;

/// Everything the panels read. Only [`super::command`] changes it.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Remembered.
    pub settings: Settings,
    /// Forgotten at the end.
    pub session: Session,
}

/// What lasts as long as the window.
#[derive(Debug, Clone, PartialEq)]
pub struct Session {
    /// What rides past, at rest, as its file says.
    pub scene: Scene,
    /// Its bodies where the shifted path has them; kept since every frame needs them.
    pub bodies: Arc<[Body]>,
    /// T.
    pub time: f64,
    /// Whether T runs.
    pub playing: bool,
    /// The followed points.
    pub points: Points,
    /// Whether the help is shown.
    pub help: bool,
    /// A message about the last thing that could not be done.
    pub notice: Option<String>,
}

impl State {
    /// The state at start: the scene with its own point selected, shortly before it passes.
    #[must_use]
    pub fn new(settings: Settings, scene: Scene) -> Self {
        let points = Points::tracked(scene.tracked);
        let session = Session {
            bodies: Arc::default(),
            time: 0.0,
            playing: false,
            points,
            help: false,
            notice: None,
            scene,
        };
        let mut state = Self { settings, session };
        state.place_bodies();
        state.go_to_approach();
        state
    }

    /// The speed of the scene.
    #[must_use]
    pub fn speed(&self) -> Speed {
        self.settings.motion.speed.speed()
    }

    /// First and last T of the scrubber and the plots.
    #[must_use]
    pub fn time_range(&self) -> [f64; 2] {
        self.settings
            .playback
            .range
            .unwrap_or_else(|| clock::fitted_range(&self.speed(), self.selected_source()))
    }

    /// Goes to a T at which the selected point is seen shortly before it passes.
    pub fn go_to_approach(&mut self) {
        let time = clock::time_of_approach(&self.speed(), self.selected_source());
        let step = clock::step_size(self.time_range());
        self.session.time = (time / step).round() * step;
    }

    /// How far the path is from where the scene has it: along y and z.
    #[must_use]
    pub fn shift(&self) -> [f64; 3] {
        let motion = &self.settings.motion;
        [0.0, motion.depth_shift, motion.height_shift]
    }

    /// Moves the bodies to where the path now is.
    pub fn place_bodies(&mut self) {
        let shift = self.shift();
        self.session.bodies = self.session.scene.bodies_moved(shift).into();
    }

    /// Wavelength at rest of the light of `point`, nm: of the body it was picked on, else of the first.
    #[must_use]
    pub fn rest_wavelength_nm(&self, point: &Point) -> f64 {
        let bodies = &self.session.bodies;
        let body = point.body.and_then(|body| bodies.get(body)).or(bodies.first());
        body.map_or(f64::NAN, |body| body.rest_wavelength_nm)
    }

    /// The looks of a view, in a light window or a dark one.
    #[must_use]
    pub fn appearance(&self, light_window: bool) -> Appearance {
        let light = &self.settings.light;
        let ground_z = self.session.scene.ground_z.filter(|_| light.ground);
        Appearance {
            colour: light.colour,
            doppler_shift: light.doppler_shift,
            intensity_exponent: light.intensity_exponent,
            exposure_ev: light.exposure_ev,
            shading: light.shading,
            ground_z: ground_z.map(|z| z + self.settings.motion.height_shift),
            sky: light.sky,
            light: light_window,
        }
    }
}
