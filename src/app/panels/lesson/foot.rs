//! The buttons below the page: one leads on, the others are quiet.

use eframe::egui::{Align, Button, Layout, Response, RichText, TextWrapMode, Ui, Vec2, vec2};

use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, ShowCommand, WindowCommand};
use crate::app::panels::{Commands, OnClick as _, on_change};
use crate::app::state::State;
use crate::app::state::lesson::{LessonCommand, Running};
use crate::app::state::overlay::Overlay;
use crate::lesson::{Answer, AnswerKind, Course, Lesson};

/// Least width and height of the button that leads on.
const MAIN_SIZE: [f32; 2] = [92.0, 30.0];

/// Shows the buttons at the foot of the panel.
pub fn show(ui: &mut Ui, state: &State, running: &Running, commands: &mut Commands) {
    let course = &running.course;
    ui.separator();
    ui.with_layout(Layout::top_down(Align::Min), |ui| {
        let next = state.lesson_after().filter(|_| is_over(running));
        if let Some(next) = &next {
            begin(ui, next, commands);
        }
        ui.horizontal(|ui| {
            back(ui, course, commands);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| match next {
                Some(_) => close(ui, false, commands),
                None => lead_on(ui, running, commands),
            });
        });
        if next.is_some() {
            return;
        }
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
                    let button = Button::new("Set up again").frame_when_inactive(false);
                    ui.add(button)
                        .on_hover_text("Restores the state of this step")
                        .on_click(commands, LessonCommand::SetUp);
                }
            });
        });
    });
}

fn back(ui: &mut Ui, course: &Course, commands: &mut Commands) {
    let [can_go_back, _] = course.can_go();
    let back = Button::new("Back").min_size(vec2(0.0, MAIN_SIZE[1])).frame_when_inactive(false);
    let back = ui.add_enabled(can_go_back, back);
    back.on_hover_text(with_keys("", &[Command::Show(ShowCommand::Next(-1))]))
        .on_click(commands, LessonCommand::Back);
}

/// Whether the lesson is at its end, with nothing left to ask or to show.
fn is_over(running: &Running) -> bool {
    let [_, can_go_on] = running.course.can_go();
    !running.is_running() && running.course.asked().is_none() && !can_go_on
}

fn lead_on(ui: &mut Ui, running: &Running, commands: &mut Commands) {
    let course = &running.course;
    let [_, can_go_on] = course.can_go();
    if running.is_running() {
        main(ui, "Show the end", true, MAIN_SIZE.into())
            .on_hover_text("Goes to the end of what is playing")
            .on_click(commands, LessonCommand::Forward);
    } else if course.asked().is_some() {
        let is_entered = course.draft.as_ref().is_some_and(Answer::is_entered);
        main(ui, "Predict", is_entered, MAIN_SIZE.into()).on_click(commands, LessonCommand::Predict);
        if course.is_answered() {
            return;
        }
        let skip = Button::new("Skip").min_size(vec2(0.0, MAIN_SIZE[1])).frame_when_inactive(false);
        ui.add(skip).on_hover_text("Goes on without a prediction").on_click(commands, LessonCommand::Skip);
    } else if can_go_on {
        main(ui, "Next", true, MAIN_SIZE.into())
            .on_hover_text(with_keys("", &[Command::Show(ShowCommand::Next(1))]))
            .on_click(commands, LessonCommand::Forward);
    } else {
        close(ui, true, commands);
    }
    let is_a_state_alone = course.step().is_some() && !can_go_on;
    if is_a_state_alone {
        ui.button("All lessons").on_click(commands, WindowCommand::Toggle(Overlay::Start));
    }
}

/// The button that begins the lesson after this one, with as much of its title as the panel has room for.
fn begin(ui: &mut Ui, next: &Lesson, commands: &mut Commands) {
    let name = format!("Next: {}", next.title);
    let width = ui.available_width();
    let begin = ui.scope(|ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
        main(ui, &name, true, vec2(width, MAIN_SIZE[1]))
    });
    begin
        .inner
        .on_hover_text(format!("Begins the next lesson: {}", next.title))
        .on_click(commands, LessonCommand::Open(next.name.clone()));
}

/// The button that closes the lesson; it leads on where no other does.
fn close(ui: &mut Ui, is_main: bool, commands: &mut Commands) {
    let button = if is_main {
        main(ui, "Close", true, MAIN_SIZE.into())
    } else {
        ui.add(Button::new("Close").min_size(vec2(0.0, MAIN_SIZE[1])).frame_when_inactive(false))
    };
    button.on_click(commands, LessonCommand::Close);
}

/// The button that leads on, of at least this `size`.
fn main(ui: &mut Ui, text: &str, is_enabled: bool, size: Vec2) -> Response {
    let chosen = ui.visuals().selection;
    let text = RichText::new(text).color(if is_enabled {
        chosen.stroke.color
    } else {
        ui.visuals().weak_text_color()
    });
    let mut button = Button::new(text).min_size(size);
    if is_enabled {
        button = button.fill(chosen.bg_fill);
    }
    ui.add_enabled(is_enabled, button)
}

fn count_hands(ui: &mut Ui, course: &Course, commands: &mut Commands) {
    let mut is_class = course.is_class;
    let tip = "Counts how many of a class raise their hands for each choice";
    ui.checkbox(&mut is_class, "Count hands").on_hover_text(tip);
    on_change(commands, &course.is_class, is_class, |_| LessonCommand::ToggleClass);
}
