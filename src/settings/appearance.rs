//! Light and exposure of a picture, and settings in which every automatic choice is made.

use relativity_render::light::exposure::automatic_ev;
use relativity_render::{Appearance, Motion, RelativeVelocity, Velocity};

use super::all::Settings;
use super::sections::{Daylight, LightSettings, Theme};
use super::views::Subject;
use crate::flags::Exposure;
use crate::scene::Scene;

impl Settings {
    /// Returns the appearance of `scene` at `time`, in a light window or a dark one.
    #[must_use]
    pub fn appearance(&self, scene: &Scene, time: f64, light_window: bool) -> Appearance {
        let exposure_ev = self.light.exposure.0.unwrap_or_else(|| self.automatic_ev(scene, time));
        self.appearance_at(exposure_ev, scene, light_window)
    }

    /// Returns the appearance of `scene` at this exposure, factors of 2.
    pub(crate) fn appearance_at(&self, exposure_ev: f64, scene: &Scene, light_window: bool) -> Appearance {
        Appearance { exposure_ev, ..self.unexposed(scene, light_window) }
    }

    /// Returns the appearance of `scene` without exposure.
    fn unexposed(&self, scene: &Scene, light_window: bool) -> Appearance {
        let light = &self.light;
        Appearance {
            colour: light.colour,
            temperature_k: light.temperature,
            doppler_shift: light.doppler_shift,
            intensity_exponent: light.intensity_exponent.0,
            exposure_ev: 0.0,
            invisible: light.invisible,
            shading: light.shading,
            ground_z: scene.ground_z.filter(|_| light.ground),
            road: scene.street.map(|[near, far, _]| [near, far]),
            fronts: scene.street.map(|[_, _, fronts]| fronts).filter(|_| light.surroundings),
            sky: light.sky,
            street: light.street_colours,
            light: scene.sunlit
                || match light.light {
                    Daylight::Theme => light_window,
                    Daylight::On => true,
                    Daylight::Off => false,
                },
        }
    }

    /// The exposure that is found for `scene`, factors of 2: of a ride, by its speed at `time`. Where the
    /// scene is in sunlight, eyes are adapted to what stands in it, not to what passes through.
    #[must_use]
    pub fn automatic_ev(&self, scene: &Scene, time: f64) -> f64 {
        let rider = self.rider(time);
        let stands = |motion: Motion| motion == Motion::Own(Velocity::REST);
        let exposed = scene.passing().filter(|group| !scene.sunlit || stands(group.motion));
        let lights = exposed.flat_map(|group| {
            let past = RelativeVelocity::new(self.velocity(group.motion), &rider.observer().velocity);
            let velocity = Velocity::forward(past.speed);
            scene.bodies[group.bodies()].iter().map(move |body| (velocity, body.emission))
        });
        automatic_ev(lights, self.geometry(), &self.unexposed(scene, false))
    }

    /// Returns these settings with a number for the automatic exposure of `scene` at their time; where two
    /// pictures are compared, each has its own.
    #[must_use]
    pub fn exposed_for(self, scene: &Scene) -> Self {
        if self.is_comparing() {
            return self;
        }
        let exposure = Exposure(
            self.light.exposure.0.or_else(|| Some(self.automatic_ev(scene, self.time.unwrap_or_default()))),
        );
        Self { light: LightSettings { exposure, ..self.light }, ..self }
    }

    /// Returns these settings with a number in place of everything automatic: all that decides the picture
    /// that `self` makes of this `subject`.
    #[must_use]
    pub fn resolved(&self, subject: Subject) -> Self {
        let time = self.time.unwrap_or_else(|| self.time_of_approach(&subject.tracked));
        let mut resolved = Self { time: Some(time), ..self.clone() };
        // One gaze could not be that of both pictures that are compared: each follows what it shows.
        if !self.is_comparing() {
            resolved.look = self.fixed_look(subject, time, self.picture.size.0);
        }
        if self.light.light == Daylight::Theme {
            resolved.light.light =
                if self.window.theme == Theme::Light { Daylight::On } else { Daylight::Off };
        }
        resolved
    }
}
