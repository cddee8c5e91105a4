//! Axes of the plots over T: frames, ticks and labels, and pointing at a T.

use eframe::egui::{self, Align2, Id, PointerButton, Rect, Sense, Stroke, TextStyle, Ui, pos2, vec2};
use egui_plot::{GridInput, GridMark, Plot, PlotBounds, PlotResponse};
use relativity_core::math;

use crate::caption::times::ObserverClock;
use crate::plot::{
    Axis, LabelPlaces, MOST_TICKS, Tick, at_least, extent, ticks_along, widened, with_margin, zoom_step,
};
use crate::quantity::{Dimension, Quantity};
use crate::units::{Measures, Unit};

/// Room for the numbers beside a plot.
pub(super) const Y_AXIS_WIDTH: f32 = 48.0;
/// Room that a number takes along T, and between two above each other, points.
const NUMBER_ROOM: [f32; 2] = [58.0, 26.0];
/// Least room between two numbers above each other.
const LEAST_NUMBER_ROOM: f32 = 16.0;
/// About how wide a digit is, points.
const DIGIT: f64 = 7.2;
/// A plot less wide or less high has no room for words at its axis.
const LEAST_WITH_WORDS: [f32; 2] = [170.0, 110.0];
/// Least height of an axis as a part of the largest value, and most of what that asks for, radians.
const LEAST_SHARE: f64 = 0.05;
const LEAST_ANGLE: f64 = 0.01;
/// Room above and below the curves, as a part of their height.
const MARGIN: f64 = 0.08;

/// Least space between labels, points.
const LABELS_APART: f32 = 3.0;
/// The weight of the present among what labels avoid: it moves, and they should not.
const NOW: f32 = 0.1;
/// Opacity of the backdrop of words at an axis.
const BACKDROP: f32 = 0.75;

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
    ruler
        .below(still_plot(ui, id, size))
        .link_cursor(Id::unique("cursor over T"), [true, false])
        .show_y(false)
        .label_formatter(|_| None)
}

/// The ruler of an axis, which places its ticks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ruler {
    logarithmic: bool,
    unit: Unit,
    wanted: usize,
    /// Greatest number of ticks that have room.
    most: usize,
    /// Room for numbers beside each other, if they are.
    along: Option<f64>,
}

impl Ruler {
    /// Returns a ruler for T, shown in `unit`, along a plot of this width, its numbers included.
    pub fn of_time(unit: Unit, width: f32) -> Self {
        let room = f64::from(width - Y_AXIS_WIDTH);
        let wanted = ticks_along(room, NUMBER_ROOM[0].into());
        Self { logarithmic: false, unit, wanted, most: MOST_TICKS, along: Some(room) }
    }

    /// Returns a ruler for values of `quantity`, shown in `unit`, in a plot of this height.
    pub fn of_values(quantity: Quantity, unit: Unit, height: f32) -> Self {
        Self { logarithmic: quantity.row().is_logarithmic, unit, ..Self::of_height(height) }
    }

    /// Returns a ruler for powers of ten, whose exponents are plotted, in a plot of this height.
    pub fn of_powers(height: f32) -> Self {
        Self { logarithmic: true, ..Self::of_height(height) }
    }

    /// Returns a ruler for powers of ten along a plot of this width.
    pub fn of_powers_along(width: f32) -> Self {
        Self { logarithmic: true, ..Self::of_time(Unit::OWN, width) }
    }

    /// Returns a ruler for angles in a plot of this height.
    pub fn of_angles(height: f32) -> Self {
        Self::of_values(Quantity::DeltaPhi, Unit::OWN, height)
    }

    /// Returns a ruler for plain numbers in a plot of this height.
    pub fn of_height(height: f32) -> Self {
        let [wanted, most] =
            [NUMBER_ROOM[1], LEAST_NUMBER_ROOM].map(|room| ticks_along(height.into(), room.into()));
        Self { logarithmic: false, unit: Unit::OWN, wanted, most, along: None }
    }

    /// A plotted value as the axis counts it.
    pub fn counted(self, plotted: f64) -> f64 {
        if self.logarithmic { plotted + math::log10(self.unit.factor) } else { self.unit.shown(plotted) }
    }

    fn plotted(self, counted: f64) -> f64 {
        if self.logarithmic { counted - math::log10(self.unit.factor) } else { self.unit.in_scene(counted) }
    }

    /// A plotted range a step further in or out, in which a plotted value stays `about` where it is. The
    /// steps go through widths that have four to seven ticks wherever they begin.
    pub fn zoomed(self, range: [f64; 2], about: f64, inwards: bool) -> [f64; 2] {
        let [from, to] = range.map(|end| self.counted(end));
        let about = self.counted(about);
        let share = ((about - from) / (to - from)).clamp(0.0, 1.0);
        let width = zoom_step(to - from, inwards);
        let from = about - share * width;
        [from, from + width].map(|end| self.plotted(end))
    }

    /// A plotted range as little wider as it takes to have four ticks, but no more than there is room for.
    pub fn widened(self, range: [f64; 2]) -> [f64; 2] {
        widened(self.logarithmic, range.map(|end| self.counted(end)), self.most).map(|end| self.plotted(end))
    }

    /// Widens the values of `bounds`, and its times by the ruler `times`.
    pub fn widened_bounds(self, times: Self, bounds: &PlotBounds) -> PlotBounds {
        let [[left, low], [right, high]] = [bounds.min(), bounds.max()];
        let ([left, right], [low, high]) = (times.widened([left, right]), self.widened([low, high]));
        PlotBounds::from_min_max([left, low], [right, high])
    }

    /// Returns the label of the axis over the values of `bounds`: `what / unit`, with the power of ten that
    /// its numbers have in common.
    pub fn label(self, what: &str, bounds: &PlotBounds) -> String {
        self.axis(self.widened([bounds.min()[1], bounds.max()[1]])).label(what)
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
        let off = |tick: &Tick| (self.plotted(tick.place) - mark.value).abs();
        let ticks = self.axis(range).ticks;
        // Where not all numbers have room every second or third is written.
        let longest = ticks.iter().map(|tick| tick.text.chars().count()).max().unwrap_or_default();
        let taken = ticks.len() as f64 * DIGIT * longest as f64;
        let stride = self.along.map_or(1, |room| (taken / room.max(1.0)).ceil().max(1.0) as usize);
        let nearest = ticks.into_iter().enumerate().min_by(|(_, a), (_, b)| off(a).total_cmp(&off(b)));
        nearest.filter(|(number, _)| number % stride == 0).map_or_else(String::new, |(_, tick)| tick.text)
    }

    /// `plot` with these ticks below it.
    pub fn below(self, plot: Plot<'_>) -> Plot<'_> {
        plot.grid_spacing(1.0..=2.0)
            .x_grid_spacer(move |input| self.grid(&input))
            .x_axis_formatter(move |mark, range| self.text(mark, [*range.start(), *range.end()]))
    }

    /// `plot` with these ticks beside it.
    pub fn beside(self, plot: Plot<'_>) -> Plot<'_> {
        plot.y_grid_spacer(move |input| self.grid(&input))
            .y_axis_formatter(move |mark, range| self.text(mark, [*range.start(), *range.end()]))
    }
}

/// Returns the range of an axis of `quantity` that shows all of these plotted `values`: with a margin, and so
/// wide that what hardly changes is a line in the middle. Values up to `rounding` are what that leaves of 0.
pub(super) fn value_range(quantity: Quantity, values: impl Iterator<Item = f64>, rounding: f64) -> [f64; 2] {
    let [low, high] = extent(values).unwrap_or_default();
    let least = if quantity.row().is_logarithmic {
        math::log10(1.0 + LEAST_SHARE)
    } else {
        let largest = low.abs().max(high.abs());
        if largest > rounding { (LEAST_SHARE * largest).min(LEAST_ANGLE) } else { LEAST_ANGLE }
    };
    at_least(with_margin([low, high], MARGIN), least)
}

/// Returns the bounds of all `values` (angles) in the range of T, with a margin; never of no height.
pub(super) fn bounds(values: impl Iterator<Item = f64>, [from, to]: [f64; 2]) -> PlotBounds {
    let [lowest, highest] = value_range(Quantity::DeltaPhi, values, 0.0);
    let width = (to - from).max(1e-9);
    PlotBounds::from_min_max([from, lowest], [from + width, highest])
}

/// Returns the label of an axis of `quantity` where lengths and times are shown in these `measures`.
pub(super) fn axis_label(quantity: Quantity, measures: &Measures) -> String {
    with_unit(quantity, quantity.row().name, measures)
}

/// Returns the heading of a curve of `quantity` where lengths and times are shown in these `measures`, in
/// short.
pub(super) fn column_label(quantity: Quantity, measures: &Measures) -> String {
    with_unit(quantity, quantity.row().symbol, measures)
}

/// Ratios have no unit.
fn with_unit(quantity: Quantity, words: &str, measures: &Measures) -> String {
    if quantity.row().dimension == Dimension::Ratio {
        words.to_owned()
    } else {
        in_unit(words, quantity.unit(measures))
    }
}

/// Returns the label of an axis of the time by this `clock` that is shown in `unit`.
pub(super) fn time_label(clock: &ObserverClock, unit: Unit) -> String {
    in_unit(clock.words, unit)
}

/// The scene's own unit has a name here, as all axes have units.
pub(super) fn in_unit(words: &str, unit: Unit) -> String {
    if unit.name.is_empty() { format!("{words} / units") } else { unit.label(words) }
}

/// Returns the places of labels in a plot, T being `now`.
pub(super) fn label_places(response: &PlotResponse<()>, now: f64) -> LabelPlaces {
    let frame = *response.transform.frame();
    let mut labels = LabelPlaces::new(frame, LABELS_APART);
    let x = response.transform.position_from_point_x(now);
    labels.avoid([pos2(x, frame.min.y), pos2(x, frame.max.y)], NOW);
    labels
}

/// Names the axis, whose time by this `clock` is shown in `unit`, in the corner where that covers least, and
/// T0, and frames the plot.
pub(super) fn annotate(
    ui: &Ui,
    response: &PlotResponse<()>,
    (clock, unit): (&ObserverClock, Unit),
    equidistant: Option<(f64, &'static str)>,
    labels: &mut LabelPlaces,
) {
    let frame = *response.transform.frame();
    let painter = ui.painter().with_clip_rect(frame);
    let (small, weak) = (TextStyle::Small.resolve(ui.style()), ui.visuals().weak_text_color());
    let laid = |text: String| painter.layout_no_wrap(text, small.clone(), weak);
    let is_wide = frame.width() >= LEAST_WITH_WORDS[0] && frame.height() >= LEAST_WITH_WORDS[1];
    let placed = equidistant.map(|(time, words)| (response.transform.position_from_point_x(time), words));
    // At the lowest speeds it is further away than can be told in pixels.
    if let Some((x, words)) = placed.filter(|(x, _)| frame.x_range().contains(*x)) {
        let galley = laid(if is_wide { format!("T₀, {words}") } else { "T₀".to_owned() });
        let beside = [(x + 3.0, Align2::LEFT_TOP), (x - 3.0, Align2::RIGHT_TOP)]
            .map(|(x, align)| align.anchor_size(pos2(x, frame.min.y + 2.0), galley.size()));
        if let Some(place) = labels.take(beside).map(Rect::from) {
            painter.galley(place.min, galley, weak);
        }
    }
    let bounds = response.transform.bounds();
    let ruler = Ruler::of_time(unit, frame.width() + Y_AXIS_WIDTH);
    let axis = ruler.axis([bounds.min()[0], bounds.max()[0]]);
    let words = if is_wide { time_label(clock, unit) } else { in_unit(clock.symbol, unit) };
    let galley = laid(axis.label(&words));
    let corners = [Align2::RIGHT_BOTTOM, Align2::LEFT_BOTTOM, Align2::RIGHT_TOP, Align2::LEFT_TOP];
    let inside = frame.shrink2(vec2(7.0, 3.0));
    let corners = corners.map(|corner| corner.align_size_within_rect(galley.size(), inside));
    if let Some(place) = labels.take(corners).map(Rect::from) {
        // What it covers in spite of that shows through, faintly.
        painter.rect_filled(place.expand(1.0), 0.0, ui.visuals().extreme_bg_color.gamma_multiply(BACKDROP));
        painter.galley(place.min, galley, weak);
    }
    self::frame(ui, response);
}

/// Names the cursors, whose lines are at these T.
pub(super) fn name_cursors(ui: &Ui, response: &PlotResponse<()>, cursors: &[f64], labels: &mut LabelPlaces) {
    let frame = *response.transform.frame();
    let painter = ui.painter().with_clip_rect(frame);
    let (font, colour) = (TextStyle::Small.resolve(ui.style()), ui.visuals().text_color());
    for (name, &time) in ["A", "B"].into_iter().zip(cursors) {
        let x = response.transform.position_from_point_x(time) + 2.0;
        let galley = painter.layout_no_wrap(name.to_owned(), font.clone(), colour);
        let places = [0.97, 0.85, 0.75, 0.65].map(|share| {
            Align2::LEFT_BOTTOM.anchor_size(pos2(x, frame.min.y + share * frame.height()), galley.size())
        });
        if let Some(place) = labels.take(places).map(Rect::from) {
            painter.galley(place.min, galley, colour);
        }
    }
}

/// Draws the frame of the plot.
pub(super) fn frame(ui: &Ui, response: &PlotResponse<()>) {
    let stroke = Stroke::new(1.0, ui.visuals().widgets.noninteractive.bg_stroke.color);
    ui.painter().rect_stroke(*response.transform.frame(), 2.0, stroke, egui::StrokeKind::Inside);
}

/// The T that is pointed at with the button pressed.
pub(super) fn time_at_pointer(response: &PlotResponse<()>) -> Option<f64> {
    let pressed = response.response.dragged_by(PointerButton::Primary) || response.response.clicked();
    let place = response.response.interact_pointer_pos().filter(|_| pressed)?;
    let time = response.transform.value_from_position(place).x;
    time.is_finite().then_some(time)
}
