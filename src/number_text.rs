//! Numbers as text on screen: fixed decimals, a true minus sign, and enough nines.

use std::borrow::Cow;

use gamow_platform::messages;
use relativity_core::Speed;
use relativity_core::math;

/// Sign for a number that does not exist.
pub const NONE: &str = "–";

/// Space between groups of digits.
const THIN_SPACE: char = '\u{2009}';

/// `value` with `decimals` digits after the point; in powers of ten, with two, where that would not
/// fit; a dash if it is not a number.
#[must_use]
pub fn fixed(value: f64, decimals: u8) -> String {
    if !value.is_finite() {
        return NONE.to_owned();
    }
    let text = if value.abs() >= 1e6 || (value != 0.0 && rounds_to_zero(value, decimals)) {
        format!("{value:.2e}")
    } else {
        format!("{value:.width$}", width = usize::from(decimals))
    };
    with_minus(&text)
}

/// Returns the number in `text` with the true minus sign.
#[must_use]
pub fn with_minus(text: &str) -> String {
    text.replace('-', "−")
}

/// Writes like [`fixed`], but 0 where the `decimals` would show nothing else.
#[must_use]
pub fn rounded(value: f64, decimals: u8) -> String {
    fixed(if rounds_to_zero(value, decimals) { 0.0 } else { value }, decimals)
}

fn rounds_to_zero(value: f64, decimals: u8) -> bool {
    value.abs() < 0.5 * 10f64.powi(-i32::from(decimals))
}

/// Writes like [`fixed`], without zeros at the end of the decimals.
#[must_use]
pub fn trimmed(value: f64, decimals: u8) -> String {
    let text = fixed(value, decimals);
    if text.contains('e') || !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Writes like [`fixed`], with a dash for `None`.
#[must_use]
pub fn fixed_or_none(value: Option<f64>, decimals: u8) -> String {
    value.map_or_else(|| NONE.to_owned(), |value| fixed(value, decimals))
}

/// beta with as many nines as it takes to see two or three digits of 1 - beta, in groups of three.
#[must_use]
pub fn beta(speed: &Speed) -> String {
    beta_to(speed, 2.0)
}

/// Writes like [`beta`], without zeros at the end.
#[must_use]
pub fn trimmed_beta(speed: &Speed) -> String {
    let text = beta(speed);
    if text.contains('e') {
        return text;
    }
    text.trim_end_matches(['0', THIN_SPACE]).trim_end_matches('.').to_owned()
}

/// beta at a glance: with as many nines as it takes to see the first digit of 1 - beta.
#[must_use]
pub fn short_beta(speed: &Speed) -> String {
    beta_to(speed, 0.0)
}

/// beta with so many more decimals than 1 - beta has zeros, but at least three.
fn beta_to(speed: &Speed, digits: f64) -> String {
    let distance = speed.one_minus_beta();
    if distance < 1e-12 {
        return format!("1 − {distance:.2e}").replace("e-", "e−");
    }
    // The slack keeps 1e-4, which is no sum of powers of two, from counting as the decade below.
    let decimals = (digits + (-math::log10(distance) - 1e-9).ceil()).max(3.0) as usize;
    grouped(&format!("{:.decimals$}", speed.beta()))
}

/// A thin space after every third decimal if there are more than four, as the SI writes numbers.
fn grouped(number: &str) -> String {
    let Some((whole, decimals)) = number.split_once('.').filter(|(_, decimals)| decimals.len() > 4) else {
        return number.to_owned();
    };
    let digits: Vec<char> = decimals.chars().collect();
    let groups: Vec<String> = digits.chunks(3).map(|group| group.iter().collect()).collect();
    format!("{whole}.{}", groups.join(&THIN_SPACE.to_string()))
}

/// Radians as written beside an angle: degrees with one decimal.
#[must_use]
pub fn degrees(radians: f64) -> String {
    format!("{}°", fixed(radians.to_degrees(), 1))
}

/// The shortest text that parses as `value`.
#[must_use]
pub fn shortest(value: f64) -> String {
    if value.abs() >= 1e9 { format!("{value:e}") } else { value.to_string() }
}

/// `value` with that many significant `digits`.
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    let magnitude = math::log10(value.abs()).floor();
    if value != 0.0 && !(-4.0..=digits as f64).contains(&magnitude) {
        return format!("{value:.precision$e}", precision = digits - 1);
    }
    let decimals = (digits as f64 - 1.0 - if value == 0.0 { 0.0 } else { magnitude }).max(0.0) as usize;
    format!("{value:.decimals$}")
}

/// Returns the number of decimals that show two digits of `uncertainty`, but no more than nine.
#[must_use]
pub fn decimals_of(uncertainty: f64) -> usize {
    const MOST: f64 = 9.0;
    if uncertainty > 0.0 {
        (1.0 - math::log10(uncertainty).floor()).clamp(0.0, MOST) as usize
    } else {
        MOST as usize
    }
}

/// Writes a number of bytes with this many significant `digits`, in the largest unit that leaves a number
/// above 1.
#[must_use]
pub fn bytes(count: u64, digits: i32) -> String {
    let (mut value, mut unit) = (count as f64, "bytes");
    for larger in ["kB", "MB", "GB", "TB"] {
        if value >= 1000.0 {
            (value, unit) = (value / 1000.0, larger);
        }
    }
    let step = 10.0_f64.powi(math::log10(value.max(1.0)).floor() as i32 + 1 - digits);
    let step = if unit == "bytes" { step.max(1.0) } else { step };
    let decimals = if step < 1.0 { math::log10(1.0 / step).round() as usize } else { 0 };
    format!("{:.decimals$} {unit}", (value / step).round() * step)
}

/// 10 to the power of `exponent`, as a number as short as it gets.
#[must_use]
pub fn power_of_ten(exponent: f64) -> String {
    let value = math::powf(10.0, exponent);
    if (0.001..10_000.0).contains(&value) {
        return format!("{}", (value * 1e4).round() / 1e4);
    }
    with_minus(&format!("{value:.0e}"))
}

/// The number a user typed: surrounding space, groups of digits, a true minus sign and a decimal comma are
/// all right.
pub fn parsed(text: &str) -> Result<f64, String> {
    let plain: String = text.chars().filter(|c| !c.is_whitespace()).collect::<String>().replace('−', "-");
    let plain = with_point(&plain);
    match plain.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("“{}” is not a number", messages::excerpt(text))),
    }
}

/// A number with a decimal point in place of a decimal comma. What has a point already, or more commas, is
/// left as it is.
#[must_use]
pub fn with_point(number: &str) -> Cow<'_, str> {
    if number.matches(',').count() == 1 && !number.contains('.') {
        Cow::Owned(number.replace(',', "."))
    } else {
        Cow::Borrowed(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_speed_at_a_glance_is_never_rounded_to_that_of_light() {
        for (beta, text) in [
            (0.0, "0.000"),
            (0.9, "0.900"),
            (0.995_054_75, "0.995"),
            (0.999, "0.999"),
            (0.9996, "0.9996"),
            (0.999_95, "0.999\u{2009}95"),
        ] {
            assert_eq!(short_beta(&Speed::from_beta(beta).expect("a speed")), text);
        }
    }

    #[test]
    fn bytes_are_in_the_unit_that_suits() {
        let texts = [0, 7, 999, 12_345, 123_456, 5_000_000_000].map(|count| bytes(count, 2));
        assert_eq!(texts, ["0 bytes", "7 bytes", "1000 bytes", "12 kB", "120 kB", "5.0 GB"]);
        assert_eq!(bytes(1_234_567, 3), "1.23 MB");
    }

    #[test]
    fn beta_shows_its_nines() {
        let text = |beta_value| beta(&Speed::from_beta(beta_value).expect("in range"));
        assert_eq!(text(0.0), "0.000");
        assert_eq!(text(0.5), "0.500");
        assert_eq!(text(0.9), "0.900");
        assert_eq!(text(0.9999), "0.999\u{2009}900");
        let fast = Speed::from_gamma(1e12).expect("in range");
        assert_eq!(beta(&fast), "1 − 5.00e−25");
        let trimmed = |beta_value| trimmed_beta(&Speed::from_beta(beta_value).expect("in range"));
        assert_eq!([0.0, 0.6, 0.93, 0.9999].map(trimmed), ["0", "0.6", "0.93", "0.999\u{2009}9"]);
        assert_eq!(trimmed_beta(&fast), "1 − 5.00e−25");
    }

    #[test]
    fn numbers_that_do_not_exist_are_dashes() {
        assert_eq!(fixed(f64::NAN, 3), NONE);
        assert_eq!(fixed(-1.5, 3), "−1.500");
        assert_eq!(fixed(0.0, 2), "0.00");
        assert_eq!(fixed(-2.5e9, 2), "−2.50e9");
        assert_eq!(fixed(-7.45e-7, 5), "−7.45e−7");
        assert_eq!(rounded(-7.45e-7, 5), "0.00000");
        assert_eq!(rounded(-0.012_345_6, 5), "−0.01235");
        assert_eq!([0.9, 20.0, -2.5e9].map(|value| trimmed(value, 4)), ["0.9", "20", "−2.50e9"]);
    }

    #[test]
    fn typed_numbers_may_be_grouped() {
        assert_eq!(parsed(" 0.999\u{2009}9 "), Ok(0.9999));
        assert_eq!(parsed("−2"), Ok(-2.0));
        assert_eq!(parsed("fast"), Err("“fast” is not a number".to_owned()));
        assert!(parsed("inf").is_err());
    }

    #[test]
    fn a_decimal_comma_is_a_decimal_point() {
        assert_eq!((parsed("0,9"), parsed("−1,5e-3")), (Ok(0.9), Ok(-1.5e-3)));
        for text in ["1,234,567", "1,234.5", ",", "0,9,"] {
            assert!(parsed(text).is_err(), "{text}");
        }
    }
}
