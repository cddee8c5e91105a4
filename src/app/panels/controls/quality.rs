//! The controls of quality: what draws the views, what that keeps, and whether they get smoother.

use eframe::egui::{Checkbox, RichText, Ui};
use gamow_platform::threads;

use crate::app::commands::SettingsCommand;
use crate::app::panels::{Commands, on_change};
use crate::app::state::State;
use crate::app::widgets::{Edit, NumberRow, choice, named_text, row};
use crate::flags::choices::RendererChoice;
use crate::flags::{BUDGET_MS, ERROR_PX, Goal};
use crate::settings::{QualitySettings, about};

/// Shows the controls of the quality.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let (before, default) = (state.document.settings.quality, state.defaults().quality);
    let mut quality = before;
    let tip = format!("{} The Accuracy tab shows the cost and the error of each.", about("renderer"));
    row(ui, "Quality", &tip, |ui| _ = choice(ui, &mut quality.renderer, &RENDERERS[..2]));
    row(ui, "", "", |ui| _ = choice(ui, &mut quality.renderer, &RENDERERS[2..]));
    if quality.renderer == RendererChoice::Auto {
        goal_rows(ui, state, &mut quality, default);
    }
    row(ui, "", "", |ui| {
        let checkbox = Checkbox::new(&mut quality.refine, "smoother when still");
        ui.add_enabled(threads::ARE_SEVERAL, checkbox).on_hover_text(about("refine")).on_disabled_hover_text(
            "Only in the desktop program: it would stop the page for parts of a second.",
        );
    });
    on_change(commands, &before, quality, SettingsCommand::Quality);
}

/// Shows the goal of automatic quality, and its choice.
fn goal_rows(ui: &mut Ui, state: &State, quality: &mut QualitySettings, default: QualitySettings) {
    let is_budget = matches!(quality.goal, Goal::Budget(_));
    row(ui, "Limit", "Chooses the bound that the automatic choice keeps.", |ui| {
        let is_error = !is_budget;
        ui.spacing_mut().item_spacing.x = 3.0;
        if ui.selectable_label(is_error, "Max error").on_hover_text(about("error")).clicked() && is_budget {
            quality.goal = Goal::default();
        }
        if ui.selectable_label(is_budget, "Max time").on_hover_text(about("budget")).clicked() && is_error {
            quality.goal = Goal::Budget(Goal::USUAL_BUDGET_MS);
        }
    });
    let edit = match &mut quality.goal {
        Goal::Error(px) => {
            NumberRow::new("Error bound", about("error"), 0.001..=4.0, ERROR_PX).suffix(" px").edit(ui, px)
        }
        Goal::Budget(ms) => NumberRow::new("Frame budget", about("budget"), 1.0..=200.0, BUDGET_MS)
            .decimals(2)
            .suffix(" ms")
            .edit(ui, ms),
    };
    if edit == Edit::Restored {
        quality.goal = default.goal;
    }
    if let Some((_, choice)) = state.frame.choices.first() {
        row(ui, "", "", |ui| {
            _ = named_text(ui, RichText::new(choice.to_string()).small(), format!("Chosen: {choice}"));
        });
    }
}

const RENDERERS: [(RendererChoice, &str); 5] = [
    (RendererChoice::Auto, "Automatic"),
    (RendererChoice::Rays, "Rays"),
    (RendererChoice::Packets, "Packets"),
    (RendererChoice::Mesh, "Mesh"),
    (RendererChoice::Reference, "Reference"),
];
