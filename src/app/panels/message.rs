//! A message, over the views: it takes no room from any part, however long it is, and can be copied and
//! closed.

use eframe::egui::{
    Align, Area, Context, Frame, Id, Label, Layout, Margin, Order, Rect, RichText, ScrollArea, Sense, Stroke,
    Ui, pos2, vec2,
};

use super::{Commands, OnClick as _};
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, WindowCommand};
use crate::app::state::State;
use crate::app::state::notice::Notice;
use crate::app::widgets::icons::{self, Icon};
use crate::app::widgets::{self, theme};

/// The widest message and the least height of one, at the usual scale of writing, and what is around its
/// text; points.
const WIDEST: f32 = 640.0;
const LOWEST: f32 = 60.0;
const AROUND: f32 = 10.0;

/// Shows the message at the top of `room`, inside `window`, if there is one.
pub fn show(ctx: &Context, state: &State, room: Rect, window: Rect, commands: &mut Commands) {
    let Some(notice) = &state.scratch.notice else { return };
    let scale = theme::text_scale(&ctx.global_style());
    let width = (scale * WIDEST).min(room.width() - 2.0 * theme::GAP).max(1.0);
    let lowest = (scale * LOWEST).min(window.max.y - room.min.y);
    let height = (room.height().max(lowest) - 2.0 * theme::GAP - 2.0 * AROUND).max(1.0);
    let place = pos2(room.center().x - 0.5 * width, room.min.y + theme::GAP);
    let area =
        Area::new(Id::unique("message")).order(Order::Foreground).fixed_pos(place).constrain_to(window);
    area.show(ctx, |ui| {
        let colour = theme::notice_colour(notice.is_error, ui.visuals());
        let frame = Frame::popup(ui.style()).stroke(Stroke::new(1.5, colour)).inner_margin(Margin::same(8));
        frame.show(ui, |ui| {
            ui.set_width((width - 2.0 * AROUND).max(1.0));
            ui.horizontal_top(|ui| {
                sign(ui, notice);
                ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
                    buttons(ui, notice, commands);
                    ui.with_layout(Layout::top_down(Align::Min), |ui| text(ui, notice, height));
                });
            });
        });
    });
}

/// Draws the sign of the message: good news and errors differ in shape and colour.
fn sign(ui: &mut Ui, notice: &Notice) {
    let (rect, _) = ui.allocate_exact_size(vec2(18.0, 22.0), Sense::hover());
    let icon = if notice.is_error { Icon::Failed } else { Icon::Done };
    icons::sign(ui.painter(), icon, rect.center(), 7.0, theme::notice_colour(notice.is_error, ui.visuals()));
}

/// Shows the whole text, selectable; beyond this `height` it scrolls.
fn text(ui: &mut Ui, notice: &Notice, height: f32) {
    ScrollArea::vertical().max_height(height).show(ui, |ui| {
        let text = RichText::new(&notice.text).color(ui.visuals().strong_text_color());
        let response = ui.add(Label::new(text).wrap().selectable(true));
        widgets::read_out(ui.ctx(), response.id);
        if let Some(path) = &notice.path {
            response.on_hover_text(path);
        }
    });
}

fn buttons(ui: &mut Ui, notice: &Notice, commands: &mut Commands) {
    let close = icons::button(ui, Icon::Remove, "Close message", vec2(22.0, 22.0));
    close
        .on_hover_text(with_keys("Close.", &[Command::Window(WindowCommand::Close)]))
        .on_click(commands, WindowCommand::CloseNotice);
    if ui.button("Copy").on_hover_text("Copies the message").accessible_name("Copy message").clicked() {
        ui.ctx().copy_text(notice.text.clone());
    }
}
