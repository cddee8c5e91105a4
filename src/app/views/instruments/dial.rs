//! The dial of the rider's speed. Its arc shows the rapidity, to which every push adds evenly, while the
//! speed only nears that of light.

use std::f32::consts::TAU;
use std::sync::Arc;

use eframe::egui::{Color32, FontId, Galley, Painter, Pos2, Shape, Stroke, Vec2, vec2};

use super::values::Instruments;
use crate::app::widgets::theme;

/// Rapidity at the end of the arc: 0.9993 c.
const FULL: f64 = 4.0;
/// Rapidities of 0.5, 0.9, 0.99 and 0.999 c, which are marked.
const MARKED: [f64; 4] = [0.549_306, 1.472_219, 2.646_652, 3.800_201];
/// Turn at which the arc begins, from the right and clockwise, and its length, turns.
const START: f32 = 0.375;
const LENGTH: f32 = 0.75;
/// Straight pieces that the whole arc is drawn in.
const PIECES: f64 = 96.0;
/// Width of the arc, and the space between it and the writing, relative to the labels' size.
const WIDTH: f32 = 0.34;
const INSIDE: f32 = 0.3;
/// Greatest share of the picture's height that the dial takes while it can be made smaller.
const SHARE: f32 = 0.3;
/// Size of the speed relative to the labels, and whether it has a label, from the largest dial on.
const VARIANTS: [(f32, bool); 3] = [(2.0, true), (1.5, true), (1.5, false)];
/// Space between two lines, relative to their height: writing leaves some above and below itself.
const LINE: f32 = 0.9;
/// The speed that leaves room for all usual ones.
const USUAL: &str = "0.000\u{a0}c";

/// Text of the dial, laid out.
#[derive(Debug, Clone)]
pub struct LaidDial {
    lines: Vec<Arc<Galley>>,
    /// Radius of the dial, points.
    pub radius: f32,
    label: f32,
}

/// Returns the dial with labels of this size in a picture of this height: as large as it may be.
pub fn laid(painter: &Painter, instruments: &Instruments, label: f32, height: f32) -> LaidDial {
    let dials = VARIANTS.map(|variant| variant_of(painter, instruments, label, variant));
    let [.., last] = &dials;
    dials.iter().find(|dial| 2.0 * dial.radius <= SHARE * height).unwrap_or(last).clone()
}

fn variant_of(
    painter: &Painter,
    instruments: &Instruments,
    label: f32,
    (magnified, has_label): (f32, bool),
) -> LaidDial {
    let line = |text: &str, size: f32, colour: Color32| {
        painter.layout_no_wrap(text.to_owned(), FontId::proportional(size), colour)
    };
    let title = has_label.then(|| line("my speed", label, theme::TAG_TEXT));
    let speed = line(&instruments.speed, magnified * label, Color32::WHITE);
    let gamma = line(&instruments.gamma, label, theme::TAG_TEXT);
    let usual = line(USUAL, magnified * label, Color32::WHITE).size().x;
    let lines: Vec<_> = title.into_iter().chain([speed, gamma]).collect();
    let is_speed = |number: usize| number + 2 == lines.len();
    let corners = lines.iter().zip(tops(&lines)).enumerate().map(|(number, (line, top))| {
        let width = line.size().x.max(if is_speed(number) { usual } else { 0.0 });
        // Letters leave some of their line free above and below.
        let [above, below] = [0.2, 0.8].map(|part| (top + part * line.size().y).abs());
        vec2(0.5 * width, above.max(below)).length()
    });
    let inside = corners.fold(0.0, f32::max);
    // In steps, so that the dial holds still while digits change.
    let radius = (0.5 * (inside + (INSIDE + WIDTH) * label)).ceil() * 2.0;
    LaidDial { lines, radius, label }
}

/// The tops of `lines`, centred about 0.
fn tops(lines: &[Arc<Galley>]) -> Vec<f32> {
    let heights: Vec<f32> = lines.iter().map(|line| LINE * line.size().y).collect();
    let mut top = -0.5 * heights.iter().sum::<f32>();
    let each = heights.iter().zip(lines).map(|(height, line)| {
        let at = top - 0.5 * (line.size().y - height);
        top += height;
        at
    });
    each.collect()
}

/// Paints the `laid` dial of this `rapidity` around `centre`.
pub fn paint(painter: &Painter, laid: &LaidDial, rapidity: f64, centre: Pos2, back: Color32) {
    let LaidDial { lines, radius, label } = laid;
    painter.circle_filled(centre, *radius, back);
    let width = WIDTH * label;
    let arc = radius - 0.5 * width - 1.0;
    let line = |to: f64, colour: Color32| {
        let pieces = (PIECES * to).ceil().max(1.0);
        let at = |piece: f64| centre + arc * towards(to * piece / pieces);
        let points = (0..=pieces as u32).map(|piece| at(f64::from(piece))).collect();
        painter.add(Shape::line(points, Stroke::new(width, colour)));
    };
    line(1.0, Color32::from_white_alpha(40));
    let part = (rapidity / FULL).clamp(0.0, 1.0);
    if part > 0.0 {
        line(part, theme::focus_stroke(&eframe::egui::Visuals::dark()).color);
    }
    for marked in MARKED {
        let direction = towards(marked / FULL);
        let ends = [arc - 0.5 * width, arc + 0.5 * width].map(|away| centre + away * direction);
        painter.line_segment(ends, Stroke::new(1.5, Color32::from_black_alpha(200)));
    }
    for (galley, top) in lines.iter().zip(tops(lines)) {
        let corner = centre + vec2(-0.5 * galley.size().x, top);
        painter.galley(corner, galley.clone(), Color32::WHITE);
    }
}

/// From the middle of the dial to this part of its arc.
fn towards(part: f64) -> Vec2 {
    Vec2::angled((START + LENGTH * part as f32) * TAU)
}
