//! The numbers: what each eye receives of the selected point now, and how the two differ.

use eframe::egui::{self, Align, Color32, Grid, Layout, RichText, Sense, Ui, vec2};
use relativity_core::{Sighting, doppler::received_wavelength};
use relativity_render::{Velocity, colour};

use super::Asks;
use crate::app::command::Command;
use crate::app::observer::Eye;
use crate::app::state::State;
use crate::app::theme;
use crate::app::widgets::{dot, named_text};
use crate::figures;

/// Shows the readout.
pub fn show(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let point = state.session.points.selected();
    ui.spacing_mut().item_spacing.y = 3.0;
    ui.horizontal(|ui| {
        fold(ui, state, asks);
        let colour = theme::point_colour(point.number, ui.visuals());
        dot(ui, colour);
        ui.label(point.name(&state.session.scene));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let Velocity { speed, is_backward } = state.velocity(point);
            let sign = if is_backward { "−" } else { "" };
            ui.label(RichText::new(format!("β {sign}{}", figures::beta(&speed))).weak());
        });
    });
    let sightings = Eye::BOTH.map(|eye| state.sighting(point, eye));
    differences(ui, state);
    if !state.settings.window.readout {
        return;
    }
    ui.separator();
    let rest_wavelength = state.rest_wavelength_nm(point);
    Grid::new("readout").num_columns(3).spacing([10.0, 3.0]).min_col_width(70.0).min_row_height(18.0).show(
        ui,
        |ui| {
            ui.label("");
            for eye in Eye::BOTH {
                ui.label(RichText::new(eye.name()).color(theme::eye_colour(eye, ui.visuals())));
            }
            ui.end_row();
            wavelengths(ui, sightings, rest_wavelength);
            for quantity in &QUANTITIES {
                quantity.row(ui, sightings);
            }
        },
    );
}

/// The title, which folds the table away.
fn fold(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let mut window = state.settings.window;
    let sign = if window.readout { "▾" } else { "▸" };
    let title = egui::Button::new(RichText::new(format!("{sign} Seen")).strong()).frame(false);
    let tip = "What each eye receives of the selected point now. Click to fold the table away.";
    if ui.add(title).on_hover_text(tip).accessible_name("Readout").clicked() {
        window.readout = !window.readout;
        asks.push(Command::Window(window));
    }
}

struct Quantity {
    symbol: &'static str,
    name: &'static str,
    tip: &'static str,
    decimals: u8,
    value: fn(&Sighting) -> f64,
}

const QUANTITIES: [Quantity; 7] = [
    Quantity {
        symbol: "Doppler D",
        name: "Doppler factor D",
        tip: "Received over rest frequency; above 1 is bluer.\nD = 1/(γ(1 + β X/R))",
        decimals: 4,
        value: |seen| seen.doppler_factor,
    },
    Quantity {
        symbol: "emitted t",
        name: "Retarded time t",
        tip: "When the light that arrives at T was emitted.\nt = T − R",
        decimals: 4,
        value: |seen| seen.retarded_time,
    },
    Quantity {
        symbol: "seen at X",
        name: "Apparent X",
        tip: "Apparent position along the motion, from this eye.",
        decimals: 4,
        value: |seen| seen.position[0],
    },
    Quantity {
        symbol: "Y",
        name: "Apparent Y",
        tip: "Apparent position in depth.",
        decimals: 4,
        value: |seen| seen.position[1],
    },
    Quantity {
        symbol: "Z",
        name: "Apparent Z",
        tip: "Apparent height.",
        decimals: 4,
        value: |seen| seen.position[2],
    },
    Quantity {
        symbol: "φ / rad",
        name: "Azimuth φ",
        tip: "Azimuth from +x towards +y.\nφ = atan2(Y, X)",
        decimals: 5,
        value: Sighting::phi,
    },
    Quantity {
        symbol: "θ / rad",
        name: "Elevation θ",
        tip: "Elevation from the x-y plane.\nθ = atan2(Z, √(X² + Y²))",
        decimals: 5,
        value: Sighting::theta,
    },
];

impl Quantity {
    fn row(&self, ui: &mut Ui, sightings: [Option<Sighting>; 2]) {
        ui.label(RichText::new(self.symbol).weak()).on_hover_text(self.tip);
        for (eye, seen) in Eye::BOTH.into_iter().zip(sightings) {
            let text = figures::fixed_or_none(seen.as_ref().map(self.value), self.decimals);
            let name = format!("{}, {}: {text}", eye.name(), self.name);
            named_text(ui, RichText::new(text), name).on_hover_text(self.tip);
        }
        ui.end_row();
    }
}

fn wavelengths(ui: &mut Ui, sightings: [Option<Sighting>; 2], rest_wavelength: Option<f64>) {
    let tip = rest_wavelength.map_or_else(
        || "White light has every wavelength.".to_owned(),
        |nm| {
            format!("Received wavelength; at rest {} nm.\nλ received = λ at rest / D", figures::fixed(nm, 0))
        },
    );
    ui.label(RichText::new("λ / nm").weak()).on_hover_text(&tip);
    for (eye, seen) in Eye::BOTH.into_iter().zip(sightings) {
        let received =
            seen.zip(rest_wavelength).map(|(seen, nm)| received_wavelength(nm, seen.doppler_factor));
        let text = figures::fixed_or_none(received, 1);
        let name = format!("{}, Received wavelength: {text} nm", eye.name());
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            named_text(ui, text, name).on_hover_text(&tip);
            swatch(ui, received);
        });
    }
    ui.end_row();
}

/// The colour of a wavelength; a struck-out box where it has none.
fn swatch(ui: &mut Ui, wavelength_nm: Option<f64>) {
    let (rect, _) = ui.allocate_exact_size(vec2(14.0, 12.0), Sense::hover());
    let linear = wavelength_nm.map_or([0.0; 3], colour::linear_srgb);
    let [r, g, b] =
        linear.map(|channel| (255.0 * colour::srgb_encoded(channel.clamp(0.0, 1.0))).round() as u8);
    let stroke = ui.visuals().widgets.noninteractive.bg_stroke;
    let painter = ui.painter();
    painter.rect(rect, 2.0, Color32::from_rgb(r, g, b), stroke, egui::StrokeKind::Inside);
    if [r, g, b] == [0, 0, 0] {
        let stroke = egui::Stroke::new(1.0, ui.visuals().weak_text_color());
        painter.line_segment([rect.left_bottom(), rect.right_top()], stroke);
    }
}

/// The disparities, large: what the binocular observer measures.
fn differences(ui: &mut Ui, state: &State) {
    let both = state.disparity(state.session.points.selected());
    let parts = [
        ("Δφ", both.map(|both| both.dphi), "Azimuth, left minus right.\nΔφ = φ left − φ right"),
        ("Δθ", both.map(|both| both.dtheta), "Elevation, left minus right.\nΔθ = θ left − θ right"),
    ];
    ui.horizontal(|ui| {
        for (symbol, value, tip) in parts {
            ui.label(RichText::new(symbol).weak()).on_hover_text(tip);
            let text = figures::fixed_or_none(value, 5);
            let name = format!("Disparity {symbol}: {text} rad");
            let degrees = value.map_or_else(String::new, figures::degrees);
            let shown = RichText::new(format!("{text} rad")).strong();
            named_text(ui, shown, name).on_hover_text(format!("{tip} = {degrees}"));
            ui.add_space(8.0);
        }
    });
}
