//! Where points of the bodies appear, in f64: what the vertex stage repeats in f32.

use glam::DVec3;
use relativity_core::Speed;

use crate::camera::Axes;
use crate::view::{Geometry, View};

/// The map from rest-frame places to apparent positions, and the camera they are seen with.
#[derive(Debug, Clone, Copy)]
pub struct Map {
    pub geometry: Geometry,
    origin: DVec3,
    speed: Speed,
    separation: f64,
    pub axes: Axes,
    pub focal_length_px: f64,
}

impl Map {
    pub fn new(view: &View) -> Self {
        Self {
            geometry: view.geometry,
            origin: view.rest_origin(),
            speed: view.speed,
            separation: view.published_separation(),
            axes: view.camera.gaze.axes(),
            focal_length_px: view.camera.focal_length_px(),
        }
    }

    /// Where the rest-frame point `place` appears, from the aperture.
    pub fn apparent(&self, place: DVec3) -> DVec3 {
        let c = place - self.origin;
        match self.geometry {
            Geometry::Seen => self.seen(c),
            Geometry::Contracted => DVec3::new(c.x / self.speed.gamma(), c.y, c.z),
            Geometry::Rest => c,
            Geometry::Published => {
                let shift = self.speed.gamma() * self.speed.beta() * self.delay(self.seen(c));
                self.seen(c - DVec3::X * shift)
            }
        }
    }

    /// `X = gamma (c_x - beta |c|)`, for `c_x > 0` as a quotient of what does not cancel.
    fn seen(&self, c: DVec3) -> DVec3 {
        let (beta, gamma) = (self.speed.beta(), self.speed.gamma());
        let distance = c.length();
        if c.x <= 0.0 {
            return DVec3::new(gamma * (c.x - beta * distance), c.y, c.z);
        }
        let along = c.x * c.x * self.speed.inverse_gamma_squared();
        let across = beta * beta * (c.y * c.y + c.z * c.z);
        DVec3::new(gamma * (along - across) / (c.x + beta * distance), c.y, c.z)
    }

    /// The paper's Delta T (eq. 5) for what the left eye sees at `left`.
    fn delay(&self, left: DVec3) -> f64 {
        let event_x = left.x - 0.5 * self.separation;
        let to_right = left - DVec3::X * self.separation;
        -2.0 * event_x * self.separation / (left.length() + to_right.length())
    }
}
