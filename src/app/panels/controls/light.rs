//! The controls of light: colour, Doppler effect, intensity, shading and background.

use eframe::egui::Ui;
use relativity_core::doppler::{
    BOLOMETRIC_INTENSITY_EXPONENT, PAPER_INTENSITY_EXPONENT, SPECIFIC_INTENSITY_EXPONENT,
};
use relativity_render::{Colour, Shading, StreetColours};

use crate::app::commands::SettingsCommand;
use crate::app::panels::{Commands, on_change};
use crate::app::state::State;
use crate::app::widgets::{Edit, NumberRow, choice, choice_of, row};
use crate::flags::{EXPOSURE_EV, Exposure, TEMPERATURE_K};
use crate::number_text;
use crate::settings::{LightSettings, about};

/// Shows the controls of the light.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let before = state.document.settings.light;
    let (mut light, default) = (before, state.defaults().light);
    row(ui, "Light", about("colour"), |ui| _ = choice(ui, &mut light.colour, &COLOURS[..3]));
    row(ui, "", "", |ui| _ = choice(ui, &mut light.colour, &COLOURS[3..]));
    if light.colour == Colour::Glowing {
        NumberRow::new("Temperature", about("temperature"), 600.0..=10_000.0, TEMPERATURE_K)
            .decimals(2)
            .suffix(" K")
            .show(ui, &mut light.temperature, default.temperature);
    }
    let tip = about("doppler-shift");
    row(ui, "Doppler", tip, |ui| _ = choice_of(ui, &mut light.doppler_shift, &SHIFTS, tip));
    intensity_row(ui, &mut light);
    let tip = about("invisible");
    row(ui, "UV and IR", tip, |ui| _ = choice_of(ui, &mut light.invisible, &UNSEEN, tip));
    row(ui, "Shading", about("shading"), |ui| _ = choice(ui, &mut light.shading, &SHADINGS));
    exposure_rows(
        ui,
        state.document.settings.automatic_ev(&state.document.scene, state.document.time),
        &mut light.exposure,
        default.exposure,
    );
    row(ui, "Background", "Chooses the background, which rests with the eyes.", |ui| {
        ui.checkbox(&mut light.sky, "Sky").on_hover_text(about("sky"));
        ui.checkbox(&mut light.ground, "Ground").on_hover_text(about("ground"));
        ui.checkbox(&mut light.surroundings, "Street").on_hover_text(about("surroundings"));
    });
    if state.document.settings.ride.is_on() {
        row(ui, "Street", about("street-colours"), |ui| {
            choice(ui, &mut light.street_colours, &STREETS);
        });
    }
    on_change(commands, &before, light, SettingsCommand::Light);
}

/// Shows the exponent of the brightness: light of one wavelength follows it, any other follows Planck's law.
fn intensity_row(ui: &mut Ui, light: &mut LightSettings) {
    let tip = about("intensity-exponent");
    row(ui, "Intensity", tip, |ui| match light.colour {
        Colour::OneWavelength => {
            _ = choice_of(ui, &mut light.intensity_exponent.0, &EXPONENTS[..2], tip);
        }
        Colour::Glowing => _ = ui.weak("Planck's law at D·H: no exponent"),
        Colour::White | Colour::StreetDaylight => _ = ui.weak("sunlight, shifted by D"),
        Colour::False => _ = ui.weak("not shown: the colour is D"),
    });
    if light.colour == Colour::OneWavelength {
        row(ui, "", "", |ui| _ = choice_of(ui, &mut light.intensity_exponent.0, &EXPONENTS[2..], tip));
    }
}

/// Whether the exposure is automatic, and the number.
fn exposure_rows(ui: &mut Ui, automatic_ev: f64, exposure: &mut Exposure, default: Exposure) {
    let tip = about("exposure");
    row(ui, "Exposure", tip, |ui| {
        let automatic = format!("auto ({} EV)", number_text::fixed(automatic_ev, 1));
        ui.selectable_value(&mut exposure.0, None, automatic).on_hover_text(tip);
        if ui.selectable_label(exposure.0.is_some(), "set").on_hover_text(tip).clicked() {
            exposure.0 = exposure.0.or(Some(automatic_ev));
        }
    });
    if let Some(ev) = &mut exposure.0 {
        let row = NumberRow::new("EV", tip, -8.0..=8.0, EXPOSURE_EV).decimals(2).suffix(" EV");
        if row.edit(ui, ev) == Edit::Restored {
            *exposure = default;
        }
    }
}

const COLOURS: [(Colour, &str); 5] = [
    (Colour::OneWavelength, "Single line"),
    (Colour::Glowing, "Glow"),
    (Colour::White, "White"),
    (Colour::StreetDaylight, "Daylight"),
    (Colour::False, "False"),
];

const UNSEEN: [(bool, &str); 2] = [(true, "Hatched"), (false, "Black")];

const SHIFTS: [(bool, &str); 2] = [(true, "Shifted"), (false, "As at rest")];

const EXPONENTS: [(Option<f64>, &str); 4] = [
    (None, "Off"),
    (Some(PAPER_INTENSITY_EXPONENT), "D² paper"),
    (Some(SPECIFIC_INTENSITY_EXPONENT), "D³ photons"),
    (Some(BOLOMETRIC_INTENSITY_EXPONENT), "D⁴ surface"),
];

const STREETS: [(StreetColours, &str); 3] = [
    (StreetColours::Shifted, "Shifted"),
    (StreetColours::Received, "As received"),
    (StreetColours::Painted, "As painted"),
];

const SHADINGS: [(Shading, &str); 2] = [(Shading::Form, "Form"), (Shading::Emission, "Plain")];
