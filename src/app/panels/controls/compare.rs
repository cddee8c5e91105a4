//! The choice of a second picture of one eye beside the first.

use eframe::egui::{Button, ComboBox, RichText, Ui};

use crate::app::state::State;
use crate::app::widgets::row;
use crate::flags::choices::Compare;
use crate::settings::{ComparisonError, Look};

const TIP: &str = "Shows two pictures of the left eye in place of both eyes': the first as everything else \
    is set, the second as chosen here. A gaze that follows does so in each; both have one field of view.   \
    Key: B";

/// The choices with their names, and tooltips about the picture that each shows second.
const CHOICES: [(Compare, &str, &str); 5] = [
    (Compare::Off, "nothing: two eyes", "The pictures of two eyes."),
    (Compare::Seen, "as seen", "The second picture is as seen."),
    (
        Compare::Contracted,
        "contracted",
        "The second picture is contracted only: where everything is measured to be at T, what Gamow drew.",
    ),
    (Compare::Rest, "at rest", "The second picture is at rest: what a camera that rides along photographs."),
    (
        Compare::Paper,
        "D² paper",
        "The second picture has the intensity D², the paper's; both have the exposure of the first.\nWhite bodies follow \
        Planck's law, and so look alike in both, while the Doppler effect shifts.",
    ),
];

/// Returns the reason why a choice cannot be had, in the words of the controls.
const fn problem_text(problem: &ComparisonError) -> &'static str {
    match problem {
        ComparisonError::Layout(_) => "Needs the layout side by side or over-under.",
        ComparisonError::Headset => "A headset shows two eyes.",
        ComparisonError::Light => "D² needs the light “One λ”: no other has an exponent.",
        ComparisonError::Alike => "The first picture shows this already.",
        ComparisonError::NoDoppler => "D² needs the geometry as seen: else D is 1 everywhere.",
    }
}

/// Shows the row of the choice.
pub fn show(ui: &mut Ui, state: &State, look: &mut Look) {
    let settings = &state.document.settings;
    let refused = settings.check_two_pictures().err();
    let problem = settings.check_comparison().err();
    let name = |of| CHOICES.iter().find(|(choice, ..)| *choice == of).map_or("", |(_, name, _)| name);
    row(ui, "Compare with", TIP, |ui| {
        let reason = refused.as_ref().map_or("", problem_text);
        ui.add_enabled_ui(refused.is_none(), |ui| {
            let list = ComboBox::from_id_salt("compare").selected_text(name(look.compare)).width(150.0);
            let list = list.show_ui(ui, |ui| choices(ui, state, look));
            list.response
                .on_hover_text(TIP)
                .on_disabled_hover_text(reason)
                .accessible_name("Second picture of the eye");
        });
    });
    if let Some(problem) = problem {
        row(ui, "", "", |ui| _ = ui.label(RichText::new(problem_text(&problem)).small()));
    }
}

/// Shows the choices; one that changes nothing cannot be had.
fn choices(ui: &mut Ui, state: &State, look: &mut Look) {
    for (choice, name, tip) in CHOICES {
        let refused = state.document.settings.check_compared_with(choice).err();
        let button = ui.add_enabled(refused.is_none(), Button::selectable(choice == look.compare, name));
        let reason = refused.as_ref().map_or("", problem_text);
        if button.on_hover_text(tip).on_disabled_hover_text(reason).clicked() {
            look.compare = choice;
        }
    }
}
