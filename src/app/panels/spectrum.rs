//! The wavelengths that arrive of the selected point, on a scale of all that are near the visible.

use eframe::egui::{
    self, Align2, Color32, CornerRadius, FontId, Painter, Pos2, Rect, Sense, Shape, Stroke, StrokeKind, Ui,
    Visuals, accesskit::Role, pos2, vec2,
};
use relativity_core::math;
use relativity_render::colour::spectrum::VISIBLE_NM;

use crate::app::state::State;
use crate::app::widgets::apart::{Span, apart};
use crate::app::widgets::theme;
use crate::app::widgets::wavelength_colour::{SCALE_NM, paint_strip, places, visible_colour};
use crate::caption::{Moment, RestLight, beginnings, in_words};
use crate::eye::Eye;

/// Height of the numbers above the strip of colours, points.
const NUMBERS_HEIGHT: f32 = 16.0;
/// Space below the strip.
const BELOW: f32 = 3.0;
/// Least space between two numbers.
const BETWEEN: f32 = 12.0;
/// Least space between a mark and a name on the strip.
const NAME_MARGIN: f32 = 6.0;
/// Writing on the scale and above it.
const FONT: FontId = FontId::proportional(theme::SMALL_SIZE);

/// Shows the strip of wavelengths.
pub fn show(ui: &mut Ui, state: &State) {
    let moment = state.moment();
    let rect = ui.max_rect();
    let strip = Rect::from_min_max(rect.min + vec2(0.0, NUMBERS_HEIGHT), rect.max - vec2(0.0, BELOW));
    let painter = ui.painter().clone();
    let marks = marks(&moment, state.document.settings.motion.d == 0.0, ui.visuals());
    paint_colours(&painter, strip, ui.visuals());
    paint_names(&painter, strip, &marks, ui.visuals());
    paint_marks(ui, strip, &marks);
    if marks.is_empty() {
        paint_light(&painter, rect, &moment.light().unwrap_or_default(), ui.visuals().text_color());
    }
    let name = format!("Wavelengths that arrive: {}", description(&marks, &moment));
    let response = ui.interact(strip, ui.scope_id().with("spectrum"), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Image, true, &name));
    response.on_hover_text(
        "The wavelengths that arrive from the selected point now, and the one that it emits at rest, on a \
            logarithmic scale.\nλ received = λ at rest / D",
    );
}

/// Writes above the strip at the bottom of `rect` as much of the `light` in words as has room.
fn paint_light(painter: &Painter, rect: Rect, light: &str, colour: Color32) {
    let mut laid = beginnings(light).into_iter().rev().map(|text| painter.layout_no_wrap(text, FONT, colour));
    let Some(galley) = laid.find(|galley| galley.size().x <= rect.width()) else { return };
    let place = pos2(rect.min.x, rect.min.y + NUMBERS_HEIGHT / 2.0);
    painter.galley(Align2::LEFT_CENTER.anchor_size(place, galley.size()).min, galley, colour);
}

/// Returns the place of a wavelength on the strip; beyond its ends where it lies beyond.
fn place(strip: Rect, wavelength_nm: f64) -> f32 {
    let [first, last] = SCALE_NM.map(math::log10);
    let fraction = (math::log10(wavelength_nm) - first) / (last - first);
    strip.min.x + strip.width() * fraction.clamp(-1.0, 2.0) as f32
}

/// The wavelength at `x` of the scale.
fn wavelength_at(strip: Rect, x: f32) -> f64 {
    let [first, last] = SCALE_NM.map(math::log10);
    math::powf(10.0, first + (last - first) * f64::from((x - strip.min.x) / strip.width()))
}

/// A wavelength on the scale.
struct WavelengthMark {
    /// Name of the mark's wavelength.
    name: &'static str,
    wavelength_nm: f64,
    /// Written above the scale.
    text: String,
    colour: Color32,
    is_at_rest: bool,
}

impl WavelengthMark {
    /// Returns the place of the mark: at an end of the strip where it lies beyond.
    fn x(&self, strip: Rect) -> f32 {
        place(strip, self.wavelength_nm).clamp(strip.min.x, strip.max.x.max(strip.min.x))
    }
}

/// The marks of `moment`: at rest, and what arrives at each eye, or at both in one place.
fn marks(moment: &Moment, are_eyes_together: bool, visuals: &Visuals) -> Vec<WavelengthMark> {
    let RestLight::Line(at_rest) = moment.source else { return Vec::new() };
    let mark = |name, text: &str, wavelength_nm: f64, colour| WavelengthMark {
        name,
        wavelength_nm,
        text: format!("{text} {}", in_words(&[wavelength_nm])),
        colour,
        is_at_rest: false,
    };
    let rest = mark("at rest", "at rest", at_rest, visuals.text_color());
    let mut marks = vec![WavelengthMark { is_at_rest: true, ..rest }];
    let received = moment.wavelengths_nm();
    if let ([Some(both), _], true) = (received, are_eyes_together) {
        marks.push(mark("both eyes", "L = R", both, visuals.strong_text_color()));
        return marks;
    }
    for (eye, letter) in Eye::BOTH.into_iter().zip(["L", "R"]) {
        let wavelength = received[eye.index()];
        marks.extend(wavelength.map(|nm| mark(eye.name(), letter, nm, theme::eye_colour(eye, visuals))));
    }
    marks
}

/// The scale for those who do not see it.
fn description(marks: &[WavelengthMark], moment: &Moment) -> String {
    let texts: Vec<_> =
        marks.iter().map(|mark| format!("{} {}", mark.name, in_words(&[mark.wavelength_nm]))).collect();
    if texts.is_empty() { moment.light().unwrap_or_default() } else { texts.join(", ") }
}

/// The colours of the scale.
fn paint_colours(painter: &Painter, strip: Rect, visuals: &Visuals) {
    let colours = places(strip).map(|x| (x, scale_colour(wavelength_at(strip, x), visuals)));
    paint_strip(painter, strip, colours);
    let stroke = visuals.widgets.noninteractive.bg_stroke;
    painter.rect_stroke(strip, CornerRadius::ZERO, stroke, StrokeKind::Outside);
}

/// Paints the ends of the scale, and names of bands without a colour; left out where a mark is.
fn paint_names(painter: &Painter, strip: Rect, marks: &[WavelengthMark], visuals: &Visuals) {
    let [violet, red] = VISIBLE_NM.map(|end| place(strip, end));
    let names = [
        (strip.min.x + 5.0, Align2::LEFT_CENTER, "100 nm"),
        (violet - 8.0, Align2::RIGHT_CENTER, "ultraviolet"),
        (red + 8.0, Align2::LEFT_CENTER, "infrared"),
        (strip.max.x - 5.0, Align2::RIGHT_CENTER, "3 µm"),
    ];
    for (x, align, text) in names {
        let galley = painter.layout_no_wrap(text.to_owned(), FONT, visuals.text_color());
        let rect = align.anchor_size(pos2(x, strip.center().y), galley.size());
        let room = rect.x_range().expand(NAME_MARGIN);
        if !marks.iter().any(|mark| room.contains(mark.x(strip))) {
            painter.galley(rect.min, galley, visuals.text_color());
        }
    }
}

/// The colour of a wavelength over that of its part of the scale, which shows where it has none.
fn scale_colour(wavelength_nm: f64, visuals: &Visuals) -> Color32 {
    let [ultraviolet, infrared] = if visuals.dark_mode {
        [Color32::from_rgb(0x26, 0x1E, 0x3A), Color32::from_rgb(0x3A, 0x1E, 0x1E)]
    } else {
        [Color32::from_rgb(0xDD, 0xD6, 0xEC), Color32::from_rgb(0xF0, 0xDC, 0xD8)]
    };
    let is_ultraviolet = wavelength_nm < VISIBLE_NM[0].midpoint(VISIBLE_NM[1]);
    visible_colour(wavelength_nm, if is_ultraviolet { ultraviolet } else { infrared })
}

/// Ticks on the strip, and above them the numbers, none of which covers another.
fn paint_marks(ui: &Ui, strip: Rect, marks: &[WavelengthMark]) {
    let painter = ui.painter();
    let galleys: Vec<_> =
        marks.iter().map(|mark| painter.layout_no_wrap(mark.text.clone(), FONT, mark.colour)).collect();
    let spans: Vec<Span> = marks
        .iter()
        .zip(&galleys)
        .map(|(mark, galley)| Span { middle: place(strip, mark.wavelength_nm), width: galley.size().x })
        .collect();
    let lefts = apart(&spans, strip.x_range(), BETWEEN);
    for ((mark, galley), left) in marks.iter().zip(galleys).zip(lefts) {
        let corner =
            pos2(left, strip.min.y - NUMBERS_HEIGHT + (NUMBERS_HEIGHT - galley.size().y) / 2.0 - 1.0);
        painter.galley(corner, galley, mark.colour);
        paint_tick(ui, strip, mark);
    }
}

/// The tick of `mark`, an arrow where it lies beyond an end of the strip.
fn paint_tick(ui: &Ui, strip: Rect, mark: &WavelengthMark) {
    let painter = ui.painter();
    let halo = theme::halo_colour(ui.visuals());
    let (wanted, x) = (place(strip, mark.wavelength_nm), mark.x(strip));
    if wanted == x {
        let (beyond, width) = if mark.is_at_rest { (0.0, 1.5) } else { (2.0, 2.5) };
        let line = strip.y_range().expand(beyond);
        painter.vline(x, line, Stroke::new(width + 2.5, halo));
        painter.vline(x, line, Stroke::new(width, mark.colour));
    } else {
        // The right eye's below the left's, which may lie beyond the same end.
        let part = if mark.name == Eye::Right.name() { 0.75 } else { 0.25 };
        let tip = pos2(x, strip.min.y + part * strip.height());
        paint_arrow(painter, tip, (wanted - x).signum(), mark.colour);
    }
    let at = Rect::from_center_size(pos2(x, strip.center().y), vec2(4.0, strip.height()));
    let response = ui.interact(at, ui.scope_id().with(mark.name), Sense::hover());
    let name = format!("Wavelength, {}: {:.1} nm", mark.name, mark.wavelength_nm);
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Label, true, &name));
}

/// An arrow at the end of a scale that points out of it: to the left (-1) or right (1).
fn paint_arrow(painter: &Painter, tip: Pos2, direction: f32, colour: Color32) {
    let back = tip.x - direction * 10.0;
    let corners = vec![tip, pos2(back, tip.y - 4.0), pos2(back, tip.y + 4.0)];
    painter.add(Shape::convex_polygon(corners, colour, Stroke::NONE));
}
