//! The title of the lesson, and where one is in it.

use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Label, Layout, Response, RichText, Sense, Stroke, Ui, WidgetInfo, vec2};

use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::lesson::LessonCommand;
use crate::app::widgets::icons::{self, Icon};
use crate::app::widgets::theme;
use crate::lesson::{Course, Phase, Place};

/// Side of the buttons in the title.
const BUTTON_SIDE: f32 = 22.0;
/// Radius of the dot of a step, from one to the next at most, and how high it can be clicked.
const DOT_RADIUS: f32 = 4.0;
const DOT_STEP: f32 = 24.0;
const DOT_HEIGHT: f32 = 18.0;

/// Shows the title and the dots.
pub fn show(ui: &mut Ui, course: &Course, commands: &mut Commands) {
    ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        let size = vec2(BUTTON_SIDE, BUTTON_SIDE);
        let close = icons::button(ui, Icon::Remove, "Close the lesson", size);
        close
            .on_hover_text("Closes the lesson, and restores the parts of the window. Its answers are kept")
            .on_click(commands, LessonCommand::Close);
        fold(ui, Icon::Back, "Fold the lesson", commands);
        ui.with_layout(Layout::top_down(Align::Min), |ui| {
            ui.add_space(2.0);
            ui.add(Label::new(&course.lesson().title).wrap());
        });
    });
    let count = course.lesson().steps.len();
    if count < 2 {
        return;
    }
    ui.horizontal(|ui| {
        let place = course.place().step;
        let text = if place < count { format!("{} of {count}", place + 1) } else { "End".to_owned() };
        ui.spacing_mut().item_spacing.x = 0.0;
        let step = DOT_STEP.min((ui.available_width() - 50.0) / count as f32).max(0.0);
        for number in 0..count {
            dot(ui, course, number, vec2(step, DOT_HEIGHT), commands);
        }
        ui.add_space(theme::GAP);
        ui.label(RichText::new(text).weak());
    });
}

/// Shows the strip of a lesson that is folded.
pub fn folded(ui: &mut Ui, course: &Course, commands: &mut Commands) {
    ui.with_layout(Layout::top_down(Align::Center), |ui| {
        fold(ui, Icon::Forward, "Unfold the lesson", commands);
        ui.add_space(theme::GAP);
        let count = course.lesson().steps.len();
        for number in 0..if count < 2 { 0 } else { count } {
            dot(ui, course, number, vec2(BUTTON_SIDE, DOT_STEP), commands);
        }
    });
}

fn fold(ui: &mut Ui, icon: Icon, name: &str, commands: &mut Commands) {
    let button = icons::button(ui, icon, name, vec2(BUTTON_SIDE, BUTTON_SIDE));
    button.on_hover_text(name).on_click(commands, LessonCommand::ToggleFolded);
}

/// The dot of the step of this `number`, which goes there.
fn dot(ui: &mut Ui, course: &Course, number: usize, size: eframe::egui::Vec2, commands: &mut Commands) {
    let (place, can_reach) = (course.place().step, course.can_reach(number));
    let title = &course.lesson().steps[number].title;
    let sense = if can_reach { Sense::click() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(size, sense);
    let name = format!("Step {}: {title}", number + 1);
    let is_here = number == place;
    response.widget_info(|| WidgetInfo::selected(Role::Button, can_reach, is_here, &name));
    paint(ui, &response, rect.center(), [is_here, number < place, can_reach]);
    response
        .on_hover_text(&name)
        .on_click(commands, LessonCommand::GoTo(Place { step: number, phase: Phase::Ask }));
}

fn paint(ui: &Ui, response: &Response, centre: eframe::egui::Pos2, [is_here, is_past, can_reach]: [bool; 3]) {
    let visuals = ui.visuals();
    let accent = theme::focus_stroke(visuals).color;
    let quiet = visuals.weak_text_color();
    let is_pointed_at = can_reach && response.hovered();
    let radius = DOT_RADIUS + if is_here || is_pointed_at { 1.0 } else { 0.0 };
    if is_here {
        ui.painter().circle_filled(centre, radius, accent);
    } else if is_past {
        ui.painter().circle_filled(centre, radius, quiet);
    } else {
        let colour = if can_reach { accent } else { quiet };
        ui.painter().circle_stroke(centre, radius - 0.5, Stroke::new(1.2, colour));
    }
}
