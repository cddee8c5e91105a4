//! Texts in the corners of a picture.

use std::sync::Arc;

use eframe::egui::{self, Align2, Color32, Galley, Id, Painter, Rect, Sense, TextStyle, Ui, vec2};

use super::markers::marked;
use super::notes::unseen;
use super::pedals;
use crate::app::state::State;
use crate::app::tools::awake;
use crate::app::views::instruments;
use crate::app::views::laid_ruler;
use crate::app::views::offscreen_arrows;
use crate::app::views::panes::EyePane;
use crate::app::views::predicted_place;
use crate::app::views::slide;

/// Says in the picture of `pane` what is beyond it, what it is, and why a part of it is dark; whoever rides
/// has the instruments there, which leave marked points in sight.
pub fn words(ui: &Ui, state: &State, pane: EyePane, note: String) {
    let inside = ui.painter().with_clip_rect(pane.rect);
    slide::paint_resting(ui, &inside, state, pane);
    let is_before_audience = !pane.is_in_window();
    // Only instruments, and what stands beside them, make way for what is marked.
    let marks_points =
        state.document.settings.ride.is_on() && (!is_before_audience || state.has_markers_for_audience());
    let pedals = pedals::show(ui, state, pane);
    let marked = if marks_points { marked(state, pane) } else { Vec::new() };
    let marked = [marked, pedals].concat();
    let instruments = instruments::show(ui, &inside, state, pane, &marked);
    let places = instruments.places.clone();
    // Before an audience what is to be said stands below the picture.
    let note = if is_before_audience { String::new() } else { note };
    let why_dark = unseen(ui, state, pane).filter(|_| !is_before_audience).unwrap_or_default();
    let mut faded = inside.clone();
    faded.set_opacity(notes_opacity(ui, pane, &[&note, &why_dark]));
    let notes = if places.is_empty() {
        [(Align2::LEFT_BOTTOM, note), (Align2::LEFT_TOP, why_dark)]
            .map(|(corner, text)| write(ui, &faded, pane, corner, text))
            .to_vec()
    } else {
        // The handlebar and what is marked stay free.
        let lines: Vec<_> = [why_dark, note].into_iter().filter(|text| !text.is_empty()).collect();
        let (text, taken) = (lines.join("\n"), [places.as_slice(), &marked].concat());
        let corner = free_corner(ui, &inside, pane, &text, &taken, UPPER_CORNERS);
        vec![write(ui, &faded, pane, corner, text)]
    };
    let covered = [places.as_slice(), &notes].concat();
    let way = instruments.write_beside(&inside, pane.rect, &[covered.as_slice(), &marked].concat());
    let covered: Vec<_> = covered.into_iter().chain(way).collect();
    let above = places.iter().fold(pane.rect.max.y, |top, part| top.min(part.min.y));
    // Only a rider, before an audience, looks for what is out of view.
    let has_arrows = !is_before_audience || state.document.settings.ride.is_on();
    let arrows = if has_arrows { state.offscreen_arrows(pane.eye, pane.size) } else { Vec::new() };
    offscreen_arrows::paint(ui, &inside, pane.rect.with_max_y(above), &arrows, &covered);
    let hint = predicted_place::hint(state)
        .or_else(|| laid_ruler::hint(state))
        .or_else(|| newcomers_hint(ui, state));
    if let Some(hint) = hint.filter(|_| pane.takes_the_mouse() && !is_before_audience) {
        let corner = free_corner(ui, &inside, pane, &hint, &covered, LOWER_CORNERS);
        let place = write(ui, &inside, pane, corner, hint.clone());
        let response = ui.interact(place, ui.scope_id().with(("hint", pane.eye.index())), Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &hint));
    }
}

/// Seconds for which notes on a picture stand there without the pointer, and in which they come and go.
const NOTES_TIME: f64 = 4.0;
const NOTES_FADE: f32 = 0.2;

/// Returns the opacity of the `notes` on the picture in `pane`: they fade a while after they are new, and
/// come back while the pointer moves over the picture, or the keyboard is at it.
fn notes_opacity(ui: &Ui, pane: EyePane, notes: &[&String]) -> f32 {
    let (ctx, name) = (ui.ctx(), NOTES[pane.index()]);
    // Another measured number is no other note.
    let words = notes.iter().map(|note| note.replace(|letter: char| letter.is_ascii_digit(), ""));
    let left = NOTES_TIME - awake::shown_for(ctx, name, words.collect::<Vec<_>>());
    if left > 0.0 {
        ctx.request_repaint_after_secs(left as f32 + 0.01);
    }
    let is_pointed = ui.rect_contains_pointer(pane.rect) && awake::is_moved(ctx);
    let focused = ctx.memory(egui::Memory::focused).and_then(|id| ctx.read_response(id));
    let is_focused = focused.is_some_and(|response| {
        response.rect.width() == pane.rect.width() && response.rect.contains(pane.rect.center())
    });
    // Where the style has no animations they come and go at once.
    let fade = if ui.style().animation_time > 0.0 { NOTES_FADE } else { 0.0 };
    ctx.animate_bool_with_time(Id::unique(name), left > 0.0 || is_pointed || is_focused, fade)
}

const NOTES: [&str; 2] = ["notes on the first picture", "notes on the second picture"];

/// The hint for newcomers in the views, and its duration in seconds.
const HINT: &str = "Click a point to follow it.";
const HINT_TIME: f64 = 12.0;

/// Returns the hint for a newcomer who has not clicked yet: for a while, never before an audience, and never
/// in a lesson, which says itself what to do.
fn newcomers_hint(ui: &Ui, state: &State) -> Option<String> {
    let is_alone = !state.session.stage.has_audience() && state.session.lesson.is_none();
    let is_shown = state.session.hint && is_alone;
    (is_shown && awake::is_new(ui.ctx(), HINT, HINT_TIME)).then(|| HINT.to_owned())
}

/// Places for a hint, and for notes on a ride, the first preferred.
const LOWER_CORNERS: [Align2; 4] =
    [Align2::CENTER_BOTTOM, Align2::RIGHT_BOTTOM, Align2::RIGHT_TOP, Align2::CENTER_CENTER];
const UPPER_CORNERS: [Align2; 4] =
    [Align2::LEFT_TOP, Align2::RIGHT_TOP, Align2::RIGHT_CENTER, Align2::LEFT_TOP];

/// The first of the `corners` in which `text` covers none of the `others`; the last where there is none.
fn free_corner(
    ui: &Ui,
    painter: &Painter,
    pane: EyePane,
    text: &str,
    others: &[Rect],
    corners: [Align2; 4],
) -> Align2 {
    let is_free = |corner: &Align2| {
        let place = written(ui, painter, pane, *corner, text.to_owned()).1.expand(6.0);
        others.iter().all(|other| !other.is_positive() || !other.expand(6.0).intersects(place))
    };
    corners.into_iter().find(is_free).unwrap_or(corners[3])
}

/// `text` laid out in a corner of the picture, and where that is.
fn written(ui: &Ui, painter: &Painter, pane: EyePane, corner: Align2, text: String) -> (Arc<Galley>, Rect) {
    let font = TextStyle::Small.resolve(ui.style());
    let galley = painter.layout(text, font, Color32::WHITE, (pane.rect.width() - 24.0).max(1.0));
    let place = corner.align_size_within_rect(galley.size(), pane.rect.shrink(8.0));
    (galley, place)
}

/// Writes `text` into a corner of the picture; where that is.
fn write(ui: &Ui, painter: &Painter, pane: EyePane, corner: Align2, text: String) -> Rect {
    let (galley, place) = written(ui, painter, pane, corner, text);
    if galley.size().x > 0.0 {
        painter.rect_filled(place.expand2(vec2(5.0, 2.0)), 3.0, Color32::from_black_alpha(150));
        painter.galley(place.min, galley, Color32::WHITE);
    }
    place
}
