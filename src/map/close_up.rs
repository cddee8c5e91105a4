//! The close-up framing: a box around a body where it is seen, or around events of points in spacetime. It
//! moves with T, as what it frames does.

use glam::DVec3;
use relativity_core::Event;
use relativity_render::{Motion, Shape};

use super::diagram::Diagram;
use super::fit::WorldBox;
use super::instant::{BodyPicture, MapInstant};
use crate::scene::Scene;
use crate::settings::MapFrame;

/// Space left free around the body on each side, as a share of the box.
const MARGIN: f64 = 0.12;
/// At most this many bodies of a group are sampled; larger groups are strided.
const MOST_BODIES: usize = 150;
/// The stereo position is followed this many sizes of what is seen away: lines of sight that are nearly
/// parallel cross arbitrarily far off.
const STEREO_REACH: f64 = 1.5;
/// Space left free around events, as a share of their span.
const EVENT_MARGIN: f64 = 0.6;
/// Least span of the events, in the distance at which the nearest point passes: a single point may span
/// nothing.
const LEAST_SPAN: f64 = 0.25;

/// A box, grown point by point.
#[derive(Debug, Clone, Copy)]
struct PointBox {
    low: DVec3,
    high: DVec3,
}

impl PointBox {
    const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    fn joined(self, place: DVec3) -> Self {
        Self { low: self.low.min(place), high: self.high.max(place) }
    }

    fn grown(self, by: DVec3) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    fn size(self) -> DVec3 {
        self.high - self.low
    }

    fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }
}

impl WorldBox {
    /// The box around what moves at `motion`, or around all that moves if that rests on the ground: on the
    /// ground where both eyes see it and where two eyes place it, in its own frame where it is. `None` where
    /// it is nowhere.
    #[must_use]
    pub fn close_up(instant: &MapInstant, scene: &Scene, motion: Motion) -> Option<Self> {
        let bounds = |picture: BodyPicture, into: PointBox| {
            let framed = |other: Motion| {
                if instant.rests(motion) { !instant.rests(other) } else { other == motion }
            };
            let groups = scene.passing().filter(|group| framed(group.motion));
            groups.fold(into, |bounds, group| {
                let places = instant.places(group.motion);
                let stride = group.count.div_ceil(MOST_BODIES).max(1);
                let bodies = group.bodies().step_by(stride).map(|body| &scene.bodies[body].shape);
                let seen = bodies.flat_map(Shape::samples).filter_map(|rest| places.place(picture, rest));
                seen.fold(bounds, PointBox::joined)
            })
        };
        let around = match instant.frame() {
            MapFrame::Bicycle => bounds(BodyPicture::Measured, PointBox::EMPTY),
            MapFrame::Ground | MapFrame::Rider => {
                let seen = bounds(BodyPicture::Seen(1), bounds(BodyPicture::Seen(0), PointBox::EMPTY));
                let within = seen.grown(STEREO_REACH * seen.size());
                let stereo = bounds(BodyPicture::Stereo, seen);
                PointBox { low: stereo.low.max(within.low), high: stereo.high.min(within.high) }
            }
        };
        let margin = MARGIN * around.size().max_element();
        let PointBox { low, high } = around.grown(DVec3::splat(margin));
        (margin > 0.0 && around.is_finite()).then(|| Self([0, 1, 2].map(|axis| [low[axis], high[axis]])))
    }
}

/// The lowest and highest x and t around the events of the points of `diagrams` that are now on the clocks of
/// the ground and on those of the scene. `None` where there is no finite such box.
#[must_use]
pub fn around_now(diagrams: &[Diagram]) -> Option<[Event; 2]> {
    let events = diagrams.iter().flat_map(|diagram| {
        let nows = [diagram.time, diagram.other_now()];
        nows.map(|time| diagram.point.at(time))
    });
    let places = events.map(|event| DVec3::new(event.x, event.t, 0.0));
    let around = places.fold(PointBox::EMPTY, PointBox::joined);
    let nearest = diagrams.iter().map(|diagram| diagram.point.distance()).fold(f64::INFINITY, f64::min);
    let span = around.size().max_element();
    let margin = EVENT_MARGIN * span.max(LEAST_SPAN * nearest);
    let event = |place: DVec3| Event { x: place.x, t: place.y };
    let framed = around.grown(DVec3::splat(margin));
    (margin > 0.0 && framed.is_finite()).then(|| [framed.low, framed.high].map(event))
}
