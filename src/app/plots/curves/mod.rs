//! Curves of a point over T, sampled densely where they bend, and kept until something they depend on
//! changes.

mod bends;
mod sampled;
#[cfg(test)]
mod tests;

use egui_plot::PlotPoint;
use relativity_core::math;
use relativity_core::{Baseline, Disparity, Model, Observer, PublishedVariant, SourcePoint, Stereo};
use relativity_render::{MaterialPoint, Velocity};

use crate::settings::Riding;

pub(in crate::app) use bends::Bends;
use sampled::pieces;
pub(in crate::app) use sampled::{Sample, sampled};

/// A quantity that is plotted against T.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Difference of azimuths, Delta-phi.
    DeltaPhi,
    /// Difference of elevations, Delta-theta.
    DeltaTheta,
    /// Delta-u, the difference of columns of conformal pictures.
    DeltaU,
    /// Delta-v, the difference of rows of conformal pictures.
    DeltaV,
    /// phi of the left and the right eye.
    Phi,
    /// theta of the left and the right eye.
    Theta,
    /// Decimal logarithm of D of the left and the right eye.
    LogDoppler,
    /// Decimal logarithm of the stereo gain.
    LogGain,
    /// Decimal logarithms of the point's distances, of each [`DistanceKind`]: two of them are as far apart as their ratio.
    LogDistance,
}

impl Quantity {
    /// Whether what is plotted is a logarithm.
    #[must_use]
    pub const fn is_logarithm(self) -> bool {
        matches!(self, Self::LogDoppler | Self::LogGain | Self::LogDistance)
    }

    /// Whether the quantity is a difference between what both eyes see.
    #[must_use]
    pub const fn is_disparity(self) -> bool {
        matches!(self, Self::DeltaPhi | Self::DeltaTheta | Self::DeltaU | Self::DeltaV)
    }
}

/// A curve of a point: of a quantity, and of one of its kinds where it has several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Curve {
    /// Difference of azimuths, Delta-phi.
    DeltaPhi,
    /// Difference of elevations, Delta-theta.
    DeltaTheta,
    /// Delta-u, the difference of columns of conformal pictures.
    DeltaU,
    /// Delta-v, the difference of rows of conformal pictures.
    DeltaV,
    /// Delta-u of the point at rest, for eyes gamma d apart.
    RestingU,
    /// phi of the left (0) or the right (1) eye.
    Phi(usize),
    /// theta of an eye.
    Theta(usize),
    /// Decimal logarithm of D of an eye.
    LogDoppler(usize),
    /// Decimal logarithm of the stereo gain.
    LogGain,
    /// Decimal logarithm of a distance.
    LogDistance(DistanceKind),
}

impl Curve {
    /// Whether the curve is a difference between what both eyes see.
    #[must_use]
    pub const fn is_disparity(self) -> bool {
        matches!(self, Self::DeltaPhi | Self::DeltaTheta | Self::DeltaU | Self::DeltaV | Self::RestingU)
    }
}

/// A distance of a point at one T.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DistanceKind {
    /// From the middle between the eyes to where both take it to be: |p|.
    Stereo,
    /// From the left (0) or the right (1) eye to where it sees the point: R.
    Seen(usize),
    /// From the middle between the eyes to where the point is at T.
    Measured,
}

impl DistanceKind {
    /// Every kind of distance.
    pub const ALL: [Self; 4] = [Self::Stereo, Self::Seen(0), Self::Seen(1), Self::Measured];
}

/// The key of a point's curves: everything they depend on.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvesKey {
    /// Ride of the eyes.
    pub ride: Riding,
    /// Velocity of the point.
    pub velocity: Velocity,
    /// Place of the point, at rest or on its wheel, from between the eyes.
    pub point: MaterialPoint,
    /// From the left to the right eye.
    pub baseline: Baseline,
    /// First and last T.
    pub range: [f64; 2],
    /// The model of what the views show. Where that is not the exact one, its curves are there beside.
    pub model: Model,
    /// Whether the published model is wanted too.
    pub published: bool,
    /// Whether what two eyes make of it is wanted too.
    pub stereo: bool,
    /// Whether the disparities of u and v are wanted too.
    pub conformal: bool,
}

impl CurvesKey {
    /// The observer at `time`.
    fn observer(&self, time: f64) -> Observer {
        self.ride.rider(time).observer()
    }

    /// The disparity at `time` in this `model`; `None` outside the domain of the core.
    fn disparity(&self, model: Model, time: f64) -> Option<Disparity> {
        let pair = self.baseline.apertures();
        self.velocity.disparity_before(&self.observer(time), model, self.point, pair).ok()
    }

    /// The times around which the curves bend.
    fn bends(&self) -> Bends {
        if self.ride.is_on() {
            return self.bends_of_ride();
        }
        let source = self.velocity.reflected_source(self.point);
        let pair = self.velocity.reflected_pair(self.baseline.apertures_or_limit());
        Bends::new(&self.velocity.speed, source, pair, self.range)
    }

    /// Returns the bends of a ride: around the passage of the point while the rider coasts, else at the ends of legs.
    fn bends_of_ride(&self) -> Bends {
        let place = self.point.axle().to_array();
        let past = self.velocity.past(&self.observer(0.0), place).filter(|_| self.ride.coasts());
        let Some((speed, there)) = past else {
            return Bends { passage: self.ride.turns().collect(), ..Bends::default() };
        };
        Bends::new(&speed, there, self.baseline.apertures_or_limit(), self.range)
    }
}

/// Every curve of one point.
#[derive(Debug, Clone)]
pub struct Curves {
    key: CurvesKey,
    shown: OfModel,
    exact: Option<OfModel>,
    published: [Vec<PlotPoint>; 2],
    published_conformal: [Pieces; 2],
    resting: Pieces,
}

/// The pieces of a curve.
type Pieces = Vec<Vec<PlotPoint>>;

/// The curves of one binocular model.
#[derive(Debug, Clone)]
struct OfModel {
    eyes: [Vec<PlotPoint>; EYES],
    /// Log gain, in pieces.
    gains: Vec<Vec<PlotPoint>>,
    /// Logarithms of the distances, in the order of their kinds.
    distances: Vec<Vec<PlotPoint>>,
    /// Delta-u and Delta-v, in pieces.
    conformal: [Pieces; 2],
}

/// Delta-phi, Delta-theta, then phi, theta and log D of the left and of the right eye.
const EYES: usize = 8;

impl OfModel {
    fn new(key: &CurvesKey, model: Model, bends: &Bends) -> Self {
        let eyes = channels(&sampled(key.range, bends, |time| values(key, model, time)));
        let (mut gains, mut distances) = (Vec::new(), Vec::new());
        if key.stereo {
            distances.extend(channels(&sampled(key.range, bends, |time| distance_values(key, model, time))));
            let values = |time| stereo_values(key, model, time);
            // Those of eyes along the motion meet, unless the two events of the point differ in height.
            let pieces = if key.baseline.is_along_motion() && key.point.spin.is_none() {
                vec![key.range]
            } else {
                pieces(key.range, bends, values)
            };
            for [gain, distance] in pieces.into_iter().map(|piece| channels(&sampled(piece, bends, values))) {
                gains.push(gain);
                distances.push(distance);
            }
        }
        let conformal = conformal_pieces(key, bends, |time| conformal_values(key, model, time));
        Self { eyes, gains, distances, conformal }
    }

    fn points(&self, curve: Curve) -> &[Vec<PlotPoint>] {
        if let Some(channel) = eyes_channel(curve) {
            return &self.eyes[channel..=channel];
        }
        let kind = match curve {
            Curve::DeltaU => return &self.conformal[0],
            Curve::DeltaV => return &self.conformal[1],
            Curve::LogDistance(kind) => kind,
            _ => return &self.gains,
        };
        let from = match kind {
            DistanceKind::Measured => 0,
            DistanceKind::Seen(eye) => 2 - eye,
            DistanceKind::Stereo => return self.distances.get(3..).unwrap_or_default(),
        };
        self.distances.get(from..=from).unwrap_or_default()
    }
}

/// Returns the channel of a curve of what each eye sees among the [`EYES`]; `None` for the others.
const fn eyes_channel(curve: Curve) -> Option<usize> {
    match curve {
        Curve::DeltaPhi => Some(0),
        Curve::DeltaTheta => Some(1),
        Curve::Phi(eye) => Some(2 + eye),
        Curve::Theta(eye) => Some(4 + eye),
        Curve::LogDoppler(eye) => Some(6 + eye),
        Curve::DeltaU | Curve::DeltaV | Curve::RestingU | Curve::LogGain | Curve::LogDistance(_) => None,
    }
}

impl Curves {
    /// The curves for `key`.
    #[must_use]
    pub fn new(key: CurvesKey) -> Self {
        let bends = key.bends();
        let of = |model| OfModel::new(&key, model, &bends);
        let shown = of(key.model);
        let exact = (key.model != Model::Exact).then(|| of(Model::Exact));
        let published = if key.published {
            channels(&sampled(key.range, &bends, |time| published_values(&key, time)))
        } else {
            [Vec::new(), Vec::new()]
        };
        let conformal = |time| conformal_values(&key, PUBLISHED, time).filter(|_| key.published);
        let published_conformal = conformal_pieces(&key, &bends, conformal);
        let [resting] = conformal_pieces(&key, &bends, |time| resting_value(&key, time).map(|du| [du]));
        Self { key, shown, exact, published, published_conformal, resting }
    }

    /// Returns the key that the curves were made for.
    #[must_use]
    pub const fn key(&self) -> &CurvesKey {
        &self.key
    }

    /// The pieces of a curve in this `model`: that of the key, or the exact one; of a disparity also the published one. None
    /// of what is not wanted.
    #[must_use]
    pub fn pieces(&self, curve: Curve, model: Model) -> &[Vec<PlotPoint>] {
        let published = |number: usize| {
            if self.key.published { &self.published[number..=number] } else { &[] }
        };
        match (model, &self.exact, curve) {
            (_, _, Curve::RestingU) => &self.resting,
            _ if model == self.key.model => self.shown.points(curve),
            (Model::Published(_), _, Curve::DeltaPhi) => published(0),
            (Model::Published(_), _, Curve::DeltaTheta) => published(1),
            (Model::Published(_), _, Curve::DeltaU) => &self.published_conformal[0],
            (Model::Published(_), _, Curve::DeltaV) => &self.published_conformal[1],
            (Model::Exact, Some(exact), _) => exact.points(curve),
            _ => &[],
        }
    }
}

/// The published model, of which disparities have a curve.
pub const PUBLISHED: Model = Model::Published(PublishedVariant::AppendixA);

/// Returns the value of a `curve` of the point of `key` at `time` in this `model`, as plotted; `None` outside the domain of the core,
/// and where there is no such thing.
#[must_use]
pub fn value(key: &CurvesKey, model: Model, curve: Curve, time: f64) -> Option<f64> {
    if let (Model::Published(_), Curve::DeltaPhi | Curve::DeltaTheta) = (model, curve) {
        return published_values(key, time)
            .map(|[dphi, dtheta]| if curve == Curve::DeltaPhi { dphi } else { dtheta });
    }
    if let Some(channel) = eyes_channel(curve) {
        return Some(values(key, model, time)?[channel]);
    }
    let value = match curve {
        Curve::DeltaU => return conformal_values(key, model, time).map(|[du, _]| du),
        Curve::DeltaV => return conformal_values(key, model, time).map(|[_, dv]| dv),
        Curve::RestingU => return resting_value(key, time),
        Curve::LogDistance(DistanceKind::Stereo) => fused(key, model, time)?.distance(),
        Curve::LogDistance(DistanceKind::Seen(eye)) => seen_distances(key, model, time)?[eye],
        Curve::LogDistance(DistanceKind::Measured) => measured_distance(key, time),
        _ => fused(key, model, time)?.gain,
    };
    Some(math::log10(value)).filter(|log| log.is_finite())
}

fn values(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; EYES]> {
    let both = key.disparity(model, time)?;
    let (l, r) = (both.primary, both.secondary);
    let values = [
        both.dphi,
        both.dtheta,
        l.phi(),
        r.phi(),
        l.theta(),
        r.theta(),
        math::log10(l.doppler_factor),
        math::log10(r.doppler_factor),
    ];
    values.iter().all(|value| value.is_finite()).then_some(values)
}

fn published_values(key: &CurvesKey, time: f64) -> Option<[f64; 2]> {
    let both = key.disparity(PUBLISHED, time)?;
    let values = [both.dphi, both.dtheta];
    values.iter().all(|value| value.is_finite()).then_some(values)
}

/// Delta-u and Delta-v in this `model` at `time`; `None` where an eye sees the point along the baseline. Those of a ride are
/// differences of what each eye sees, known to 1e-15 of u and v.
fn conformal_values(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; 2]> {
    if key.ride.is_on() {
        let (both, axes) = (key.disparity(model, time)?, key.baseline.axes());
        let [left, right] = [both.primary, both.secondary].map(|seen| axes.conformal(seen.position));
        let (left, right) = (left?, right?);
        return Some([left.u - right.u, left.v - right.v]);
    }
    let both = key.velocity.conformal(model, key.point, &key.baseline, time).ok()??;
    Some([both.du, both.dv])
}

/// Delta-u at `time` of the point at rest where it is in its own frame, for eyes gamma d apart; `None` where motion is no slide.
fn resting_value(key: &CurvesKey, time: f64) -> Option<f64> {
    if key.ride.is_on() {
        return None;
    }
    Some(key.velocity.resting_conformal(key.point, &key.baseline, time).ok()??.du)
}

/// The pieces of curves of u and v, if these are wanted.
fn conformal_pieces<const N: usize>(
    key: &CurvesKey,
    bends: &Bends,
    values: impl Fn(f64) -> Option<[f64; N]>,
) -> [Pieces; N] {
    let mut all = std::array::from_fn(|_| Pieces::new());
    if key.conformal {
        for piece in pieces(key.range, bends, &values) {
            for (channel, points) in channels(&sampled(piece, bends, &values)).into_iter().enumerate() {
                all[channel].push(points);
            }
        }
    }
    all
}

/// Returns the stereo position of the point of `key` in this `model` at `time`; `None` where the lines of sight do not meet.
fn fused(key: &CurvesKey, model: Model, time: f64) -> Option<Stereo> {
    let pair = key.baseline.stereo_apertures(key.ride.is_on());
    key.velocity.stereo_before(&key.observer(time), model, key.point, pair).ok()
}

/// The distances from each eye to where it sees the point of `key` in this `model` at `time`; `None` outside the domain of the core.
fn seen_distances(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; 2]> {
    let both = key.disparity(model, time)?;
    Some([both.primary.distance, both.secondary.distance])
}

/// Returns the distance of the point of `key` at `time`, as measured in the observer's frame; no number of a point that turns before
/// eyes that ride.
fn measured_distance(key: &CurvesKey, time: f64) -> f64 {
    let speed = &key.velocity.speed;
    if key.ride.is_on() {
        let there = key.velocity.past(&key.observer(time), key.point.rest.to_array());
        let there = there.filter(|_| key.point.spin.is_none());
        return there.map_or(f64::NAN, |(_, SourcePoint { x0, y, z })| math::hypot(x0, math::hypot(y, z)));
    }
    let SourcePoint { x0, y, z } = key.velocity.reflected_source(key.point).place_when_measured(speed, time);
    [x0 + speed.beta() * time, y, z].map(|along| along * along).iter().sum::<f64>().sqrt()
}

/// Logs of the stereo gain and of the distance at which two eyes take the point to be, where they do.
fn stereo_values(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; 2]> {
    let fused = fused(key, model, time)?;
    logs([fused.gain, fused.distance()])
}

/// Logs of the distances that there are at every T, in the order of their curves.
fn distance_values(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; 3]> {
    let [left, right] = seen_distances(key, model, time)?;
    logs([measured_distance(key, time), right, left])
}

fn logs<const N: usize>(values: [f64; N]) -> Option<[f64; N]> {
    let logs = values.map(math::log10);
    logs.iter().all(|log| log.is_finite()).then_some(logs)
}

fn channels<const N: usize>(samples: &[Sample<N>]) -> [Vec<PlotPoint>; N] {
    std::array::from_fn(|channel| {
        samples.iter().map(|sample| PlotPoint::new(sample.time, sample.values[channel])).collect()
    })
}
