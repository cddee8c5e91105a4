//! Remarks of a fit on the sigmas it was given: whether the readings scatter accordingly.

use crate::number_text::significant;

/// Reduced chi squared below and above which sigmas do not fit the scatter.
const FITTING: [f64; 2] = [0.5, 2.0];
/// Standard deviations of chi squared by which it must differ from 1 besides.
const LEAST_DEVIATION: f64 = 3.0;

/// Returns a sentence if `readings` scatter clearly less or more than their sigmas, around a fit of this many
/// `parameters` with this reduced chi squared; nothing without sigmas.
#[must_use]
pub fn remark(reduced: Option<f64>, readings: usize, parameters: usize) -> Option<String> {
    let reduced = reduced?;
    let free = readings.saturating_sub(parameters).max(1) as f64;
    let [low, high] = FITTING;
    if (low..=high).contains(&reduced) || (reduced - 1.0).abs() < LEAST_DEVIATION * (2.0 / free).sqrt() {
        return None;
    }
    let times = significant(reduced.sqrt(), 2);
    let meaning = if reduced < 1.0 {
        "they are upper bounds, and so are the linear uncertainties; the bootstrap's follow the scatter"
    } else {
        "they are too small, or the model is another; the linear uncertainties are too small then, and the bootstrap's follow \
         the scatter"
    };
    Some(format!("the readings scatter {times} times as much as their sigmas say: {meaning}"))
}
