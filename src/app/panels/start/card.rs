//! Cards in rows: a picture of what is shown, and what it is called. A row is as high as its longest text
//! needs.

use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::epaint::{CornerRadius, Shadow};
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{
    Color32, CursorIcon, FontId, Galley, Id, Rect, Response, Sense, Stroke, StrokeKind, TextStyle,
    TextureHandle, Ui, WidgetInfo, pos2, vec2,
};

use super::Commands;
use super::picture::{self, ASPECT, RADIUS};
use crate::app::commands::Command;
use crate::app::panels::OnClick as _;
use crate::app::views::thumbnails::Thumbnails;
use crate::app::widgets::theme;
use crate::lesson::Lesson;

/// Space between cards, and around what is written in one; points.
const BETWEEN: f32 = 14.0;
const AROUND: f32 = 11.0;
/// Number of presets, at least, that a row has room for where it can.
const FEWEST: usize = 5;

/// The cards of a section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cards {
    /// Chapters on the first page, one card each.
    Chapters,
    /// Large cards of lessons.
    Lessons,
    /// Small cards of presets.
    Presets,
}

/// A card of the start page.
pub struct Card<'a> {
    /// Lesson or preset of the card's picture.
    pub lesson: &'a Arc<Lesson>,
    /// Title below the picture.
    pub title: &'a str,
    /// Number among the others, if they come in an order.
    pub number: Option<usize>,
    /// In small writing below the title; may be empty.
    pub details: String,
    /// Description; may be empty.
    pub text: String,
    /// Longer description, for the tooltip.
    pub tip: String,
    /// The remark on the card of the preset that is shown.
    pub state: Option<String>,
    /// Command of a click on the card.
    pub command: Command,
}

impl Cards {
    /// The narrowest of them, points.
    const fn narrowest(self) -> f32 {
        match self {
            Self::Lessons => 226.0,
            Self::Chapters | Self::Presets => 150.0,
        }
    }

    /// Returns the number of cards in a row of this `width`, so that the last row of `count` cards lacks as
    /// few as possible.
    fn columns(self, width: f32, scale: f32, count: usize) -> usize {
        let most = (width + scale * BETWEEN) / (scale * (self.narrowest() + BETWEEN));
        let most = (most as usize).max(1);
        // Those of a small group are no larger than the others.
        let count = if self == Self::Presets { count.max(FEWEST) } else { count };
        count.div_ceil(count.div_ceil(most).max(1)).max(1)
    }

    /// Shows `cards` in rows.
    pub fn show(self, ui: &mut Ui, cards: &[Card<'_>], thumbnails: &mut Thumbnails, commands: &mut Commands) {
        let (width, scale) = (ui.available_width(), theme::text_scale(ui.style()));
        let columns = self.columns(width, scale, cards.len());
        let between = scale * BETWEEN;
        let card_width = (width - between * (columns - 1) as f32) / columns as f32;
        for row in cards.chunks(columns) {
            let written: Vec<_> = row.iter().map(|card| card.written(ui, self, card_width, scale)).collect();
            let text_height = written.iter().map(|galley| galley.size().y).fold(0.0, f32::max);
            let height = card_width * ASPECT + text_height + 2.0 * scale * AROUND;
            let (room, _) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
            for (number, (card, written)) in row.iter().zip(written).enumerate() {
                let left = room.min.x + number as f32 * (card_width + between);
                let rect = Rect::from_min_size(pos2(left, room.min.y), vec2(card_width, height));
                card.show(ui, rect, written, thumbnails).on_click(commands, card.command.clone());
            }
            ui.add_space(between - ui.spacing().item_spacing.y);
        }
    }
}

impl Card<'_> {
    /// Returns the name of the card for assistive technology.
    fn name(&self) -> String {
        match self.number {
            Some(number) => format!("{number}. {}", self.title),
            None => self.title.to_owned(),
        }
    }

    /// Lays out the text below the picture.
    fn written(&self, ui: &Ui, cards: Cards, width: f32, scale: f32) -> Arc<Galley> {
        let (body, small) = (TextStyle::Body.resolve(ui.style()), TextStyle::Small.resolve(ui.style()));
        let visuals = ui.visuals();
        let title = match cards {
            Cards::Chapters => FontId { size: 1.3 * body.size, ..body.clone() },
            Cards::Lessons => FontId { size: 1.15 * body.size, ..body.clone() },
            Cards::Presets => FontId { size: 0.96 * body.size, ..body.clone() },
        };
        let mut job = LayoutJob {
            wrap: TextWrapping::wrap_at_width((width - 2.0 * scale * AROUND).max(1.0)),
            ..LayoutJob::default()
        };
        if let Some(number) = self.number {
            job.append(
                &format!("{number}   "),
                0.0,
                TextFormat::simple(title.clone(), visuals.weak_text_color()),
            );
        }
        job.append(self.title, 0.0, TextFormat::simple(title, visuals.strong_text_color()));
        if !self.details.is_empty() {
            let format = TextFormat {
                line_height: Some(1.7 * small.size),
                ..TextFormat::simple(small, visuals.weak_text_color())
            };
            job.append(&format!("\n{}", self.details), 0.0, format);
        }
        if !self.text.is_empty() {
            let font = FontId { size: 0.93 * body.size, ..body };
            job.append(&format!("\n{}", self.text), 0.0, TextFormat::simple(font, visuals.text_color()));
        }
        ui.painter().layout_job(job)
    }

    fn show(&self, ui: &Ui, rect: Rect, written: Arc<Galley>, thumbnails: &mut Thumbnails) -> Response {
        let id: Id =
            ui.make_persistent_id(("card", self.lesson.is_a_preset(), &self.lesson.name, self.title));
        let response = ui.interact(rect, id, Sense::click());
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, self.state.is_some(), self.name()));
        if response.gained_focus() {
            ui.scroll_to_rect(rect, None);
        }
        let is_in_view = ui.is_rect_visible(rect);
        let picture = thumbnails.picture(ui.ctx(), self.lesson, is_in_view);
        if is_in_view {
            self.paint(ui, &response, written, picture);
        }
        let response = response.on_hover_cursor(CursorIcon::PointingHand);
        if self.tip.is_empty() || self.tip == self.text {
            response
        } else {
            response.on_hover_text(&self.tip)
        }
    }

    fn paint(&self, ui: &Ui, response: &Response, written: Arc<Galley>, picture: Option<&TextureHandle>) {
        let (rect, visuals, painter) = (response.rect, ui.visuals(), ui.painter());
        let scale = theme::text_scale(ui.style());
        let is_pointed_at = response.hovered() || response.has_focus();
        let shadow = Shadow {
            offset: [0, if is_pointed_at { 4 } else { 2 }],
            blur: if is_pointed_at { 16 } else { 8 },
            spread: 0,
            color: Color32::from_black_alpha(if visuals.dark_mode { 90 } else { 28 }),
        };
        painter.add(shadow.as_shape(rect, CornerRadius::same(RADIUS)));
        painter.rect_filled(rect, RADIUS, visuals.window_fill);
        let upper = rect.with_max_y(rect.min.y + rect.width() * ASPECT);
        let corners = CornerRadius { nw: RADIUS, ne: RADIUS, sw: 0, se: 0 };
        picture::paint(ui, upper, corners, picture);
        let text = pos2(rect.min.x, upper.max.y) + scale * vec2(AROUND, AROUND);
        painter.galley(text, written, visuals.text_color());
        let stroke = match (&self.state, is_pointed_at) {
            (Some(_), _) => Stroke::new(2.0, theme::primary_colours(visuals)[0]),
            (None, true) => Stroke::new(1.5, theme::focus_stroke(visuals).color),
            (None, false) => visuals.widgets.noninteractive.bg_stroke,
        };
        painter.rect_stroke(rect, RADIUS, stroke, StrokeKind::Inside);
        if let Some(state) = &self.state {
            picture::tag(ui, upper, state, theme::primary_colours(visuals));
        }
    }
}
