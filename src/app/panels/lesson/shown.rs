//! What was predicted beside what is so.

use eframe::egui::{Align, Layout, Rect, RichText, Sense, TextStyle, Ui, vec2};

use super::cards::{self, Sign};
use crate::app::theme;
use crate::app::widgets::markdown;
use crate::figures;
use crate::lesson::{Answer, Course, Kind, Number, Options, Outcome, Prediction};

/// Shows what was said, before it is compared.
pub fn said(ui: &mut Ui, course: &Course, prediction: &Prediction) {
    let Some(answer) = answer(course) else { return cards::quiet(ui, "You left this out.") };
    match (answer, &prediction.kind) {
        (Answer::Choice(choice), Kind::Choice(options)) => {
            cards::quiet(ui, "You said");
            options.texts.get(*choice).into_iter().for_each(|text| cards::told(ui, text, false));
        }
        (Answer::Votes(votes), Kind::Choice(options)) => bars(ui, options, votes, None),
        (Answer::Number(number), Kind::Number(asked)) => {
            value(ui, "You said", &with_unit(&figures::shortest(*number), asked));
        }
        _ => cards::quiet(ui, "You marked it."),
    }
}

/// Shows what was said and what is so.
pub fn compared(ui: &mut Ui, course: &Course, prediction: &Prediction) {
    match (&prediction.kind, answer(course)) {
        (Kind::Choice(options), Some(Answer::Votes(votes))) => bars(ui, options, votes, Some(options.right)),
        (Kind::Choice(options), Some(Answer::Choice(choice))) if *choice != options.right => {
            cards::quiet(ui, "You said");
            options.texts.get(*choice).into_iter().for_each(|text| cards::told(ui, text, false));
            cards::quiet(ui, "It is");
            cards::told(ui, &options.texts[options.right], true);
        }
        (Kind::Choice(options), answer) => {
            cards::quiet(ui, if answer.is_some() { "You said, and it is" } else { "It is" });
            cards::told(ui, &options.texts[options.right], true);
        }
        (Kind::Number(asked), answer) => {
            let said = match answer {
                Some(Answer::Number(number)) => Some(*number),
                _ => None,
            };
            number(ui, asked, said);
        }
        // Places and curves are compared where they were drawn.
        (Kind::Point(_) | Kind::Curve(_), _) => {}
    }
}

fn answer(course: &Course) -> Option<&Answer> {
    match course.record()?.outcome.as_ref()? {
        Outcome::Made { answer, .. } => Some(answer),
        Outcome::Skipped => None,
    }
}

fn with_unit(number: &str, asked: &Number) -> String {
    format!("{number} {}", asked.unit).trim_end().to_owned()
}

fn number(ui: &mut Ui, asked: &Number, said: Option<f64>) {
    let Some(truth) = asked.truth else { return };
    if let Some(said) = said {
        value(ui, "You said", &with_unit(&figures::shortest(said), asked));
    }
    value(ui, "It is", &with_unit(&figures::fixed(truth, asked.decimals), asked));
    let Some(said) = said else { return };
    let off = with_unit(&figures::fixed((said - truth).abs(), asked.decimals), asked);
    ui.horizontal_wrapped(|ui| {
        if asked.is_met_by(said) == Some(true) {
            ui.label(RichText::new(format!("Near enough: {off} off.")).color(cards::right_colour(ui)));
        } else {
            ui.label(format!("That is {off} off."));
        }
    });
}

/// A large `value` behind its `name`.
fn value(ui: &mut Ui, name: &str, value: &str) {
    ui.horizontal(|ui| {
        let size = TextStyle::Body.resolve(ui.style()).size;
        let room = vec2(5.0 * size, 1.8 * size);
        ui.allocate_ui_with_layout(room, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(room.x);
            cards::quiet(ui, name);
        });
        let text = RichText::new(value).size(1.3 * size).color(ui.visuals().strong_text_color());
        ui.label(text);
    });
}

/// The hands that were raised for each of the options, as bars; the `right` one has a tick.
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
            ui.label(count.to_string()).accessible_name(format!("Hands for {name}: {count}"));
        });
    }
}
