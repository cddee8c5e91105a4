//! Texts in the corners of a picture.

use std::sync::Arc;

use eframe::egui::{self, Align2, Color32, Galley, Id, Painter, Rect, Sense, TextStyle, Ui, vec2};

use super::notes::unseen;
use crate::app::state::State;
use crate::app::tools::awake;
use crate::app::views::laid_ruler;
use crate::app::views::offscreen_arrows;
use crate::app::views::panes::EyePane;
use crate::app::views::predicted_place;
use crate::app::views::slide;

/// Says in the picture of `pane` what is beyond it, what it is, and why a part of it is dark.
pub fn words(ui: &Ui, state: &State, pane: EyePane, note: String) {
    let inside = ui.painter().with_clip_rect(pane.rect);
    let ruler = slide::paint(ui, &inside, state, pane);
    let pane = EyePane { rect: pane.rect.with_max_y(pane.rect.max.y - ruler), ..pane };
    offscreen_arrows::paint(ui, &inside, pane.rect, &state.offscreen_arrows(pane.eye, pane.size));
    let why_dark = unseen(ui, state, pane).unwrap_or_default();
    let mut notes = inside.clone();
    notes.set_opacity(notes_opacity(ui, pane, &[&note, &why_dark]));
    let note = write(ui, &notes, pane, Align2::LEFT_BOTTOM, note);
    let handlebar = handlebar(ui, &inside, state, pane);
    // Beside the instruments, where they are.
    let beside = if handlebar.is_positive() { handlebar.min.x } else { pane.rect.max.x };
    let free = EyePane { rect: pane.rect.with_max_x(beside), ..pane };
    let unseen = write(ui, &notes, free, Align2::LEFT_TOP, why_dark);
    let hint = predicted_place::hint(state)
        .or_else(|| laid_ruler::hint(state))
        .or_else(|| newcomers_hint(ui, state));
    if let Some(hint) = hint.filter(|_| pane.takes_the_mouse()) {
        let corner = free_corner(ui, &inside, pane, &hint, [note, unseen, handlebar]);
        let place = write(ui, &inside, pane, corner, hint.clone());
        let response = ui.interact(place, ui.scope_id().with(("hint", pane.eye.index())), Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &hint));
    }
}

/// Seconds for which notes on a picture stand there without the pointer, and in which they come and go.
const NOTES_TIME: f64 = 4.0;
const NOTES_FADE: f32 = 0.2;

/// Returns the opacity of the `notes` on the picture in `pane`: they fade a while after they are new, and come
/// back while the pointer moves over the picture, or the keyboard is at it.
fn notes_opacity(ui: &Ui, pane: EyePane, notes: &[&String]) -> f32 {
    let (ctx, name) = (ui.ctx(), NOTES[pane.index()]);
    let left = NOTES_TIME - awake::shown_for(ctx, name, notes);
    if left > 0.0 {
        ctx.request_repaint_after_secs(left as f32 + 0.01);
    }
    let is_pointed = ui.rect_contains_pointer(pane.rect) && awake::is_moved(ctx);
    let focused = ctx.memory(|memory| memory.focused()).and_then(|id| ctx.read_response(id));
    let is_focused = focused.is_some_and(|response| {
        response.rect.width() == pane.rect.width() && response.rect.contains(pane.rect.center())
    });
    // Where the style has no animations they come and go at once.
    let fade = if ui.style().animation_time > 0.0 { NOTES_FADE } else { 0.0 };
    ctx.animate_bool_with_time(Id::unique(name), left > 0.0 || is_pointed || is_focused, fade)
}

const NOTES: [&str; 2] = ["notes on the first picture", "notes on the second picture"];

/// The greatest part of a picture's height that the instruments cover.
const SHARE_OF_INSTRUMENTS: f32 = 0.35;

/// Writes the instruments of who rides into the corner of the picture, as many as have room; where that is.
fn handlebar(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) -> Rect {
    let Some(lines) = state.instruments() else { return Rect::ZERO };
    let line = ui.text_style_height(&TextStyle::Small);
    let room = (SHARE_OF_INSTRUMENTS * pane.rect.height() / line) as usize;
    let shown = lines[..room.clamp(1, lines.len())].join("\n");
    let instruments = lines.join("\n");
    let place = write(ui, painter, pane, Align2::RIGHT_TOP, shown);
    let response = ui.interact(place, ui.scope_id().with(("handlebar", pane.eye.index())), Sense::hover());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(
            egui::accesskit::Role::Label,
            true,
            format!("{}, instruments: {instruments}", pane.eye.name()),
        )
    });
    place
}

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

/// The first corner in which `text` covers none of the `others`.
fn free_corner(ui: &Ui, painter: &Painter, pane: EyePane, text: &str, others: [Rect; 3]) -> Align2 {
    const CORNERS: [Align2; 4] =
        [Align2::CENTER_BOTTOM, Align2::RIGHT_BOTTOM, Align2::RIGHT_TOP, Align2::CENTER_CENTER];
    let is_free = |corner: &Align2| {
        let place = written(ui, painter, pane, *corner, text.to_owned()).1.expand(6.0);
        others.iter().all(|other| !other.is_positive() || !other.expand(6.0).intersects(place))
    };
    CORNERS.into_iter().find(is_free).unwrap_or(Align2::CENTER_CENTER)
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
