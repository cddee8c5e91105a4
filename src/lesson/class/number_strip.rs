//! Predicted numbers as dots on an axis, stacked, beside the true one.

use std::fmt::Write as _;

use crate::lesson::plan::Number;
use crate::markup::escaped;
use crate::number_text;
use crate::plot::{Axis, BLUE, ticks_along, with_margin};

/// Width of the drawing, and room at each side, pixels.
const WIDTH: f64 = 640.0;
const ASIDE: f64 = 24.0;
/// Room above the dots, for the true number, and below, for the ticks and for the label.
const ABOVE: f64 = 26.0;
const TICKS: f64 = 26.0;
const LABEL: f64 = 20.0;
/// From one dot to the next, and the height of the tallest stack, pixels.
const STEP: f64 = 12.0;
const TALLEST: f64 = 180.0;
/// Quartiles' distances beyond which a number lies outside the axis: J. Tukey, *Exploratory Data Analysis*
/// (1977), calls it *far out*.
const FAR_OUT: f64 = 3.0;
/// Size from which on a number is far out, whatever the others are: the axis of those before it is finite.
const ABSURD: f64 = 1e100;

/// Returns the drawing of the predicted `numbers`, which are finite, and a sentence on those beyond its axis;
/// empty without any.
pub(super) fn svg(asked: &Number, numbers: &[f64]) -> (String, String) {
    let mut numbers = numbers.to_vec();
    numbers.sort_by(f64::total_cmp);
    let fences = fences(&numbers, asked.truth);
    let (inside, outside): (Vec<f64>, Vec<f64>) =
        numbers.iter().partition(|number| (fences[0]..=fences[1]).contains(*number) && number.abs() < ABSURD);
    let shown = inside.iter().copied().chain(asked.truth);
    let range = crate::plot::extent(shown).unwrap_or([0.0, 1.0]);
    let strip = Strip::new(with_margin(range, 0.04), &inside);
    (strip.svg(asked, &inside), beyond(asked, &outside))
}

/// Returns the ends beyond which sorted `numbers` are far out.
fn fences(numbers: &[f64], truth: Option<f64>) -> [f64; 2] {
    let Some(last) = numbers.len().checked_sub(1) else { return [0.0, 0.0] };
    let [low, high] = [last / 4, last - last / 4].map(|place| numbers[place]);
    // Where most say the same, as far as the truth is from nothing.
    let apart = (high - low).max(truth.unwrap_or(high).abs() / FAR_OUT);
    [low - FAR_OUT * apart, high + FAR_OUT * apart]
}

/// The sentence on the numbers outside the axis.
fn beyond(asked: &Number, outside: &[f64]) -> String {
    if outside.is_empty() {
        return String::new();
    }
    let numbers: Vec<_> = outside.iter().map(|number| number_text::significant(*number, 3)).collect();
    let unit = if asked.unit.is_empty() { String::new() } else { format!(" {}", asked.unit) };
    format!("Far out, and not on the axis: {}{unit}.", numbers.join(", "))
}

/// The axis with its stacks.
struct Strip {
    axis: Axis,
    /// From one dot of a stack to the next, pixels.
    up: f64,
    /// Height of the axis in the drawing, from its top.
    bottom: f64,
}

impl Strip {
    fn new(range: [f64; 2], numbers: &[f64]) -> Self {
        let axis = Axis::fitted(false, range, ticks_along(WIDTH - 2.0 * ASIDE, 75.0));
        let mut strip = Self { axis, up: STEP, bottom: 0.0 };
        let levels = strip.dots(numbers).iter().map(|(_, level)| level + 1).max();
        let tallest = levels.unwrap_or(0).max(3) as f64;
        strip.up = STEP.min(TALLEST / tallest);
        strip.bottom = ABOVE + strip.up * (tallest + 0.5);
        strip
    }

    fn x(&self, number: f64) -> f64 {
        let [low, high] = self.axis.range;
        ASIDE + (number - low) / (high - low) * (WIDTH - 2.0 * ASIDE)
    }

    /// Returns the place of each number along the axis, pixels, and its level above that, from 0: the lowest
    /// on which it covers no other. `numbers` are sorted.
    fn dots(&self, numbers: &[f64]) -> Vec<(f64, usize)> {
        let mut ends: Vec<f64> = Vec::new();
        let dot = |number: &f64| {
            let x = self.x(*number);
            let level = ends.iter().position(|end| *end <= x).unwrap_or(ends.len());
            ends.resize(ends.len().max(level + 1), 0.0);
            ends[level] = x + STEP;
            (x, level)
        };
        numbers.iter().map(dot).collect()
    }

    fn svg(&self, asked: &Number, numbers: &[f64]) -> String {
        let label = escaped(&self.axis.label(&asked.unit));
        let below = if label.is_empty() { TICKS } else { TICKS + LABEL };
        let (height, bottom, right) = (self.bottom + below, self.bottom, WIDTH - ASIDE);
        let what = format!("{} predicted numbers on an axis", numbers.len());
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{what}\" width=\"{WIDTH}\" height=\"{height:.1}\" \
             viewBox=\"0 0 {WIDTH} {height:.1}\" font-family=\"sans-serif\" font-size=\"13\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        );
        if let Some(truth) = asked.truth {
            let ends = [-1.0, 1.0].map(|side| self.x(truth + side * asked.within * truth.abs()));
            let [from, to] = ends.map(|end| end.clamp(ASIDE, right));
            let _ = writeln!(
                svg,
                "<rect x=\"{from:.1}\" y=\"{ABOVE}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"{BLUE}\" fill-opacity=\"0.15\"/>",
                to - from,
                bottom - ABOVE
            );
            let x = self.x(truth);
            let anchor = if x < 0.2 * WIDTH {
                "start"
            } else if x > 0.8 * WIDTH {
                "end"
            } else {
                "middle"
            };
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {ABOVE}V{bottom:.1}\" stroke=\"{BLUE}\" stroke-width=\"1.6\"/>\
                 <text x=\"{x:.1}\" y=\"{:.1}\" fill=\"{BLUE}\" text-anchor=\"{anchor}\">it is {}</text>",
                ABOVE - 8.0,
                escaped(&asked.text(truth))
            );
        }
        let radius = 0.42 * self.up;
        for ((x, level), number) in self.dots(numbers).into_iter().zip(numbers) {
            let is_right = asked.is_met_by(*number) == Some(true);
            let y = bottom - (level as f64 + 0.75) * self.up;
            let fill = if is_right { BLUE } else { "white" };
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\" fill=\"{fill}\" stroke=\"{}\"/>",
                if is_right { BLUE } else { "#000000" }
            );
        }
        let _ = writeln!(svg, "<path d=\"M{ASIDE} {bottom:.1}H{right}\" stroke=\"#444\"/>");
        for tick in &self.axis.ticks {
            let x = self.x(tick.place);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {bottom:.1}v5\" stroke=\"#444\"/><text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
                bottom + 19.0,
                tick.text
            );
        }
        let (middle, below) = (0.5 * WIDTH, bottom + 38.0);
        let _ = writeln!(
            svg,
            "<text x=\"{middle}\" y=\"{below:.1}\" text-anchor=\"middle\">{label}</text>\n</svg>"
        );
        svg
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked() -> Number {
        let (value, unit) = ("gain".to_owned(), "m".to_owned());
        Number { value, line: 1, unit, decimals: 1, within: 0.1, truth: Some(2.0) }
    }

    #[test]
    fn each_number_has_a_dot_and_the_right_ones_are_filled() {
        let (svg, beyond) = svg(&asked(), &[1.0, 1.0, 1.9, 2.1, 4.0]);
        assert_eq!((svg.matches("<circle").count(), beyond.as_str()), (5, ""));
        assert_eq!(svg.matches(&format!("fill=\"{BLUE}\" stroke")).count(), 2);
        assert!(svg.contains("it is 2.0 m"), "{svg}");
    }

    #[test]
    fn numbers_that_are_far_out_leave_room_for_the_others() {
        let (svg, beyond) = svg(&asked(), &[1.0, 2.0, 3.0, 2.5, 1e300, -f64::MAX]);
        assert_eq!(svg.matches("<circle").count(), 4);
        assert!(beyond.starts_with("Far out, and not on the axis: ") && beyond.contains("300"), "{beyond}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        let (svg, _) = super::svg(&asked(), &[-f64::MAX, f64::MAX, 1e300, -1e200]);
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }

    #[test]
    fn one_number_or_the_same_from_all_is_an_axis() {
        for numbers in [&[0.0][..], &[2.0; 40], &[-3.0, -3.0]] {
            let (svg, _) = svg(&asked(), numbers);
            assert_eq!(svg.matches("<circle").count(), numbers.len());
            assert!(!svg.contains("NaN") && svg.matches("text-anchor=\"middle\"").count() > 2, "{svg}");
        }
    }
}
