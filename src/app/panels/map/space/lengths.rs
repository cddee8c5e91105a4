//! The length of the selected rod, or of what has the selected point, in each picture of the close-up,
//! written beside it.

use glam::DVec3;

use super::sheet::{SheetPainter, colour};
use crate::app::panels::map::canvas;
use crate::map::{BodyPicture, MapProjection};
use crate::scene::{Scene, Track};
use crate::settings::MapFraming;

/// From the middle of a rod to its label, points.
const BESIDE: f32 = 12.0;
const DECIMALS: u8 = 2;
/// A body shorter than this share of its group counts as a part of the group.
const SMALL_PART: f64 = 0.5;

/// The name of the length in each picture.
const NAMES: [(BodyPicture, &str); 3] = [
    (BodyPicture::Stereo, "two eyes"),
    (BodyPicture::Seen(0), "left eye"),
    (BodyPicture::Measured, "measured now"),
];

/// Returns the ends of `body` if it has two, or those along the motion of what it is a small part of: of a
/// hub nobody asks how long it is, but of the bicycle.
fn ends(scene: &Scene, body: usize) -> Option<[Track; 2]> {
    let group = scene.groups.iter().find(|group| group.bodies().contains(&body))?;
    let samples = group.bodies().flat_map(|part| scene.bodies[part].shape.samples());
    let along = samples.map(|rest| rest.to_array()).collect::<Vec<_>>();
    let by_x = |a: &&[f64; 3], b: &&[f64; 3]| a[0].total_cmp(&b[0]);
    let whole = [*along.iter().min_by(by_x)?, *along.iter().max_by(by_x)?];
    let length = |[from, to]: [[f64; 3]; 2]| DVec3::from(from).distance(DVec3::from(to));
    let own = scene.bodies[body].shape.ends().filter(|own| length(*own) >= SMALL_PART * length(whole));
    let is_one = group.bodies().any(|part| scene.bodies[part].spin.is_some());
    let [from, to] = own.or_else(|| is_one.then_some(whole))?;
    // A wheel is as long as it is, however it has turned.
    let track = |rest| Some(Track { spin: None, ..scene.track_at(rest, body)? });
    Some([track(from)?, track(to)?])
}

/// Writes the lengths in the plan of a close-up, if what is selected has two ends.
pub(super) fn show(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, state, instant, sheet, labels, .. } = on;
    if state.document.settings.map.framing != MapFraming::CloseUp || sheet.projection != MapProjection::Plan {
        return;
    }
    let point = state.document.points.selected();
    let scene = &state.document.scene;
    let Some([from, to]) = point.body_in(scene).and_then(|body| ends(scene, body)) else { return };
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
        labels.write((middle, BESIDE), &text, colour(picture, ui.visuals()));
        canvas::name_place(ui, sheet.room(), middle, &format!("{}: length, {text}", sheet.name()));
    }
}
