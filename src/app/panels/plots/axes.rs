//! What the plots over T have in common: frames, grids, numbers at the grid lines, pointing at a T.

use eframe::egui::{self, Align2, Id, Sense, Stroke, TextStyle, Ui, vec2};
use egui_plot::{GridInput, GridMark, Plot, PlotBounds, PlotResponse};
use relativity_core::math;

use crate::app::curves::Quantity;
use crate::figures;
use crate::plot::round_step;
use crate::units::Unit;

/// Room for the numbers beside a plot.
pub(super) const Y_AXIS_WIDTH: f32 = 48.0;
/// Least space from number to number along T, points.
const NUMBER_SPACING: f32 = 85.0;
/// Heights of a decade in which six numbers, or three, are a line of text apart; points.
const SIX_NUMBERS: f64 = 95.0;
const THREE_NUMBERS: f64 = 45.0;
/// How many lines there are for each number along T.
const FINE_LINES: i64 = 5;

/// A plot that neither scrolls nor zooms.
pub(super) fn still_plot<'a>(ui: &Ui, id: impl egui::AsIdSalt, size: egui::Vec2) -> Plot<'a> {
    Plot::new(id)
        .width(size.x)
        .height(size.y)
        .allow_zoom(false)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .allow_axis_zoom_drag(false)
        .sense(Sense::click_and_drag())
        .y_axis_min_width(Y_AXIS_WIDTH)
        .grid_color(ui.visuals().weak_text_color().gamma_multiply(0.25))
}

/// A still plot over T, shown in `unit`, in which a drag can move T.
pub(super) fn plot_over_time<'a>(ui: &Ui, id: impl egui::AsIdSalt, unit: Unit, size: egui::Vec2) -> Plot<'a> {
    let width = size.x - Y_AXIS_WIDTH;
    still_plot(ui, id, size)
        .grid_spacing(24.0..=220.0)
        .x_grid_spacer(move |input| time_grid(unit, width, input.bounds))
        .x_axis_formatter(move |mark, _| time_tick(unit, mark))
        .link_cursor(Id::unique("cursor over T"), [true, false])
}

/// All `values` in the range of T, with a margin; never of no height.
pub(super) fn bounds(values: impl Iterator<Item = f64> + Clone, [from, to]: [f64; 2]) -> PlotBounds {
    let [lowest, highest] = extent(values).unwrap_or_default();
    let margin = (0.08 * (highest - lowest)).max(1e-6 * highest.abs()).max(1e-9);
    let width = (to - from).max(1e-9);
    PlotBounds::from_min_max([from, lowest - margin], [from + width, highest + margin])
}

/// Lowest and highest of `values`, `None` of none.
pub(super) fn extent(values: impl Iterator<Item = f64> + Clone) -> Option<[f64; 2]> {
    let lowest = values.clone().fold(f64::INFINITY, f64::min);
    let highest = values.fold(f64::NEG_INFINITY, f64::max);
    (lowest <= highest).then_some([lowest, highest])
}

/// The symbol of a quantity.
pub(super) fn label(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::DeltaPhi => "Δφ",
        Quantity::DeltaTheta => "Δθ",
        Quantity::Phi => "φ",
        Quantity::Theta => "θ",
        Quantity::LogDoppler => "D",
        Quantity::LogGain => "stereo gain",
        Quantity::LogDistance => "distance",
    }
}

/// What stands above a plot of `quantity`, in a window that shows lengths in `length`: with the unit where several numbers
/// follow.
pub(super) fn heading(quantity: Quantity, length: Unit) -> String {
    match quantity {
        Quantity::LogDistance => length.label(label(quantity)),
        _ => label(quantity).to_owned(),
    }
}

/// The unit that `quantity` is shown in, of a window that shows lengths in `length`.
pub(super) const fn shown_in(quantity: Quantity, length: Unit) -> Unit {
    match quantity {
        Quantity::LogDistance => length,
        Quantity::LogDoppler | Quantity::LogGain => Unit::OWN,
        _ => Unit { factor: 1.0, name: "rad" },
    }
}

/// What the logarithm `quantity` has more of where it is one of numbers in `unit`.
pub(super) fn shift(quantity: Quantity, unit: Unit) -> f64 {
    if quantity.is_logarithm() { math::log10(unit.factor) } else { 0.0 }
}

/// Where the grid lines are in a plot of this `height`: at round numbers; for a logarithm at round numbers of what it is
/// one of, which is shown with this `shift`.
pub(super) fn grid(quantity: Quantity, shift: f64, height: f32, input: GridInput) -> Vec<GridMark> {
    if !quantity.is_logarithm() {
        return even_grid(input);
    }
    let (from, to) = (input.bounds.0 + shift, input.bounds.1 + shift);
    let stride = ((to - from) / 8.0).ceil().max(1.0);
    let first = (from / stride).floor();
    let decades = (0..=9).map(|i| (first + f64::from(i)) * stride);
    let within: &[f64] = match f64::from(height) / (to - from) {
        decade if decade > SIX_NUMBERS => &[1.0, 1.5, 2.0, 3.0, 5.0, 7.0],
        decade if decade > THREE_NUMBERS => &[1.0, 2.0, 5.0],
        _ => &[1.0],
    };
    // A step of half a decade or more leaves room for the number at each.
    let step_size = if within.len() > 1 { 0.5 } else { stride };
    decades
        .flat_map(|decade| within.iter().map(move |value| decade + math::log10(*value)))
        .filter(|value| (from..=to).contains(value))
        .map(|value| GridMark { value: value - shift, step_size })
        .collect()
}

/// Lines at round numbers.
pub(super) fn even_grid(input: GridInput) -> Vec<GridMark> {
    egui_plot::log_grid_spacer(10)(input)
}

/// The text at a grid line: as many digits as tell it from its neighbours.
pub(super) fn tick(quantity: Quantity, value: f64, step: f64) -> String {
    if quantity.is_logarithm() {
        return figures::power_of_ten(value);
    }
    let decimals = (-math::log10(step.abs()).floor()).clamp(0.0, 9.0) as u8;
    // Rounding, so that a grid line at -1e-17 reads 0.
    let rounded = (value / step).round() * step + 0.0;
    figures::fixed(rounded, decimals)
}

/// Where the lines of T are between two times in a plot of this `width`: at round numbers of the `unit` it is shown in,
/// with finer lines between those that have their numbers.
fn time_grid(unit: Unit, width: f32, (from, to): (f64, f64)) -> Vec<GridMark> {
    let [from, to] = [from, to].map(|time| unit.shown(time));
    let step = round_step((to - from) * f64::from(NUMBER_SPACING / width.max(1.0)));
    let fine = step / FINE_LINES as f64;
    if fine.is_nan() || fine <= 0.0 {
        return Vec::new(); // a range that rounding leaves nothing of
    }
    let numbers = (from / fine).ceil() as i64..=(to / fine).floor() as i64;
    let mark = |number: i64| GridMark {
        value: unit.in_scene(number as f64 * fine),
        step_size: unit.in_scene(if number % FINE_LINES == 0 { step } else { fine }),
    };
    numbers.map(mark).collect()
}

/// The text at a line of T, which is shown in `unit`.
fn time_tick(unit: Unit, mark: GridMark) -> String {
    tick(Quantity::Phi, unit.shown(mark.value), unit.shown(mark.step_size))
}

/// Names the axis, whose T is shown in `unit`, and T0, and frames the plot.
pub(super) fn annotate(ui: &Ui, response: &PlotResponse<()>, unit: Unit, equidistant: Option<f64>) {
    let frame = *response.transform.frame();
    let painter = ui.painter().with_clip_rect(frame);
    let small = TextStyle::Small.resolve(ui.style());
    let inset = vec2(7.0, 4.0);
    let weak = ui.visuals().weak_text_color();
    painter.text(frame.max - inset, Align2::RIGHT_BOTTOM, unit.label("T"), small.clone(), weak);
    if let Some(time) = equidistant {
        let x = response.transform.position_from_point_x(time);
        let place = egui::pos2(x + 3.0, frame.max.y - 3.0);
        painter.text(place, Align2::LEFT_BOTTOM, "T₀", small, weak);
    }
    self::frame(ui, response);
}

/// Frames the plot.
pub(super) fn frame(ui: &Ui, response: &PlotResponse<()>) {
    let stroke = Stroke::new(1.0, ui.visuals().widgets.noninteractive.bg_stroke.color);
    ui.painter().rect_stroke(*response.transform.frame(), 2.0, stroke, egui::StrokeKind::Inside);
}

/// The T that is pointed at with the button pressed.
pub(super) fn time_at_pointer(response: &PlotResponse<()>) -> Option<f64> {
    let pressed = response.response.dragged() || response.response.clicked();
    let place = response.response.interact_pointer_pos().filter(|_| pressed)?;
    let time = response.transform.value_from_position(place).x;
    time.is_finite().then_some(time)
}
