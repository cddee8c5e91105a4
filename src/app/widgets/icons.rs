//! Buttons with a drawn sign: the fonts that come along have no transport signs.

use std::f32::consts::TAU;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Color32, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, pos2,
    vec2,
};

/// A sign, drawn inside a square of side 2 around the origin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Icon {
    /// A bar and a triangle to the left.
    Start,
    /// A triangle to the left.
    Back,
    /// A large triangle to the right.
    Play,
    /// Two bars, for pausing.
    Pause,
    /// A triangle to the right.
    Forward,
    /// A triangle to the right and a bar.
    End,
    /// A circular arrow, for looping.
    Loop,
    /// A sun, for the light theme.
    Light,
    /// A crescent, for the dark theme.
    Dark,
    /// A cross, for removing.
    Remove,
    /// An arrow that turns back to the left.
    Undo,
    /// An arrow that turns to the right.
    Redo,
    /// A circular arrow the other way round.
    Reset,
    /// A tick in a circle.
    Done,
    /// An exclamation mark in a triangle.
    Failed,
    /// A plus sign.
    More,
    /// A minus sign.
    Fewer,
}

/// A button of this `size` with an `icon`; `name` is for assistive technology.
pub fn button(ui: &mut Ui, icon: Icon, name: &str, size: Vec2) -> Response {
    let (_, response) = ui.allocate_exact_size(size, Sense::click());
    drawn(ui, response, icon, name, None)
}

/// A [`button`] that switches something on and off.
pub fn switch(ui: &mut Ui, icon: Icon, name: &str, size: Vec2, is_on: bool) -> Response {
    let (_, response) = ui.allocate_exact_size(size, Sense::click());
    drawn(ui, response, icon, name, Some(is_on))
}

/// A button with an `icon` in `rect`, over what else is there.
pub fn button_in(ui: &Ui, rect: Rect, icon: Icon, name: &str) -> Response {
    let response = ui.interact(rect, ui.scope_id().with(("button", name)), Sense::click());
    drawn(ui, response, icon, name, None)
}

fn drawn(ui: &Ui, response: Response, icon: Icon, name: &str, is_on: Option<bool>) -> Response {
    let (rect, size) = (response.rect, response.rect.size());
    response.widget_info(|| WidgetInfo {
        selected: is_on,
        ..WidgetInfo::labeled(Role::Button, ui.is_enabled(), name)
    });
    let visuals = ui.style().interact_selectable(&response, is_on == Some(true));
    let painter = ui.painter();
    if icon != Icon::Remove || response.hovered() {
        painter.rect(
            rect,
            visuals.corner_radius,
            visuals.weak_bg_fill,
            visuals.bg_stroke,
            StrokeKind::Inside,
        );
    }
    let radius = 0.24 * size.y.min(size.x) * if icon == Icon::Play { 1.15 } else { 1.0 };
    paint(painter, icon, rect.center(), radius, visuals.fg_stroke.color, visuals.weak_bg_fill);
    response
}

/// Draws an `icon` by itself.
pub fn sign(painter: &Painter, icon: Icon, centre: Pos2, radius: f32, colour: Color32) {
    paint(painter, icon, centre, radius, colour, Color32::TRANSPARENT);
}

fn paint(painter: &Painter, icon: Icon, centre: Pos2, radius: f32, colour: Color32, background: Color32) {
    let at = |x: f32, y: f32| centre + radius * vec2(x, y);
    let triangle = |from: f32, to: f32| {
        let points = vec![at(from, -1.0), at(to, 0.0), at(from, 1.0)];
        painter.add(Shape::convex_polygon(points, colour, Stroke::NONE));
    };
    let bar = |x: f32, width: f32| {
        let half = vec2(radius * width / 2.0, radius);
        painter.rect_filled(eframe::egui::Rect::from_center_size(at(x, 0.0), 2.0 * half), 0.5, colour);
    };
    match icon {
        Icon::Back => triangle(0.7, -0.8),
        Icon::Forward => triangle(-0.7, 0.8),
        Icon::Play => triangle(-0.8, 1.0),
        Icon::Pause => [-0.5, 0.5].into_iter().for_each(|x| bar(x, 0.55)),
        Icon::Start => {
            triangle(1.0, -0.6);
            bar(-0.9, 0.35);
        }
        Icon::End => {
            triangle(-1.0, 0.6);
            bar(0.9, 0.35);
        }
        Icon::Loop => circular_arrow(painter, centre, radius, colour, 1.0),
        Icon::Reset => circular_arrow(painter, centre, radius, colour, -1.0),
        Icon::Undo => arrow_back(painter, centre, radius, colour, 1.0),
        Icon::Redo => arrow_back(painter, centre, radius, colour, -1.0),
        Icon::Light => sun(painter, centre, radius, colour),
        Icon::Dark => {
            painter.circle_filled(centre, radius, colour);
            painter.circle_filled(at(0.45, -0.35), 0.85 * radius, background);
        }
        Icon::More | Icon::Fewer => {
            let stroke = Stroke::new(1.5, colour);
            painter.line_segment([at(-0.9, 0.0), at(0.9, 0.0)], stroke);
            if icon == Icon::More {
                painter.line_segment([at(0.0, -0.9), at(0.0, 0.9)], stroke);
            }
        }
        Icon::Remove => {
            let stroke = Stroke::new(1.3, colour);
            painter.line_segment([at(-0.9, -0.9), at(0.9, 0.9)], stroke);
            painter.line_segment([at(-0.9, 0.9), at(0.9, -0.9)], stroke);
        }
        Icon::Done => {
            let stroke = Stroke::new(1.6, colour);
            painter.circle_stroke(centre, 1.1 * radius, stroke);
            painter.add(Shape::line(vec![at(-0.5, 0.0), at(-0.1, 0.45), at(0.55, -0.4)], stroke));
        }
        Icon::Failed => {
            let stroke = Stroke::new(1.6, colour);
            painter.add(Shape::closed_line(vec![at(0.0, -1.1), at(1.15, 0.95), at(-1.15, 0.95)], stroke));
            painter.line_segment([at(0.0, -0.45), at(0.0, 0.3)], stroke);
            painter.circle_filled(at(0.0, 0.62), 1.1, colour);
        }
    }
}

/// Clockwise where `side` is 1, the other way round where it is -1.
fn circular_arrow(painter: &Painter, centre: Pos2, radius: f32, colour: Color32, side: f32) {
    let at = |turn: f32, r: f32| centre + r * radius * Vec2::angled(turn * TAU) * vec2(side, 1.0);
    let arc: Vec<Pos2> = (0..=24).map(|i| at(0.02 + 0.8 * i as f32 / 24.0, 1.0)).collect();
    painter.add(Shape::line(arc, Stroke::new(1.6, colour)));
    let tip = pos2(at(0.93, 1.05).x, at(0.93, 1.05).y);
    painter.add(Shape::convex_polygon(vec![at(0.80, 0.45), at(0.80, 1.6), tip], colour, Stroke::NONE));
}

/// To the left where `side` is 1, to the right where it is -1.
fn arrow_back(painter: &Painter, centre: Pos2, radius: f32, colour: Color32, side: f32) {
    let at = |x: f32, y: f32| centre + radius * vec2(side * x, y);
    let turn = (0..=12).map(|i| {
        let along = Vec2::angled((-0.25 + 0.5 * i as f32 / 12.0) * TAU);
        at(0.25 + 0.8 * along.x, 0.15 + 0.65 * along.y)
    });
    let stem: Vec<Pos2> = [at(-0.6, -0.5)].into_iter().chain(turn).chain([at(-0.5, 0.8)]).collect();
    painter.add(Shape::line(stem, Stroke::new(1.6, colour)));
    painter.add(Shape::convex_polygon(
        vec![at(-0.45, -1.1), at(-0.45, 0.1), at(-1.15, -0.5)],
        colour,
        Stroke::NONE,
    ));
}

fn sun(painter: &Painter, centre: Pos2, radius: f32, colour: Color32) {
    painter.circle_filled(centre, 0.55 * radius, colour);
    for ray in 0..8 {
        let direction = Vec2::angled(ray as f32 / 8.0 * TAU);
        let ends = [0.85, 1.2].map(|r| centre + r * radius * direction);
        painter.line_segment(ends, Stroke::new(1.4, colour));
    }
}
