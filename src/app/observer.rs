//! What the two eyes make of the state: sightings of the followed points, gaze, cameras, markers.

use glam::DVec3;
use relativity_core::{
    Aperture, Disparity, Model, Parameter, PublishedVariant, Sighting, SourcePoint, Speed, equidistance_time,
    sighting,
};
use relativity_render::{Camera, Gaze, Geometry, View};

use super::curves::Key;
use super::fitting;
use super::points::Point;
use super::settings::GazeSetting;
use super::state::State;

/// One of the two eyes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Eye {
    /// The primary aperture, at (-d/2, 0, 0).
    Left,
    /// The secondary aperture, at (+d/2, 0, 0).
    Right,
}

impl Eye {
    /// Left, then right, as everywhere on screen.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// Its place in [`Self::BOTH`].
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::Left => 0,
            Self::Right => 1,
        }
    }

    /// What it is called.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Left => "Left eye",
            Self::Right => "Right eye",
        }
    }
}

/// Straight ahead: along +y.
pub const STRAIGHT_AHEAD: Gaze = Gaze { azimuth: std::f64::consts::FRAC_PI_2, elevation: 0.0 };

/// Steepest elevation of the gaze: at the zenith itself no horizon is level.
pub const MAX_ELEVATION: f64 = 89.5 * std::f64::consts::PI / 180.0;

/// By which speed a picture is corrected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction {
    /// The speed.
    pub speed: Speed,
    /// Whether it was found by the fit; else it is the scene's own.
    pub is_fitted: bool,
}

impl State {
    /// The speed found by `fit`, or the scene's own without one.
    #[must_use]
    pub fn correction(&self, fit: Option<&fitting::Outcome>) -> Correction {
        let beta = fit.and_then(|outcome| outcome.fitted.as_ref().ok()?.value(Parameter::Beta));
        match beta.and_then(|beta| Speed::from_beta(beta).ok()) {
            Some(speed) => Correction { speed, is_fitted: true },
            None => Correction { speed: self.speed(), is_fitted: false },
        }
    }

    /// The aperture of `eye`.
    #[must_use]
    pub fn aperture(&self, eye: Eye) -> Aperture {
        Aperture::pair(self.settings.motion.separation)[eye.index()]
    }

    /// Rest coordinates of `point` on the shifted path.
    #[must_use]
    pub fn rest_place(&self, point: &Point) -> [f64; 3] {
        let [_, dy, dz] = self.shift();
        let [x, y, z] = point.rest;
        [x, y + dy, z + dz]
    }

    /// The worldline of `point`.
    #[must_use]
    pub fn source(&self, point: &Point) -> SourcePoint {
        SourcePoint::from_rest(self.rest_place(point), &self.speed())
    }

    /// The worldline of the selected point.
    #[must_use]
    pub fn selected_source(&self) -> SourcePoint {
        self.source(self.session.points.selected())
    }

    /// What `eye` sees of `point` now; `None` outside the domain of the core.
    #[must_use]
    pub fn sighting(&self, point: &Point, eye: Eye) -> Option<Sighting> {
        sighting(&self.speed(), self.source(point), self.aperture(eye), self.session.time).ok()
    }

    /// The exact disparity of `point` now.
    #[must_use]
    pub fn disparity(&self, point: &Point) -> Option<Disparity> {
        self.disparity_in(Model::Exact, point)
    }

    fn disparity_in(&self, model: Model, point: &Point) -> Option<Disparity> {
        let separation = self.settings.motion.separation;
        model.disparity(&self.speed(), self.source(point), separation, self.session.time).ok()
    }

    /// T0 of `point`: when both eyes see it at the same distance. `None` at rest.
    #[must_use]
    pub fn equidistance_time(&self, point: &Point) -> Option<f64> {
        equidistance_time(&self.speed(), self.source(point), self.settings.motion.separation).ok().flatten()
    }

    /// Whether `eye` sees what the published model has the right eye see, measured from the left aperture.
    #[must_use]
    pub fn sees_as_published(&self, eye: Eye) -> bool {
        let look = &self.settings.look;
        eye == Eye::Right && look.right_as_published && look.geometry == Geometry::Seen
    }

    /// The published model's apparent position of `point` for the right eye, from the left aperture.
    fn published_position(&self, point: &Point) -> Option<[f64; 3]> {
        let model = Model::Published(PublishedVariant::AppendixA);
        Some(self.disparity_in(model, point)?.secondary.position)
    }

    /// From the aperture of `eye` to where the shown geometry has `point` now.
    #[must_use]
    pub fn direction(&self, point: &Point, eye: Eye) -> Option<DVec3> {
        self.direction_in(self.settings.look.geometry, point, eye)
    }

    fn direction_in(&self, geometry: Geometry, point: &Point, eye: Eye) -> Option<DVec3> {
        let aperture = self.aperture(eye);
        let source = self.source(point);
        let direction = match geometry {
            Geometry::Seen | Geometry::Published if self.sees_as_published(eye) => {
                DVec3::from(self.published_position(point)?)
            }
            Geometry::Seen | Geometry::Published => DVec3::from(self.sighting(point, eye)?.position),
            Geometry::Contracted => {
                let x = (source.x0 - aperture.x) + self.speed().beta() * self.session.time;
                DVec3::new(x, source.y, source.z)
            }
            Geometry::Rest => {
                DVec3::from(self.rest_place(point)) - self.view(eye, [1, 1], STRAIGHT_AHEAD).rest_origin()
            }
        };
        direction.is_finite().then_some(direction)
    }

    /// What the curves of `point` depend on.
    #[must_use]
    pub fn curve_key(&self, point: &Point) -> Key {
        Key {
            speed: self.speed(),
            source: self.source(point),
            separation: self.settings.motion.separation,
            range: self.time_range(),
            published: self.settings.plots.published,
        }
    }

    /// What the fit of the selected point depends on.
    #[must_use]
    pub fn fit_key(&self) -> fitting::Key {
        fitting::Key {
            speed: self.speed(),
            source: self.selected_source(),
            separation: self.settings.motion.separation,
            range: self.settings.fit.range.unwrap_or_else(|| self.time_range()),
            setup: self.settings.fit,
        }
    }

    /// Where both eyes look now, in parallel.
    #[must_use]
    pub fn gaze(&self) -> Gaze {
        self.gaze_in(self.settings.look.geometry)
    }

    fn gaze_in(&self, geometry: Geometry) -> Gaze {
        match self.settings.look.gaze {
            GazeSetting::Fixed { azimuth, elevation } => Gaze { azimuth, elevation },
            GazeSetting::Tracking => self.tracking_gaze(geometry).unwrap_or(STRAIGHT_AHEAD),
        }
    }

    /// At the selected point: the mean of its two apparent directions. `None` inside an aperture.
    fn tracking_gaze(&self, geometry: Geometry) -> Option<Gaze> {
        let point = self.session.points.selected();
        let mut sum = DVec3::ZERO;
        for eye in Eye::BOTH {
            sum += self.direction_in(geometry, point, eye)?.try_normalize()?;
        }
        let Gaze { azimuth, elevation } = Gaze::along(sum.try_normalize()?.to_array());
        Some(Gaze { azimuth, elevation: elevation.clamp(-MAX_ELEVATION, MAX_ELEVATION) })
    }

    /// The picture that is corrected: what the left eye sees, whichever geometry is shown.
    #[must_use]
    pub fn view_to_correct(&self, size: [u32; 2]) -> View {
        let view = self.view(Eye::Left, size, self.gaze_in(Geometry::Seen));
        View { geometry: Geometry::Seen, ..view }
    }

    /// The picture of `eye` that looks along `gaze`, `size` in pixels.
    #[must_use]
    pub fn view(&self, eye: Eye, size: [u32; 2], gaze: Gaze) -> View {
        let published = self.sees_as_published(eye);
        let camera = Camera {
            aperture: self.aperture(if published { Eye::Left } else { eye }),
            gaze,
            horizontal_fov: self.settings.look.fov_degrees.to_radians(),
            size,
        };
        View {
            camera,
            speed: self.speed(),
            observation_time: self.session.time,
            geometry: if published { Geometry::Published } else { self.settings.look.geometry },
        }
    }
}
