//! A halo around the pointer, so that an audience sees where it is.

use eframe::egui::{Color32, Context, Id, LayerId, Order, Stroke};

use crate::app::tools::awake;

const RADIUS: f32 = 22.0;

/// Draws it, above everything, while the pointer is in use.
pub fn paint(ctx: &Context) {
    let Some(pointer) = ctx.pointer_hover_pos().filter(|_| awake::is_moved(ctx)) else { return };
    let painter = ctx.layer_painter(LayerId::new(Order::Debug, Id::unique("halo")));
    painter.circle_filled(pointer, RADIUS, Color32::from_rgba_unmultiplied(0xF0, 0xE4, 0x42, 60));
    painter.circle_stroke(pointer, RADIUS, Stroke::new(4.0, Color32::from_black_alpha(130)));
    painter.circle_stroke(pointer, RADIUS, Stroke::new(2.0, Color32::from_rgb(0xF0, 0xE4, 0x42)));
}
