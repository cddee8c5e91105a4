//! The buttons below the page: one leads on, the others are quiet.

use eframe::egui::{Align, Button, Layout, RichText, Ui, vec2};

use super::asked::ask;
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, ShowCommand, WindowCommand};
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::lesson::{LessonCommand, Running};
use crate::app::state::overlay::Overlay;
use crate::lesson::{Answer, AnswerKind, Course};

/// Least width and height of the button that leads on.
const MAIN_SIZE: [f32; 2] = [92.0, 30.0];

/// Shows the buttons at the foot of the panel.
pub fn show(ui: &mut Ui, state: &State, running: &Running, commands: &mut Commands) {
    let course = &running.course;
    ui.separator();
    ui.with_layout(Layout::top_down(Align::Min), |ui| {
        ui.horizontal(|ui| {
            let [can_go_back, _] = course.can_go();
            let back = Button::new("Back").min_size(vec2(0.0, MAIN_SIZE[1])).frame_when_inactive(false);
            if ui
                .add_enabled(can_go_back, back)
                .on_hover_text(with_keys("", &[Command::Show(ShowCommand::Next(-1))]))
                .clicked()
            {
                ask(commands, LessonCommand::Back);
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| lead_on(ui, state, running, commands));
        });
        ui.horizontal(|ui| {
            if course.lesson().steps.iter().any(|step| {
                let kind = step.prediction.as_ref().map(|prediction| &prediction.kind);
                matches!(kind, Some(AnswerKind::Choice(_)))
            }) {
                count_hands(ui, course, commands);
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let can_be_set_up = !running.is_running() && course.step().is_some();
                if can_be_set_up && !state.is_as_in_lesson() {
                    set_up_again(ui, commands);
                }
            });
        });
    });
}

fn lead_on(ui: &mut Ui, state: &State, running: &Running, commands: &mut Commands) {
    let course = &running.course;
    let [_, can_go_on] = course.can_go();
    if running.is_running() {
        if main(ui, "Finish", true).on_hover_text("Goes to the end of what is playing").clicked() {
            ask(commands, LessonCommand::Forward);
        }
    } else if course.asked().is_some() {
        let is_entered = course.draft.as_ref().is_some_and(Answer::is_entered);
        if main(ui, "Predict", is_entered).clicked() {
            ask(commands, LessonCommand::Predict);
        }
        if course.is_answered() {
            return;
        }
        let skip = Button::new("Skip").min_size(vec2(0.0, MAIN_SIZE[1])).frame_when_inactive(false);
        if ui.add(skip).on_hover_text("Goes on without a prediction").clicked() {
            ask(commands, LessonCommand::Skip);
        }
    } else if can_go_on {
        if main(ui, "Next", true)
            .on_hover_text(with_keys("", &[Command::Show(ShowCommand::Next(1))]))
            .clicked()
        {
            ask(commands, LessonCommand::Forward);
        }
    } else {
        leave(ui, state, commands);
    }
    let is_a_state_alone = course.step().is_some() && !can_go_on;
    if is_a_state_alone && ui.button("All lessons").clicked() {
        commands.push(WindowCommand::Toggle(Overlay::Start).into());
    }
}

/// The ways out of a lesson that is over: to the next one, or to none.
fn leave(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let next = state.lesson_after();
    if let Some(next) = &next {
        let begin = main(ui, &next_name(ui, &next.title), true);
        if begin.on_hover_text(format!("Begins the next lesson: {}", next.title)).clicked() {
            ask(commands, LessonCommand::Open(next.name.clone()));
        }
    }
    let is_main = next.is_none();
    let is_closed = if is_main {
        main(ui, "Close", true).clicked()
    } else {
        ui.add(Button::new("Close").min_size(vec2(0.0, MAIN_SIZE[1])).frame_when_inactive(false)).clicked()
    };
    if is_closed {
        ask(commands, LessonCommand::Close);
    }
}

/// *Next* with as much of the `title` as there is room for beside the quiet buttons.
fn next_name(ui: &Ui, title: &str) -> String {
    let size = eframe::egui::TextStyle::Body.resolve(ui.style()).size;
    let room = ((ui.available_width() - 9.0 * size) / (0.52 * size)).max(0.0) as usize;
    let name = format!("Next: {title}");
    if name.chars().count() <= room {
        return name;
    }
    let begin: String = name.chars().take(room.max(6) - 1).collect();
    format!("{}…", begin.trim_end())
}

/// The button that leads on.
fn main(ui: &mut Ui, text: &str, is_enabled: bool) -> eframe::egui::Response {
    let chosen = ui.visuals().selection;
    let text = RichText::new(text).color(if is_enabled {
        chosen.stroke.color
    } else {
        ui.visuals().weak_text_color()
    });
    let mut button = Button::new(text).min_size(MAIN_SIZE.into());
    if is_enabled {
        button = button.fill(chosen.bg_fill);
    }
    ui.add_enabled(is_enabled, button)
}

fn count_hands(ui: &mut Ui, course: &Course, commands: &mut Commands) {
    let mut is_class = course.is_class();
    let tip = "Counts how many of a class raise their hands for each choice";
    if ui.checkbox(&mut is_class, "Count hands").on_hover_text(tip).changed() {
        ask(commands, LessonCommand::ToggleClass);
    }
}

fn set_up_again(ui: &mut Ui, commands: &mut Commands) {
    let button = Button::new("Set up again").frame_when_inactive(false);
    if ui.add(button).on_hover_text("Restores the state of this step").clicked() {
        ask(commands, LessonCommand::SetUp);
    }
}
