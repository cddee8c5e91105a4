//! Lines of sight of many pixels of one camera.

use glam::DVec3;
use relativity_core::math::sin_cos;
use std::f64::consts::PI;

use super::axes::Axes;
use super::mercator::Mercator;

/// The lines of sight of one camera, for many pixels: its angles are turned into vectors once.
#[derive(Debug, Clone, Copy)]
pub struct LinesOfSight {
    pub(crate) axes: Axes,
    pub(crate) focal_length_px: f64,
    pub(crate) map: DirectionMap,
}

/// The highest rectangle of a conformal picture whose middle row is found between the outer ones, radians.
const MOST_ROWS_AROUND: f64 = 3.0;

/// The map of a picture's places to directions.
#[derive(Debug, Clone, Copy)]
pub(crate) enum DirectionMap {
    /// On a plane, whose top left corner is there, in pixels.
    Flat { to_top_left: DVec3 },
    /// By longitude and latitude, a picture of this size being half of the sky.
    Round { size: [f64; 2] },
    /// Onto a conformal map of the sky.
    Mercator(Mercator),
}

impl LinesOfSight {
    /// Unit vector from the aperture through the point `[u, v]` of the picture, in pixels.
    #[must_use]
    pub fn through(&self, [u, v]: [f64; 2]) -> DVec3 {
        let Axes { right, up, forward } = self.axes;
        match self.map {
            DirectionMap::Flat { to_top_left } => (to_top_left + right * u - up * v).normalize(),
            DirectionMap::Round { size: [width, height] } => {
                let (sine, cosine) = sin_cos(PI * (u / width - 0.5));
                let (height, level) = sin_cos(PI * (0.5 - v / height));
                (forward * cosine + right * sine) * level + up * height
            }
            DirectionMap::Mercator(mercator) => mercator.line_of_sight(mercator.coordinates_at([u, v])),
        }
    }

    /// Unit vectors through the middle of the rectangle between these places of the picture, in pixels, and
    /// through its corners.
    pub(crate) fn around(&self, [left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> (DVec3, [DVec3; 4]) {
        if let DirectionMap::Mercator(mercator) = self.map {
            let [low, high] = [[left, bottom], [right, top]].map(|place| mercator.coordinates_at(place));
            if high.y - low.y < MOST_ROWS_AROUND {
                return mercator.lines_of_sight_around(low, high);
            }
        }
        let middle = self.through([0.5 * (left + right), 0.5 * (top + bottom)]);
        (
            middle,
            [[left, top], [right, top], [left, bottom], [right, bottom]].map(|place| self.through(place)),
        )
    }

    /// Returns the turn of the line of sight from this pixel to the one on the right, and to the one below.
    pub(crate) fn turns(&self, [u, v]: [f64; 2]) -> [DVec3; 2] {
        let Axes { right, up, .. } = self.axes;
        let DirectionMap::Flat { to_top_left } = self.map else { return self.turns_of(self.through([u, v])) };
        let unnormalised = to_top_left + right * u - up * v;
        let length = unnormalised.length();
        let sight = unnormalised / length;
        [right, -up].map(|across| (across - sight * sight.dot(across)) / length)
    }

    /// Returns the turns of the line of sight from the pixel in which it is `sight`.
    pub(crate) fn turns_of(&self, sight: DVec3) -> [DVec3; 2] {
        let Axes { right, up, forward } = self.axes;
        let across = |side: DVec3| side - sight * sight.dot(side);
        match self.map {
            DirectionMap::Flat { .. } => {
                [right, -up].map(|side| across(side) * (sight.dot(forward) / self.focal_length_px))
            }
            DirectionMap::Round { size: [width, height] } => {
                let along_row = right * sight.dot(forward) - forward * sight.dot(right);
                [along_row * (PI / width), across(-up).normalize_or_zero() * (PI / height)]
            }
            DirectionMap::Mercator(mercator) => mercator.turns(sight),
        }
    }
}
