//! Curves of a point over T, sampled densely where they bend, and kept until something they depend on
//! changes.

use egui_plot::PlotPoint;
use relativity_core::math;
use relativity_core::{
    Aperture, Baseline, Model, PublishedVariant, equidistance_time, observation_time_when_seen_at,
};
use relativity_render::{MaterialPoint, Velocity};

use crate::passage::time_within;

/// A quantity that is plotted against T.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Delta-phi.
    DeltaPhi,
    /// Delta-theta.
    DeltaTheta,
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
}

/// One curve of a point: of a quantity and, where that has several, which of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Curve {
    /// Delta-phi.
    DeltaPhi,
    /// Delta-theta.
    DeltaTheta,
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
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Stereo, Self::Seen(0), Self::Seen(1), Self::Measured];
}

/// What a point's curves depend on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvesKey {
    /// How the point moves.
    pub velocity: Velocity,
    /// Where it is at rest or turns, from between the eyes.
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
}

/// Every curve of one point.
#[derive(Debug, Clone)]
pub struct Curves {
    key: CurvesKey,
    shown: OfModel,
    exact: Option<OfModel>,
    published: [Vec<PlotPoint>; 2],
}

/// Those of one binocular model.
#[derive(Debug, Clone)]
struct OfModel {
    eyes: [Vec<PlotPoint>; EYES],
    /// Log gain, in pieces.
    gains: Vec<Vec<PlotPoint>>,
    /// Logs of the distances, each of the kind that its number says.
    distances: Vec<Vec<PlotPoint>>,
}

/// Delta-phi, Delta-theta, then phi, theta and log D of the left and of the right eye.
const EYES: usize = 8;

/// Largest distance of a drawn chord from the curve, as a fraction of the curve's height: a third of a
/// pixel in a plot 600 pixels high.
const TOLERANCE: f64 = 1.0 / 1800.0;
/// Most halvings of one of the first intervals. A jump (phi of a point at y = 0) ends there.
const MAX_DEPTH: u32 = 16;
/// From this many samples on nothing is divided any more, however it bends.
const MAX_SAMPLES: usize = 10_000;
/// Intervals at first.
const FIRST_INTERVALS: u32 = 64;
/// Halvings of the distance to each point of interest: features narrower than 2^-40 of the range show
/// as steps.
const RUNGS: i32 = 40;

impl OfModel {
    fn new(key: &CurvesKey, model: Model, anchors: &[f64]) -> Self {
        let eyes = channels(&sampled(key.range, anchors, |time| values(key, model, time)));
        let (mut gains, mut distances) = (Vec::new(), Vec::new());
        if key.stereo {
            distances
                .extend(channels(&sampled(key.range, anchors, |time| distance_values(key, model, time))));
            let values = |time| stereo_values(key, model, time);
            let pieces = if key.baseline.is_along_motion() {
                vec![key.range]
            } else {
                pieces(key.range, anchors, values)
            };
            for [gain, distance] in pieces.into_iter().map(|piece| channels(&sampled(piece, anchors, values)))
            {
                gains.push(gain);
                distances.push(distance);
            }
        }
        Self { eyes, gains, distances }
    }

    fn of(&self, curve: Curve) -> &[Vec<PlotPoint>] {
        if let Some(channel) = eyes_channel(curve) {
            return &self.eyes[channel..=channel];
        }
        let Curve::LogDistance(kind) = curve else { return &self.gains };
        let from = match kind {
            DistanceKind::Measured => 0,
            DistanceKind::Seen(eye) => 2 - eye,
            DistanceKind::Stereo => return self.distances.get(3..).unwrap_or_default(),
        };
        self.distances.get(from..=from).unwrap_or_default()
    }
}

/// Where a curve of what each eye sees is among the [`EYES`]; `None` of the others.
const fn eyes_channel(curve: Curve) -> Option<usize> {
    match curve {
        Curve::DeltaPhi => Some(0),
        Curve::DeltaTheta => Some(1),
        Curve::Phi(eye) => Some(2 + eye),
        Curve::Theta(eye) => Some(4 + eye),
        Curve::LogDoppler(eye) => Some(6 + eye),
        Curve::LogGain | Curve::LogDistance(_) => None,
    }
}

impl Curves {
    /// The curves for `key`.
    #[must_use]
    pub fn new(key: CurvesKey) -> Self {
        let anchors = bends(&key.velocity, key.point, key.baseline.apertures_or_limit());
        let of = |model| OfModel::new(&key, model, &anchors);
        let shown = of(key.model);
        let exact = (key.model != Model::Exact).then(|| of(Model::Exact));
        let published = if key.published {
            channels(&sampled(key.range, &anchors, |time| published_values(&key, time)))
        } else {
            [Vec::new(), Vec::new()]
        };
        Self { key, shown, exact, published }
    }

    /// What they were made for.
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
            _ if model == self.key.model => self.shown.of(curve),
            (Model::Published(_), _, Curve::DeltaPhi) => published(0),
            (Model::Published(_), _, Curve::DeltaTheta) => published(1),
            (Model::Exact, Some(exact), _) => exact.of(curve),
            _ => &[],
        }
    }
}

/// The published model, of which disparities have a curve.
pub const PUBLISHED: Model = Model::Published(PublishedVariant::AppendixA);

/// What a `curve` of the point of `key` is at `time` in this `model`, as plotted; `None` outside the domain of the core,
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
    let view = stereo_view(key, model, time)?;
    let value = match curve {
        Curve::LogDistance(kind) => view.distances[DistanceKind::ALL.iter().position(|&any| any == kind)?],
        _ => view.gain,
    };
    Some(math::log10(value?)).filter(|log| log.is_finite())
}

fn values(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; EYES]> {
    let both = key.velocity.disparity(model, key.point, key.baseline.apertures(), time).ok()?;
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
    let both = key.velocity.disparity(PUBLISHED, key.point, key.baseline.apertures(), time).ok()?;
    let values = [both.dphi, both.dtheta];
    values.iter().all(|value| value.is_finite()).then_some(values)
}

/// What two eyes make of a point at one T.
#[derive(Debug, Clone, Copy)]
pub struct StereoView {
    /// The stereo gain; none where the lines of sight do not meet.
    pub gain: Option<f64>,
    /// Of every [`DistanceKind`].
    pub distances: [Option<f64>; DistanceKind::ALL.len()],
}

/// What two eyes make in this `model` at `time` of the point of `key`; `None` outside the domain of the
/// core.
#[must_use]
pub fn stereo_view(key: &CurvesKey, model: Model, time: f64) -> Option<StereoView> {
    let fused = key.velocity.stereo(model, key.point, key.baseline.apertures_or_limit(), time).ok();
    let both = key.velocity.disparity(model, key.point, key.baseline.apertures(), time).ok()?;
    let source = key.velocity.reflected_source(key.point).place();
    let measured = [source.x0 + key.velocity.speed.beta() * time, source.y, source.z];
    let distances = [
        fused.map(|fused| fused.distance()),
        Some(both.primary.distance),
        Some(both.secondary.distance),
        Some(measured.map(|along| along * along).iter().sum::<f64>().sqrt()),
    ];
    Some(StereoView { gain: fused.map(|fused| fused.gain), distances })
}

/// Logs of the stereo gain and of the distance at which two eyes take the point to be, where they do.
fn stereo_values(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; 2]> {
    let StereoView { gain, distances: [stereo, ..] } = stereo_view(key, model, time)?;
    logs([gain?, stereo?])
}

/// Logs of the distances that there are at every T, in the order of their curves.
fn distance_values(key: &CurvesKey, model: Model, time: f64) -> Option<[f64; 3]> {
    let StereoView { distances: [_, left, right, measured], .. } = stereo_view(key, model, time)?;
    logs([measured?, right?, left?])
}

fn logs<const N: usize>(values: [f64; N]) -> Option<[f64; N]> {
    let logs = values.map(math::log10);
    logs.iter().all(|log| log.is_finite()).then_some(logs)
}

/// Halvings of an interval in which lines of sight begin or cease to meet: nearer to that the distance is beyond the plot.
const GAP_DEPTH: u32 = 6;

/// The parts of `range` in which there are `values`.
fn pieces<const N: usize>(
    range: [f64; 2],
    anchors: &[f64],
    values: impl Fn(f64) -> Option<[f64; N]>,
) -> Vec<[f64; 2]> {
    let is_there = |time| values(time).is_some();
    // From a time at which there are some towards one at which there are none.
    let edge = |mut there: f64, mut gone: f64| {
        for _ in 0..GAP_DEPTH {
            let middle = there.midpoint(gone);
            *if is_there(middle) { &mut there } else { &mut gone } = middle;
        }
        there
    };
    let mut found = Vec::new();
    let mut before: Option<f64> = None;
    let mut begun: Option<f64> = None;
    for time in first_times(range, anchors) {
        match (is_there(time), begun) {
            (true, None) => begun = Some(before.map_or(time, |gone| edge(time, gone))),
            (false, Some(first)) => {
                found.push([first, edge(before.unwrap_or(first), time)]);
                begun = None;
            }
            _ => {}
        }
        before = Some(time);
    }
    found.extend(begun.zip(before).map(|(first, last)| [first, last]));
    found
}

/// The times around which curves bend: T0, when the point is objectively abreast of each eye, and when that sees it there.
pub(super) fn bends(velocity: &Velocity, point: impl Into<MaterialPoint>, pair: [Aperture; 2]) -> Vec<f64> {
    let (speed, source) = (&velocity.speed, velocity.reflected_source(point).place());
    let pair = velocity.reflected_pair(pair);
    let equidistant = equidistance_time(speed, source, pair).ok().flatten();
    let abreast = pair.map(|aperture| (aperture.x - source.x0) / speed.beta());
    let seen = pair.map(|eye| observation_time_when_seen_at(speed, source, 0.0, [eye; 2]).ok().flatten());
    equidistant
        .into_iter()
        .chain(abreast)
        .chain(seen.into_iter().flatten())
        .filter(|time| time.is_finite())
        .collect()
}

/// Values at one T.
pub(super) struct Sample<const N: usize> {
    /// T.
    pub time: f64,
    /// Values there.
    pub values: [f64; N],
}

/// `values` over `range`, in order of T, densely where they bend; without the times at which there are none.
pub(super) fn sampled<const N: usize>(
    range: [f64; 2],
    anchors: &[f64],
    values: impl Fn(f64) -> Option<[f64; N]>,
) -> Vec<Sample<N>> {
    let sample = |time| values(time).map(|values| Sample { time, values });
    let first: Vec<Sample<N>> = first_times(range, anchors).into_iter().filter_map(&sample).collect();
    let tolerances = tolerances(&first);
    let mut refined = Vec::with_capacity(4 * first.len());
    for end in first {
        if let Some(start) = refined.pop() {
            refine(start, &end, &sample, &tolerances, MAX_DEPTH, &mut refined);
        }
        refined.push(end);
    }
    thinned(refined, &tolerances, (range[1] - range[0]) * TOLERANCE)
}

/// Without the samples that lie on the one before, as drawn: a line through them would be drawn uneven.
fn thinned<const N: usize>(
    samples: Vec<Sample<N>>,
    tolerances: &[f64; N],
    time_tolerance: f64,
) -> Vec<Sample<N>> {
    let mut kept: Vec<Sample<N>> = Vec::with_capacity(samples.len());
    for sample in samples {
        let same = kept.last().is_some_and(|last| {
            sample.time - last.time < time_tolerance
                && (0..N).all(|i| (sample.values[i] - last.values[i]).abs() <= 2.0 * tolerances[i])
        });
        if !same {
            kept.push(sample);
        }
    }
    kept
}

/// Even steps, and a ladder towards each anchor from both sides.
fn first_times([from, to]: [f64; 2], anchors: &[f64]) -> Vec<f64> {
    let width = to - from;
    let even =
        (0..=FIRST_INTERVALS).map(|i| time_within([from, to], f64::from(i) / f64::from(FIRST_INTERVALS)));
    let rungs = (1..=RUNGS).map(|k| width * 0.5f64.powi(k));
    let ladders = anchors.iter().flat_map(|anchor| {
        std::iter::once(*anchor).chain(rungs.clone().flat_map(move |rung| [anchor - rung, anchor + rung]))
    });
    let mut times: Vec<f64> = even.chain(ladders).filter(|time| (from..=to).contains(time)).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// How far a chord may be from each curve.
fn tolerances<const N: usize>(samples: &[Sample<N>]) -> [f64; N] {
    std::array::from_fn(|channel| {
        let values = samples.iter().map(|sample| sample.values[channel]);
        let lowest = values.clone().fold(f64::INFINITY, f64::min);
        let highest = values.fold(f64::NEG_INFINITY, f64::max);
        // What a curve of hardly any height does within its rounding is no bend.
        let rounding = 16.0 * f64::EPSILON * highest.abs().max(lowest.abs());
        ((highest - lowest) * TOLERANCE).max(rounding).max(f64::MIN_POSITIVE)
    })
}

/// Pushes `start` and what lies between it and `end`, both exclusive of `end`.
fn refine<const N: usize>(
    start: Sample<N>,
    end: &Sample<N>,
    sample: &impl Fn(f64) -> Option<Sample<N>>,
    tolerances: &[f64; N],
    depth: u32,
    refined: &mut Vec<Sample<N>>,
) {
    let time = start.time.midpoint(end.time);
    let Some(middle) = sample(time).filter(|_| depth > 0 && start.time < time && time < end.time) else {
        return refined.push(start);
    };
    let straight = (0..N).all(|i| {
        let chord = start.values[i].midpoint(end.values[i]);
        (middle.values[i] - chord).abs() <= tolerances[i]
    });
    if straight || refined.len() >= MAX_SAMPLES {
        return refined.push(start);
    }
    let middle_values = middle.values;
    refine(start, &middle, sample, tolerances, depth - 1, refined);
    refine(Sample { time, values: middle_values }, end, sample, tolerances, depth - 1, refined);
}

fn channels<const N: usize>(samples: &[Sample<N>]) -> [Vec<PlotPoint>; N] {
    std::array::from_fn(|channel| {
        samples.iter().map(|sample| PlotPoint::new(sample.time, sample.values[channel])).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(beta: f64, point: [f64; 3]) -> CurvesKey {
        let velocity = Velocity::from_beta(beta).expect("in range");
        let [x0, y, z] = point;
        let rest = [x0 * velocity.speed.gamma(), y, z];
        let model = Model::OneCone;
        CurvesKey {
            velocity,
            point: rest.into(),
            baseline: Baseline::straight(0.3),
            range: [-2.0, 5.0],
            model,
            published: true,
            stereo: true,
        }
    }

    /// Linear interpolation in a drawn curve.
    fn drawn(curve: &[PlotPoint], time: f64) -> f64 {
        let after = curve.partition_point(|point| point.x < time).clamp(1, curve.len() - 1);
        let (a, b) = (curve[after - 1], curve[after]);
        a.y + (b.y - a.y) * (time - a.x) / (b.x - a.x)
    }

    #[test]
    fn drawn_curves_stay_within_a_pixel_of_the_exact_ones() {
        for (beta, point) in [
            (0.0, [0.0, 0.5, 0.5]),
            (0.9, [0.0, 0.5, 0.5]),
            (0.9999, [0.3, 3.0, 2.0]),
            (0.9, [0.0, 1e-3, 1e-3]),
        ] {
            let key = key(beta, point);
            let curves = Curves::new(key);
            for (model, curves) in
                [(Model::OneCone, &curves.shown), (Model::Exact, curves.exact.as_ref().expect("another"))]
            {
                let curve = &curves.eyes[0];
                let height = curve.iter().map(|p| p.y).fold(0.0f64, |a, b| a.max(b.abs()));
                for i in 0..5000 {
                    let time = -2.0 + 7.0 * (f64::from(i) + 0.37) / 5000.0;
                    let exact = values(&key, model, time).expect("in the domain")[0];
                    assert!(
                        (drawn(curve, time) - exact).abs() <= height / 600.0,
                        "{model:?}, beta = {beta}, T = {time}: {} for {exact}",
                        drawn(curve, time)
                    );
                }
                assert!(curve.len() < 4000, "{} samples", curve.len());
            }
        }
    }

    #[test]
    fn every_drawn_value_is_finite() {
        for beta in [0.0, 0.5, 0.999_999_999_999_999_9] {
            for point in [[0.0, 0.0, 0.0], [0.15, 0.0, 0.0], [0.0, 0.0, 1.0], [1e6, 1e-9, 0.0]] {
                let curves = Curves::new(key(beta, point));
                let models = [Some(&curves.shown), curves.exact.as_ref()].into_iter().flatten();
                let models = models.flat_map(|of| of.eyes.iter().chain(&of.gains).chain(&of.distances));
                let all = models.chain(&curves.published).flatten();
                assert!(all.clone().all(|point| point.x.is_finite() && point.y.is_finite()));
                assert!(all.count() < 20_000, "beta = {beta}, {point:?}");
            }
        }
    }
}
