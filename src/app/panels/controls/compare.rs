//! The choice of a second picture of one eye beside the first.

use eframe::egui::{Button, ComboBox, RichText, Ui};

use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, SettingsCommand, Switch};
use crate::app::state::State;
use crate::app::widgets::{explained_lazily, row};
use crate::flags::choices::Compare;
use crate::settings::{ComparisonError, LookSettings, about, meaning};

/// The choices with their names.
const CHOICES: [(Compare, &str); 6] = [
    (Compare::Off, "nothing: two eyes"),
    (Compare::Standing, "standing here"),
    (Compare::Seen, "as seen"),
    (Compare::Contracted, "contracted"),
    (Compare::Rest, "at rest"),
    (Compare::Paper, "D² paper"),
];

/// Returns the reason why a choice cannot be had, in the words of the controls.
const fn problem_text(problem: &ComparisonError) -> &'static str {
    match problem {
        ComparisonError::Layout(_) => "Needs the layout side by side or over-under.",
        ComparisonError::Headset => "A headset shows two eyes.",
        ComparisonError::Light => "D² needs the light “One λ”: no other has an exponent.",
        ComparisonError::NoRide => "Needs a ride: you stand already.",
        ComparisonError::Alike => "The first picture shows this already.",
        ComparisonError::NoDoppler => "D² needs the geometry as seen: else D is 1 everywhere.",
    }
}

/// Shows the row of the choice.
pub fn show(ui: &mut Ui, state: &State, look: &mut LookSettings) {
    let settings = &state.document.settings;
    let refused = settings.check_two_pictures().err();
    let problem = settings.check_comparison().err();
    let name = |of| CHOICES.iter().find(|(choice, _)| *choice == of).map_or("", |(_, name)| name);
    let tip = with_keys(about("compare"), &[Command::Settings(SettingsCommand::Switch(Switch::Comparison))]);
    row(ui, "Compare with", &tip, |ui| {
        let reason = refused.as_ref().map_or("", problem_text);
        ui.add_enabled_ui(refused.is_none(), |ui| {
            let list = ComboBox::from_id_salt("compare").selected_text(name(look.compare)).width(150.0);
            let list = list.show_ui(ui, |ui| choices(ui, state, look));
            list.response
                .on_hover_text(&tip)
                .on_disabled_hover_text(reason)
                .accessible_name("Second picture of the eye");
        });
    });
    if let Some(problem) = problem {
        row(ui, "", "", |ui| _ = ui.label(RichText::new(problem_text(&problem)).small()));
    }
}

/// Shows the choices; one that changes nothing cannot be had.
fn choices(ui: &mut Ui, state: &State, look: &mut LookSettings) {
    for (choice, name) in CHOICES {
        let refused = state.document.settings.check_compared_with(choice).err();
        let button = ui.add_enabled(refused.is_none(), Button::selectable(choice == look.compare, name));
        let reason = refused.as_ref().map_or("", problem_text);
        if explained_lazily(button, || meaning(&choice)).on_disabled_hover_text(reason).clicked() {
            look.compare = choice;
        }
    }
}
