//! The layout for an audience.

use eframe::egui::Rect;

use super::rects::{large_enough, split_left, split_top};
use crate::app::views::panes::{Arrangement, Pane};
use crate::app::widgets::theme::GAP;

/// The layout for an audience: the views, and below them words beside a plot, the map or a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Presentation {
    /// Panes of the views.
    pub panes: Vec<Pane>,
    /// The words; none where the picture needs the whole screen.
    pub words: Option<Rect>,
    /// Room for the plot, the map, or the fit with its residuals and its table; none where it would be too
    /// small.
    pub plot: Option<Rect>,
}

/// The panel beside the words for an audience.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Beside {
    /// Nothing: they have all the room.
    Nothing,
    /// A single plot, beside the words.
    Plot,
    /// The map beside the words.
    Map,
    /// The fit: readings, residuals and a table.
    Fit,
}

impl Beside {
    /// Returns the share of the width that the words take.
    const fn words_width(self) -> f32 {
        match self {
            Self::Nothing => 1.0,
            Self::Plot | Self::Map => 0.5,
            Self::Fit => 0.38,
        }
    }

    /// Returns shares of the height for the words and the panel beside them: the least, the most, and the
    /// most for words that could otherwise not be read from the last row.
    const fn heights(self) -> [f32; 3] {
        match self {
            Self::Nothing => [0.12, 0.62, 0.66],
            Self::Plot | Self::Map => [0.38, 0.54, 0.66],
            Self::Fit => [0.64, 0.64, 0.76],
        }
    }
}

impl Presentation {
    /// Lays out a window with this inner `area`, its views as `arranged`. The words take as much of the
    /// height as they `need`, if that is known, and the views the rest; an infinite need means that the words
    /// are too small.
    #[must_use]
    pub fn new(area: Rect, arranged: &Arrangement, beside: Beside, need: Option<f32>) -> Self {
        if let Some(panes) = arranged.whole_screen(area) {
            return Self { panes, words: None, plot: None };
        }
        let [least, most, utmost] = beside.heights().map(|share| share * area.height());
        let height = match need {
            Some(f32::INFINITY) => utmost,
            Some(need) => (need + 2.0 * around(most)).clamp(least, most),
            None => most,
        };
        let (upper, lower) = split_top(area, area.height() - height);
        let (words, plot) = split_left(lower, beside.words_width() * lower.width());
        let panes = large_enough(upper).map_or_else(Vec::new, |views| arranged.panes(views));
        Self { panes, words: Some(words.shrink(around(most))), plot: large_enough(plot) }
    }
}

/// Returns the margin around words in a part of this `height`.
fn around(height: f32) -> f32 {
    (1.5 * GAP).min(0.1 * height)
}
