//! The length of the selected rod in each picture of the close-up, written beside it.

use super::sheet::{SheetPainter, colour};
use crate::app::panels::map::canvas;
use crate::app::widgets::theme;
use crate::map::{BodyPicture, MapProjection};
use crate::settings::MapFraming;

const FONT_SIZE: f32 = 13.0;
/// From the middle of a rod to its label, points.
const BESIDE: f32 = 12.0;
const DECIMALS: u8 = 2;

/// The name of the length in each picture.
const NAMES: [(BodyPicture, &str); 3] = [
    (BodyPicture::Stereo, "two eyes"),
    (BodyPicture::Seen(0), "left eye"),
    (BodyPicture::Measured, "measured now"),
];

/// Writes the lengths in the plan of a close-up, if the selected body has two ends.
pub(super) fn show(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, painter, state, instant, sheet, labels } = on;
    if state.document.settings.map.framing != MapFraming::CloseUp || sheet.projection != MapProjection::Plan {
        return;
    }
    let point = state.document.points.selected();
    let scene = &state.document.scene;
    let Some(body) = point.body_in(scene) else { return };
    let Some(ends) = scene.bodies[body].shape.ends() else { return };
    let ends = ends.map(|end| scene.track_at(end, body));
    let [Some(from), Some(to)] = ends else { return };
    let pictures = NAMES.into_iter().filter_map(|(picture, name)| {
        let places = [from, to].map(|end| instant.place(&end, picture));
        let [Some(from), Some(to)] = places else { return None };
        Some((picture, name, [from, to]))
    });
    let pictures: Vec<_> = pictures.collect();
    for (_, _, ends) in &pictures {
        labels.places.avoid(ends.map(|end| sheet.on_screen(end)), 1.0);
    }
    let length = state.measures().length;
    for (picture, name, [from, to]) in pictures {
        let middle = sheet.on_screen(from.midpoint(to));
        let text = format!("{name}: {}", length.text(from.distance(to), DECIMALS));
        let font = theme::scaled_font(ui.style(), FONT_SIZE);
        labels.write(painter, (middle, BESIDE), &text, font, colour(picture, ui.visuals()));
        canvas::name_place(ui, sheet.room(), middle, &format!("{}: length, {text}", sheet.name()));
    }
}
