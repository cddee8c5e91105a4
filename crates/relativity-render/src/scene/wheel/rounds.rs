//! The first entry of a ray into a body that turns, in rounds, as the rays on the GPU find what is no tube (`turning.wgsl`).
//! Spokes they find as `course.wgsl` says, which costs about as much and passes no entry.
//!
//! In the frame that turns with the body the ray is a curve (see `solid.rs`). A round takes its tangent for it,
//! and the next one the tangent where that met the body, or passed it: what is off is about squared each time. Where the
//! body turns far while the ray is among what it sweeps, that is done in several parts of the ray, from the middle of
//! each. Nothing says that an entry so found is the first one; how far off they are [`PreparedScene::turned_entry`] tells.

use glam::DVec3;

use super::solid::{TurningRay, TurningSolid};
use crate::geometry::intersect::Solid;
use crate::geometry::ray::Ray;
use crate::scene::prepared_scene::PreparedScene;
use crate::view::group_view::GroupView;

/// A part of the ray in which the body turns by no more than this, radians.
const LONGEST_PART: f64 = 0.4;
/// Greatest number of parts.
const MOST_PARTS: f64 = 5.0;

/// A search for the entry into a body that turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Search {
    /// Exact, as in the reference: the first entry, to 1e-12 of the body's size.
    Exact,
    /// In this number of rounds, 1 or more.
    Rounds(u32),
}

impl PreparedScene {
    /// Whether the body of this number turns and has another shape or place for it, as the spokes of a wheel do; models have no rounds.
    #[must_use]
    pub fn is_turned(&self, body: usize) -> bool {
        self.turning(body).is_some() && self.triangles(body).is_none()
    }

    /// Returns the first entry of the camera's `line_of_sight` into the body of this number, which `view` shows: the length along the ray
    /// in the rest frame, from near the middle of the group. `None` if it misses, or if [`Self::is_turned`] does not hold.
    ///
    /// # Accuracy
    ///
    /// `tests/rounds.rs`, spokes at beta 0.1 to 0.999. Of rays at more than 20 degrees to the wheel's plane, 99 % are off by at
    /// most 5e-4 radii after one round, by 2e-7 after two, by 1e-13 after three; the worst by 4e-3, by 2e-5, by 1e-9. Of
    /// rays nearer to that plane three rounds lead 5 % to a later entry: these stay off, by tenths of a radius.
    #[must_use]
    pub fn turned_entry(
        &self,
        body: usize,
        view: &GroupView,
        line_of_sight: DVec3,
        search: Search,
    ) -> Option<f64> {
        let turning = self.turning(body).filter(|_| self.triangles(body).is_none())?;
        let ray = view.rest_ray(line_of_sight);
        let near = Ray::new(ray.origin, ray.direction)
            .counted_from(self.groups()[self.group_of(body)].extent.middle);
        match search {
            Search::Exact => {
                self.turning_entry(body, turning, &near, view, None).0.map(|entry| entry.distance)
            }
            Search::Rounds(rounds) => turning.entry_in_rounds(&near, view, rounds),
        }
    }
}

impl TurningSolid {
    /// Searches along `ray` in this number of rounds.
    fn entry_in_rounds(&self, ray: &Ray, view: &GroupView, rounds: u32) -> Option<f64> {
        let (local, from_start) = self.local_ray(ray);
        let [first, last] = self.reach_along(&local)?;
        let course = TurningRay::new(self, &local, view, local.behind.max(0.0));
        let parts = (course.rate.abs() * (last - first) / LONGEST_PART).ceil().clamp(1.0, MOST_PARTS);
        let length = (last - first) / parts;
        let entry = |i: u32| course.entry_near(first + f64::from(i) * length, length, rounds);
        let found = (0..parts as u32).filter_map(entry).filter(|&s| s > local.behind);
        found.reduce(f64::min).map(|s| from_start + s)
    }
}

impl TurningRay<'_> {
    /// Searches in this number of rounds from the middle of the part of the ray that begins at `low`.
    fn entry_near(&self, low: f64, length: f64, rounds: u32) -> Option<f64> {
        let mut s = low + 0.5 * length;
        let mut found = None;
        for _ in 0..rounds {
            let [place, slope] = self.at(s);
            let rate = slope.length();
            let tangent = Ray {
                start: self.solid().center + place,
                direction: slope / rate,
                from_camera: f64::INFINITY,
            };
            let entry = self.solid().entry(&tangent).map(|entry| entry.distance);
            let step = entry.unwrap_or_else(|| self.solid().passed_at(&tangent)) / rate;
            s = (s + step).clamp(low - length, low + 2.0 * length);
            found = entry.map(|_| s);
        }
        found
    }
}

impl Solid {
    /// Returns the place where `ray` passes the line within which it lies most closely.
    fn passed_at(&self, ray: &Ray) -> f64 {
        let ([from, to], _) = self.core();
        let along = to - from;
        let flat = along.reject_from(ray.direction);
        let offset = (ray.start - from).reject_from(ray.direction);
        let share = offset.dot(flat) / flat.length_squared().max(f64::MIN_POSITIVE);
        let nearest = from + along * share.clamp(0.0, 1.0);
        (nearest - ray.start).dot(ray.direction)
    }
}
