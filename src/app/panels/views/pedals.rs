//! The pedals in the lower corners of a rider's picture, on a screen that knows touches.

use std::f32::consts::PI;

use eframe::egui::accesskit::Role;
use eframe::egui::{Align2, Color32, Rect, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo};

use crate::app::commands::riding::thumbs::{self, Pedal};
use crate::app::state::State;
use crate::app::state::riding::saddle::PushDirection;
use crate::app::views::panes::EyePane;

/// Widest and smallest pedal, points, and their distance from the edges of the picture.
const WIDEST: f32 = 76.0;
const SMALLEST: f32 = 44.0;
const MARGIN: f32 = 10.0;
/// Widest pedal as a share of the picture's sides.
const OF_SIDE: f32 = 0.2;
/// Opacity of a pedal, and of one that is held.
const BACK: [u8; 2] = [110, 210];

/// Each pedal: which way it pushes, how far its sign is turned, and its name.
const PEDALS: [(PushDirection, f32, &str); 2] =
    [(PushDirection::Backwards, PI, "Brake: hold"), (PushDirection::Forwards, 0.0, "Pedal: hold")];

/// Shows the pedals in the picture of `pane` if they belong there; returns their places.
#[must_use]
pub fn show(ui: &Ui, state: &State, pane: EyePane) -> Vec<Rect> {
    let is_first = pane.takes_the_mouse() && !pane.is_second;
    if !(state.document.settings.ride.is_on() && is_first && thumbs::are_there(ui.ctx())) {
        return Vec::new();
    }
    let [width, height] = [pane.rect.width(), pane.rect.height()];
    let side = (OF_SIDE * width.min(height)).clamp(SMALLEST, WIDEST);
    if width < 4.0 * side || height < 2.0 * side {
        return Vec::new();
    }
    let room = pane.rect.shrink(MARGIN);
    let places = [Align2::LEFT_BOTTOM, Align2::RIGHT_BOTTOM]
        .map(|corner| corner.align_size_within_rect(Vec2::splat(side), room));
    let held = thumbs::held(ui.ctx());
    let mut by_pointer = None;
    let mut pedals: Vec<Pedal> = Vec::new();
    for (place, (push, turn, name)) in places.into_iter().zip(PEDALS) {
        let response = ui.interact(place, ui.scope_id().with((name, pane.eye.index())), Sense::drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
        if response.is_pointer_button_down_on() {
            by_pointer = Some(push);
        }
        paint(ui, place, turn, held == Some(push));
        pedals.push((place, push));
    }
    thumbs::show(ui.ctx(), &pedals, by_pointer);
    places.to_vec()
}

/// Paints a pedal, whose sign points up, `turn` radians from there.
fn paint(ui: &Ui, place: Rect, turn: f32, is_held: bool) {
    let (middle, radius) = (place.center(), 0.5 * place.width());
    let painter = ui.painter().with_clip_rect(place);
    painter.circle_filled(middle, radius, Color32::from_black_alpha(BACK[usize::from(is_held)]));
    painter.circle_stroke(middle, radius - 1.0, Stroke::new(1.5, Color32::from_white_alpha(BACK[1])));
    let corner = |third: f32| middle + 0.5 * radius * Vec2::angled(turn - 0.5 * PI + third * 2.0 * PI / 3.0);
    let corners = [0.0, 1.0, 2.0].map(corner).to_vec();
    painter.add(Shape::convex_polygon(corners, Color32::from_white_alpha(230), Stroke::NONE));
}
