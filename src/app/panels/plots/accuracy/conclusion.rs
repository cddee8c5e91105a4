//! The conclusion from the Accuracy tab's figures, in a sentence.

use relativity_render::Method;

use crate::app::views::examination::{Examination, ExaminedMethod, Figures};
use crate::caption::capitalised;
use crate::number_text;

/// The sentence; `None` before there is something to compare.
pub fn sentence(examination: &Examination) -> Option<String> {
    let measured = measured(examination);
    if let [(row, _)] = measured.as_slice() {
        let is_all = !examination.is_pending() && row.method == Method::Reference;
        return is_all.then(|| "Reference: without a GPU there is nothing to compare it with.".to_owned());
    }
    let is_worth = |(row, _): &&(ExaminedMethod<'_>, &Figures)| examination.better_than(row).is_none();
    let mut worth: Vec<_> = measured.iter().filter(is_worth).collect();
    worth.sort_by(|(_, a), (_, b)| a.frame_ms.total_cmp(&b.frame_ms));
    let [(cheapest, cost), others @ ..] = worth.as_slice() else { return None };
    let first = format!(
        "{}: error {}, cheapest here ({} ms)",
        capitalised(cheapest.name()),
        if cheapest.method == Method::Reference { "none".to_owned() } else { px(cost.error_px) },
        number_text::significant(cost.frame_ms, 2)
    );
    let more = others.iter().map(|(row, other)| {
        let times = number_text::significant(other.frame_ms / cost.frame_ms, 2);
        if row.method == Method::Reference {
            return format!("the reference has none, in {times} times the time");
        }
        format!("{}: error {}, in {times} times the time", row.name(), px(other.error_px))
    });
    let lost = |method| {
        measured.iter().any(|(row, _)| row.method == method)
            && !worth.iter().any(|(row, _)| row.method == method)
    };
    let nothing = [(lost(Method::Mesh), "the mesh gains nothing"), (lost(Method::Rays), "rays gain nothing")];
    let nothing = nothing.into_iter().filter(|(is_lost, _)| *is_lost).map(|(_, text)| text.to_owned());
    let parts: Vec<String> = [first].into_iter().chain(nothing).chain(more).collect();
    let end = if examination.is_pending() { " (so far)." } else { "." };
    Some(parts.join("; ") + end)
}

/// The methods that were measured in the present views.
fn measured(examination: &Examination) -> Vec<(ExaminedMethod<'_>, &Figures)> {
    examination.rows().filter_map(|row| Some((row, row.measured()?))).collect()
}

/// A small error as a part of a pixel: 1/20,000 px.
fn px(error: f64) -> String {
    if error <= 0.0 {
        return "none".to_owned();
    }
    if error > 0.05 {
        return format!("{} px", number_text::significant(error, 2));
    }
    let parts = 1.0 / error;
    // One digit says enough of how small it is.
    let magnitude = 10f64.powi(relativity_core::math::log10(parts).floor() as i32);
    format!("1/{} px", with_commas((parts / magnitude).round() * magnitude))
}

fn with_commas(whole: f64) -> String {
    let digits: Vec<char> = format!("{whole:.0}").chars().collect();
    let groups: Vec<String> = digits.rchunks(3).rev().map(|group| group.iter().collect()).collect();
    groups.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_errors_are_parts_of_a_pixel() {
        assert_eq!(px(5.2e-5), "1/20,000 px");
        assert_eq!(px(1e-3), "1/1,000 px");
        assert_eq!(px(0.25), "0.25 px");
        assert_eq!(px(2.04), "2.0 px");
    }
}
