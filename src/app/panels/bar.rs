//! The bar at the top: the scene, and which parts of the window are shown.

use eframe::egui::{Align, ComboBox, Layout, RichText, Ui, vec2};

use super::Asks;
use crate::app::command::Command;
use crate::app::state::State;
use crate::app::widgets::icons::{self, Icon};
use crate::scene::{PRESETS, Scene};
use crate::settings::Theme;

/// Shows the bar.
pub fn show(ui: &mut Ui, state: &State, asks: &mut Asks) {
    ui.horizontal_centered(|ui| {
        ui.label(RichText::new("Gamow").heading().strong());
        scene(ui, state, asks);
        if let Some(notice) = &state.session.notice {
            ui.colored_label(ui.visuals().error_fg_color, notice);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button("Help").on_hover_text("Keys and mouse.   Keys: ? or F1").clicked() {
                asks.push(Command::ToggleHelp);
            }
            parts(ui, state, asks);
        });
    });
}

fn scene(ui: &mut Ui, state: &State, asks: &mut Asks) {
    ComboBox::from_id_salt("scene")
        .selected_text(&state.session.scene.name)
        .width(170.0)
        .show_ui(ui, |ui| {
            for (preset, scene) in PRESETS.into_iter().filter_map(|name| Some((name, Scene::preset(name)?))) {
                let shown = scene.name == state.session.scene.name;
                if ui.selectable_label(shown, scene.name).clicked() {
                    asks.push(Command::Preset(preset));
                }
            }
        })
        .response
        .on_hover_text("What rides past. A scene file dropped onto the window opens too.")
        .accessible_name("Scene");
}

fn parts(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let mut window = state.settings.window;
    let dark = ui.visuals().dark_mode;
    let (icon, other) = if dark { (Icon::Light, Theme::Light) } else { (Icon::Dark, Theme::Dark) };
    if icons::button(ui, icon, "Theme", vec2(30.0, 22.0), false).on_hover_text("Light or dark").clicked() {
        window.theme = other;
    }
    ui.separator();
    ui.toggle_value(&mut window.controls, "Controls").on_hover_text("Show the controls and the readout");
    ui.toggle_value(&mut window.plots, "Plots").on_hover_text("Show the plots");
    ui.toggle_value(&mut window.views, "Views").on_hover_text("Show what the eyes see");
    if window != state.settings.window {
        asks.push(Command::Window(window));
    }
}
