//! The borders between the parts of the window, and what share a part has whose border is dragged somewhere.

use eframe::egui::{Pos2, Rect};

use crate::flags::Share;
use crate::settings::WindowSettings;

/// The two parts that a border separates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BorderParts {
    /// The controls, on the right, and the rest.
    Side,
    /// The map and the plots, below, and the views.
    Strip,
    /// The map, on the left, and the plots.
    Map,
}

impl BorderParts {
    /// Returns the name of the border.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Side => "Border of the controls",
            Self::Strip => "Border of the views",
            Self::Map => "Border of the map",
        }
    }

    /// The direction in which the border is dragged.
    #[must_use]
    pub const fn is_upright(self) -> bool {
        matches!(self, Self::Side | Self::Map)
    }

    /// `window` with this `share` of what it parts.
    #[must_use]
    pub const fn with(self, window: WindowSettings, share: Share) -> WindowSettings {
        match self {
            Self::Side => WindowSettings { side_share: share, ..window },
            Self::Strip => WindowSettings { strip_share: share, ..window },
            Self::Map => WindowSettings { map_share: share, ..window },
        }
    }
}

/// A border between two parts of the window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Border {
    /// Parts that the border separates.
    pub split: BorderParts,
    /// Rectangle where the border can be grabbed, points.
    pub rect: Rect,
    /// Ends of its way, for a share of 0 and of 1: x of an upright one, y of a level one.
    pub ends: [f32; 2],
}

impl Border {
    /// Returns the share with the border at `place`.
    #[must_use]
    pub fn share_at(&self, place: Pos2) -> Share {
        let [zero, one] = self.ends;
        let at = if self.split.is_upright() { place.x } else { place.y };
        let share = f64::from((at - zero) / (one - zero)).clamp(0.0, 1.0);
        // Thousandths, so that what is remembered can be read.
        Share(share.is_finite().then(|| (1000.0 * share).round() / 1000.0))
    }
}
