//! Panels: a pair of axes with lines, their colours, dashes and names.
//!
//! Colours are those of M. Okabe and K. Ito, *Color universal design* (2008), which colour-blind eyes tell
//! apart; lines differ by dashes too.

use std::borrow::Cow;

use relativity_core::math;

use super::axis::{extent, with_margin};

/// Colour black.
pub const BLACK: &str = "#000000";
/// Blue: the left eye.
pub const BLUE: &str = "#0072B2";
/// Vermilion: the right eye.
#[cfg(feature = "desktop")]
pub const VERMILION: &str = "#D55E00";

/// Height of a panel unless it has another, pixels.
const HEIGHT: f64 = 380.0;

/// The dashes of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// A solid line.
    Solid,
    /// Dashes of this length, pixels or points.
    Dashed(u8),
    /// A dotted line.
    Dotted,
}

/// The stroke of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineStroke {
    /// A line through the points.
    Line(Dash),
    /// Dots at the points instead of a line.
    Dots,
}

/// A line through points; several pieces share one entry of the legend.
#[derive(Debug, Clone)]
pub struct Line {
    /// Entry in the legend.
    pub name: String,
    /// Colour, in CSS.
    pub colour: Cow<'static, str>,
    /// Stroke of the line.
    pub stroke: LineStroke,
    /// Pieces of the line.
    pub pieces: Vec<Vec<[f64; 2]>>,
}

impl Line {
    /// A solid line in one piece.
    pub fn solid(
        name: impl Into<String>,
        colour: impl Into<Cow<'static, str>>,
        points: Vec<[f64; 2]>,
    ) -> Self {
        Self::in_pieces(name, colour, vec![points])
    }

    /// A solid line in these pieces.
    pub fn in_pieces(
        name: impl Into<String>,
        colour: impl Into<Cow<'static, str>>,
        pieces: Vec<Vec<[f64; 2]>>,
    ) -> Self {
        Self { name: name.into(), colour: colour.into(), stroke: LineStroke::Line(Dash::Solid), pieces }
    }

    /// Returns this line, drawn with `stroke`.
    #[must_use]
    pub fn with(self, stroke: LineStroke) -> Self {
        Self { stroke, ..self }
    }
}

/// A pair of axes with lines.
#[derive(Debug, Clone)]
pub struct Panel {
    /// Title above the axes.
    pub title: String,
    /// Below and beside them.
    pub labels: [String; 2],
    /// Lines of the panel.
    pub lines: Vec<Line>,
    /// Range of the horizontal axis besides the lines, so that panels can be compared.
    pub shown_x: Option<[f64; 2]>,
    /// Values on the horizontal axis to mark, and their names.
    pub marks: Vec<(f64, String)>,
    /// Whether a unit is as long on both axes.
    pub equal_scales: bool,
    /// Whether the horizontal and the vertical axis are logarithmic: all values are above 0 then, and
    /// `equal_scales` has no effect.
    pub is_logarithmic: [bool; 2],
    /// Ends of the axes, logarithms of a logarithmic one; `None` lets the lines decide.
    pub ranges: [Option<[f64; 2]>; 2],
    /// Width of the picture, pixels.
    pub width: f64,
    /// Height of the picture, pixels.
    pub height: f64,
}

impl Panel {
    /// Linear axes with scales of their own, 480 by 380 pixels.
    pub fn new(title: impl Into<String>, labels: [impl Into<String>; 2], lines: Vec<Line>) -> Self {
        Self {
            title: title.into(),
            labels: labels.map(Into::into),
            lines,
            shown_x: None,
            marks: Vec::new(),
            equal_scales: false,
            is_logarithmic: [false; 2],
            ranges: [None; 2],
            width: 480.0,
            height: HEIGHT,
        }
    }

    /// Returns the range that the lines need of an axis (logarithms of a logarithmic one), with this share of
    /// it more at both ends.
    pub(super) fn needed(&self, axis: usize, room: f64) -> [f64; 2] {
        let values = self.lines.iter().flat_map(|line| &line.pieces).flatten().map(|point| point[axis]);
        let values = values.chain(self.shown_x.filter(|_| axis == 0).into_iter().flatten());
        let range = extent(values.map(|value| self.along(axis, value)));
        with_margin(range.unwrap_or_default(), room)
    }

    /// Returns the place of `value` along an axis: its logarithm on a logarithmic one.
    pub(super) fn along(&self, axis: usize, value: f64) -> f64 {
        if self.is_logarithmic[axis] { math::log10(value) } else { value }
    }
}
