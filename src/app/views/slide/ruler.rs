//! The rapidity ruler: ticks named by speed, as far to both sides of where things are seen abreast as that
//! speed slides them.

use eframe::egui::{
    self, Align2, Color32, FontId, Painter, Rect, Sense, Stroke, Ui, accesskit::Role, pos2, vec2,
};
use relativity_core::math;

use super::columns::PixelColumns;
use super::sliding_view::SlidingView;
use super::spectrum;
use crate::app::state::State;
use crate::app::views::panes::EyePane;
use crate::number_text;
use crate::plot::LabelPlaces;

/// Lower views have none.
pub const LEAST_VIEW: f32 = 110.0;
/// Height of the ruler alone.
const RULER: f32 = 18.0;
const FONT_SIZE: f32 = 11.0;
/// Least space between two names.
const BETWEEN: f32 = 8.0;
/// Ticks without a name, this much rapidity apart.
const FINE: f64 = 0.1;
/// Least distance of these, points.
const LEAST_FINE: f64 = 5.0;
/// The speeds that have ticks, the first to be named first.
const SPEEDS: [f64; 17] =
    [0.0, 0.9, 0.5, 0.99, 0.999, 0.9999, 0.7, 0.8, 0.3, 0.6, 0.95, 0.1, 0.2, 0.4, 0.98, 0.995, 0.99999];
const TIP: &str = "Measures rapidity: a speed slides everything by that much, from where it would be seen \
    at rest to where it is seen. Zero is where things are seen abreast.\nη = artanh β\nThe colours are \
    those of a passing body's light in that column: they stand still while it passes.\n1/D = γ (1 + β tanh \
    u)";

/// Draws it along the lower edge of `pane`, which has these `columns`, with the spectrum.
pub fn paint(
    ui: &Ui,
    painter: &Painter,
    state: &State,
    pane: EyePane,
    slide: &SlidingView,
    columns: &PixelColumns,
) {
    let top = columns.rect.max.y - columns.scale * RULER;
    let ruler = Rect::from_min_max(pos2(columns.rect.min.x, top), columns.rect.max);
    painter.rect_filled(ruler, 0.0, Color32::from_black_alpha(190));
    let strip = Rect::from_min_max(columns.rect.min, pos2(ruler.max.x, ruler.min.y));
    spectrum::paint(painter, state, slide, columns, strip);
    paint_fine_ticks(painter, ruler, columns);
    let own = state.speed();
    let named = paint_named_ticks(painter, ruler, columns, own.beta());
    if own.rapidity() > 0.0 {
        let x = columns.x(-own.rapidity());
        let tip = pos2(x, strip.min.y - 1.0);
        let corners = vec![tip, tip + vec2(-5.0, -7.0), tip + vec2(5.0, -7.0)];
        painter.add(egui::Shape::convex_polygon(corners, Color32::WHITE, Stroke::new(1.0, Color32::BLACK)));
    }
    let name = format!(
        "Rapidity ruler, {}: ticks at {}; {}",
        pane.eye.name(),
        named.join(", "),
        spectrum::description(state)
    );
    let id = ui.scope_id().with(("rapidity ruler", pane.eye.index()));
    let response = ui.interact(columns.rect, id, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Label, true, &name));
    response.on_hover_text(TIP);
}

fn paint_fine_ticks(painter: &Painter, ruler: Rect, columns: &PixelColumns) {
    if columns.per_unit.abs() * FINE < LEAST_FINE {
        return;
    }
    let ends = [ruler.min.x, ruler.max.x].map(|x| columns.u(x) / FINE);
    let (first, last) = (ends[0].min(ends[1]).ceil() as i64, ends[0].max(ends[1]).floor() as i64);
    for number in first..=last {
        let x = columns.x(number as f64 * FINE);
        let top = ruler.min.y;
        painter.vline(x, top..=top + 3.0, Stroke::new(1.0, Color32::from_gray(130)));
    }
}

/// Draws the ticks of speeds with the names that have room, and returns these. The tick of `own` goes first.
fn paint_named_ticks(painter: &Painter, ruler: Rect, columns: &PixelColumns, own: f64) -> Vec<String> {
    let mut labels = LabelPlaces::new(ruler.expand2(vec2(0.0, RULER)), BETWEEN);
    let mut named = Vec::new();
    let speeds = [own].into_iter().chain(SPEEDS);
    for (number, beta) in speeds.enumerate().filter(|(number, beta)| *number == 0 || *beta != own) {
        for side in [-1.0, 1.0] {
            let x = columns.x(side * math::atanh(beta));
            if !ruler.x_range().contains(x) || (beta == 0.0 && side > 0.0) {
                continue;
            }
            let text = if beta == 0.0 {
                "abreast".to_owned()
            } else {
                format!("{} c", number_text::trimmed(beta, 6))
            };
            let is_own = number == 0 && side < 0.0;
            let colour = if is_own { Color32::WHITE } else { Color32::from_gray(200) };
            let galley =
                painter.layout_no_wrap(text.clone(), FontId::proportional(columns.scale * FONT_SIZE), colour);
            let place = Align2::CENTER_BOTTOM.anchor_size(pos2(x, ruler.max.y - 1.0), galley.size());
            if labels.take_free([place]).is_none() {
                continue;
            }
            painter.vline(x, ruler.min.y..=ruler.min.y + 6.0, Stroke::new(1.5, colour));
            painter.galley(place.min, galley, colour);
            named.push(text);
        }
    }
    named
}
