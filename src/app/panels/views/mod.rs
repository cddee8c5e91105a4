//! The views of the two eyes, side by side: pictures, markers of the followed points, and the mouse in
//! them.

mod captions;
mod markers;
mod notes;
mod pedals;
mod pointer;

use eframe::egui::{self, Color32, Rect, Sense, Stroke, StrokeKind, TextureId, Ui, pos2};

use crate::app::state::State;
use crate::app::views::eyes::ShownPicture;
use crate::app::views::highlight;
use crate::app::views::hover;
use crate::app::views::laid_ruler;
use crate::app::views::layouts;
use crate::app::views::panes::{EyePane, PaneTitle};
use crate::app::views::predicted_place;
use crate::app::views::slide;
use crate::app::widgets::pane_title;
use crate::app::widgets::theme;
use crate::eye::Eye;
use captions::words;
use markers::{Coat, markers};
use notes::note;

pub use notes::note_for_audience;
pub use pointer::interact;

/// The pictures painted in an eye's pane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Painted {
    /// Picture of the scene.
    pub picture: Option<ShownPicture>,
    /// Heat map of its error, if it is shown.
    pub heat_map: Option<TextureId>,
}

/// Draws `pane`: what is `painted` there, the markers on it, its `title` and frame.
pub fn paint(ui: &Ui, state: &State, pane: EyePane, title: &str, painted: Painted) {
    let Painted { picture, heat_map } = painted;
    let colour = theme::eye_colour(pane.eye, ui.visuals());
    if pane.is_in_window() {
        pane_title(ui, pane.rect, title, colour);
    }
    slide::paint_band(ui, state, pane, title, colour);
    ui.painter().rect_filled(pane.rect, 0.0, ui.visuals().extreme_bg_color);
    for texture in picture.map(|picture| picture.texture).into_iter().chain(heat_map) {
        image(ui, pane.rect, texture);
    }
    state.scratch.comfort.paint(ui.painter(), pane.rect);
    let inside = ui.painter().with_clip_rect(pane.rect);
    if pane.is_in_window() || state.has_markers_for_audience() {
        for coat in [Coat::Halo, Coat::Ring] {
            markers(ui, &inside, state, pane, coat);
        }
    }
    predicted_place::paint(ui, &inside, state, pane);
    laid_ruler::paint(ui, &inside, state, pane);
    words(ui, state, pane, note(state, pane.eye, picture, heat_map.is_some()));
    frame(ui, pane.rect, pane.title, colour);
    hover(ui, state, pane);
    missed(ui, state, pane);
}

/// Draws `pane` with nothing but its `picture` in it: what is written beside it would be in each eye's at
/// another place.
pub fn paint_bare(ui: &Ui, state: &State, pane: EyePane, picture: Option<ShownPicture>) {
    let id = ui.scope_id().with(("lens", pane.eye.index()));
    let response = ui.interact(pane.rect, id, Sense::hover());
    let name = format!("{} through its lens", pane.eye.name());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, &name));
    if let Some(ShownPicture { texture, .. }) = picture {
        image(ui, pane.rect, texture);
    }
    state.scratch.comfort.paint(ui.painter(), pane.rect);
}

/// Draws the one `picture` of both eyes, whose `panes` are in it in the order of the layout, or of the one
/// whose turn it is; over each its heat map, if there is one.
pub fn paint_both(
    ui: &Ui,
    state: &State,
    panes: &[EyePane],
    picture: Option<ShownPicture>,
    heat_maps: &[Option<TextureId>],
) {
    let colour = ui.visuals().text_color();
    let rect = panes.iter().map(|pane| pane.rect).reduce(Rect::union).unwrap_or(Rect::NOTHING);
    let title = layouts::title(&state.document.settings.picture);
    let place = panes.first().map_or(PaneTitle::Nowhere, |pane| pane.title);
    if place.is_in_window() {
        pane_title(ui, rect, &title, colour);
    }
    ui.painter().rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
    if let Some(ShownPicture { texture, .. }) = picture {
        image(ui, rect, texture);
    }
    for (pane, heat_map) in panes.iter().zip(heat_maps) {
        if let Some(texture) = *heat_map {
            image(ui, pane.rect, texture);
        }
        state.scratch.comfort.paint(ui.painter(), pane.rect);
    }
    // All halos first: markers that the eyes see in one place would hide each other.
    let has_markers = place.is_in_window() || state.has_markers_for_audience();
    for coat in [Coat::Halo, Coat::Ring].into_iter().filter(|_| has_markers) {
        for &pane in panes {
            markers(ui, &ui.painter().with_clip_rect(pane.rect), state, pane, coat);
        }
    }
    for &pane in panes {
        let inside = ui.painter().with_clip_rect(pane.rect);
        predicted_place::paint(ui, &inside, state, pane);
        laid_ruler::paint(ui, &inside, state, pane);
    }
    for (&pane, heat_map) in panes.iter().zip(heat_maps) {
        if pane.takes_the_mouse() || panes.len() == 1 {
            slide::paint_band(ui, state, pane, &title, colour);
            words(ui, state, pane, note(state, pane.eye, picture, heat_map.is_some()));
            missed(ui, state, pane);
        }
    }
    frame(ui, rect, place, colour);
    // Where both are in one place, the left eye tells what is under the pointer, as it takes the clicks.
    let told = |pane: &EyePane| if pane.is_shared { EyePane { eye: Eye::Left, ..*pane } } else { *pane };
    let pointed = panes.iter().find(|pane| hover::pointer(ui, state, pane.rect).is_some());
    if let Some(pane) = pointed.map(told) {
        hover(ui, state, pane);
    }
}

/// Draws a frame around a picture that has a title.
fn frame(ui: &Ui, rect: Rect, title: PaneTitle, colour: Color32) {
    if title != PaneTitle::Nowhere {
        ui.painter().rect_stroke(rect, 0.0, Stroke::new(1.5, colour), StrokeKind::Outside);
    }
}

fn image(ui: &Ui, rect: Rect, texture: TextureId) {
    let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    ui.painter().image(texture, rect, uv, Color32::WHITE);
}

/// Tells what is under the pointer in `pane`.
fn hover(ui: &Ui, state: &State, pane: EyePane) {
    let pointer = hover::pointer(ui, state, pane.rect);
    let hovered =
        pointer.and_then(|place| Some((place, state.hovered(pane.eye, pane.pixel(place), pane.size)?)));
    if let Some((place, hovered)) = hovered {
        let outline = state.outline_of(hovered.body, pane.eye, hovered.pixel, pane.size);
        highlight::paint(&ui.painter().with_clip_rect(pane.rect), pane, &outline);
        hover::show(ui, pane.rect, place, &hovered);
    }
}

/// Says where a click into `pane` hit nothing.
fn missed(ui: &Ui, state: &State, pane: EyePane) {
    if let Some(missed) =
        state.scratch.missed.filter(|missed| (missed.eye, missed.is_second) == (pane.eye, pane.is_second))
    {
        hover::show_nothing(ui, pane.rect, pane.place(missed.pixel));
    }
}
