//! An axis: where it begins and ends, and its ticks, four to seven at round places.

use std::ops::Range;

use relativity_core::math;

use super::grid::{Grid, count, scaled};
use super::tick_text::{common_exponent, text, with_factor};

/// Fewest and most ticks.
const TICKS: [usize; 2] = [4, MOST_TICKS];
/// Greatest number of ticks of an axis.
pub const MOST_TICKS: usize = 7;
/// An axis is at least this wide, as a part of the values on it: what is narrower is rounding.
const NARROWEST: f64 = 1e-9;
/// Weight of a gap of the axis' whole length without a tick, in ticks too many or too few.
const GAP_WEIGHT: f64 = 8.0;

/// Greatest number of evenly spaced ticks, and greatest size of a number on their axis in steps from one to
/// the next: beyond either there are none.
const MOST_SPACED: i64 = 1000;
const FINEST: f64 = 1e15;

/// A mark along an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// Place of the tick; on a logarithmic axis the logarithm.
    pub place: f64,
    /// Text at the tick.
    pub text: String,
}

/// An axis, with its ticks.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Ends of the axis; on a logarithmic axis their logarithms.
    pub range: [f64; 2],
    /// From the lowest to the highest.
    pub ticks: Vec<Tick>,
    /// Power of ten that the numbers at the ticks are in units of.
    pub exponent: i32,
}

/// Returns the number of ticks that fit into `length`, where each takes `each`, pixels.
#[must_use]
pub fn ticks_along(length: f64, each: f64) -> usize {
    let [fewest, most] = TICKS;
    ((length / each).max(0.0) as usize).clamp(fewest, most)
}

/// From the least to the largest of `values`; `None` of none.
#[must_use]
pub fn extent(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values.fold(None, |extent, value| {
        let [low, high] = extent.unwrap_or([value; 2]);
        Some([low.min(value), high.max(value)])
    })
}

/// `range` with the same middle, at least so `wide`.
#[must_use]
pub fn at_least([low, high]: [f64; 2], wide: f64) -> [f64; 2] {
    if high - low >= wide {
        return [low, high];
    }
    let middle = low.midpoint(high);
    [middle - 0.5 * wide, middle + 0.5 * wide]
}

/// `range` and such a `share` of it more at both ends.
#[must_use]
pub fn with_margin([low, high]: [f64; 2], share: f64) -> [f64; 2] {
    let margin = share * (high - low);
    [low - margin, high + margin]
}

impl Axis {
    /// An axis over at least `range`, of logarithms if it is `logarithmic`: widened where there would not be
    /// four to seven ticks, and with about as many as are `wanted`.
    #[must_use]
    pub fn fitted(logarithmic: bool, range: [f64; 2], wanted: usize) -> Self {
        let range = widened(logarithmic, range, TICKS[1]);
        Self::within(logarithmic, range, wanted)
    }

    /// An axis over this `range` and no more, whose ticks may then be a few more or less than four to seven.
    #[must_use]
    pub fn within(logarithmic: bool, range: [f64; 2], wanted: usize) -> Self {
        let range = sound(range);
        let grids = grids(logarithmic, range);
        let [fewest, most] = TICKS;
        let misfit = |grid: &Grid| {
            let count = count(&grid.numbers(range));
            let amiss = count.clamp(fewest, most).abs_diff(count);
            let score = count.abs_diff(wanted) as f64 + GAP_WEIGHT * widest_gap(grid, range);
            (amiss, score)
        };
        let best = grids.into_iter().map(|grid| (misfit(&grid), grid));
        let best = best.min_by(|((a, x), _), ((b, y), _)| a.cmp(b).then(x.total_cmp(y)));
        best.map_or(Self::without_ticks(range), |(_, grid)| Self::on(&grid, range, grid.numbers(range)))
    }

    /// A linear axis over this `range` and no more, with all ticks that have at least so much between them;
    /// with none where these cannot be counted.
    #[must_use]
    pub fn spaced(range: [f64; 2], least: f64) -> Self {
        let [low, high] = range;
        let is_range = low.is_finite() && high.is_finite() && low < high && least > 0.0;
        if !is_range || high - low > MOST_SPACED as f64 * least || low.abs().max(high.abs()) > FINEST * least
        {
            return Self::without_ticks(range);
        }
        let grid = Grid::spaced(least);
        Self::on(&grid, range, grid.first_numbers(range, MOST_SPACED))
    }

    /// Returns `words`, the name of what is along the axis and its unit, with the power of ten that the
    /// numbers have in common.
    #[must_use]
    pub fn label(&self, words: &str) -> String {
        with_factor(words, self.exponent)
    }

    const fn without_ticks(range: [f64; 2]) -> Self {
        Self { range, ticks: Vec::new(), exponent: 0 }
    }

    fn on(grid: &Grid, range: [f64; 2], numbers: Range<i64>) -> Self {
        let largest = range[0].abs().max(range[1].abs());
        let exponent = if let Grid::Steps { .. } = grid { common_exponent(largest) } else { 0 };
        let tick = |number| {
            let place = grid.place(number)?.clamp(range[0], range[1]);
            Some(Tick { place, text: text(grid, number, exponent) })
        };
        Self { range, ticks: numbers.filter_map(tick).collect(), exponent }
    }
}

fn grids(logarithmic: bool, range: [f64; 2]) -> Vec<Grid> {
    if logarithmic { Grid::logarithmic(range) } else { Grid::linear(range) }
}

/// Returns `range` as little wider as it takes to have four ticks or more, but at most `most` (4 to 7).
#[must_use]
pub fn widened(logarithmic: bool, range: [f64; 2], most: usize) -> [f64; 2] {
    let range = sound(range);
    let fewest = TICKS[0];
    let grids = grids(logarithmic, range);
    if grids.iter().any(|grid| (fewest..=most).contains(&count(&grid.numbers(range)))) {
        return range;
    }
    let coarse = grids.into_iter().filter(|grid| count(&grid.numbers(range)) < fewest);
    let wider = coarse.map(|grid| grid.widened(range, fewest));
    wider.min_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0]))).unwrap_or(range)
}

/// Returns `range`, or a range around it if it is empty or too narrow for numbers to differ at its ends.
fn sound([low, high]: [f64; 2]) -> [f64; 2] {
    if !(low.is_finite() && high.is_finite() && low <= high) {
        return [-1.0, 1.0];
    }
    let least = NARROWEST * low.abs().max(high.abs());
    at_least(
        [low, high],
        if least > 0.0 {
            least
        } else if high > low {
            0.0
        } else {
            1.0
        },
    )
}

/// The widest part of the axis without a tick, as a share of it.
fn widest_gap(grid: &Grid, [low, high]: [f64; 2]) -> f64 {
    let places = grid.numbers([low, high]).filter_map(|number| grid.place(number));
    let (mut widest, mut last) = (0.0f64, low);
    for place in places.chain([high]) {
        widest = widest.max(place - last);
        last = place;
    }
    widest / (high - low)
}

/// Widths, of each power of ten, that leave room for four to seven steps of 1, 2 or 5 wherever they begin.
const ZOOM_WIDTHS: [f64; 6] = [1.0, 1.3, 2.2, 3.2, 4.4, 6.4];

/// The next narrower or wider of the widths that a linear axis is zoomed to.
#[must_use]
pub fn zoom_step(width: f64, inwards: bool) -> f64 {
    let power = math::log10(width).floor() as i32;
    let widths = (power - 1..=power + 1).flat_map(|power| ZOOM_WIDTHS.map(|digits| scaled(digits, power)));
    // What differs by less is the same width.
    let mut widths = widths.filter(|&next| if inwards { next < 0.95 * width } else { next > 1.05 * width });
    let next = if inwards { widths.next_back() } else { widths.next() };
    next.unwrap_or(width)
}

/// The least of 1, 2 and 5 times a power of ten that is not below `step`.
#[must_use]
pub fn round_step(step: f64) -> f64 {
    Grid::spaced(step).place(1).unwrap_or(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ranges of every size and place.
    fn ranges() -> impl Iterator<Item = [f64; 2]> {
        let widths = (-24..=24).map(|i| 10f64.powf(f64::from(i) / 4.0));
        widths.flat_map(|width| {
            (0..40).map(move |i| {
                let low = (f64::from(i) - 20.3) * 0.37 * width + f64::from(i % 3) * 11.0 * width;
                [low, low + width * (1.0 + 0.021 * f64::from(i))]
            })
        })
    }

    fn check(axis: &Axis, wide: [f64; 2]) {
        let [low, high] = axis.range;
        assert!(low <= wide[0] && high >= wide[1], "{wide:?} in {axis:?}");
        assert!((4..=7).contains(&axis.ticks.len()), "{wide:?}: {axis:?}");
        assert!(axis.ticks.iter().all(|tick| (low..=high).contains(&tick.place)), "{axis:?}");
        assert!(axis.ticks.windows(2).all(|pair| pair[0].place < pair[1].place), "{axis:?}");
        let mut texts: Vec<&str> = axis.ticks.iter().map(|tick| tick.text.as_str()).collect();
        texts.sort_unstable();
        texts.dedup();
        assert_eq!(texts.len(), axis.ticks.len(), "{axis:?}");
        // No more room than what the next tick takes.
        assert!(high - low <= 1.5 * (wide[1] - wide[0]), "{wide:?}: {axis:?}");
    }

    /// Returns the number in the text.
    fn number(text: &str, exponent: i32) -> f64 {
        let plain: f64 = text.replace('−', "-").parse().expect("a number");
        plain * 10f64.powi(exponent)
    }

    fn leading_digit(step: f64) -> f64 {
        let digit = step / 10f64.powf((step * 1.000_001).log10().floor());
        (digit * 1e6).round() / 1e6
    }

    #[test]
    fn linear_axes_have_four_to_seven_ticks_at_steps_of_1_2_or_5() {
        for wide in ranges() {
            for wanted in 4..=7 {
                let axis = Axis::fitted(false, wide, wanted);
                check(&axis, wide);
                let step = axis.ticks[1].place - axis.ticks[0].place;
                assert!([1.0, 2.0, 5.0].contains(&leading_digit(step)), "{step} {axis:?}");
                for tick in &axis.ticks {
                    let said = number(&tick.text, axis.exponent);
                    assert!((said - tick.place).abs() < 1e-6 * step, "{tick:?} {axis:?}");
                }
            }
        }
    }

    #[test]
    fn a_zoomed_axis_has_four_to_seven_ticks_wherever_it_begins() {
        for inwards in [true, false] {
            let mut width = 0.037;
            for _ in 0..20 {
                width = zoom_step(width, inwards);
                for i in 0..100 {
                    let low = f64::from(i - 30) * 0.013 * width;
                    let axis = Axis::within(false, [low, low + width], 5);
                    assert!((4..=7).contains(&axis.ticks.len()), "{low} {axis:?}");
                    assert!(((axis.range[1] - axis.range[0]) / width - 1.0).abs() < 1e-9);
                }
            }
            assert!(if inwards { width < 4e-5 } else { width > 40.0 }, "{width}");
        }
    }

    #[test]
    fn logarithmic_axes_have_four_to_seven_ticks() {
        for width in (0..200).map(|i| 0.02 * 1.06f64.powi(i)).filter(|&width| width < 300.0) {
            for i in 0..23 {
                let low = f64::from(i - 11) * 0.73;
                let wide = [low, low + width];
                for wanted in 4..=7 {
                    check(&Axis::fitted(true, wide, wanted), wide);
                }
            }
        }
    }

    #[test]
    fn a_constant_far_from_0_has_an_axis_of_numbers_that_differ() {
        for value in [1.0, -0.033_333_22, 1e12, 3e-9] {
            let axis = Axis::fitted(false, [value, value * (1.0 + 1e-15)], 5);
            check(&Axis { range: axis.range, ..axis.clone() }, axis.range);
        }
        for none in [[f64::NAN, 1.0], [f64::INFINITY, f64::NEG_INFINITY], [0.0, 0.0]] {
            let axis = Axis::fitted(false, none, 5);
            check(&axis, axis.range);
        }
    }

    fn texts(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|tick| tick.text.as_str()).collect()
    }

    #[test]
    fn numbers_are_short_and_their_power_of_ten_stands_in_the_label() {
        let axis = Axis::fitted(false, [-0.035, 0.008], 5);
        assert_eq!(texts(&axis), ["−30", "−20", "−10", "0"]);
        assert_eq!(axis.label("Δφ / rad"), "Δφ / 10⁻³ rad");
        let axis = Axis::fitted(false, [0.0, 11.0], 6);
        assert_eq!((texts(&axis), axis.exponent), (vec!["0", "2", "4", "6", "8", "10"], 0));
        assert_eq!(with_factor("T", 6), "T / 10⁶");
        assert_eq!(
            texts(&Axis::fitted(true, [-10.0, 2.0], 7)),
            ["10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "0.01", "1", "100"]
        );
        assert_eq!(texts(&Axis::fitted(true, [-0.1, 1.4], 5)), ["1", "2", "5", "10", "20"]);
        assert_eq!(texts(&Axis::fitted(true, [0.0, 0.15], 4)), ["1.0", "1.1", "1.2", "1.3", "1.4"]);
    }

    #[test]
    fn spaced_ticks_are_round_and_as_dense_as_allowed() {
        assert_eq!(texts(&Axis::spaced([-4.5, 4.9], 1.7)), ["−4", "−2", "0", "2", "4"]);
        assert_eq!(texts(&Axis::spaced([0.0, 0.11], 0.03)), ["0", "0.05", "0.10"]);
        let far = Axis::spaced([0.0, 3e7], 1e7);
        assert_eq!((texts(&far), far.exponent), (vec!["0", "10", "20", "30"], 6));
    }

    #[test]
    fn no_range_has_no_spaced_ticks() {
        for range in [[1.0, 1.0], [f64::NAN, 2.0], [0.0, f64::INFINITY], [1e30, 2e30]] {
            assert!(Axis::spaced(range, 1e-3).ticks.is_empty(), "{range:?}");
        }
    }
}
