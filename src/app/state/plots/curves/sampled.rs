//! Sampling of curves: even steps, ladders towards the times around which they bend, and halves where chords are off.

use super::Bends;
use crate::time_range::time_within;

/// Largest distance of a drawn chord from the curve, as a fraction of the curve's height: a third of a
/// pixel in a plot 600 pixels high.
const TOLERANCE: f64 = 1.0 / 1800.0;
/// Greatest number of halvings of one of the first intervals. A jump (phi of a point at y = 0) ends there.
const MAX_DEPTH: u32 = 16;
/// From this many samples on nothing is divided any more, however it bends.
const MAX_SAMPLES: usize = 10_000;
/// Number of intervals at first.
const FIRST_INTERVALS: u32 = 64;
/// Halvings of the distance to each point of interest: features narrower than 2^-40 of the range show
/// as steps.
const RUNGS: i32 = 40;

/// Values at one T.
#[derive(Debug, Clone, Copy)]
pub struct CurveSample<const N: usize> {
    /// Observation time T.
    pub time: f64,
    /// Values at that time.
    pub values: [f64; N],
}

/// `values` over `range`, in order of T, densely where they bend; without the times at which there are none.
pub fn sampled<const N: usize>(
    range: [f64; 2],
    bends: &Bends,
    values: impl Fn(f64) -> Option<[f64; N]>,
) -> Vec<CurveSample<N>> {
    let sample = |time| values(time).map(|values| CurveSample { time, values });
    let mut samples: Vec<CurveSample<N>> =
        first_times(range, bends).into_iter().filter_map(&sample).collect();
    let tolerances = tolerances(&samples);
    let is_clear = |ends: &[CurveSample<N>]| Some(ends[0].time) >= bends.blurred_until;
    let mut is_open: Vec<bool> = samples.windows(2).map(is_clear).collect();
    let checks = if bends.turns.is_empty() { &ON_CHORDS[..1] } else { &ON_CHORDS };
    // All at once, so that every part of the range has its share of the samples.
    for _ in 0..MAX_DEPTH {
        let mut room = MAX_SAMPLES.saturating_sub(samples.len());
        let middle = |(ends, &is_open): (&[CurveSample<N>], &bool)| {
            let middle = (is_open && room > 0)
                .then(|| bend([ends[0], ends[1]], checks, &sample, &tolerances))
                .flatten();
            room -= usize::from(middle.is_some());
            middle
        };
        let middles: Vec<_> = samples.windows(2).zip(&is_open).map(middle).collect();
        if middles.iter().all(Option::is_none) {
            break;
        }
        let halves =
            |middle: &Option<CurveSample<N>>| vec![middle.is_some(); 1 + usize::from(middle.is_some())];
        is_open = middles.iter().flat_map(halves).collect();
        let inside = middles.into_iter().chain([None]);
        samples = samples
            .into_iter()
            .zip(inside)
            .flat_map(|(start, middle)| [Some(start), middle])
            .flatten()
            .collect();
    }
    thinned(samples, &tolerances, (range[1] - range[0]) * TOLERANCE)
}

/// The greatest distance of a sample that is left out from the one before, as a part of a chord's greatest distance from the curve: a
/// drawn curve is off by both together at most.
const LEFT_OUT: f64 = 0.5;

/// Without the samples that lie on the one before, as drawn: a line through them would be drawn uneven.
fn thinned<const N: usize>(
    samples: Vec<CurveSample<N>>,
    tolerances: &[f64; N],
    time_tolerance: f64,
) -> Vec<CurveSample<N>> {
    let mut kept: Vec<CurveSample<N>> = Vec::with_capacity(samples.len());
    for sample in samples {
        let same = kept.last().is_some_and(|last| {
            sample.time - last.time < time_tolerance
                && (0..N).all(|i| (sample.values[i] - last.values[i]).abs() <= LEFT_OUT * tolerances[i])
        });
        if !same {
            kept.push(sample);
        }
    }
    kept
}

/// Even steps, every turn, and a ladder towards each other bend from both sides.
fn first_times([from, to]: [f64; 2], bends: &Bends) -> Vec<f64> {
    let width = to - from;
    let even =
        (0..=FIRST_INTERVALS).map(|i| time_within([from, to], f64::from(i) / f64::from(FIRST_INTERVALS)));
    let rungs = (1..=RUNGS).map(|k| width * 0.5f64.powi(k));
    let ladders = bends.passage.iter().flat_map(|anchor| {
        std::iter::once(*anchor).chain(rungs.clone().flat_map(move |rung| [anchor - rung, anchor + rung]))
    });
    let mut times: Vec<f64> = even
        .chain(ladders)
        .chain(bends.turns.iter().copied())
        .filter(|time| (from..=to).contains(time))
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
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

/// Halvings of an interval in which lines of sight begin or cease to meet: nearer to that the distance is beyond the plot.
const GAP_DEPTH: u32 = 6;

/// The parts of `range` in which there are `values`.
pub fn pieces<const N: usize>(
    range: [f64; 2],
    bends: &Bends,
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
    for time in first_times(range, bends) {
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

/// Fractions of an interval where chords are held against the curve: in the middle, and where a point turns also beside it, since halfway to
/// the other side of a peak it is on the chord.
const ON_CHORDS: [f64; 2] = [0.5, 0.3];

/// Returns the sample halfway between two others, unless the chord between them is near the curve `at` these parts of it, of which the
/// first is the half.
fn bend<const N: usize>(
    [start, end]: [CurveSample<N>; 2],
    at: &[f64],
    sample: &impl Fn(f64) -> Option<CurveSample<N>>,
    tolerances: &[f64; N],
) -> Option<CurveSample<N>> {
    let inside = |part| {
        let time = time_within([start.time, end.time], part);
        sample(time).filter(|_| start.time < time && time < end.time)
    };
    let is_off = |found: &CurveSample<N>, part| {
        (0..N).any(|i| {
            let chord = time_within([start.values[i], end.values[i]], part);
            (found.values[i] - chord).abs() > tolerances[i]
        })
    };
    let middle = inside(0.5)?;
    let is_bent = at.iter().any(|&part| {
        if part == 0.5 {
            is_off(&middle, part)
        } else {
            inside(part).is_some_and(|found| is_off(&found, part))
        }
    });
    is_bent.then_some(middle)
}
