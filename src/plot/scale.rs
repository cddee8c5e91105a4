//! Where axes begin and end, and where their ticks are.

use relativity_core::math;

/// About how many ticks an axis has.
const TICKS: f64 = 6.0;

/// From the least to the largest of `values`, and `margin` of that more at both ends.
pub fn span(values: impl Iterator<Item = f64> + Clone, margin: f64) -> [f64; 2] {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(f64::NEG_INFINITY, f64::max);
    let room = margin * (high - low);
    if high > low { [low - room, high + room] } else { [low - 1.0, low + 1.0] }
}

/// Share of a logarithmic axis that stays free at each end, so that nothing is drawn on the frame.
const FREE: f64 = 0.05;

/// Exponents of the powers of ten around `values`, and as much more as leaves both ends free.
pub fn decades(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let [low, high] = span(values.map(math::log10), 0.0);
    let [from, to] = [low.floor(), high.ceil().max(low.floor() + 1.0)];
    let free = FREE * (to - from);
    [from.min(low - free), to.max(high + free)]
}

/// About [`TICKS`] powers of ten whose exponents lie in `range`.
pub fn powers_of_ten([low, high]: [f64; 2]) -> Vec<(f64, String)> {
    let step = ((high - low) / TICKS).ceil().max(1.0) as usize;
    let exponents = (low.ceil() as i32..=high.floor() as i32).step_by(step);
    exponents.map(|exponent| (10.0_f64.powi(exponent), power_label(exponent))).collect()
}

fn power_label(exponent: i32) -> String {
    let superscript = |digit: char| match digit {
        '-' => '\u{207b}',
        '1' => '\u{b9}',
        '2' => '\u{b2}',
        '3' => '\u{b3}',
        // The other superscripts are in one row.
        digit => digit.to_digit(10).and_then(|digit| char::from_u32(0x2070 + digit)).unwrap_or(digit),
    };
    format!("10{}", exponent.to_string().chars().map(superscript).collect::<String>())
}

/// The range of this `length` with the same middle.
pub fn widened([low, high]: [f64; 2], length: f64) -> [f64; 2] {
    let middle = 0.5 * (low + high);
    [middle - 0.5 * length, middle + 0.5 * length]
}

/// Round values inside `range`, and how they are written.
pub fn linear_ticks(range: [f64; 2]) -> Vec<(f64, String)> {
    ticks(range).into_iter().map(|value| (value, tick_label(value))).collect()
}

/// Round values inside `range`: multiples of 1, 2 or 5 times a power of ten.
fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let step = round_step((high - low) / TICKS);
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    (first..=last).map(|n| n as f64 * step).collect()
}

/// The least of 1, 2 and 5 times a power of ten that is not below `step`.
pub fn round_step(step: f64) -> f64 {
    let power = math::powf(10.0, math::log10(step).floor());
    let leading = step / power;
    power * [1.0, 2.0, 5.0, 10.0].into_iter().find(|&nice| nice >= leading).unwrap_or(10.0)
}

/// At most six significant digits: what is left of them is rounding.
fn tick_label(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    rounded.to_string().replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: Vec<(f64, String)>) -> Vec<String> {
        ticks.into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(labels(linear_ticks([-0.35, 0.08])), ["−0.3", "−0.2", "−0.1", "0"]);
        assert_eq!(labels(linear_ticks([0.0, 11.0])), ["0", "2", "4", "6", "8", "10"]);
    }

    #[test]
    fn logarithmic_axes_go_from_power_to_power() {
        assert_eq!(decades([3e-4, 0.02, 5.0].into_iter()), [-4.0, 1.0]);
        assert_eq!(decades([1e-4, 0.02, 10.0].into_iter()), [-4.25, 1.25]);
        assert_eq!(
            labels(powers_of_ten([-10.0, 2.0])),
            ["10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰", "10²"]
        );
    }
}
