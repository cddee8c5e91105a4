//! A chart: the plots of a tab against T, as plain data: the window draws it, and files contain it.

use eframe::egui::{Color32, Visuals};
use egui_plot::PlotPoint;
use relativity_core::{Model, math};

use super::axes::{Ruler, value_range};
use crate::app::state::plots::curves::{Curve, SeenPoint};
use crate::app::state::plots::look::MAX_PINS;
use crate::app::widgets::theme;
use crate::caption::times::ObserverClock;
use crate::eye::Eye;
use crate::plot::Dash;
use crate::quantity::Quantity;
use crate::units::{Measures, Unit};

/// A plot against T.
pub(super) struct TimePlot<'a> {
    /// Quantity that is plotted.
    pub quantity: Quantity,
    /// The units in which lengths and times are shown.
    pub measures: Measures,
    /// The unit of its values as they are shown.
    pub unit: Unit,
    /// The unit of T as it is shown.
    pub time_unit: Unit,
    /// Clock by which T counts.
    pub clock: &'static ObserverClock,
    /// First and last T, in the scene's unit.
    pub range: [f64; 2],
    /// Lowest and highest value, as plotted, if only a part is shown.
    pub zoomed: Option<[f64; 2]>,
    /// The curves, those on top last.
    pub traces: Vec<Trace<'a>>,
    /// T0, and what that is in words.
    pub equidistant: Option<(f64, &'static str)>,
    /// Present T.
    pub now: f64,
    /// T of the cursors.
    pub cursors: Vec<f64>,
    /// Values up to this are what rounding leaves of 0.
    pub rounding: f64,
    /// About how high the chart is drawn, points.
    pub height: f32,
}

/// A curve of a chart.
pub(super) struct Trace<'a> {
    /// Name of the curve.
    pub name: String,
    /// Pieces of the curve, as plotted: logarithms of a quantity that is one.
    pub pieces: &'a [Vec<PlotPoint>],
    /// Owner of the curve's colour.
    pub hue: Hue,
    /// Dashes of the line.
    pub dash: Dash,
    /// Whether the trace is drawn with a wide line.
    pub wide: bool,
    /// Whether the trace is drawn faintly, since it is pinned.
    pub pale: bool,
    /// Whether a dot shows where it is at T.
    pub dot: bool,
    /// Source of the curve's values.
    pub source: ValueSource,
}

/// The source of a curve's values.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ValueSource {
    /// The point, and how it is seen.
    pub point: SeenPoint,
    /// Model of the curve.
    pub model: Model,
    /// Curve of the point.
    pub curve: Curve,
}

/// The owner of a curve's colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hue {
    /// A followed point's, by its number.
    Point(usize),
    /// An eye, left or right.
    Eye(Eye),
    /// The place where two eyes take something to be.
    Stereo,
    /// The place that is measured at one time.
    Measured,
}

/// Dashes of the right eye, over the left one.
pub(super) const RIGHT_DASHES: Dash = Dash::Dashed(7);
/// Dashes of the published model.
pub(super) const PUBLISHED_DASHES: Dash = Dash::Dashed(4);
/// Dashes of pinned curves.
pub(super) const PINNED_DASHES: [Dash; MAX_PINS] =
    [Dash::Dashed(12), Dash::Dotted, Dash::Dashed(6), Dash::Dashed(24)];

impl Hue {
    /// The colour on such a background.
    fn colour(self, visuals: &Visuals) -> Color32 {
        match self {
            Self::Point(number) => theme::point_colour(number, visuals),
            Self::Eye(eye) => theme::eye_colour(eye, visuals),
            Self::Stereo => theme::stereo_colour(visuals),
            Self::Measured => theme::measured_colour(visuals),
        }
    }
}

/// Share of its colour that a pinned curve keeps.
const PALE: f32 = 0.7;

impl Trace<'_> {
    /// Whether the trace belongs to the point with this number, or to none of several points.
    pub fn is_of(&self, number: usize) -> bool {
        !matches!(self.hue, Hue::Point(of) if of != number)
    }

    /// The width of the line, points: that of the selected point is the widest.
    pub const fn width(&self) -> f32 {
        if self.wide { 2.0 } else { 1.5 }
    }

    /// Returns the colour of the curve on such a background.
    pub fn colour(&self, visuals: &Visuals) -> Color32 {
        let colour = self.hue.colour(visuals);
        if self.pale { visuals.panel_fill.lerp_to_gamma(colour, PALE) } else { colour }
    }
}

impl ValueSource {
    /// Returns the value at `time` as plotted, from the core itself.
    pub fn value(&self, time: f64) -> Option<f64> {
        self.point.value(self.model, self.curve, time)
    }
}

impl TimePlot<'_> {
    /// Returns the ruler of the values.
    pub fn ruler(&self) -> Ruler {
        Ruler::of_values(self.quantity, self.unit, self.height)
    }

    /// Returns the ruler of T in a plot of this width.
    pub fn time_ruler(&self, width: f32) -> Ruler {
        Ruler::of_time(self.time_unit, width)
    }

    /// Lowest and highest value, as plotted.
    pub fn value_range(&self) -> [f64; 2] {
        if let Some(zoomed) = self.zoomed {
            return zoomed;
        }
        let values = self.traces.iter().flat_map(|trace| trace.pieces).flatten().map(|point| point.y);
        self.ruler().widened(value_range(self.quantity, values, self.rounding))
    }

    /// A value as plotted, in the chart's unit: of a logarithm the number that it is one of.
    pub fn shown(&self, plotted: f64) -> f64 {
        let value = if self.quantity.row().is_logarithmic { math::powf(10.0, plotted) } else { plotted };
        self.unit.shown(if value.abs() <= self.rounding { 0.0 } else { value })
    }
}
