//! The form in which a prediction is entered: a choice, a count of raised hands, a number, a place or a
//! curve; and its confidence.

use eframe::egui::{Align, Event, Id, Key, Layout, RichText, TextEdit, TextStyle, Ui, vec2};

use super::cards::{self, Room};
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::views::predicted_place;
use crate::app::widgets::icons::{self, Icon};
use crate::app::widgets::markdown;
use crate::lesson::{Answer, AnswerKind, Confidence, Course, Number, Options, Prediction};
use crate::number_text;

/// Shows the form of `prediction`.
pub fn show(
    ui: &mut Ui,
    state: &State,
    room: Room,
    (course, prediction): (&Course, &Prediction),
    commands: &mut Commands,
) {
    match &prediction.kind {
        AnswerKind::Choice(options) if course.counts_hands() => votes(ui, room, course, options, commands),
        AnswerKind::Choice(options) => choices(ui, room, course, options, commands),
        AnswerKind::Number(asked) => number(ui, course, asked, commands),
        // Before an audience the question says it, and the plot.
        AnswerKind::Point(_) | AnswerKind::Curve(_) if room == Room::Audience && course.draft.is_none() => {}
        AnswerKind::Point(_) | AnswerKind::Curve(_) => hint(ui, state, course),
    }
}

fn draft(commands: &mut Commands, answer: Option<Answer>) {
    commands.push(LessonCommand::Draft(answer).into());
}

/// The choices, one of which can be taken.
fn choices(ui: &mut Ui, room: Room, course: &Course, options: &Options, commands: &mut Commands) {
    cards::each(ui, room, &options.texts, |ui, number, text| {
        let is_chosen = course.draft == Some(Answer::Choice(number));
        cards::choice(ui, text, number, is_chosen)
            .on_click(commands, LessonCommand::Draft(Some(Answer::Choice(number))));
    });
}

/// Shows the choices, each with the number of hands raised for it.
fn votes(ui: &mut Ui, room: Room, course: &Course, options: &Options, commands: &mut Commands) {
    let votes = course.votes(options.texts.len());
    let side = 1.6 * TextStyle::Body.resolve(ui.style()).size;
    cards::each(ui, room, &options.texts, |ui, number, text| {
        ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            let name = markdown::said(ui, &text.markdown);
            let changed = |by: i32| {
                let mut votes = votes.clone();
                votes[number] = votes[number].saturating_add_signed(by);
                Some(Answer::Votes(votes))
            };
            let size = vec2(side, side);
            if icons::button(ui, Icon::More, &format!("One more for {name}"), size).clicked() {
                draft(commands, changed(1));
            }
            let count = hands(ui, course, number, (votes[number], &name), 1.7 * side);
            if let Some(count) = count {
                let mut votes = votes.clone();
                votes[number] = count;
                draft(commands, Some(Answer::Votes(votes)));
            }
            if icons::button(ui, Icon::Fewer, &format!("One fewer for {name}"), size).clicked() {
                draft(commands, changed(-1));
            }
            ui.add_space(6.0);
            ui.with_layout(Layout::top_down(Align::Min), |ui| {
                ui.add_space(2.0);
                cards::text_behind(ui, text, cards::Sign::Letter(number, false));
            });
        });
    });
}

/// Largest number of votes for one choice.
const MOST_HANDS: u32 = 9999;

/// Shows the field for the number of votes for a choice; returns a new number when it changes. A digit typed
/// while no field has the keyboard focus goes to the first one.
fn hands(ui: &mut Ui, course: &Course, number: usize, (count, name): (u32, &str), width: f32) -> Option<u32> {
    let id = Id::unique(("hands", ui.layer_id(), &course.lesson().name, course.place().step, number));
    let types_digit = |event: &Event| matches!(event, Event::Text(text) if text.starts_with(|sign: char| sign.is_ascii_digit()));
    if number == 0 && !ui.ctx().text_edit_focused() && ui.input(|input| input.events.iter().any(types_digit))
    {
        ui.memory_mut(|memory| memory.request_focus(id));
    }
    let mut text = if count == 0 { String::new() } else { count.to_string() };
    let field = TextEdit::singleline(&mut text).id(id).desired_width(width).hint_text("0");
    let response = ui.add(field.char_limit(4));
    let changed = response.changed();
    response.accessible_name(format!("Hands for {name}: {count}"));
    let typed: String = text.chars().filter(char::is_ascii_digit).collect();
    let typed = typed.parse().unwrap_or(0).min(MOST_HANDS);
    (changed && typed != count).then_some(typed)
}

/// The field in which a number is typed. Enter predicts it.
pub fn number(ui: &mut Ui, course: &Course, asked: &Number, commands: &mut Commands) {
    let id = Id::unique(("number predicted", ui.layer_id(), &course.lesson().name, course.place().step));
    ui.horizontal(|ui| {
        let drafted = match course.draft {
            Some(Answer::Number(number)) => number_text::shortest(number),
            _ => String::new(),
        };
        let is_edited = ui.memory(|memory| memory.has_focus(id));
        // What is no number stays where it is until it is mended.
        let is_kept = |text: &String| is_edited || remark(text).is_some();
        let kept = ui.data(|data| data.get_temp::<String>(id)).filter(is_kept);
        let mut text = kept.unwrap_or(drafted);
        let size = TextStyle::Body.resolve(ui.style()).size;
        let field = TextEdit::singleline(&mut text).id(id).desired_width(6.5 * size).hint_text("a number");
        // On light paper its ground alone does not show it.
        ui.visuals_mut().widgets.inactive.bg_stroke = ui.visuals().widgets.noninteractive.bg_stroke;
        let response = ui.add(field.margin(vec2(8.0, 5.0))).accessible_name("Predicted number");
        if is_newly_shown(ui, id) {
            response.request_focus();
        }
        if !asked.unit.is_empty() {
            ui.label(&asked.unit);
        }
        let answer = number_text::parsed(&text).ok().map(Answer::Number);
        if response.changed() && answer != course.draft {
            draft(commands, answer.clone());
        }
        ui.data_mut(|data| data.insert_temp(id, text));
        let is_entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if is_entered && answer.is_some_and(|answer| answer.is_entered()) {
            commands.push(LessonCommand::Predict.into());
        }
    });
    if let Some(remark) = ui.data(|data| data.get_temp::<String>(id)).and_then(|text| remark(&text)) {
        ui.colored_label(ui.visuals().error_fg_color, remark);
    }
}

/// Whether what has this `id` was not shown in the pass before.
fn is_newly_shown(ui: &Ui, id: Id) -> bool {
    let (id, now) = (id.with("shown in pass"), ui.ctx().cumulative_pass_nr());
    let before: Option<u64> = ui.data(|data| data.get_temp(id));
    ui.data_mut(|data| data.insert_temp(id, now));
    before.is_none_or(|before| before + 1 < now)
}

/// Returns the problem with a number that is typed, and its correction.
fn remark(text: &str) -> Option<String> {
    let is_begun = ["", "-", "−", "+"].contains(&text.trim());
    number_text::parsed(text)
        .err()
        .filter(|_| !is_begun)
        .map(|wrong| format!("{wrong}: type one such as 1.25 or 2e-3."))
}

/// Shows a hint on what to do in a view or in a plot.
pub fn hint(ui: &mut Ui, state: &State, course: &Course) {
    let is_marked = course.draft.is_some();
    match predicted_place::hint(state) {
        Some(_) if is_marked => ui.label("A cross in the views marks it. Click again to move it."),
        Some(hint) => ui.label(hint),
        None if is_marked => ui.label("Your curve is in the plot. Draw over it to change it."),
        None => ui.label("Draw the curve that you expect in the plot: press and drag."),
    };
}

/// Shows the choice of the confidence.
pub fn confidence(ui: &mut Ui, course: &Course, commands: &mut Commands) {
    if course.counts_hands() {
        return;
    }
    ui.add_space(cards::APART);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        ui.label(RichText::new("How sure?").weak());
        ui.add_space(4.0);
        for level in Confidence::ALL {
            let is_chosen = course.confidence == Some(level);
            let name = level.name();
            let button = ui.selectable_label(is_chosen, format!(" {name} "));
            button
                .accessible_name(format!("How sure: {name}"))
                .on_click(commands, LessonCommand::Confidence(Some(level).filter(|_| !is_chosen)));
        }
    });
}
