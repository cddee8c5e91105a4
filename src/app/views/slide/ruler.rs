//! The ruler: ticks named by speed, as far to both sides of where things are seen abreast as that speed
//! slides them; before an audience, by the Doppler factor of what passes there.

use eframe::egui::{
    self, Align2, FontId, Painter, Rect, Sense, Stroke, Ui, Visuals, accesskit::Role, pos2, vec2,
};
use relativity_core::math;

use super::columns::PixelColumns;
use super::sliding_view::SlidingView;
use super::spectrum;
use crate::app::state::State;
use crate::app::views::panes::EyePane;
use crate::app::widgets::theme;
use crate::flags::choices::Form;
use crate::number_text;
use crate::plot::{Axis, LabelPlaces};

/// Least space between two names.
const BETWEEN: f32 = 8.0;
/// Least distance of ticks without a name, points.
const LEAST_FINE: f64 = 5.0;
/// Lengths of ticks with a name and without, points.
const NAMED_LENGTH: f32 = 5.0;
const FINE_LENGTH: f32 = 3.0;
/// The speeds that have ticks, the first to be named first.
const SPEEDS: [f64; 17] =
    [0.0, 0.9, 0.5, 0.99, 0.999, 0.9999, 0.7, 0.8, 0.3, 0.6, 0.95, 0.1, 0.2, 0.4, 0.98, 0.995, 0.99999];
/// The name of what the speeds measure.
const MEASURED: &str = "slid by";
const TIP: &str = "Measures rapidity: a speed slides everything by that much, from where it would be seen \
    at rest to where it is seen. Zero is where things are seen abreast.\nη = artanh β\nThe colours are \
    those of a passing body's light in that column: they stand still while it passes.\n1/D = γ (1 + β tanh \
    u)";

/// A tick with a name.
struct NamedTick {
    u: f64,
    text: String,
    /// Whether it is that of the bodies' own speed.
    is_own: bool,
}

/// Draws the ruler into the band below `pane`, which has these `columns`, with the spectrum; the `title` of
/// the picture stands in it already.
pub fn paint(
    ui: &Ui,
    state: &State,
    pane: EyePane,
    slide: &SlidingView,
    columns: &PixelColumns,
    title: Option<Rect>,
) {
    let band = columns.strip.union(columns.ticks);
    let painter = ui.painter().with_clip_rect(band);
    // A lesson measures by speeds, and so does whoever has the controls.
    let is_in_window = pane.is_in_window();
    let has_speeds = is_in_window || state.session.lesson.is_some();
    let has_colours = spectrum::paint(&painter, state, slide, columns, is_in_window);
    let mut labels = LabelPlaces::new(columns.ticks.expand2(vec2(0.0, columns.ticks.height())), BETWEEN);
    if let Some(title) = title {
        labels.keep_free(title);
    }
    let ruler = Ruler { painter, columns, visuals: ui.visuals(), is_in_window, has_colours };
    let named = if has_speeds {
        if is_in_window {
            ruler.paint_fine_ticks();
        }
        if title.is_none() && is_first(state, pane) {
            ruler.paint_measured(&mut labels);
        }
        ruler.paint_named(speed_ticks(state.speed().beta()), &mut labels)
    } else {
        let tick = |(factor, u)| NamedTick { u, text: spectrum::factor_text(factor), is_own: false };
        ruler.paint_named(spectrum::named_factors(&state.speed()).map(tick), &mut labels)
    };
    let name = format!(
        "Rapidity ruler, {}: ticks at {}; {}",
        pane.eye.name(),
        named.join(", "),
        spectrum::description(state)
    );
    let id = ui.scope_id().with(("rapidity ruler", pane.eye.index()));
    let response = ui.interact(band, id, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Label, true, &name));
    response.on_hover_text(TIP);
}

/// Whether `pane` has the first of the rulers: of two pictures above each other only the lower one has one.
fn is_first(state: &State, pane: EyePane) -> bool {
    let picture = &state.document.settings.picture;
    picture.layout.form() == Form::Above || picture.eyes().first() == Some(&pane.index())
}

/// The ticks of speeds, on both sides: the bodies' `own` first.
fn speed_ticks(own: f64) -> impl Iterator<Item = NamedTick> {
    let speeds = [own].into_iter().chain(SPEEDS.into_iter().filter(move |beta| *beta != own));
    speeds.enumerate().flat_map(|(number, beta)| {
        let sides: &[f64] = if beta == 0.0 { &[0.0] } else { &[-1.0, 1.0] };
        sides.iter().map(move |side| {
            let text = if beta == 0.0 {
                "abreast".to_owned()
            } else {
                format!("{} c", number_text::trimmed(beta, 6))
            };
            NamedTick { u: side * math::atanh(beta), text, is_own: number == 0 && *side < 0.0 }
        })
    })
}

/// The painter of the ticks, and their places.
struct Ruler<'a> {
    painter: Painter,
    columns: &'a PixelColumns,
    visuals: &'a Visuals,
    /// Whether there is room for ticks above their names; else they stand in the spectrum.
    is_in_window: bool,
    /// Whether the spectrum has colours.
    has_colours: bool,
}

impl Ruler<'_> {
    fn font(&self) -> FontId {
        FontId::proportional(self.columns.scale * theme::SMALL_SIZE)
    }

    /// Ticks at round rapidities.
    fn paint_fine_ticks(&self) {
        let Self { painter, columns, visuals, .. } = self;
        let ends = [columns.ticks.min.x, columns.ticks.max.x].map(|x| columns.u(x));
        let range = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let stroke = Stroke::new(1.0, visuals.weak_text_color().gamma_multiply(0.6));
        let top = columns.ticks.min.y;
        for tick in Axis::spaced(range, LEAST_FINE / columns.per_unit.abs()).ticks {
            painter.vline(columns.x(tick.place), top..=top + FINE_LENGTH, stroke);
        }
    }

    /// Says at the left end what the speeds measure.
    fn paint_measured(&self, labels: &mut LabelPlaces) {
        let Self { painter, columns, visuals, .. } = self;
        let colour = visuals.weak_text_color();
        let galley = painter.layout_no_wrap(MEASURED.to_owned(), self.font(), colour);
        let place = Align2::LEFT_BOTTOM.anchor_size(columns.ticks.left_bottom(), galley.size());
        if labels.take_free([place]).is_some() {
            painter.galley(place.min, galley, colour);
        }
    }

    /// Draws those of the `ticks` whose names have room, and returns these. A triangle marks the bodies' own.
    fn paint_named(&self, ticks: impl Iterator<Item = NamedTick>, labels: &mut LabelPlaces) -> Vec<String> {
        let Self { painter, columns, visuals, is_in_window, has_colours } = self;
        let room = columns.ticks;
        let mut named = Vec::new();
        for NamedTick { u, text, is_own } in ticks {
            let x = columns.x(u);
            if !room.x_range().contains(x) {
                continue;
            }
            let colour = if is_own { visuals.strong_text_color() } else { visuals.weak_text_color() };
            let galley = painter.layout_no_wrap(text.clone(), self.font(), colour);
            let place = Align2::CENTER_BOTTOM.anchor_size(pos2(x, room.max.y), galley.size());
            if labels.take_free([place]).is_none() {
                continue;
            }
            if !is_in_window && *has_colours {
                spectrum::paint_tick(painter, columns.strip, x);
            } else if !is_in_window {
                painter.vline(x, columns.strip.y_range(), Stroke::new(2.0, colour));
            } else if is_own {
                let tip = pos2(x, room.min.y);
                let corners = [vec2(4.0, NAMED_LENGTH), vec2(-4.0, NAMED_LENGTH)].map(|off| tip + off);
                let triangle = [tip].into_iter().chain(corners).collect();
                painter.add(egui::Shape::convex_polygon(triangle, colour, Stroke::NONE));
            } else {
                painter.vline(x, room.min.y..=room.min.y + NAMED_LENGTH, Stroke::new(1.5, colour));
            }
            painter.galley(place.min, galley, colour);
            named.push(text);
        }
        named
    }
}
