//! The numbers at ticks: as many digits as distinguish neighbours, in units of a power of ten that stands in
//! the axis' label.

use relativity_core::math;

use super::grid::{Grid, power_of_ten, scaled};

/// Returns the power of ten in which values up to `largest` are written: 0 for short ones, else a multiple of
/// three.
pub fn common_exponent(largest: f64) -> i32 {
    if largest == 0.0 {
        return 0;
    }
    let exponent = math::log10(largest * (1.0 + 1e-12)).floor() as i32;
    if (-1..=3).contains(&exponent) { 0 } else { 3 * (exponent + 1).div_euclid(3) }
}

/// Returns the text at a place of `grid`: as many digits as distinguish it from its neighbours.
pub fn text(grid: &Grid, number: i64, exponent: i32) -> String {
    let decimals = |power: i32| (-power).max(0) as usize;
    let text = match *grid {
        Grid::Steps { .. } if number == 0 => "0".to_owned(),
        Grid::Steps { leading, power } => {
            let digits = (number * i64::from(leading)) as f64;
            format!("{:.*}", decimals(power - exponent), scaled(digits, power - exponent))
        }
        Grid::LogSteps { leading, power } => {
            let (digits, most) = ((number * i64::from(leading)) as f64, decade_of(grid, number));
            if (-3..=3).contains(&most) {
                format!("{:.*}", decimals(power), scaled(digits, power))
            } else {
                let mantissa = format!("{:.*}", decimals(power - most), scaled(digits, power - most));
                format!("{mantissa}·{}", power_text(most))
            }
        }
        Grid::Digits(digits) => {
            let (decade, digit) = Grid::digit(digits, number);
            digit_text(digit, decade as i32)
        }
        Grid::Decades { leading, power } => {
            digit_text(1, scaled((number * i64::from(leading)) as f64, power) as i32)
        }
    };
    text.replace('-', "\u{2212}")
}

/// Returns the power of ten of the number at this place.
fn decade_of(grid: &Grid, number: i64) -> i32 {
    grid.place(number).map_or(0, |place| (place + 1e-12).floor() as i32)
}

/// A `digit` times 10 to the power of `exponent`.
fn digit_text(digit: u8, exponent: i32) -> String {
    match (digit, exponent) {
        (_, -3..=3) => {
            format!("{:.*}", (-exponent).max(0) as usize, f64::from(digit) * power_of_ten(exponent))
        }
        (1, _) => power_text(exponent),
        _ => format!("{digit}·{}", power_text(exponent)),
    }
}

fn power_text(exponent: i32) -> String {
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

/// Returns the label of an axis, `symbol / unit`, whose numbers are in units of 10 to the power of
/// `exponent`.
pub fn with_factor(label: &str, exponent: i32) -> String {
    if exponent == 0 {
        return label.to_owned();
    }
    let power = power_text(exponent);
    match label.split_once(" / ") {
        Some((what, unit)) => format!("{what} / {power} {unit}"),
        None => format!("{label} / {power}"),
    }
}
