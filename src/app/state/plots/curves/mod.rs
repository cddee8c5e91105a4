//! Curves of a point over T, sampled densely where they bend, and kept until something they depend on
//! changes.

mod bends;
mod sampled;
#[cfg(test)]
mod tests;

use egui_plot::PlotPoint;
use relativity_core::math;
use relativity_core::{
    Baseline, ConformalDisparity, Disparity, Model, Observer, PublishedVariant, SourcePoint, Stereo,
};
use relativity_render::{MaterialPoint, Velocity};

use crate::eye::Eye;
use crate::plot::CurveSample;
use crate::quantity::{Of, Quantity};
use crate::settings::{Rider, Riding};

pub(in crate::app) use bends::Bends;

/// A curve of a point: of a quantity, and of one of those who have a value of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Curve {
    /// Quantity that is plotted.
    pub quantity: Quantity,
    /// The observer whose value it is.
    pub whose: Whose,
}

/// The observer to whom a value of a quantity belongs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Whose {
    /// Both eyes together, as one observer.
    Both,
    /// An eye by itself.
    Eye(Eye),
    /// Eyes gamma d apart, of the point at rest.
    Resting,
    /// Whoever measures where the point is at T, from the middle between the eyes.
    Measured,
}

impl Whose {
    /// Returns those who have a value of `quantity`, in the order in which they are named.
    #[must_use]
    pub const fn of(quantity: Quantity) -> &'static [Self] {
        const EYES: [Whose; 2] = [Whose::Eye(Eye::Left), Whose::Eye(Eye::Right)];
        match (quantity, quantity.row().of) {
            (Quantity::Distance, _) => &[Self::Both, EYES[0], EYES[1], Self::Measured],
            (Quantity::DeltaU, _) => &[Self::Both, Self::Resting],
            (_, Of::Sighting(_) | Of::Conformal(_)) => &EYES,
            (_, Of::Pair(_) | Of::ConformalPair(_) | Of::Stereo(_)) => &[Self::Both],
        }
    }
}

/// A point as it moves and is seen: what every curve of it depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct SeenPoint {
    /// Ride of the eyes.
    pub ride: Riding,
    /// Velocity of the point.
    pub velocity: Velocity,
    /// Place of the point, at rest or on its wheel, from between the eyes.
    pub point: MaterialPoint,
    /// From the left to the right eye, in the axes of the head.
    pub baseline: Baseline,
    /// The model of what the views show.
    pub model: Model,
}

/// The published model, of which disparities have a curve.
pub const PUBLISHED: Model = Model::Published(PublishedVariant::AppendixA);

impl SeenPoint {
    /// Returns the value of a `curve` at `time` in this `model`, as plotted; `None` outside the domain of the
    /// core, and where there is no such thing.
    #[must_use]
    pub fn value(&self, model: Model, Curve { quantity, whose }: Curve, time: f64) -> Option<f64> {
        let value = match (quantity.row().of, whose) {
            (_, Whose::Measured) => self.measured_distance(time),
            (Of::ConformalPair(of), Whose::Resting) => of(&self.resting(time)?),
            (Of::ConformalPair(of), _) => of(&self.conformal(model, time)?),
            (Of::Conformal(of), Whose::Eye(eye)) => {
                let both = self.conformal(model, time)?;
                of([&both.primary, &both.secondary][eye.index()])
            }
            (Of::Sighting(of), Whose::Eye(eye)) => {
                let both = self.disparity(model, time)?;
                of([&both.primary, &both.secondary][eye.index()])
            }
            // Of what each eye has, both together have the distance alone.
            (Of::Sighting(_), _) => self.stereo(model, time)?.distance(),
            (Of::Pair(of), _) => of(&self.disparity(model, time)?),
            (Of::Stereo(of), _) => of(&self.stereo(model, time)?),
            (Of::Conformal(_), _) => return None,
        };
        let plotted = if quantity.row().is_logarithmic { math::log10(value) } else { value };
        plotted.is_finite().then_some(plotted)
    }

    /// From the left to the right eye at `time`, in the observer's axes.
    #[must_use]
    pub fn baseline_at(&self, time: f64) -> Baseline {
        self.ride.rider(time).baseline(self.baseline)
    }

    /// The observer at `time`.
    fn observer(&self, time: f64) -> Observer {
        self.ride.rider(time).observer()
    }

    /// The disparity at `time` in this `model`; `None` outside the domain of the core.
    fn disparity(&self, model: Model, time: f64) -> Option<Disparity> {
        self.disparity_of(&self.ride.rider(time), model)
    }

    /// The same of this `rider`.
    fn disparity_of(&self, rider: &Rider, model: Model) -> Option<Disparity> {
        let pair = rider.baseline(self.baseline).apertures();
        self.velocity.disparity_before(&rider.observer(), model, self.point, pair).ok()
    }

    /// The disparity of conformal pictures in this `model` at `time`; `None` where an eye sees the point
    /// along the baseline. That of a ride is the difference of what each eye sees, known to 1e-15 of u and v.
    fn conformal(&self, model: Model, time: f64) -> Option<ConformalDisparity> {
        if self.ride.is_on() {
            let rider = self.ride.rider(time);
            let (both, axes) = (self.disparity_of(&rider, model)?, rider.baseline(self.baseline).axes());
            let [primary, secondary] =
                [both.primary, both.secondary].map(|seen| axes.conformal(seen.position));
            let (primary, secondary) = (primary?, secondary?);
            let (du, dv) = (primary.u - secondary.u, primary.v - secondary.v);
            return Some(ConformalDisparity { primary, secondary, du, dv });
        }
        self.velocity.conformal(model, self.point, &self.baseline, time).ok()?
    }

    /// The disparity at `time` of the point at rest where it is in its own frame, for eyes gamma d apart;
    /// `None` where motion is no slide.
    fn resting(&self, time: f64) -> Option<ConformalDisparity> {
        if self.ride.is_on() {
            return None;
        }
        self.velocity.resting_conformal(self.point, &self.baseline, time).ok()?
    }

    /// Returns the stereo position in this `model` at `time`; `None` where the lines of sight do not meet.
    fn stereo(&self, model: Model, time: f64) -> Option<Stereo> {
        let rider = self.ride.rider(time);
        let pair = rider.baseline(self.baseline).stereo_apertures(self.ride.is_on());
        self.velocity.stereo_before(&rider.observer(), model, self.point, pair).ok()
    }

    /// Returns the distance at `time`, as measured in the observer's frame; no number of a point that turns
    /// before eyes that ride.
    fn measured_distance(&self, time: f64) -> f64 {
        let speed = &self.velocity.speed;
        if self.ride.is_on() {
            let there = self.velocity.past(&self.observer(time), self.point.rest.to_array());
            let there = there.filter(|_| self.point.spin.is_none());
            return there
                .map_or(f64::NAN, |(_, SourcePoint { x0, y, z })| math::hypot(x0, math::hypot(y, z)));
        }
        let there = self.velocity.reflected_source(self.point).place_when_measured(speed, time);
        [there.worldline(speed).at(time).x, there.y, there.z]
            .map(|along| along * along)
            .iter()
            .sum::<f64>()
            .sqrt()
    }

    /// The times in `range` around which the curves bend.
    fn bends(&self, range: [f64; 2]) -> Bends {
        if self.ride.is_on() {
            return self.bends_of_ride(range);
        }
        let source = self.velocity.reflected_source(self.point);
        let pair = self.velocity.reflected_pair(self.baseline.apertures_or_limit());
        Bends::new(&self.velocity.speed, source, pair, range)
    }

    /// Returns the bends of a ride: around the passage of the point while the rider coasts, else at the ends
    /// of legs.
    fn bends_of_ride(&self, range: [f64; 2]) -> Bends {
        let place = self.point.axle().to_array();
        let past = self.velocity.past(&self.observer(0.0), place).filter(|_| self.ride.coasts_along_street());
        let Some((speed, there)) = past else {
            return Bends { passage: self.ride.turns().collect(), ..Bends::default() };
        };
        Bends::new(&speed, there, self.baseline.apertures_or_limit(), range)
    }

    /// Whether a curve is there at every T. Where eyes are along the motion, lines of sight meet, unless the
    /// two events of the point differ in height.
    fn is_whole(&self, Curve { quantity, whose }: Curve) -> bool {
        let meets = self.baseline.is_along_motion() && self.point.spin.is_none();
        match (quantity.row().of, whose) {
            (Of::Stereo(_), _) | (Of::Sighting(_), Whose::Both) => meets,
            (Of::ConformalPair(_) | Of::Conformal(_), _) => false,
            (Of::Pair(_) | Of::Sighting(_), _) => true,
        }
    }
}

/// The key of the curves of a quantity of a point: everything they depend on.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvesKey {
    /// The point, as the views show it. Where that is not exact, its exact curves are there beside.
    pub point: SeenPoint,
    /// Quantity that is plotted.
    pub quantity: Quantity,
    /// First and last T.
    pub range: [f64; 2],
    /// Whether a disparity of the published model is wanted too.
    pub published: bool,
}

/// The curves of a quantity of a point, by everyone who has a value of it.
#[derive(Debug, Clone)]
pub struct QuantityCurves {
    /// The key that the curves were made for.
    pub key: CurvesKey,
    drawn: Vec<(Model, Whose, CurvePieces)>,
}

/// The pieces of a curve.
type CurvePieces = Vec<Vec<PlotPoint>>;

impl QuantityCurves {
    /// The curves for `key`.
    #[must_use]
    pub fn new(key: CurvesKey) -> Self {
        let bends = key.point.bends(key.range);
        let shown = key.point.model;
        let mut drawn: Vec<_> = Whose::of(key.quantity)
            .iter()
            .map(|&whose| (shown, whose, curve(&key, shown, whose, &bends)))
            .collect();
        // Of the distances there are enough curves already.
        let exact = (shown != Model::Exact && key.quantity != Quantity::Distance).then_some(Model::Exact);
        let published = (key.published && key.quantity.is_disparity()).then_some(PUBLISHED);
        for model in [exact, published].into_iter().flatten() {
            let others = Whose::of(key.quantity).iter().filter(|whose| **whose != Whose::Resting);
            drawn.extend(others.map(|&whose| (model, whose, curve(&key, model, whose, &bends))));
        }
        Self { key, drawn }
    }

    /// The pieces of the curve of `whose` value in this `model`: that of the key, the exact one, and of a
    /// disparity also the published one. None of what is not wanted.
    #[must_use]
    pub fn pieces(&self, whose: Whose, model: Model) -> &[Vec<PlotPoint>] {
        let found = self.drawn.iter().find(|(of, who, _)| (*of, *who) == (model, whose));
        found.map_or(&[], |(_, _, pieces)| pieces)
    }
}

/// The pieces of a curve of `key`.
fn curve(key: &CurvesKey, model: Model, whose: Whose, bends: &Bends) -> CurvePieces {
    let curve = Curve { quantity: key.quantity, whose };
    let value = |time| key.point.value(model, curve, time).map(|value| [value]);
    let pieces =
        if key.point.is_whole(curve) { vec![key.range] } else { bends.sampling(key.range).pieces(value) };
    let points = |piece| {
        let samples = bends.sampling(piece).samples(value).into_iter();
        samples.map(|CurveSample { time, values: [value] }| PlotPoint::new(time, value)).collect()
    };
    pieces.into_iter().map(points).collect()
}
