//! Answers one below the other, each on a card that is chosen by a click.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Align2, Color32, Frame, Layout, Margin, Rect, Response, RichText, Sense, Stroke, StrokeKind,
    TextStyle, Ui, UiBuilder, WidgetInfo, vec2,
};

use crate::app::commands::choice_keys::letter_of;
use crate::app::widgets::icons::{self, Icon};
use crate::app::widgets::markdown;
use crate::app::widgets::theme;
use crate::comfort::ComfortVerdict;
use crate::lesson::Text;

/// Space between what belongs together less.
pub const APART: f32 = 8.0;
/// Corners of a card, its border, and the space inside that.
const CORNER: u8 = 6;
const BORDER: f32 = 1.5;
const INSIDE: Margin = Margin::symmetric(9, 6);

/// The sign before the text of a card.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// A ring, filled if it is chosen.
    Ring(bool),
    /// The letter of the choice with this number, from 0, and whether it is chosen: its key answers, and an
    /// audience holds up cards.
    Letter(usize, bool),
    /// A tick: it is so.
    Right,
    /// No sign.
    Nothing,
}

/// The room for cards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Room {
    /// The panel, which is high: they stand one below the other.
    Panel,
    /// Below the picture before an audience: they stand beside each other, as far as each has some width.
    Audience,
}

/// Least width of a card beside others, in heights of the writing.
const LEAST_BESIDE: f32 = 7.0;

/// Shows something for each of these `texts`.
pub fn each(ui: &mut Ui, room: Room, texts: &[Text], mut show: impl FnMut(&mut Ui, usize, &Text)) {
    let size = TextStyle::Body.resolve(ui.style()).size;
    let (has_width, count) = (ui.available_width() >= LEAST_BESIDE * size * texts.len() as f32, texts.len());
    if room == Room::Audience && has_width && count > 1 {
        ui.columns(count, |columns| {
            for (number, (ui, text)) in columns.iter_mut().zip(texts).enumerate() {
                show(ui, number, text);
            }
        });
    } else {
        texts.iter().enumerate().for_each(|(number, text)| show(ui, number, text));
    }
}

/// Letters of this number of choices, in words: "A, B or C".
pub fn keys_text(count: usize) -> String {
    let letters: Vec<&str> = (0..count).map(letter_of).collect();
    match letters.as_slice() {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [others @ .., last] => format!("{} or {last}", others.join(", ")),
    }
}

/// The card of the choice with this number, from 0, which its letter chooses, too.
pub fn choice(ui: &mut Ui, text: &Text, number: usize, is_chosen: bool) -> Response {
    let sign = Sign::Letter(number, is_chosen);
    let name = markdown::said(ui, &text.markdown);
    let builder = UiBuilder::new().id_salt(("choice", text.line, &name)).sense(Sense::click());
    let response = ui
        .scope_builder(builder, |ui| {
            let response = ui.response();
            let colour = match (is_chosen, response.hovered()) {
                (true, _) => theme::focus_stroke(ui.visuals()).color,
                (false, true) => ui.visuals().text_color(),
                (false, false) => quiet_line(ui),
            };
            card(ui, text, sign, colour);
        })
        .response;
    response.widget_info(|| WidgetInfo::selected(Role::RadioButton, ui.is_enabled(), is_chosen, &name));
    response
}

/// Shows a card that only gives information.
pub fn show(ui: &mut Ui, text: &Text, is_right: bool) {
    let (sign, colour) =
        if is_right { (Sign::Right, right_colour(ui)) } else { (Sign::Ring(true), quiet_line(ui)) };
    card(ui, text, sign, colour);
}

fn quiet_line(ui: &Ui) -> Color32 {
    ui.visuals().widgets.noninteractive.bg_stroke.color
}

/// The colour of what is right.
pub fn right_colour(ui: &Ui) -> Color32 {
    theme::verdict_colour(ComfortVerdict::Comfortable, ui.visuals())
}

fn card(ui: &mut Ui, text: &Text, sign: Sign, border: Color32) {
    let stroke = Stroke::new(BORDER, border);
    let fill = ui.visuals().faint_bg_color;
    let frame = Frame::new().fill(fill).corner_radius(CORNER).inner_margin(INSIDE).stroke(stroke);
    frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        text_behind(ui, text, sign);
    });
}

/// `text` behind its `sign`.
pub fn text_behind(ui: &mut Ui, text: &Text, sign: Sign) {
    let size = TextStyle::Body.resolve(ui.style()).size;
    ui.with_layout(Layout::left_to_right(Align::Min), |ui| {
        ui.spacing_mut().item_spacing.x = 0.5 * size;
        if sign != Sign::Nothing {
            let part = if matches!(sign, Sign::Letter(..)) { LETTER } else { 1.0 };
            let (rect, response) = ui.allocate_exact_size(vec2(part * size, 1.3 * size), Sense::hover());
            if let Sign::Letter(number, _) = sign {
                response.widget_info(|| WidgetInfo::labeled(Role::Label, true, letter_of(number)));
            }
            paint(ui, sign, rect.center(), 0.42 * part * size);
        }
        ui.vertical(|ui| markdown::show(ui, &text.markdown));
    });
}

/// Size of a letter with its ring, relative to other signs.
const LETTER: f32 = 1.4;

fn paint(ui: &Ui, sign: Sign, centre: eframe::egui::Pos2, radius: f32) {
    let painter = ui.painter();
    match sign {
        Sign::Nothing => {}
        Sign::Right => icons::sign(painter, Icon::Done, centre, 1.1 * radius, right_colour(ui)),
        Sign::Letter(number, is_chosen) => {
            let visuals = ui.visuals();
            let [fill, ink] = if is_chosen {
                theme::primary_colours(visuals)
            } else {
                [visuals.widgets.inactive.weak_bg_fill, visuals.strong_text_color()]
            };
            // As a key of a keyboard.
            let cap = Rect::from_center_size(centre, 1.9 * vec2(radius, radius));
            let (corner, edge) = (0.3 * radius, visuals.weak_text_color());
            painter.rect_filled(cap.translate(vec2(0.0, 0.16 * radius)), corner, edge);
            painter.rect(cap, corner, fill, Stroke::new(1.0, edge), StrokeKind::Inside);
            let font = TextStyle::Small.resolve(ui.style());
            painter.text(centre, Align2::CENTER_CENTER, letter_of(number), font, ink);
        }
        Sign::Ring(is_chosen) => {
            let visuals = ui.visuals();
            let colour =
                if is_chosen { theme::focus_stroke(visuals).color } else { visuals.weak_text_color() };
            painter.circle_stroke(centre, radius, Stroke::new(1.3, colour));
            if is_chosen {
                painter.circle_filled(centre, 0.5 * radius, colour);
            }
        }
    }
}

/// A quiet line above a card.
pub fn quiet(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).weak());
}

/// `text`, in the colour of what counts.
pub fn question(ui: &mut Ui, text: &Text) {
    ui.scope(|ui| {
        let strong = ui.visuals().strong_text_color();
        ui.visuals_mut().override_text_color = Some(strong);
        markdown::show(ui, &text.markdown);
    });
}
