//! The controls of light: colour, Doppler effect, intensity, shading and background.

use eframe::egui::Ui;
use relativity_core::doppler::{
    BOLOMETRIC_INTENSITY_EXPONENT, PAPER_INTENSITY_EXPONENT, SPECIFIC_INTENSITY_EXPONENT,
};
use relativity_render::{Colour, Shading};

use crate::app::command::Command;
use crate::app::panels::Asks;
use crate::app::widgets::{NumberRow, choice, row};
use crate::settings::{EXPOSURE_EV, Light};

/// Shows them.
pub fn show(ui: &mut Ui, before: Light, asks: &mut Asks) {
    let mut light = before;
    row(ui, "Colour", "How a received wavelength becomes a colour.", |ui| {
        choice(ui, &mut light.colour, &COLOURS);
    });
    row(ui, "Doppler", "Whether motion shifts the wavelength.\nλ received = λ at rest / D", |ui| {
        choice(ui, &mut light.doppler_shift, &SHIFTS);
    });
    row(ui, "Intensity", "How much brighter the Doppler factor D makes light.", |ui| {
        choice(ui, &mut light.intensity_exponent.0, &EXPONENTS);
    });
    row(ui, "Shading", "How form is shown.", |ui| {
        choice(ui, &mut light.shading, &SHADINGS);
    });
    let exposure = NumberRow {
        name: "Exposure",
        tip: "Brightness of the picture: light × 2^EV.",
        slider: -8.0..=8.0,
        typed: EXPOSURE_EV,
        decimals: 2,
        suffix: " EV",
    };
    exposure.show(ui, &mut light.exposure);
    row(ui, "Background", "What rests with the eyes.", |ui| {
        ui.checkbox(&mut light.sky, "Sky").on_hover_text("A sky behind the scene.");
        ui.checkbox(&mut light.ground, "Ground").on_hover_text("A road or a grid on the ground, at rest.");
        let tip = "What stands around the scene, at rest: houses and lamp posts.";
        ui.checkbox(&mut light.surroundings, "Street").on_hover_text(tip);
    });
    if light != before {
        asks.push(Command::Light(light));
    }
}

const COLOURS: [(Colour, &str, &str); 2] = [
    (Colour::Visible, "Natural", "As a human eye sees it (CIE 1931). Ultraviolet and infrared are black."),
    (Colour::False, "False", "A false colour that keeps ultraviolet and infrared visible."),
];

const SHIFTS: [(bool, &str, &str); 2] = [
    (true, "Shifted", "λ received = λ at rest / D"),
    (false, "As at rest", "Colours stay as they are at rest."),
];

const EXPONENTS: [(Option<f64>, &str, &str); 4] = [
    (None, "Off", "Intensity stays as it is at rest."),
    (Some(PAPER_INTENSITY_EXPONENT), "D²", "As in the paper."),
    (Some(SPECIFIC_INTENSITY_EXPONENT), "D³", "Specific intensity of a surface: I(ν)/ν³ is invariant."),
    (Some(BOLOMETRIC_INTENSITY_EXPONENT), "D⁴", "Radiance of a surface over all frequencies."),
];

const SHADINGS: [(Shading, &str, &str); 2] = [
    (Shading::Form, "Form", "A gentle shading, fixed to the scene."),
    (Shading::Emission, "Plain", "Plain emission, as in the paper."),
];
