//! The controls of light: colour, Doppler effect, intensity, shading and background.

use eframe::egui::Ui;
use relativity_core::doppler::{
    BOLOMETRIC_INTENSITY_EXPONENT, PAPER_INTENSITY_EXPONENT, SPECIFIC_INTENSITY_EXPONENT,
};
use relativity_render::{Colour, Shading, StreetColours};

use crate::app::command::Command;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::widgets::{Edit, NumberRow, choice, row};
use crate::flags::{EXPOSURE_EV, Exposure, TEMPERATURE_K};
use crate::number_text;
use crate::settings::Light;

/// Shows the controls of the light.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let before = state.document.settings.light;
    let (mut light, default) = (before, state.defaults().light);
    row(ui, "Light", "Chooses the light that the bodies send, and how it becomes a colour.", |ui| {
        choice(ui, &mut light.colour, &COLOURS[..3]);
    });
    row(ui, "", "", |ui| _ = choice(ui, &mut light.colour, &COLOURS[3..]));
    if light.colour == Colour::Glowing {
        temperature().show(ui, &mut light.temperature, default.temperature);
    }
    row(
        ui,
        "Doppler",
        "Shifts the wavelength by the motion, or leaves it as at rest.\nλ received = λ at \
        rest / D",
        |ui| {
            choice(ui, &mut light.doppler_shift, &SHIFTS);
        },
    );
    intensity_row(ui, &mut light);
    row(
        ui,
        "UV and IR",
        "Chooses how light is drawn that is received as ultraviolet or infrared, which \
        eyes do not see.",
        |ui| {
            choice(ui, &mut light.invisible, &UNSEEN);
        },
    );
    row(ui, "Shading", "Chooses how the form of bodies is shown.", |ui| {
        choice(ui, &mut light.shading, &SHADINGS);
    });
    exposure_rows(
        ui,
        state.document.settings.automatic_ev(&state.document.scene, state.document.time),
        &mut light.exposure,
        default.exposure,
    );
    row(ui, "Background", "Chooses the background, which rests with the eyes.", |ui| {
        ui.checkbox(&mut light.sky, "Sky").on_hover_text("Shows a sky behind the scene.");
        let tip = "Shows a road or a grid on the ground, at rest. Wheels leave a contact shadow on a road: \
            exact where they touch it, only suggested around that.";
        ui.checkbox(&mut light.ground, "Ground").on_hover_text(tip);
        let tip = "Shows what stands around the scene, at rest: houses and lamp posts.";
        ui.checkbox(&mut light.surroundings, "Street").on_hover_text(tip);
    });
    if state.document.settings.ride.is_on() {
        row(
            ui,
            "Street",
            "Chooses the colours of road, ground, house fronts and sky while you ride.",
            |ui| {
                choice(ui, &mut light.street_colours, &STREETS);
            },
        );
    }
    if light != before {
        commands.push(Command::Light(light));
    }
}

fn temperature() -> NumberRow<'static> {
    NumberRow {
        name: "Temperature",
        tip: "Sets the temperature H of glowing bodies, which are seen at D·H.",
        slider: 600.0..=10_000.0,
        typed: TEMPERATURE_K,
        decimals: 2,
        suffix: " K",
    }
}

/// Shows the exponent of the brightness: light of one wavelength follows it, any other follows Planck's law.
fn intensity_row(ui: &mut Ui, light: &mut Light) {
    let tip = "Chooses how much brighter the Doppler factor D makes light.";
    row(ui, "Intensity", tip, |ui| match light.colour {
        Colour::OneWavelength => _ = choice(ui, &mut light.intensity_exponent.0, &EXPONENTS[..2]),
        Colour::Glowing => _ = ui.weak("Planck's law at D·H: no exponent"),
        Colour::White | Colour::StreetDaylight => _ = ui.weak("Planck's law at D·6504 K"),
        Colour::False => _ = ui.weak("not shown: the colour is D"),
    });
    if light.colour == Colour::OneWavelength {
        row(ui, "", "", |ui| _ = choice(ui, &mut light.intensity_exponent.0, &EXPONENTS[2..]));
    }
}

/// Whether the exposure is automatic, and the number.
fn exposure_rows(ui: &mut Ui, automatic_ev: f64, exposure: &mut Exposure, default: Exposure) {
    let tip = "Sets the brightness of the picture: light × 2^EV. The brightest light is compressed, not \
        clipped.";
    row(ui, "Exposure", tip, |ui| {
        let automatic = format!("auto ({} EV)", number_text::fixed(automatic_ev, 1));
        let tip = "Finds the exposure from the speeds and the lights of the scene, so that it is steady \
            while time runs: midway between the light at rest and the brightest that can be seen.";
        ui.selectable_value(&mut exposure.0, None, automatic).on_hover_text(tip);
        if ui.selectable_label(exposure.0.is_some(), "set").on_hover_text(tip).clicked() {
            exposure.0 = exposure.0.or(Some(automatic_ev));
        }
    });
    if let Some(ev) = &mut exposure.0 {
        let row =
            NumberRow { name: "EV", tip, slider: -8.0..=8.0, typed: EXPOSURE_EV, decimals: 2, suffix: " EV" };
        if row.edit(ui, ev) == Edit::Restored {
            *exposure = default;
        }
    }
}

const COLOURS: [(Colour, &str, &str); 5] = [
    (
        Colour::OneWavelength,
        "Single line",
        "Each body sends light of one wavelength (a spectral line), as in the paper.",
    ),
    (Colour::Glowing, "Glow", "Each body is a black body of one temperature H, seen at D·H (Planck's law)."),
    (
        Colour::White,
        "White",
        "Each body reflects the daylight (6504 K) of a lamp that rides along: a quarter of it at every \
            wavelength, the rest around the body's own.",
    ),
    (
        Colour::StreetDaylight,
        "Daylight",
        "Each body reflects the street's daylight, which comes from all sides there: what moves is lit \
            bluer and brighter from ahead, redder and dimmer from behind. Its light is shifted again on \
            its way to the eye. Needs the Doppler shift.",
    ),
    (Colour::False, "False", "The colour tells the Doppler factor: grey at D = 1, blue above, red below."),
];

const UNSEEN: [(bool, &str, &str); 2] = [
    (
        true,
        "Hatched",
        "Drawn in grey with a hatch: rising lines for infrared (/), falling ones for ultraviolet (\\).",
    ),
    (false, "Black", "Drawn black, as eyes see it."),
];

const SHIFTS: [(bool, &str, &str); 2] = [
    (true, "Shifted", "λ received = λ at rest / D"),
    (false, "As at rest", "Colours stay as they are at rest."),
];

const EXPONENTS: [(Option<f64>, &str, &str); 4] = [
    (None, "Off", "Intensity stays as it is at rest."),
    (
        Some(PAPER_INTENSITY_EXPONENT),
        "D² paper",
        "The paper's exponent: the flux of a point source, relative to what a camera riding along receives.",
    ),
    (
        Some(SPECIFIC_INTENSITY_EXPONENT),
        "D³ photons",
        "Number of photons from a surface, or its power per unit of frequency: I(ν)/ν³ is invariant.",
    ),
    (Some(BOLOMETRIC_INTENSITY_EXPONENT), "D⁴ surface", "The radiance of a surface of one wavelength."),
];

const STREETS: [(StreetColours, &str, &str); 3] = [
    (
        StreetColours::Shifted,
        "Shifted",
        "Doppler shifted: bluer ahead, redder behind. Paints count as grey, and contrasts stay as painted.",
    ),
    (
        StreetColours::Received,
        "As received",
        "Shifted, and as bright as received: dazzling ahead, dark behind.",
    ),
    (StreetColours::Painted, "As painted", "The colours of the street at rest, at any speed."),
];

const SHADINGS: [(Shading, &str, &str); 2] = [
    (Shading::Form, "Form", "A gentle shading, fixed to the scene."),
    (Shading::Emission, "Plain", "Plain emission, as in the paper."),
];
