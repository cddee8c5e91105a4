//! The eyes, and the followed points in each of their pictures.

use eframe::egui::{Align2, Stroke, TextStyle, pos2, vec2};

use super::sheet::{SheetPainter, colour};
use crate::app::panels::map::canvas;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::map::{BodyPicture, MapProjection};
use crate::settings::MapFrame;

/// Decimals of a distance in the scene's unit.
const DECIMALS: u8 = 1;
/// Distance from x = 0 that counts as abreast, points.
const ABREAST: f64 = 4.0;
const EYE_RADIUS: f32 = 4.0;
/// Radius of the selected point, and of the others.
const POINT_RADII: [f32; 2] = [4.0, 3.0];
/// A mark is at most as large as this part of a unit, but for those of a small map.
const LARGEST: f64 = 0.13;
const SMALLEST_RADIUS: f32 = 2.5;

/// Draws and names them.
pub(super) fn show(on: &mut SheetPainter<'_>) {
    eyes(on);
    points(on);
    distances(on);
    abreast(on);
    beyond(on);
}

fn points(on: &SheetPainter<'_>) {
    let SheetPainter { ui, painter, state, instant, sheet, .. } = on;
    for (index, point) in state.document.points.all().iter().enumerate() {
        let is_selected = index == state.document.points.selected_index();
        let largest = ((LARGEST * sheet.chart.scale) as f32).max(SMALLEST_RADIUS);
        let radius = POINT_RADII[usize::from(!is_selected)].min(largest);
        let fill = theme::point_colour(point.number, ui.visuals());
        for picture in BodyPicture::ALL {
            let Some(at) = instant.place(&point.track, picture) else { continue };
            let place = sheet.on_screen(at);
            painter.circle_filled(place, radius + 1.5, theme::halo_colour(ui.visuals()));
            painter.circle(place, radius, fill, Stroke::new(1.5, colour(picture, ui.visuals())));
            let name = state.name_of(point);
            canvas::name_place(
                ui,
                sheet.room(),
                place,
                &format!("{}: {name}, {}", sheet.name(), picture.words()),
            );
        }
    }
}

/// Says where the selected point is measured when that is off the sheet, ahead of where it is seen.
fn beyond(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, state, instant, sheet, labels, .. } = on;
    let (room, point) = (sheet.room(), state.document.points.selected());
    let Some(at) = instant.place(&point.track, BodyPicture::Measured).map(|at| sheet.on_screen(at)) else {
        return;
    };
    if sheet.projection == MapProjection::Plan && at.x > room.max.x && room.y_range().contains(at.y) {
        let place = (pos2(room.max.x - 4.0, at.y), Align2::RIGHT_CENTER);
        labels.write_at(place, "measured now →", theme::measured_colour(ui.visuals()));
    }
}

/// Writes the measured and the seen distance of the selected point, if distances are switched on.
fn distances(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, state, instant, sheet, labels, .. } = on;
    if !state.document.settings.window.distances || sheet.projection != MapProjection::Plan {
        return;
    }
    let point = state.document.points.selected();
    let [left, right] = instant.eyes();
    for (picture, name) in [(BodyPicture::Measured, "measured now"), (BodyPicture::Seen(0), "left eye sees")]
    {
        let Some(at) = instant.place(&point.track, picture) else { continue };
        let from = if picture == BodyPicture::Measured { left.midpoint(right) } else { left };
        let text = format!("{name}: {} away", state.measures().length.text(from.distance(at), DECIMALS));
        let place = sheet.on_screen(at);
        labels.write((place, 8.0), &text, colour(picture, ui.visuals()));
        canvas::name_place(ui, sheet.room(), place, &format!("{}: {text}", sheet.name()));
    }
}

/// Says so when the selected point is beside the eyes: measured there now, or seen there.
fn abreast(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, state, instant, sheet, labels, .. } = on;
    let point = state.document.points.selected();
    if instant.frame() == MapFrame::Bicycle
        || state.document.settings.ride.is_on()
        || state.velocity(point).speed.beta() == 0.0
    {
        return;
    }
    let place = |picture| instant.place(&point.track, picture);
    let seen = place(BodyPicture::Seen(0))
        .zip(place(BodyPicture::Seen(1)))
        .map(|(left, right)| 0.5 * (left + right));
    let words = [
        (place(BodyPicture::Measured), "measured abreast", theme::measured_colour(ui.visuals())),
        (seen, "seen abreast", theme::equidistance_colour(ui.visuals())),
    ];
    for (at, text, colour) in words {
        let Some(at) = at.filter(|at| at.x.abs() * sheet.chart.scale <= ABREAST) else { continue };
        let place = sheet.on_screen(at);
        labels.write((place, 8.0), text, colour);
        canvas::name_place(ui, sheet.room(), place, &format!("{}: {text}", sheet.name()));
    }
}

fn eyes(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, painter, instant, sheet, labels, .. } = on;
    let sides = [(Align2::RIGHT_CENTER, -1.0), (Align2::LEFT_CENTER, 1.0)];
    for ((eye, at), (anchor, side)) in Eye::BOTH.into_iter().zip(instant.eyes()).zip(sides) {
        let place = sheet.on_screen(at);
        let colour = theme::eye_colour(eye, ui.visuals());
        painter.circle_filled(place, EYE_RADIUS, colour);
        if sheet.projection == MapProjection::Plan {
            let font = TextStyle::Small.resolve(ui.style());
            labels.places.keep_free(painter.text(
                place + vec2(side * 9.0, 0.0),
                anchor,
                eye.name(),
                font,
                colour,
            ));
        }
        canvas::name_place(ui, sheet.room(), place, &format!("{}: {}", sheet.name(), eye.name()));
    }
}
