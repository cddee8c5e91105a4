//! Mercator's projection of the sky, with its poles at the two ends of the line between the eyes: the
//! conformal picture.
//!
//! With the axes of the head, x along the baseline, y ahead and z up, a line of sight n has the coordinates
//!
//! ```text
//! u = artanh n_x = arsinh(X/rho)      to the right        rho = hypot(Y, Z)
//! v = atan2(n_z, n_y)                 up
//! n = (tanh u, cos v/cosh u, sin v/cosh u)
//! ```
//!
//! u is the pseudorapidity of collider physics. A unit of u and a radian of v have equally many pixels, so
//! that small shapes are true: du^2 + dv^2 = cosh^2(u) dOmega. Rows are planes through the baseline, and so
//! both eyes see a point in the same row. Aberration along the baseline adds the rapidity to u and leaves v
//! (J. Morava, arXiv:0804.4160; J. Baez, *Special Relativity and the Mercator Projection*, The n-Category
//! Café, 3 March 2023): motion slides the picture and keeps its shapes.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};
use relativity_core::Conformal;
use relativity_core::math::{asin, asinh, atan2, atanh, exp, hypot, sin_cos};

use super::axes::Axes;

/// The farthest that a gaze can be aside, as |u|: 1.4e-12 radians from the baseline, about the resolution of
/// a gaze in angles.
pub const MOST_ASIDE: f64 = 28.0;
/// The farthest that the middle of a shifted picture can be aside, as |u|: f32 has cosh^2 u at its edges.
pub const MOST_SHIFTED: f64 = 36.0;

/// The farthest that a line of sight can be drawn aside, as |u|: its exponential is a number.
const MOST_DRAWN: f64 = 709.0;

/// The map of the sky that one conformal picture is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mercator {
    /// `right` is the baseline; v counts from `forward` towards `up`.
    pub axes: Axes,
    /// Pixels per unit of u and per radian of v.
    pub px_per_unit: f64,
    /// The place in the picture where u and v are 0, px to the right and down.
    pub origin: DVec2,
}

/// A rectangle of u and v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// The middle, as u and v.
    pub middle: DVec2,
    /// Half its width and its height.
    pub half: DVec2,
}

impl Mercator {
    /// Returns the map for places that are `turned` into other axes, or reflected.
    #[must_use]
    pub fn turned(&self, turned: impl Fn(DVec3) -> DVec3) -> Self {
        let Axes { right, up, forward } = self.axes;
        Self { axes: Axes { right: turned(right), up: turned(up), forward: turned(forward) }, ..*self }
    }

    /// (u, v) of `direction` (any length above 0); `None` along the baseline, which is infinitely far aside.
    ///
    /// v is from -pi to pi.
    #[must_use]
    pub fn coordinates(&self, direction: DVec3) -> Option<DVec2> {
        let Axes { right, up, forward } = self.axes;
        let Conformal { u, v } =
            Conformal::from_direction([right, forward, up].map(|axis| direction.dot(axis)))?;
        (u.abs() <= MOST_DRAWN).then(|| DVec2::new(u, v))
    }

    /// The line of sight (unit vector) at these coordinates; farther aside than can be drawn, that along the
    /// baseline.
    #[must_use]
    pub fn line_of_sight(&self, DVec2 { x: u, y: v }: DVec2) -> DVec3 {
        // Beyond it e^u overflows, and the quotient of two infinities is no number.
        self.line(exp(u.clamp(-MOST_DRAWN, MOST_DRAWN)), self.across(v))
    }

    /// Returns the unit vector across the baseline at this `v`.
    fn across(&self, v: f64) -> DVec3 {
        let (sine, cosine) = sin_cos(v);
        self.axes.forward * cosine + self.axes.up * sine
    }

    /// Returns the line of sight at the u of which e^u is `grown`, in the half plane of the unit vector
    /// `across` the baseline.
    fn line(&self, grown: f64, across: DVec3) -> DVec3 {
        let shrunk = 1.0 / grown;
        (self.axes.right * (grown - shrunk) + across * 2.0) / (grown + shrunk)
    }

    /// The lines of sight in the middle of the rectangle between the coordinates `low` and `high`, and at its
    /// corners.
    ///
    /// Five of [`Self::line_of_sight`] for little more than the cost of two: corners share their columns and
    /// rows, e^u in the middle is the geometric mean, and the middle row's direction halves the angle between
    /// the outer rows, which must be less than half a turn apart.
    #[must_use]
    pub fn lines_of_sight_around(&self, low: DVec2, high: DVec2) -> (DVec3, [DVec3; 4]) {
        let [left_most, right_most] = [exp(low.x), exp(high.x)];
        let [lowest, highest] = [low.y, high.y].map(|v| self.across(v));
        let middle = self.line(left_most.sqrt() * right_most.sqrt(), (lowest + highest).normalize());
        let corners =
            [(left_most, highest), (right_most, highest), (left_most, lowest), (right_most, lowest)];
        (middle, corners.map(|(grown, across)| self.line(grown, across)))
    }

    /// (u, v) at this place in the picture, px.
    #[must_use]
    pub fn coordinates_at(&self, [x, y]: [f64; 2]) -> DVec2 {
        DVec2::new(x - self.origin.x, self.origin.y - y) / self.px_per_unit
    }

    /// The place in the picture, px, of these coordinates.
    #[must_use]
    pub fn place_of(&self, DVec2 { x: u, y: v }: DVec2) -> [f64; 2] {
        [self.origin.x + u * self.px_per_unit, self.origin.y - v * self.px_per_unit]
    }

    /// Returns the turn of the line of sight `sight` (unit vector) to the next pixel on the right, and to the
    /// one below.
    ///
    /// dn/du = right - n (n . right) and dn/dv = right x n, both cosh u times shorter than 1. Of n = c
    /// right + t the first is t^2 right - c t, which is no difference of what is nearly the same.
    #[must_use]
    pub fn turns(&self, sight: DVec3) -> [DVec3; 2] {
        let right = self.axes.right;
        let cosine = sight.dot(right);
        let across = sight - right * cosine;
        [right * across.length_squared() - across * cosine, across.cross(right)]
            .map(|turn| turn / self.px_per_unit)
    }

    /// The smallest rectangle around a ball at rest with the camera, at `centre` from there; `None` where the
    /// ball is cut by the baseline, and reaches infinitely far aside.
    ///
    /// With k = `radius`/rho the outline is 2 artanh k wide and 2 arcsin k high, wherever along the baseline
    /// the ball is.
    #[must_use]
    pub fn around_ball(&self, centre: DVec3, radius: f64) -> Option<Patch> {
        let Axes { right, up, forward } = self.axes;
        let (ahead, rise) = (centre.dot(forward), centre.dot(up));
        let rho = hypot(ahead, rise);
        let k = radius / rho;
        if k >= 1.0 || rho == 0.0 {
            return None;
        }
        // The tangent from the baseline, rho sqrt(1 - k^2).
        let tangent = rho * ((1.0 - k) * (1.0 + k)).sqrt();
        let middle = DVec2::new(asinh(centre.dot(right) / tangent), atan2(rise, ahead));
        middle.is_finite().then(|| Patch { middle, half: DVec2::new(atanh(k), asin(k)) })
    }
}

/// `angle` plus as many whole turns as bring it nearest to `other`, radians.
#[must_use]
pub fn nearest_turn(angle: f64, other: f64) -> f64 {
    angle - TAU * ((angle - other) / TAU).round()
}

impl Patch {
    /// Whether it shares a place with the rectangle between `low` and `high`, or does so a whole turn of v
    /// further.
    #[must_use]
    pub fn meets(&self, low: DVec2, high: DVec2) -> bool {
        let middle = 0.5 * (low + high);
        let off_v = (nearest_turn(self.middle.y, middle.y) - middle.y).abs().min(PI);
        let off = DVec2::new((self.middle.x - middle.x).abs(), off_v);
        off.cmple(self.half + 0.5 * (high - low)).all()
    }
}
