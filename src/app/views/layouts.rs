//! Names of the layouts of the eyes' pictures in the window, and colours that assign their parts to the eyes.

use eframe::egui::{Color32, Visuals};

use crate::app::state::State;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::flags::choices::Layout;
use crate::settings::PictureSettings;

/// The layouts, with their names.
pub const LAYOUTS: [(Layout, &str); 13] = [
    (Layout::SideBySide, "Side by side"),
    (Layout::FreeViewing, "Free viewing"),
    (Layout::CrossEyed, "Cross-eyed"),
    (Layout::Left, "Left eye"),
    (Layout::Right, "Right eye"),
    (Layout::Anaglyph, "Anaglyph"),
    (Layout::Dubois, "Anaglyph, colours"),
    (Layout::Overlay, "Overlay"),
    (Layout::OverUnder, "Over-under"),
    (Layout::HalfSideBySide, "Half side by side"),
    (Layout::HalfOverUnder, "Half over-under"),
    (Layout::Rows, "Interleaved rows"),
    (Layout::Flicker, "Flicker"),
];

/// Returns the name of `layout`.
#[must_use]
pub fn name(layout: Layout) -> &'static str {
    LAYOUTS.iter().find(|(of, _)| *of == layout).map_or("", |(_, name)| name)
}

/// The title of a picture that both eyes share.
#[must_use]
pub fn title(picture: &PictureSettings) -> String {
    let swapped = if picture.swapped.has(picture.layout) { ", eyes swapped" } else { "" };
    let is_shared = !matches!(picture.layout, Layout::HalfSideBySide | Layout::HalfOverUnder);
    let clicks = if is_shared { "  ·  clicks are the left eye's" } else { "" };
    format!("Both eyes: {}{swapped}{clicks}", name(picture.layout))
}

/// The colours of the ring and the dot that mark where `eye` sees a point, whose `own` colour is given, in a
/// picture that both share: the eye's, and the point's. Behind red-cyan glasses each eye sees its own marker
/// alone, also where both are in one place, as their light is added.
#[must_use]
pub fn marker_colours(state: &State, eye: Eye, own: Color32, visuals: &Visuals) -> [Color32; 2] {
    const RED_CYAN: [Color32; 2] =
        [Color32::from_rgba_premultiplied(255, 0, 0, 0), Color32::from_rgba_premultiplied(0, 255, 255, 0)];
    let picture = &state.document.settings.picture;
    let is_first = picture.eyes().first() == Some(&eye.index());
    match picture.layout {
        Layout::Anaglyph | Layout::Dubois => [RED_CYAN[usize::from(!is_first)]; 2],
        Layout::Overlay => [theme::eye_colour(Eye::BOTH[usize::from(!is_first)], &Visuals::dark()), own],
        _ => [theme::eye_colour(eye, visuals), own],
    }
}

/// Returns the colour that sets a marker off: light is added to what is dark.
#[must_use]
pub fn halo_colour(state: &State, visuals: &Visuals) -> Color32 {
    let is_added = matches!(state.document.settings.picture.layout, Layout::Anaglyph | Layout::Dubois);
    if is_added { Color32::from_black_alpha(210) } else { theme::halo_colour(visuals) }
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;

    use super::*;

    #[test]
    fn every_layout_has_a_name_in_the_order_of_the_flags() {
        let named: Vec<_> = LAYOUTS.iter().map(|(layout, _)| *layout).collect();
        assert_eq!(named, Layout::value_variants());
    }
}
