//! A QR code in the window.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Color32, Context, Id, Pos2, Rect, Response, Sense, Shape, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use crate::lesson::class::QrCode;

/// Least side of a module, physical pixels: a camera cannot distinguish smaller ones.
const LEAST: f32 = 2.0;

/// Shows `text` as a code of about this `side`, points; `what` describes it. Nothing of a text that is too
/// long for one.
pub fn show(ui: &mut Ui, text: &str, side: f32, what: &str) -> Option<Response> {
    let code = code(ui.ctx(), text)?;
    let scale = ui.pixels_per_point();
    // Whole pixels: edges stay sharp, and no lines appear between modules.
    let module = (side * scale / code.side as f32).floor().max(LEAST) / scale;
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(module * code.side as f32), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, what));
    if ui.is_rect_visible(rect) {
        let corner = pos2((rect.min.x * scale).round() / scale, (rect.min.y * scale).round() / scale);
        ui.painter().rect_filled(Rect::from_min_size(corner, rect.size()), 0.0, Color32::WHITE);
        ui.painter().extend(code.runs().map(|run| black(corner, module, run)));
    }
    Some(response)
}

/// The black part of a row.
fn black(corner: Pos2, module: f32, [row, first, end]: [usize; 3]) -> Shape {
    let from = corner + module * vec2(first as f32, row as f32);
    Shape::rect_filled(
        Rect::from_min_size(from, module * vec2((end - first) as f32, 1.0)),
        0.0,
        Color32::BLACK,
    )
}

/// The code of `text`, made when that has changed.
fn code(ctx: &Context, text: &str) -> Option<QrCode> {
    let id = Id::unique("QR code");
    let made = ctx.data(|data| data.get_temp::<(String, Option<QrCode>)>(id));
    if let Some((_, code)) = made.filter(|(made, _)| made == text) {
        return code;
    }
    let code = QrCode::new(text);
    ctx.data_mut(|data| data.insert_temp(id, (text.to_owned(), code.clone())));
    code
}
