//! The layout for an audience: the picture comes first.

use eframe::egui::{Rect, vec2};

use super::rects::{large_enough, split_left, split_top};
use crate::app::state::stage::SidePanel;
use crate::app::views::panes::{Arrangement, Pane};

/// Share of the height that the pictures have, beside words of a preset and of a lesson.
const PICTURE_SHARE: f32 = 0.72;
const PICTURE_SHARE_IN_LESSON: f32 = 0.655;
/// Margins at the sides of the words, and above and below them, as parts of the window.
const ASIDE: f32 = 0.018;
const ABOVE_AND_BELOW: f32 = 0.008;

/// The layout for an audience: the pictures with their bands, beside them perhaps a panel, and below them
/// words.
#[derive(Debug, Clone, PartialEq)]
pub struct Presentation {
    /// Panes of the views.
    pub panes: Vec<Pane>,
    /// The words; none where the picture needs the whole screen.
    pub words: Option<Rect>,
    /// Room for the plot, the map, or the fit with its residuals and its table; none where it would be too
    /// small.
    pub panel: Option<Rect>,
}

impl SidePanel {
    /// Returns the share of the width that the panel takes.
    const fn width(self) -> f32 {
        match self {
            Self::Nothing => 0.0,
            Self::Plot | Self::Map => 0.4,
            Self::Fit => 0.58,
        }
    }
}

impl Presentation {
    /// Lays out a window with this inner `area`, its views as `arranged`, beside a `panel`. The pictures have
    /// the same height whatever stands beside and below them.
    #[must_use]
    pub fn new(area: Rect, arranged: &Arrangement, is_lesson: bool, panel: SidePanel) -> Self {
        if let Some(panes) = arranged.whole_screen(area) {
            return Self { panes, words: None, panel: None };
        }
        let share = if is_lesson { PICTURE_SHARE_IN_LESSON } else { PICTURE_SHARE };
        let (upper, words) = split_top(area, share * area.height() + arranged.band);
        let (views, panel) = split_left(upper, (1.0 - panel.width()) * upper.width());
        let panes = large_enough(views).map_or_else(Vec::new, |_| arranged.panes(views));
        let margins = vec2(ASIDE * area.width(), ABOVE_AND_BELOW * area.height());
        Self { panes, words: Some(words.shrink2(margins)), panel: large_enough(panel) }
    }
}
