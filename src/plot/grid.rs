//! Round places along an axis: multiples of 1, 2 or 5 times a power of ten; along a logarithm also 1, 2 and 5
//! of each decade, and decades.

use std::ops::Range;

use relativity_core::math;

/// A rule by which places are round.
#[derive(Debug, Clone, Copy)]
pub enum Grid {
    /// Multiples of a leading digit times a power of ten.
    Steps { leading: u8, power: i32 },
    /// Logarithms of such multiples.
    LogSteps { leading: u8, power: i32 },
    /// Logarithms of these digits times powers of ten.
    Digits(&'static [u8]),
    /// Logarithms of powers of ten, by steps of a leading digit times a power of ten between their exponents.
    Decades { leading: u8, power: i32 },
}

/// Leading digits of steps.
const LEADING: [u8; 3] = [1, 2, 5];
/// Logarithms less wide than this may have places at even steps of the number.
const NARROW_LOGARITHM: f64 = 1.5;
/// More places than this on an axis are not counted where a grid is chosen.
const MOST: i64 = 12;
/// Distance beyond the end of an axis, as a part of it, up to which a place still lies on it: rounding.
const ROUNDING: f64 = 1e-9;

/// 10 to the power of `exponent`.
pub fn power_of_ten(exponent: i32) -> f64 {
    math::powf(10.0, f64::from(exponent))
}

/// `digits` times that, rounded once where that can be.
pub fn scaled(digits: f64, exponent: i32) -> f64 {
    if exponent < 0 { digits / power_of_ten(-exponent) } else { digits * power_of_ten(exponent) }
}

/// Steps of which about five fit into `width`, with the next ones on both sides.
fn steps(width: f64) -> impl Iterator<Item = (u8, i32)> {
    let power = math::log10(width / 5.0).floor() as i32;
    (power - 1..=power + 1).flat_map(|power| LEADING.map(|leading| (leading, power)))
}

/// Returns the count of numbers.
pub const fn count(numbers: &Range<i64>) -> usize {
    (numbers.end - numbers.start) as usize
}

impl Grid {
    /// Returns the grids that may suit a linear axis.
    pub fn linear([low, high]: [f64; 2]) -> Vec<Self> {
        steps(high - low).map(|(leading, power)| Self::Steps { leading, power }).collect()
    }

    /// Returns the grids that may suit an axis between two logarithms.
    pub fn logarithmic([low, high]: [f64; 2]) -> Vec<Self> {
        let mut grids = vec![Self::Digits(&[1, 2, 5]), Self::Digits(&[1, 5])];
        let decades = steps(high - low).filter(|&(_, power)| power >= 0);
        grids.extend(decades.map(|(leading, power)| Self::Decades { leading, power }));
        let [from, to] = [low, high].map(|log| math::powf(10.0, log));
        if high - low < NARROW_LOGARITHM && from > 0.0 && to.is_finite() {
            grids.extend(steps(to - from).map(|(leading, power)| Self::LogSteps { leading, power }));
        }
        grids
    }

    /// Returns the place with this `number`; `None` where a logarithm has none.
    pub fn place(&self, number: i64) -> Option<f64> {
        match *self {
            Self::Steps { leading, power } | Self::Decades { leading, power } => {
                Some(scaled((number * i64::from(leading)) as f64, power))
            }
            Self::LogSteps { leading, power } => {
                (number > 0).then(|| math::log10(scaled((number * i64::from(leading)) as f64, power)))
            }
            Self::Digits(digits) => {
                let (decade, digit) = Self::digit(digits, number);
                Some(decade as f64 + math::log10(f64::from(digit)))
            }
        }
    }

    /// The decade, and the digit in it.
    pub fn digit(digits: &[u8], number: i64) -> (i64, u8) {
        let count = i64::from(digits.len() as u32);
        (number.div_euclid(count), digits[number.rem_euclid(count) as usize])
    }

    /// The number of a place not far below `low`.
    fn below(&self, low: f64) -> i64 {
        let whole = |ratio: f64| ratio.floor() as i64 - 1;
        match *self {
            Self::Steps { leading, power } | Self::Decades { leading, power } => {
                whole(low / scaled(f64::from(leading), power))
            }
            Self::LogSteps { leading, power } => {
                whole(math::powf(10.0, low) / scaled(f64::from(leading), power)).max(0)
            }
            Self::Digits(digits) => low.floor() as i64 * i64::from(digits.len() as u32) - 1,
        }
    }

    /// The steps that are as close as they can be with so much from one to the next.
    pub fn spaced(least: f64) -> Self {
        let power = math::log10(least).floor() as i32;
        let leading = LEADING.into_iter().find(|&leading| scaled(f64::from(leading), power) >= least);
        leading.map_or(Self::Steps { leading: 1, power: power + 1 }, |leading| Self::Steps { leading, power })
    }

    /// The numbers of the grid's places in a range, or the first of them.
    pub fn numbers(&self, range: [f64; 2]) -> Range<i64> {
        self.first_numbers(range, MOST)
    }

    /// The numbers of the first places in a range, so many at `most`.
    pub fn first_numbers(&self, [low, high]: [f64; 2], most: i64) -> Range<i64> {
        let rounding = ROUNDING * (high - low);
        let mut first = self.below(low);
        while self.place(first).is_none_or(|place| place < low - rounding) {
            first += 1;
        }
        let is_inside = |number: &i64| self.place(*number).is_some_and(|place| place <= high + rounding);
        let beyond = (first..first + most).find(|number| !is_inside(number));
        first..beyond.unwrap_or(first + most)
    }

    /// `range` widened to the next places, whichever is nearer, until there are so `many`.
    pub fn widened(&self, range: [f64; 2], many: usize) -> [f64; 2] {
        let [mut low, mut high] = range;
        let Range { start: mut first, mut end } = self.numbers(range);
        while count(&(first..end)) < many {
            let above = self.place(end);
            let below = self.place(first - 1);
            match (below, above) {
                (Some(below), above) if above.is_none_or(|above| low - below < above - high) => {
                    low = low.min(below);
                    first -= 1;
                }
                (_, Some(above)) => {
                    high = high.max(above);
                    end += 1;
                }
                _ => break,
            }
        }
        [low, high]
    }
}
