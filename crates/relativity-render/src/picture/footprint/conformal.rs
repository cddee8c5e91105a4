//! Bounds on the place of a body in a conformal picture.
//!
//! The straight line between two places is seen along a great circle. Mercator's scale is cosh u, and so the
//! curvature of its image is the part of grad ln cosh u across it: at most |tanh u|, below 1. What a convex
//! body shows is bounded by such lines. An arc of curvature below 1 whose ends are L apart departs from its
//! chord by at most 1 - sqrt(1 - L^2/4), below L^2/7 for L below 1: the body lies that near to the polygon
//! around the images of its corners.
//!
//! A ball of radius r at the distance rho from the baseline reaches no further than -ln(1 - r/rho) from the
//! image of its centre: artanh k to both sides of the middle of its image, which is at most -ln(1 - k^2)/2
//! further aside, k = r/rho.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use relativity_core::math::{asinh, ln};

use super::projection::{EVERYWHERE, Footprint, FootprintMap, ImageExtent, LOOSE_PX, LOOSE_RADII, MARGIN_PX};
use crate::camera::mercator::{Mercator, nearest_turn};

/// Images farther apart than this bound nothing together.
const MOST_APART: f64 = 1.0;
/// Nor do balls that reach so much of the way to the baseline.
const MOST_NEAR: f64 = 0.8;
/// The most that it bends by, in parts of the square of its length.
const BEND: f64 = 1.0 / 7.0;

impl FootprintMap {
    /// Returns the patch in which the hull of balls of this `radius` around `points` can appear in the
    /// picture of `mercator`, of a piece with this least radius; `None` if that cannot be said of it as a
    /// whole.
    pub(super) fn conformal_footprint(
        &self,
        mercator: &Mercator,
        points: &[DVec3],
        radius: f64,
        least_radius: f64,
    ) -> Option<Footprint> {
        let [nearest, farthest] = from_baseline(mercator, points);
        if self.is_aside(mercator, points, radius, farthest) {
            return Some(Footprint::Hidden);
        }
        let first = mercator.coordinates(points[0])?;
        let mut places = [DVec2::ZERO; 16];
        for (place, point) in places.iter_mut().zip(points) {
            let DVec2 { x, y } = mercator.coordinates(*point)?;
            *place = DVec2::new(x, nearest_turn(y, first.y));
        }
        let places = &places[..points.len()];
        let apart = length_of_hull(places);
        if apart > MOST_APART {
            return None;
        }
        let k = radius / nearest;
        if k > MOST_NEAR {
            return None;
        }
        let bend = BEND * apart * apart;
        let room = bend - ln(1.0 - k);
        let radius_px = least_radius * mercator.px_per_unit / farthest;
        let is_loose = bend * mercator.px_per_unit > LOOSE_RADII * radius_px + LOOSE_PX;
        Some(self.conformal_rectangle(places, room, radius_px, is_loose))
    }

    /// Whether all of the hull, which is no farther than this from the baseline, is beyond the left or the
    /// right edge.
    fn is_aside(&self, mercator: &Mercator, points: &[DVec3], radius: f64, farthest: f64) -> bool {
        let half_width = 0.5 * self.size.x / self.focal_length_px + MARGIN_PX / self.focal_length_px;
        let aside = points.iter().map(|point| point.dot(mercator.axes.right));
        let [low, high] = aside
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], aside| [low.min(aside), high.max(aside)]);
        // Of two places equally far along the baseline the one nearer to it is further aside.
        let least = |aside: f64| asinh((aside - radius) / (farthest + radius));
        (low > radius && least(low) > self.gauge.middle + half_width)
            || (high < -radius && least(-high) > half_width - self.gauge.middle)
    }

    /// The rectangle around `places`, which follow each other within half a turn, and this much `room`.
    fn conformal_rectangle(&self, places: &[DVec2], room: f64, radius_px: f64, is_loose: bool) -> Footprint {
        let middle = DVec2::new(self.gauge.middle, 0.0);
        let half_height = 0.5 * self.size.y / self.focal_length_px;
        let around = 0.5 * (places[0] + places[1]).y;
        let turn = nearest_turn(around, 0.0) - around;
        let from_middle = |place: &DVec2| *place + DVec2::new(0.0, turn) - middle;
        let mut own = [DVec2::ZERO; 16];
        for (own, place) in own.iter_mut().zip(places) {
            *own = from_middle(place);
        }
        let own = &own[..places.len()];
        // A picture that goes nearly around shows what is behind at both of its edges.
        let highest = own.iter().map(|place| place.y.abs()).fold(0.0, f64::max) + room;
        if highest + half_height > TAU {
            return EVERYWHERE;
        }
        let upright = ImageExtent::new(own, DVec2::X);
        let along = (own[1] - own[0]).try_normalize().map(|along| ImageExtent::new(own, along));
        let tightest =
            along.filter(|along| along.area_with(room) < upright.area_with(room)).unwrap_or(upright);
        tightest.widened(room).footprint(self, radius_px, is_loose)
    }
}

/// The greatest distance between two of `places`.
fn length_of_hull(places: &[DVec2]) -> f64 {
    let pairs =
        places.iter().enumerate().flat_map(|(i, a)| places[..i].iter().map(move |b| a.distance_squared(*b)));
    pairs.fold(0.0, f64::max).sqrt()
}

/// Between which distances from the baseline the hull of `points` is, of which the baseline passes at one
/// side.
fn from_baseline(mercator: &Mercator, points: &[DVec3]) -> [f64; 2] {
    let flat = |point: &DVec3| DVec2::new(point.dot(mercator.axes.forward), point.dot(mercator.axes.up));
    let (mut nearest, mut farthest) = (f64::INFINITY, 0.0f64);
    for (i, point) in points.iter().enumerate() {
        let from = flat(point);
        farthest = farthest.max(from.length());
        for other in &points[..=i] {
            let span = flat(other) - from;
            let share = (-from.dot(span) / span.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            nearest = nearest.min((from + span * share).length());
        }
    }
    [nearest, farthest]
}
