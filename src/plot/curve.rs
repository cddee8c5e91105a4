//! Sampling of curves, densely where they bend: intervals are halved where their chords are off, all of them
//! once before any of them twice, until there are too many samples.

use crate::time_range::time_within;

/// Largest distance of a drawn chord from the curve, as a fraction of the curve's height: a third of a
/// pixel in a plot 600 pixels high.
const TOLERANCE: f64 = 1.0 / 1800.0;
/// The bounds of a curve over T. A jump (phi of a point at y = 0) ends at the deepest interval.
const OF_CURVES: RefinementLimits = RefinementLimits { depth: 16, samples: 10_000 };
/// The greatest distance of a sample that is left out from the one before, as a part of a chord's greatest
/// distance from the curve: a drawn curve is off by both together at most.
const LEFT_OUT: f64 = 0.5;
/// The fraction of an interval where the chord of a curve that oscillates is held against it besides in the
/// middle, since halfway to the other side of a peak it is on the chord.
const BESIDE_MIDDLE: f64 = 0.3;
/// Halvings of an interval in which values begin or cease.
const GAP_DEPTH: u32 = 6;

/// The bounds of a refinement.
#[derive(Debug, Clone, Copy)]
pub struct RefinementLimits {
    /// Greatest number of halvings of one of the first intervals.
    pub depth: u32,
    /// From this many samples on nothing is divided any more, however the curve bends.
    pub samples: usize,
}

/// The `first` samples, and between neighbours those that `halfway` returns: the sample in the middle of two,
/// or `None` where the chord between them is near enough to the curve. Every part of the curve has its share
/// of the samples.
pub fn refined<S: Copy>(
    first: Vec<S>,
    limits: RefinementLimits,
    halfway: impl Fn([S; 2]) -> Option<S>,
) -> Vec<S> {
    const NONE: usize = usize::MAX;
    let mut samples = first;
    // The number of the sample after each.
    let mut next: Vec<usize> = (1..samples.len()).chain([NONE]).collect();
    let mut open: Vec<(usize, u32)> = (1..samples.len()).map(|end| (end - 1, limits.depth)).collect();
    let mut checked = 0;
    while let Some(&(start, depth)) = open.get(checked).filter(|_| samples.len() < limits.samples) {
        checked += 1;
        let Some(middle) = halfway([samples[start], samples[next[start]]]) else { continue };
        let place = samples.len();
        samples.push(middle);
        next.push(next[start]);
        next[start] = place;
        if depth > 1 {
            open.extend([(start, depth - 1), (place, depth - 1)]);
        }
    }
    let first = (!samples.is_empty()).then_some(0);
    let order = std::iter::successors(first, |&place| Some(next[place]).filter(|&place| place != NONE));
    order.map(|place| samples[place]).collect()
}

/// Values at one T.
#[derive(Debug, Clone, Copy)]
pub struct CurveSample<const N: usize> {
    /// Observation time T.
    pub time: f64,
    /// Values at that time.
    pub values: [f64; N],
}

/// The way a curve over T is sampled.
#[derive(Debug, Clone)]
pub struct CurveSampling {
    /// The times at which it is sampled at least, from the first to the last T.
    pub times: Vec<f64>,
    /// Whether it goes up and down.
    pub oscillates: bool,
    /// The time from which on it is sampled densely, if not from the first.
    pub dense_from: Option<f64>,
}

impl CurveSampling {
    /// Samples a smooth curve over `range` in at least so many `parts`.
    #[must_use]
    pub fn even(range: [f64; 2], parts: u32) -> Self {
        Self { times: even_times(range, parts).collect(), oscillates: false, dense_from: None }
    }

    /// `values` in order of T, densely where they bend; without the times at which there are none.
    pub fn samples<const N: usize>(&self, values: impl Fn(f64) -> Option<[f64; N]>) -> Vec<CurveSample<N>> {
        let sample = |time| values(time).map(|values| CurveSample { time, values });
        let first: Vec<CurveSample<N>> = self.times.iter().copied().filter_map(sample).collect();
        let tolerances = tolerances(&first);
        let samples = refined(first, OF_CURVES, |ends| {
            let [from, to] = ends.map(|end| end.time);
            if Some(from) < self.dense_from {
                return None;
            }
            let inside = |part| {
                sample(time_within([from, to], part)).filter(|found| from < found.time && found.time < to)
            };
            let is_off = |found: &CurveSample<N>| is_off(found, ends, &tolerances);
            let middle = inside(0.5)?;
            let is_bent = is_off(&middle)
                || (self.oscillates && inside(BESIDE_MIDDLE).is_some_and(|found| is_off(&found)));
            is_bent.then_some(middle)
        });
        let width = self.times.last().zip(self.times.first()).map_or(0.0, |(last, first)| last - first);
        thinned(&samples, &tolerances, width * TOLERANCE)
    }

    /// The parts of the range in which there are `values`.
    pub fn pieces<const N: usize>(&self, values: impl Fn(f64) -> Option<[f64; N]>) -> Vec<[f64; 2]> {
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
        for &time in &self.times {
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
}

/// The ends of so many equal `parts` of `range`.
pub fn even_times(range: [f64; 2], parts: u32) -> impl Iterator<Item = f64> {
    (0..=parts).map(move |part| time_within(range, f64::from(part) / f64::from(parts)))
}

/// Without the samples that lie on the one before, as drawn, and on the way to the next: a line through them
/// would be drawn uneven.
fn thinned<const N: usize>(
    samples: &[CurveSample<N>],
    tolerances: &[f64; N],
    time_tolerance: f64,
) -> Vec<CurveSample<N>> {
    let tolerances = tolerances.map(|tolerance| LEFT_OUT * tolerance);
    let mut kept: Vec<CurveSample<N>> = Vec::with_capacity(samples.len());
    for (sample, next) in samples.iter().zip(samples.iter().skip(1).map(Some).chain([None])) {
        let is_left_out = kept.last().zip(next).is_some_and(|(last, next)| {
            sample.time - last.time < time_tolerance
                && (0..N).all(|i| (sample.values[i] - last.values[i]).abs() <= tolerances[i])
                && !is_off(sample, [*last, *next], &tolerances)
        });
        if !is_left_out {
            kept.push(*sample);
        }
    }
    kept
}

/// Returns the greatest distance of a chord from each curve.
fn tolerances<const N: usize>(samples: &[CurveSample<N>]) -> [f64; N] {
    std::array::from_fn(|channel| {
        let values = samples.iter().map(|sample| sample.values[channel]);
        let lowest = values.clone().fold(f64::INFINITY, f64::min);
        let highest = values.fold(f64::NEG_INFINITY, f64::max);
        // What a curve of hardly any height does within its rounding is no bend.
        let rounding = 16.0 * f64::EPSILON * highest.abs().max(lowest.abs());
        ((highest - lowest) * TOLERANCE).max(rounding).max(f64::MIN_POSITIVE)
    })
}

/// Whether a sample is off the chord between two others.
fn is_off<const N: usize>(
    found: &CurveSample<N>,
    [start, end]: [CurveSample<N>; 2],
    tolerances: &[f64; N],
) -> bool {
    let part = (found.time - start.time) / (end.time - start.time);
    (0..N).any(|i| {
        (found.values[i] - time_within([start.values[i], end.values[i]], part)).abs() > tolerances[i]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Halves intervals longer than `length`.
    fn halved(length: f64, limits: RefinementLimits) -> Vec<f64> {
        refined(vec![0.0, 1.0, 3.0], limits, |[a, b]| (b - a > length).then(|| f64::midpoint(a, b)))
    }

    #[test]
    fn refined_samples_are_in_order_and_as_dense_as_asked_for() {
        let limits = RefinementLimits { depth: 20, samples: 1000 };
        let samples = halved(0.1, limits);
        assert_eq!((samples[0], samples.last()), (0.0, Some(&3.0)));
        assert!(samples.windows(2).all(|pair| (0.05..=0.1).contains(&(pair[1] - pair[0]))), "{samples:?}");
        assert_eq!(halved(0.1, RefinementLimits { depth: 1, ..limits }), [0.0, 0.5, 1.0, 2.0, 3.0]);
        assert!(refined(Vec::<f64>::new(), limits, |_| None).is_empty());
    }

    /// Where there is not room for all, no interval is far shorter than another.
    #[test]
    fn a_bound_is_kept_and_shared() {
        let samples = halved(1e-9, RefinementLimits { depth: 60, samples: 100 });
        let widths = || samples.windows(2).map(|pair| pair[1] - pair[0]);
        assert_eq!(samples.len(), 100);
        assert!(widths().fold(0.0, f64::max) <= 4.0 * widths().fold(1.0, f64::min));
    }

    /// Curves of one bend each are drawn within the greatest distance of a chord and of what is left out,
    /// also where they are steep.
    #[test]
    fn a_drawn_curve_is_near_the_curve() {
        let curves: [fn(f64) -> f64; 4] = [
            |time| (20.0 * (time - 0.3)).tanh(),
            |time| (2000.0 * (time - 0.3)).tanh(),
            |time| 1.0 / (1.0 + (30.0 * (time - 0.301)).powi(2)),
            |time| 1e-3f64.atan2(time),
        ];
        for (number, curve) in curves.into_iter().enumerate() {
            let samples = CurveSampling::even([-5.0, 5.0], 128).samples(|time| Some([curve(time)]));
            let [low, high] = [curve(-5.0), curve(5.0), curve(0.301)]
                .into_iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                    [low.min(value), high.max(value)]
                });
            for pair in samples.windows(2) {
                for part in [0.2, 0.4, 0.6, 0.8] {
                    let time = time_within([pair[0].time, pair[1].time], part);
                    let drawn = time_within([pair[0].values[0], pair[1].values[0]], part);
                    let off = (drawn - curve(time)).abs() / (high - low);
                    assert!(off <= (1.0 + LEFT_OUT) * TOLERANCE, "curve {number}, T = {time}: {off}");
                }
            }
        }
    }

    #[test]
    fn a_curve_that_bends_everywhere_has_no_more_samples_than_are_allowed() {
        let noise = |time: f64| Some([(1_234_567_891.0 * time).sin()]);
        let samples = CurveSampling::even([0.0, 1.0], 64).samples(noise);
        assert!((1000..=OF_CURVES.samples).contains(&samples.len()), "{}", samples.len());
    }
}
