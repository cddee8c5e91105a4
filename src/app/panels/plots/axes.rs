//! What the plots over T have in common: frames, ticks, what the axes are called, pointing at a T.

use eframe::egui::{self, Align2, Id, Sense, Stroke, TextStyle, Ui, pos2, vec2};
use egui_plot::{GridInput, GridMark, Plot, PlotBounds, PlotResponse};
use relativity_core::math;

use crate::app::curves::Quantity;
use crate::figures;
use crate::plot::{Axis, at_least, extent, ticks_along, widened, with_factor, with_margin};
use crate::units::Unit;

/// Room for the numbers beside a plot.
pub(super) const Y_AXIS_WIDTH: f32 = 48.0;
/// Room that a number takes along T, and between two above each other, points.
const NUMBER_ROOM: [f32; 2] = [58.0, 26.0];
/// A plot less wide has no room for words at its axis.
const NARROWEST_WITH_WORDS: f32 = 220.0;
/// Least height of an axis as a part of the largest value, and most of what that asks for, radians.
const LEAST_SHARE: f64 = 0.05;
const LEAST_ANGLE: f64 = 0.01;
/// What is left above and below the curves, as a part of their height.
const MARGIN: f64 = 0.08;

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

/// A still plot over T, shown in `unit`.
pub(super) fn plot_over_time<'a>(ui: &Ui, id: impl egui::AsIdSalt, unit: Unit, size: egui::Vec2) -> Plot<'a> {
    let ruler = Ruler::of_time(unit, size.x);
    still_plot(ui, id, size)
        .grid_spacing(1.0..=2.0)
        .x_grid_spacer(move |input| ruler.grid(&input))
        .x_axis_formatter(move |mark, range| ruler.text(mark, [*range.start(), *range.end()]))
        .link_cursor(Id::unique("cursor over T"), [true, false])
}

/// What the ticks of an axis are at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ruler {
    logarithmic: bool,
    unit: Unit,
    wanted: usize,
}

impl Ruler {
    /// Of T, shown in `unit`, along a plot of this width, its numbers included.
    pub fn of_time(unit: Unit, width: f32) -> Self {
        let room = f64::from(width - Y_AXIS_WIDTH);
        Self { logarithmic: false, unit, wanted: ticks_along(room, NUMBER_ROOM[0].into()) }
    }

    /// Of values of `quantity`, shown in `unit`, in a plot of this height.
    pub fn of_values(quantity: Quantity, unit: Unit, height: f32) -> Self {
        let wanted = ticks_along(height.into(), NUMBER_ROOM[1].into());
        Self { logarithmic: quantity.is_logarithm(), unit, wanted }
    }

    /// A plotted value as the axis counts it.
    pub fn counted(self, plotted: f64) -> f64 {
        if self.logarithmic { plotted + math::log10(self.unit.factor) } else { self.unit.shown(plotted) }
    }

    fn plotted(self, counted: f64) -> f64 {
        if self.logarithmic { counted - math::log10(self.unit.factor) } else { self.unit.in_scene(counted) }
    }

    /// A plotted range as little wider as it takes to have four to seven ticks.
    pub fn widened(self, range: [f64; 2]) -> [f64; 2] {
        widened(self.logarithmic, range.map(|end| self.counted(end))).map(|end| self.plotted(end))
    }

    /// The axis over a plotted range.
    pub fn axis(self, range: [f64; 2]) -> Axis {
        Axis::within(self.logarithmic, range.map(|end| self.counted(end)), self.wanted)
    }

    fn grid(self, input: &GridInput) -> Vec<GridMark> {
        let (from, to) = input.bounds;
        // Every line and number counts as the whole axis: none is drawn faintly or left out.
        let step_size = to - from;
        let ticks = self.axis([from, to]).ticks;
        ticks.into_iter().map(|tick| GridMark { value: self.plotted(tick.place), step_size }).collect()
    }

    fn text(self, mark: GridMark, range: [f64; 2]) -> String {
        let off = |place: f64| (self.plotted(place) - mark.value).abs();
        let ticks = self.axis(range).ticks.into_iter();
        let nearest = ticks.min_by(|a, b| off(a.place).total_cmp(&off(b.place)));
        nearest.map_or_else(String::new, |tick| tick.text)
    }

    /// `plot` with these ticks beside it.
    pub fn beside(self, plot: Plot<'_>) -> Plot<'_> {
        plot.y_grid_spacer(move |input| self.grid(&input))
            .y_axis_formatter(move |mark, range| self.text(mark, [*range.start(), *range.end()]))
    }
}

/// From where to where an axis of `quantity` goes that shows all of these plotted `values`: with a margin, and so wide that
/// what hardly changes is a line in the middle.
pub(super) fn value_range(quantity: Quantity, values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = extent(values).unwrap_or_default();
    let least = if quantity.is_logarithm() {
        math::log10(1.0 + LEAST_SHARE)
    } else {
        let largest = low.abs().max(high.abs());
        if largest > 0.0 { (LEAST_SHARE * largest).min(LEAST_ANGLE) } else { LEAST_ANGLE }
    };
    at_least(with_margin([low, high], MARGIN), least)
}

/// All `values` (angles) in the range of T, with a margin; never of no height.
pub(super) fn bounds(values: impl Iterator<Item = f64>, [from, to]: [f64; 2]) -> PlotBounds {
    let [lowest, highest] = value_range(Quantity::DeltaPhi, values);
    let width = (to - from).max(1e-9);
    PlotBounds::from_min_max([from, lowest], [from + width, highest])
}

/// The symbol of a quantity, or its name.
pub(super) const fn label(quantity: Quantity) -> &'static str {
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

/// A quantity in words.
const fn words(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::DeltaPhi => "Δφ, left − right",
        Quantity::DeltaTheta => "Δθ, left − right",
        Quantity::Phi => "azimuth φ",
        Quantity::Theta => "elevation θ",
        Quantity::LogDoppler => "Doppler factor D",
        Quantity::LogGain => "stereo gain",
        Quantity::LogDistance => "distance",
    }
}

/// What stands at an axis of `quantity` that is shown in `unit`: ratios have none.
pub(super) fn axis_label(quantity: Quantity, unit: Unit) -> String {
    let words = words(quantity);
    match quantity {
        Quantity::LogDoppler | Quantity::LogGain => words.to_owned(),
        _ => in_unit(words, unit),
    }
}

/// What stands at an axis of T that is shown in `unit`.
pub(super) fn time_label(unit: Unit) -> String {
    in_unit("observer's time T", unit)
}

/// The scene's own unit has a name here, as all axes have units.
fn in_unit(words: &str, unit: Unit) -> String {
    if unit.name.is_empty() { format!("{words} / units") } else { unit.label(words) }
}

/// The unit that `quantity` is shown in, of a window that shows lengths in `length`.
pub(super) const fn shown_in(quantity: Quantity, length: Unit) -> Unit {
    match quantity {
        Quantity::LogDistance => length,
        Quantity::LogDoppler | Quantity::LogGain => Unit::OWN,
        _ => Unit { factor: 1.0, name: "rad" },
    }
}

/// Lines at round numbers.
pub(super) fn even_grid(input: GridInput) -> Vec<GridMark> {
    egui_plot::log_grid_spacer(10)(input)
}

/// The text at a grid line: as many digits as tell it from its neighbours.
pub(super) fn tick(value: f64, step: f64) -> String {
    let decimals = (-math::log10(step.abs()).floor()).clamp(0.0, 9.0) as u8;
    // Rounding, so that a grid line at -1e-17 reads 0.
    let rounded = (value / step).round() * step + 0.0;
    figures::fixed(rounded, decimals)
}

/// Names the axis, whose T is shown in `unit`, and T0, and frames the plot.
pub(super) fn annotate(
    ui: &Ui,
    response: &PlotResponse<()>,
    unit: Unit,
    equidistant: Option<(f64, &'static str)>,
) {
    let frame = *response.transform.frame();
    let painter = ui.painter().with_clip_rect(frame);
    let small = TextStyle::Small.resolve(ui.style());
    let inset = vec2(7.0, 4.0);
    let weak = ui.visuals().weak_text_color();
    let exponent = {
        let bounds = response.transform.bounds();
        let ruler = Ruler::of_time(unit, frame.width() + Y_AXIS_WIDTH);
        ruler.axis([bounds.min()[0], bounds.max()[0]]).exponent
    };
    let words = if frame.width() < NARROWEST_WITH_WORDS { in_unit("T", unit) } else { time_label(unit) };
    let words = with_factor(&words, exponent);
    painter.text(frame.max - inset, Align2::RIGHT_BOTTOM, words, small.clone(), weak);
    if let Some((time, words)) = equidistant {
        let x = response.transform.position_from_point_x(time);
        let name =
            if frame.width() < NARROWEST_WITH_WORDS { "T₀".to_owned() } else { format!("T₀, {words}") };
        let galley = painter.layout_no_wrap(name, small, weak);
        // On the side of its line where there is room.
        let left = if x + 3.0 + galley.size().x < frame.max.x { x + 3.0 } else { x - 3.0 - galley.size().x };
        painter.galley(pos2(left, frame.min.y + 2.0), galley, weak);
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
