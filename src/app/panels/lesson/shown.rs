//! The prediction beside the truth.

use eframe::egui::{Align, Layout, Rect, RichText, Sense, TextStyle, Ui, vec2};

use super::cards::{self, Room, Sign};
use crate::app::state::State;
use crate::app::widgets::theme;
use crate::app::widgets::{markdown, named_text};
use crate::formula::markdown::Markdown;
use crate::lesson::{Answer, AnswerKind, Course, Options, Step, verdict};

/// Shows the prediction, before it is compared.
pub fn said(ui: &mut Ui, state: &State, step: &Step, course: &Course) {
    let told = course.record().and_then(|record| verdict(step, record, &state.sight()));
    match (kind(step), answer(course)) {
        (_, None) => cards::quiet(ui, "Skipped."),
        (Some(AnswerKind::Choice(options)), Some(Answer::Votes(votes))) => bars(ui, options, votes, None),
        (Some(AnswerKind::Choice(options)), Some(Answer::Choice(choice))) => {
            cards::quiet(ui, "You said");
            options.texts.get(*choice).into_iter().for_each(|text| cards::show(ui, text, false));
        }
        (Some(AnswerKind::Number(_)), _) => {
            if let Some(told) = told {
                value(ui, "You said", &told.said);
            }
        }
        (Some(AnswerKind::Point(_)), _) => {
            if let Some(told) = told {
                sentence(ui, format!("You clicked {}.", told.said));
            }
        }
        _ => told.into_iter().for_each(|told| sentence(ui, format!("You drew {}.", told.said))),
    }
}

/// Shows the prediction and the truth.
pub fn compared(ui: &mut Ui, state: &State, room: Room, step: &Step, course: &Course) {
    match (kind(step), answer(course)) {
        (Some(AnswerKind::Choice(options)), Some(Answer::Votes(votes))) => {
            bars(ui, options, votes, Some(options.right));
        }
        (Some(AnswerKind::Choice(options)), Some(Answer::Choice(choice))) if *choice != options.right => {
            let said = options.texts.get(*choice).unwrap_or(&options.texts[options.right]).clone();
            cards::each(ui, room, &[said, options.texts[options.right].clone()], |ui, number, text| {
                cards::quiet(ui, ["You said", "It is"][number]);
                cards::show(ui, text, number == 1);
            });
        }
        (Some(AnswerKind::Choice(options)), answer) => {
            cards::quiet(ui, if answer.is_some() { "You said, rightly," } else { "It is" });
            cards::show(ui, &options.texts[options.right], true);
        }
        (Some(kind), answer) => {
            let told = course.record().and_then(|record| verdict(step, record, &state.sight()));
            let Some(told) = told else { return };
            match (kind, answer) {
                (AnswerKind::Number(asked), Some(Answer::Number(said))) => {
                    value(ui, "You said", &told.said);
                    value(ui, "It is", &told.is);
                    let off = asked.truth.map(|truth| asked.text((said - truth).abs()));
                    near(ui, told.right, off);
                }
                (AnswerKind::Number(_), _) => value(ui, "It is", &told.is),
                (AnswerKind::Curve(_), Some(_)) => {
                    sentence(ui, format!("You drew {}. It is {}.", told.said, told.is));
                }
                (AnswerKind::Point(_), Some(_)) => {
                    sentence(ui, format!("You clicked {}; it is seen {}.", told.said, told.is));
                    near(ui, told.right, None);
                }
                (AnswerKind::Point(_), None) => sentence(ui, format!("It is seen {}.", told.is)),
                _ => sentence(ui, format!("It is {}.", told.is)),
            }
        }
        (None, _) => {}
    }
}

/// Shows a sentence in Markdown.
fn sentence(ui: &mut Ui, text: String) {
    markdown::show(ui, &Markdown::new(text));
}

/// Whether that is right, and by how much it is `off`.
fn near(ui: &mut Ui, is_right: Option<bool>, off: Option<String>) {
    let off = off.map(|off| format!("{off} off"));
    match (is_right, off) {
        (Some(true), off) => {
            let off = off.map(|off| format!(": {off}")).unwrap_or_default();
            let text = RichText::new(format!("Near enough{off}.")).color(cards::right_colour(ui));
            ui.label(text);
        }
        (Some(false), Some(off)) => {
            ui.label(format!("That is {off}."));
        }
        _ => {}
    }
}

fn kind(step: &Step) -> Option<&AnswerKind> {
    step.prediction.as_ref().map(|prediction| &prediction.kind)
}

fn answer(course: &Course) -> Option<&Answer> {
    course.record()?.answer()
}

/// A large `value` behind its `name`.
fn value(ui: &mut Ui, name: &str, value: &str) {
    let size = TextStyle::Body.resolve(ui.style()).size;
    ui.horizontal(|ui| {
        let room = vec2(5.0 * size, 1.8 * size);
        ui.allocate_ui_with_layout(room, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(room.x);
            cards::quiet(ui, name);
        });
        let text = RichText::new(value).size(1.3 * size).color(ui.visuals().strong_text_color());
        ui.label(text);
    });
}

/// Shows the hands raised for each of the options, as bars; the `right` one has a tick.
fn bars(ui: &mut Ui, options: &Options, votes: &[u32], right: Option<usize>) {
    let all: u32 = votes.iter().sum();
    for (number, (text, &count)) in options.texts.iter().zip(votes).enumerate() {
        let is_right = right == Some(number);
        cards::text_behind(ui, text, if is_right { Sign::Right } else { Sign::Nothing });
        let size = TextStyle::Body.resolve(ui.style()).size;
        ui.horizontal(|ui| {
            let (rect, _) =
                ui.allocate_exact_size(vec2(ui.available_width() - 2.5 * size, 0.6 * size), Sense::hover());
            let part = if all == 0 { 0.0 } else { count as f32 / all as f32 };
            let visuals = ui.visuals();
            let fill = if is_right { cards::right_colour(ui) } else { theme::focus_stroke(visuals).color };
            ui.painter().rect_filled(rect, 3.0, visuals.widgets.inactive.weak_bg_fill);
            let filled = Rect::from_min_size(rect.min, vec2(part * rect.width(), rect.height()));
            ui.painter().rect_filled(filled, 3.0, fill);
            let name = markdown::said(ui, &text.markdown);
            named_text(ui, count.to_string(), format!("Hands for {name}: {count}"));
        });
    }
}
