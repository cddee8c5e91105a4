//! The reach of what is seen: between which columns, and between which planes through a picture's level line,
//! it lies.

use glam::DVec3;
use relativity_core::math::{atan, hypot};

use crate::camera::axes::Axes;
use crate::camera::outline::{Ball, Range};

/// The kind of surface that a column of a picture is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Across {
    /// Planes through the picture's upright.
    Upright,
    /// Cones about the baseline.
    Baseline,
}

/// The axes of a picture, and what its columns are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ruled {
    pub(super) axes: Axes,
    pub(super) across: Across,
}

impl Ruled {
    /// Returns the distance of `place` to the right, and that from which angles across count: its depth, or
    /// its distance from the baseline.
    fn across(&self, place: DVec3) -> [f64; 2] {
        let Axes { right, up, forward } = self.axes;
        let depth = place.dot(forward);
        let off = if self.across == Across::Baseline { hypot(depth, place.dot(up)) } else { depth };
        [place.dot(right), off]
    }

    /// Returns the apparent size of a `bulge` at `place` and a `sag` there, radians or units of u.
    pub(super) fn seen_size(&self, bulge: DVec3, sag: f64, place: DVec3) -> f64 {
        let distance = place.length();
        match self.across {
            Across::Upright => bulge.length() / distance,
            Across::Baseline => {
                let right = self.axes.right;
                let along = bulge.dot(right);
                let off = (bulge - right * along).length().max(sag);
                along.abs().max(off * distance / place.reject_from_normalized(right).length()) / distance
            }
        }
    }

    /// Returns the length by which the straight line between these places is nearer to the baseline, in its
    /// midst, than the mean of both: it bows in a picture with cones for columns. At most s^2/(8 least),
    /// where s^2 is the square of what of it is across both the baseline and the way there, and `least` how
    /// near it comes.
    pub(super) fn sag(&self, [first, last]: [DVec3; 2]) -> f64 {
        if self.across == Across::Upright {
            return 0.0;
        }
        let flat = |place: DVec3| place.reject_from_normalized(self.axes.right);
        let (from, to) = (flat(first), flat(last));
        let span = to - from;
        let squared = span.length_squared();
        if squared == 0.0 {
            return 0.0;
        }
        let least = (from + span * (-from.dot(span) / squared).clamp(0.0, 1.0)).length();
        let outwards = to.length() - from.length();
        let farther = from.length().max(to.length());
        ((squared - outwards * outwards).max(0.0) / (8.0 * least.max(f64::MIN_POSITIVE))).min(farther)
    }
}

/// Between which columns, and between which planes through the picture's level line, something lies.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    pub(super) across: Wedge,
    pub(super) up: Wedge,
}

impl Reach {
    pub(super) const NOWHERE: Self = Self { across: Wedge::NOWHERE, up: Wedge::NOWHERE };
    pub(super) const EVERYWHERE: Self = Self { across: Wedge::EVERYWHERE, up: Wedge::EVERYWHERE };

    pub(super) fn holds(&self, ball: &Ball, axes: &Ruled) -> bool {
        self.holds_nearer(ball, 0.0, axes)
    }

    /// Whether it holds `ball`, also where that is nearer to the baseline by this much.
    pub(super) fn holds_nearer(&self, ball: &Ball, nearer: f64, axes: &Ruled) -> bool {
        let [aside, off] = axes.across(ball.centre);
        self.across.holds(aside, off - nearer, ball.radius)
            && (nearer == 0.0 || self.across.holds(aside, off, ball.radius))
            && self.up.holds(ball.centre.dot(axes.axes.up), ball.centre.dot(axes.axes.forward), ball.radius)
    }

    pub(super) fn widen(&mut self, ball: &Ball, axes: &Ruled) {
        self.widen_nearer(ball, 0.0, axes);
    }

    pub(super) fn widen_nearer(&mut self, ball: &Ball, nearer: f64, axes: &Ruled) {
        let [aside, off] = axes.across(ball.centre);
        self.across.widen(aside, off, ball.radius);
        self.across.widen(aside, off - nearer, ball.radius);
        self.up.widen(ball.centre.dot(axes.axes.up), ball.centre.dot(axes.axes.forward), ball.radius);
    }
}

/// Between two planes through a line, of angles below pi from the optical axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wedge {
    /// Tangents of half the angles.
    tangents: Range,
    /// Sine and cosine of each angle.
    sides: [[f64; 2]; 2],
}

impl Wedge {
    pub(super) const NOWHERE: Self =
        Self { tangents: [f64::INFINITY, f64::NEG_INFINITY], sides: [[0.0, f64::NEG_INFINITY]; 2] };
    pub(super) const EVERYWHERE: Self = Self {
        tangents: [f64::NEG_INFINITY, f64::INFINITY],
        sides: [[f64::NEG_INFINITY, 0.0], [f64::INFINITY, 0.0]],
    };

    /// Whether a ball this far `aside` and this deep is surely inside: as far from both planes as its radius.
    pub(super) fn holds(&self, aside: f64, depth: f64, radius: f64) -> bool {
        let [[low_sine, low_cosine], [high_sine, high_cosine]] = self.sides;
        aside * low_cosine - depth * low_sine >= radius && depth * high_sine - aside * high_cosine >= radius
    }

    pub(super) fn widen(&mut self, aside: f64, depth: f64, radius: f64) {
        if self.holds(aside, depth, radius) {
            return;
        }
        let [low, high] = tangents(aside, depth, radius);
        self.take([self.tangents[0].min(low), self.tangents[1].max(high)]);
    }

    fn take(&mut self, tangents: Range) {
        self.tangents = tangents;
        self.sides = self.tangents.map(|tangent| {
            let squared = tangent * tangent;
            if squared.is_finite() {
                [2.0 * tangent / (1.0 + squared), (1.0 - squared) / (1.0 + squared)]
            } else {
                [0.0, -1.0]
            }
        });
    }

    /// Returns the wedge around both.
    pub(super) fn union(&self, other: &Self) -> Self {
        let mut union = *self;
        union.take([self.tangents[0].min(other.tangents[0]), self.tangents[1].max(other.tangents[1])]);
        union
    }

    /// Returns the range of angles.
    pub(super) fn angles(&self) -> Range {
        self.tangents.map(|tangent| 2.0 * atan(tangent))
    }
}

/// Returns the tangents of half the angles at which a ball this far `aside` and this deep begins and ends.
fn tangents(aside: f64, depth: f64, radius: f64) -> Range {
    let squared = aside * aside + depth * depth;
    let outside_squared = squared - radius * radius;
    if outside_squared <= 0.0 {
        return [f64::NEG_INFINITY, f64::INFINITY];
    }
    // The tangents from the aperture lie asin(radius/distance) to both sides of the centre.
    let tangent = outside_squared.sqrt();
    let ahead = squared + depth * tangent;
    let end = |radius: f64| (aside * tangent + depth * radius) / (ahead - aside * radius);
    [end(-radius), end(radius)]
}
