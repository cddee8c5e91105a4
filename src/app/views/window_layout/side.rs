//! The parts beside the views: the controls, the readout, and among few controls the map.

use eframe::egui::Rect;

use super::rects::{large_enough, split_top};
use crate::settings::{Presence, WindowSettings};

/// Height of the readout down to the times and places, and with all of its rows.
const READOUT_HEIGHTS: [f32; 2] = [274.0, 345.0];
/// Greatest share of the side that the readout takes.
const READOUT_SHARE: f32 = 0.42;
/// Height of the controls of motion and view, which the readout leaves to them before it grows.
const CONTROLS_HEIGHT: f32 = 472.0;
/// Height of its title and what two eyes make of the point alone.
const FOLDED_READOUT_HEIGHT: f32 = 86.0;
/// Heights of the few controls and of the readout in words below them, and of the lowest map between the two.
const FEW_CONTROLS_HEIGHT: f32 = 172.0;
const WORDS_HEIGHT: f32 = 110.0;
const LOWEST_MAP_ASIDE: f32 = 180.0;

/// The parts beside the views.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct SideParts {
    /// The controls.
    pub controls: Option<Rect>,
    /// The map, between few controls and the readout.
    pub map: Option<Rect>,
    /// The readout.
    pub readout: Option<Rect>,
}

impl SideParts {
    /// Divides the `side`: controls above, the readout below them as far as there is room for both.
    pub fn new(side: Rect, window: WindowSettings) -> Self {
        if window.simple {
            return Self::few(side, window);
        }
        let [least, most] = READOUT_HEIGHTS;
        let whole = (side.height() - CONTROLS_HEIGHT).clamp(least, most);
        let wanted = if window.readout { whole } else { FOLDED_READOUT_HEIGHT };
        let readout_height = wanted.min(READOUT_SHARE * side.height());
        let (controls, readout) = split_top(side, side.height() - readout_height);
        Self { controls: Some(controls), map: None, readout: large_enough(readout) }
    }

    /// Few controls take less room, which the map has where it is enough.
    fn few(side: Rect, window: WindowSettings) -> Self {
        let wanted = if window.readout { WORDS_HEIGHT + READOUT_HEIGHTS[0] } else { WORDS_HEIGHT };
        let (upper, readout) = split_top(side, (side.height() - wanted).max(FEW_CONTROLS_HEIGHT));
        let (controls, map) = split_top(upper, FEW_CONTROLS_HEIGHT);
        let has_map = window.views && window.map != Presence::Off && map.height() >= LOWEST_MAP_ASIDE;
        let (controls, map) = if has_map { (controls, Some(map)) } else { (upper, None) };
        Self { controls: Some(controls), map, readout: large_enough(readout) }
    }
}
