//! What the layouts of the eyes' pictures are called in the window, and whose is what.

use eframe::egui::{Color32, Visuals};

use super::observer::Eye;
use super::state::State;
use super::theme;
use crate::flags::choices::{Form, Layout};
use crate::settings::Picture;

/// All layouts: what each is called, and what it is for.
pub const LAYOUTS: [(Layout, &str, &str); 13] = [
    (Layout::SideBySide, "Side by side", "The left eye's picture on the left, the right eye's on the right."),
    (
        Layout::FreeViewing,
        "Free viewing",
        "For eyes that look in parallel, through the screen: no further apart than pupils are (--picture-distance), as \
        far as the screen's density is known (--screen-width).",
    ),
    (
        Layout::CrossEyed,
        "Cross-eyed",
        "The other way round, for eyes that look at a point in front of the screen.",
    ),
    (Layout::Left, "Left eye", "The left eye only."),
    (Layout::Right, "Right eye", "The right eye only."),
    (
        Layout::Anaglyph,
        "Anaglyph",
        "For red-cyan glasses: the left eye's brightness in red, the right eye's in cyan. No colour is lost.",
    ),
    (
        Layout::Dubois,
        "Anaglyph, colours",
        "For red-cyan glasses: as near to the colours as can be (Dubois). Pure red is dark to the right eye.",
    ),
    (Layout::Overlay, "Overlay", "The left eye in blue and the right eye in orange, added."),
    (Layout::OverUnder, "Over-under", "The left eye's picture above the right eye's."),
    (
        Layout::HalfSideBySide,
        "Half side by side",
        "Each picture at half its width, as 3-D televisions and projectors take it.",
    ),
    (
        Layout::HalfOverUnder,
        "Half over-under",
        "Each picture at half its height, as 3-D televisions and projectors take it.",
    ),
    (
        Layout::Rows,
        "Interleaved rows",
        "Rows of the screen in turn, the topmost the left eye's, for screens that are polarised so.",
    ),
    (Layout::Flicker, "Flicker", "One after the other, three times a second: depth shows without glasses."),
];

/// What `layout` is called.
#[must_use]
pub fn name(layout: Layout) -> &'static str {
    LAYOUTS.iter().find(|(of, ..)| *of == layout).map_or("", |(_, name, _)| name)
}

/// The title of a picture that both eyes share.
#[must_use]
pub fn title(picture: &Picture) -> String {
    let swapped = if picture.swapped.has(picture.layout) { ", eyes swapped" } else { "" };
    let is_shared = !matches!(picture.layout, Layout::HalfSideBySide | Layout::HalfOverUnder);
    let clicks = if is_shared { "  ·  clicks are the left eye's" } else { "" };
    format!("Both eyes: {}{swapped}{clicks}", name(picture.layout))
}

/// The colour of what is of `eye` in a picture that both share: behind red-cyan glasses each eye sees its own.
#[must_use]
pub fn eye_colour(state: &State, eye: Eye, visuals: &Visuals) -> Color32 {
    const RED_CYAN: [Color32; 2] = [Color32::from_rgb(255, 0, 0), Color32::from_rgb(0, 255, 255)];
    let picture = &state.settings.picture;
    let is_first = picture.eyes().first() == Some(&eye.index());
    match (picture.layout, picture.layout.form()) {
        (Layout::Anaglyph | Layout::Dubois, _) => RED_CYAN[usize::from(!is_first)],
        (Layout::Overlay, Form::Composed(_)) => {
            theme::eye_colour(Eye::BOTH[usize::from(!is_first)], &Visuals::dark())
        }
        _ => theme::eye_colour(eye, visuals),
    }
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;

    use super::*;

    #[test]
    fn every_layout_has_a_name_in_the_order_of_the_flags() {
        let named: Vec<_> = LAYOUTS.iter().map(|(layout, ..)| *layout).collect();
        assert_eq!(named, Layout::value_variants());
    }
}
