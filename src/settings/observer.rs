//! What the two eyes are shown of a scene with these settings: the one place where the window and `gamow render` have
//! it from.

use relativity_core::{Aperture, Disparity, DomainError, Model, SourcePoint, Speed};
use relativity_render::{Appearance, Camera, Gaze, Geometry, Motion, Velocity, View};

use super::all::Settings;
use super::sections::{Daylight, Theme};
use crate::flags::choices::GazeChoice;
use crate::passage;
use crate::scene::{Scene, SceneError, Track};

impl Settings {
    /// The scene that they name, with or without what rests around what moves.
    ///
    /// # Errors
    /// A scene that cannot be had.
    pub fn opened_scene(&self) -> Result<Scene, SceneError> {
        let scene = Scene::open(&self.scene)?;
        Ok(if self.light.surroundings { scene } else { scene.without_surroundings() })
    }

    /// The speed of the scene.
    #[must_use]
    pub const fn speed(&self) -> Speed {
        self.motion.speed.speed()
    }

    /// Where the left and the right eye rest, in the scene's coordinates: it passes further away or higher where they
    /// stand back or lower.
    #[must_use]
    pub fn apertures(&self) -> [Aperture; 2] {
        let [y, z] = [0.0 - self.motion.depth_shift, 0.0 - self.motion.height_shift];
        Aperture::pair(self.motion.d).map(|aperture| Aperture { y, z, ..aperture })
    }

    /// The place `rest` in the scene, from the point between the eyes.
    #[must_use]
    pub fn rest_place(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [x, y + self.motion.depth_shift, z + self.motion.height_shift]
    }

    /// The velocity of what moves so.
    #[must_use]
    pub const fn velocity(&self, motion: Motion) -> Velocity {
        match motion {
            Motion::Scene => Velocity::forward(self.speed()),
            Motion::Own(velocity) => velocity,
        }
    }

    /// The worldline of `point` from the point between the eyes, reflected to move along +x.
    #[must_use]
    pub fn source(&self, point: &Track) -> SourcePoint {
        self.velocity(point.motion).reflected_source(self.rest_place(point.rest))
    }

    /// What the eyes see of `point` at `observation_time`, exactly.
    ///
    /// # Errors
    /// A time outside the domain of the core.
    pub fn disparity(&self, point: &Track, observation_time: f64) -> Result<Disparity, DomainError> {
        let place = self.rest_place(point.rest);
        self.velocity(point.motion).disparity(Model::Exact, place, self.motion.d, observation_time)
    }

    /// The T of a picture for which none is given: when `point` is seen 45 degrees before it is abreast.
    #[must_use]
    pub fn time_of_approach(&self, point: &Track) -> f64 {
        let speed = self.velocity(point.motion).speed;
        // Settings lie inside the domain of the core.
        passage::time_of_approach(&speed, self.source(point), self.motion.d).unwrap_or_default()
    }

    /// What the left and the right eye are shown at `observation_time`, `size` in pixels; a gaze that tracks follows
    /// the point `tracked`.
    #[must_use]
    pub fn views(&self, tracked: &Track, observation_time: f64, size: [u32; 2]) -> [View; 2] {
        let mut views = self.views_ahead(observation_time, size);
        let gaze = self.fixed_gaze(tracked, observation_time);
        for view in &mut views {
            view.camera.gaze = gaze.fixed().unwrap_or(Gaze::STRAIGHT_AHEAD);
        }
        views
    }

    /// Where both eyes look at `observation_time`, as a gaze that stays there: in degrees, from which a view's angles
    /// are made, so that a recorded gaze gives the same view to the last digit.
    #[must_use]
    pub fn fixed_gaze(&self, tracked: &Track, observation_time: f64) -> GazeChoice {
        let GazeChoice::Track = self.look.gaze else { return self.look.gaze };
        let place = |view: View| view.of_group(tracked.motion).apparent_position(tracked.rest.into());
        let [left, right] = self.views_ahead(observation_time, [1, 1]).map(place);
        let gaze = left.zip(right).and_then(|(left, right)| Gaze::towards([left, right]));
        // Inside an aperture there is no direction to follow.
        GazeChoice::fixed_at(gaze.unwrap_or(Gaze::STRAIGHT_AHEAD))
    }

    /// The views of eyes that look straight ahead.
    fn views_ahead(&self, observation_time: f64, size: [u32; 2]) -> [View; 2] {
        let geometry = self.look.geometry;
        let view = |aperture, geometry| {
            let horizontal_fov = self.look.fov.to_radians();
            let camera = Camera { aperture, gaze: Gaze::STRAIGHT_AHEAD, horizontal_fov, size };
            View { camera, speed: self.speed(), observation_time, geometry }
        };
        let [left, right] = self.apertures();
        // The published right eye's view is from the left eye's camera.
        let right = if geometry == Geometry::Published { left } else { right };
        [view(left, geometry.of_left_eye()), view(right, geometry)]
    }

    /// What becomes of the light of `scene`, in a light window or a dark one.
    #[must_use]
    pub fn appearance(&self, scene: &Scene, light_window: bool) -> Appearance {
        let light = &self.light;
        Appearance {
            colour: light.colour,
            doppler_shift: light.doppler_shift,
            intensity_exponent: light.intensity_exponent.0,
            exposure_ev: light.exposure,
            shading: light.shading,
            ground_z: scene.ground_z.filter(|_| light.ground),
            road: scene.road,
            sky: light.sky,
            light: match light.light {
                Daylight::Theme => light_window,
                Daylight::On => true,
                Daylight::Off => false,
            },
        }
    }

    /// These settings with nothing left to be found out: everything that decides the picture that `self` makes of a scene
    /// with this `tracked` point.
    #[must_use]
    pub fn resolved(&self, tracked: &Track) -> Self {
        let time = self.time.unwrap_or_else(|| self.time_of_approach(tracked));
        let mut resolved = Self { time: Some(time), ..self.clone() };
        resolved.look.gaze = self.fixed_gaze(tracked, time);
        if self.light.light == Daylight::Theme {
            resolved.light.light =
                if self.window.theme == Theme::Light { Daylight::On } else { Daylight::Off };
        }
        resolved
    }
}
