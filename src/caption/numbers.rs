//! Numbers in sentences: as short as they can be while those that differ look different.

use crate::number_text;

/// Decimals that may be added so that two numbers differ.
const MORE: u8 = 4;

/// `value` with `decimals`; 0 without a sign.
#[must_use]
pub fn decimal(value: f64, decimals: u8) -> String {
    let places = usize::from(decimals);
    let text = format!("{value:.places$}");
    if !value.is_finite() || value.abs() >= 1e6 {
        number_text::fixed(value, decimals)
    } else if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        text.trim_start_matches('-').to_owned()
    } else {
        number_text::with_minus(&text)
    }
}

/// `values` with `decimals`, or with as many as it takes until two of them differ; a single text where
/// nothing does.
pub fn distinct_texts(values: &[f64], decimals: u8) -> Vec<String> {
    let texts = |decimals| values.iter().map(|&value| decimal(value, decimals)).collect::<Vec<_>>();
    let differ = |texts: &Vec<String>| texts.iter().any(|text| *text != texts[0]);
    let apart = (decimals..=decimals + MORE).map(texts).find(differ);
    apart.unwrap_or_else(|| texts(decimals).into_iter().take(1).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_differs_looks_different() {
        assert_eq!(distinct_texts(&[-3.891, -4.092], 2), ["−3.89", "−4.09"]);
        assert_eq!(distinct_texts(&[-3.891, -3.892], 2), ["−3.891", "−3.892"]);
        assert_eq!(distinct_texts(&[2.5, 2.5], 2), ["2.50"]);
        assert_eq!(distinct_texts(&[2.5, 2.5 + 1e-12], 2), ["2.50"]);
        assert_eq!(distinct_texts(&[606.2], 0), ["606"]);
    }

    #[test]
    fn nothing_is_less_than_nothing() {
        assert_eq!([-0.001, 0.0, -0.0].map(|value| decimal(value, 2)), ["0.00"; 3]);
        assert_eq!(decimal(-2.5e9, 2), "−2.50e9");
    }
}
