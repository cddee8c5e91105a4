//! The controls of quality: what draws the views, what that keeps, and whether they get smoother.

use eframe::egui::{Checkbox, RichText, Ui};

use crate::app::command::Command;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::widgets::{Edit, NumberRow, choice, named_text, row};
use crate::flags::choices::RendererChoice;
use crate::flags::{BUDGET_MS, ERROR_PX, Goal};
use crate::platform::threads;
use crate::settings::{BOUND_PX, Quality};

/// Shows the controls of the quality.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let (before, default) = (state.document.settings.quality, state.defaults().quality);
    let mut quality = before;
    let tip = "Chooses what draws the views.   The Accuracy tab shows the cost and the error of each.";
    row(ui, "Quality", tip, |ui| _ = choice(ui, &mut quality.renderer, &RENDERERS[..2]));
    row(ui, "", "", |ui| _ = choice(ui, &mut quality.renderer, &RENDERERS[2..]));
    match quality.renderer {
        RendererChoice::Auto => goal_rows(ui, state, &mut quality, default),
        RendererChoice::Mesh => _ = bound().show(ui, &mut quality.bound_px, default.bound_px),
        RendererChoice::Rays | RendererChoice::Packets | RendererChoice::Reference => {}
    }
    row(ui, "", "", |ui| {
        let tip = "Has the reference draw the views again while nothing changes, with more and more rays per \
                pixel.";
        let checkbox = Checkbox::new(&mut quality.refine, "smoother when still");
        ui.add_enabled(threads::ARE_SEVERAL, checkbox).on_hover_text(tip).on_disabled_hover_text(
            "Only in the desktop program: it would stop the page for parts of a second.",
        );
    });
    if quality != before {
        commands.push(Command::Quality(quality));
    }
}

/// Shows the goal of automatic quality, and its choice.
fn goal_rows(ui: &mut Ui, state: &State, quality: &mut Quality, default: Quality) {
    let mut is_budget = matches!(quality.goal, Goal::Budget(_));
    row(ui, "Limit", "Chooses the bound that the automatic choice keeps.", |ui| {
        if choice(ui, &mut is_budget, &GOALS) {
            quality.goal = if is_budget { Goal::Budget(Goal::USUAL_BUDGET_MS) } else { Goal::default() };
        }
    });
    let edit = match &mut quality.goal {
        Goal::Error(px) => error().edit(ui, px),
        Goal::Budget(ms) => budget().edit(ui, ms),
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

const RENDERERS: [(RendererChoice, &str, &str); 5] = [
    (
        RendererChoice::Auto,
        "Automatic",
        "The cheapest that keeps an error bound, or the most accurate that keeps a frame's budget of time.",
    ),
    (RendererChoice::Rays, "Rays", "A ray test per pixel on the GPU, in 32-bit floats."),
    (
        RendererChoice::Packets,
        "Packets",
        "A ray test per pixel on the CPU, in 32-bit floats, eight pixels at a time.",
    ),
    (RendererChoice::Mesh, "Mesh", "Triangles on the GPU, as many as keep the bound."),
    (
        RendererChoice::Reference,
        "Reference",
        "A ray test per pixel on the CPU, in 64-bit floats: the truth that the others are compared \
            with.\nIt draws in the background when nothing moves; until it is done, the rays do.",
    ),
];

const GOALS: [(bool, &str, &str); 2] = [
    (false, "Max error", "No point is drawn further than this from where it is seen."),
    (true, "Max time", "The pictures of a frame take no longer than this."),
];

fn bound() -> NumberRow<'static> {
    NumberRow {
        name: "Bound",
        tip: "Sets how far the mesh may draw a point from where it is seen. Coarser is faster.",
        slider: 0.05..=4.0,
        typed: BOUND_PX,
        decimals: 3,
        suffix: " px",
    }
}

fn error() -> NumberRow<'static> {
    NumberRow {
        name: "Error bound",
        tip: "Sets how far a point may be drawn from where it is seen. The cheapest method within this \
            bound draws.",
        slider: 0.001..=4.0,
        typed: ERROR_PX,
        decimals: 6,
        suffix: " px",
    }
}

fn budget() -> NumberRow<'static> {
    NumberRow {
        name: "Frame budget",
        tip: "Sets how long the pictures of a frame may take. The most accurate method within this budget \
            draws; if there is none, the cheapest.",
        slider: 1.0..=200.0,
        typed: BUDGET_MS,
        decimals: 2,
        suffix: " ms",
    }
}
