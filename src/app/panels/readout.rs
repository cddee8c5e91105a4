//! The numbers: what each eye receives of the selected point now, and how the two differ.

use eframe::egui::{self, Align, Color32, Grid, Layout, RichText, ScrollArea, Sense, Ui, vec2};
use relativity_core::{
    Disparity, Model, ObserverError, ObserverVelocity, Sighting, StereoError, doppler::received_wavelength,
};
use relativity_render::{Light, Velocity, colour};

use super::{Commands, OnClick as _};
use crate::app::commands::SettingsCommand;
use crate::app::state::State;
use crate::app::state::points::Point;
use crate::app::state::queries::on_wheel::{OnWheel, angle_text};
use crate::app::state::queries::spectrum::PointLight;
use crate::app::widgets::theme;
use crate::app::widgets::{dot, named_text};
use crate::caption::capitalised;
use crate::caption::times::TimeName;
use crate::eye::Eye;
use crate::flags::choices::ProjectionChoice;
use crate::map::Diagram;
use crate::number_text;
use crate::quantity::{Of, Quantity, Row};
use crate::settings::WindowSettings;

/// Shows the readout of the selected point: among few controls in words, and its numbers on request.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let window = state.document.settings.window;
    ui.spacing_mut().item_spacing.y = 3.0;
    if window.simple {
        words(ui, state, commands);
        if !window.readout {
            return;
        }
        ui.separator();
    } else {
        ui.horizontal(|ui| {
            fold(ui, state, commands);
            name(ui, state);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let Velocity { speed, is_backward } = state.velocity(state.document.points.selected());
                let sign = if is_backward { "−" } else { "" };
                ui.label(RichText::new(format!("β {sign}{}", number_text::beta(&speed))).weak());
            });
        });
    }
    differences(ui, state);
    stereo(ui, state);
    if window.readout {
        ui.separator();
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| table(ui, state));
    }
}

/// Shows the name of the selected point in its colour.
fn name(ui: &mut Ui, state: &State) {
    let point = state.document.points.selected();
    dot(ui, theme::point_colour(point.number, ui.visuals()));
    ui.label(state.name_of(point));
}

/// Shows the selected point in words: how it looks, how fast its time is seen to pass, and how far apart the
/// eyes see it; and the button for its numbers.
fn words(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let window = state.document.settings.window;
    ui.horizontal(|ui| {
        name(ui, state);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let button = ui.add(egui::Button::new("Numbers").selected(window.readout));
            let other = WindowSettings { readout: !window.readout, ..window };
            button.on_hover_text(NUMBERS_TIP).on_click(commands, SettingsCommand::Window(other));
        });
    });
    let moment = state.moment();
    ui.label(capitalised(&moment.looks().unwrap_or_else(|| NO_LIGHT.to_owned())));
    if let Some(pace) = moment.pace() {
        ui.label(capitalised(&pace)).on_hover_text(Quantity::Doppler.row().about);
    }
    let apart = state.disparity(state.document.points.selected());
    if let Some(apart) = apart.and_then(|both| Quantity::DeltaPhi.seen(&both)) {
        let degrees = number_text::fixed(apart.to_degrees().abs(), 2);
        ui.label(format!("The eyes see it {degrees}° apart")).on_hover_text(Quantity::DeltaPhi.row().about);
    }
}

const NUMBERS_TIP: &str = "Shows what each eye receives of the selected point now: times, places, angles and \
    wavelengths, and where two eyes place it.";

const NO_LIGHT: &str = "drawn without the light that arrives: nobody sees this";

/// Shows a table of what each eye receives.
fn table(ui: &mut Ui, state: &State) {
    let point = state.document.points.selected();
    let received = SelectedSightings {
        shown: Eye::BOTH.map(|eye| state.sighting(point, eye)),
        exact: exact_beside(state).map(|exact| exact.secondary),
    };
    let light = state.point_light(!ui.visuals().dark_mode);
    Grid::new("readout").num_columns(3).spacing([10.0, 3.0]).min_col_width(70.0).min_row_height(18.0).show(
        ui,
        |ui| {
            ui.label("");
            for eye in Eye::BOTH {
                let is_published = state.sees_as_published(eye);
                let name = if is_published { "Right, published" } else { eye.name() };
                ui.label(RichText::new(name).color(theme::eye_colour(eye, ui.visuals())));
            }
            ui.end_row();
            match (light.light, state.rest_wavelength_nm(point)) {
                (Light::Line(nm), _) | (Light::Map, Some(nm)) => wavelengths(ui, &received, nm),
                (Light::Glow(_) | Light::Painted(_), _) => colours(ui, &light),
                // False colours show no light.
                (Light::Map, None) => {}
            }
            for quantity in Quantity::READ_OUT {
                row(ui, state, &received, quantity);
                match quantity {
                    Quantity::Doppler => received_time(ui, state, &received),
                    Quantity::ProperTime if state.document.settings.ride.is_on() => {
                        reckoned(ui, state, point);
                    }
                    _ => {}
                }
            }
            if state.document.settings.projection() == ProjectionChoice::Mercator {
                for quantity in Quantity::READ_OUT_OF_CONFORMAL {
                    row(ui, state, &received, quantity);
                }
            }
            if point.track.spin.is_some() {
                for of_wheel in &TURNING {
                    of_wheel.row(ui, state, &received);
                }
            }
        },
    );
}

const RECKONED_TIP: &str = "What the clock at the point shows now, by my reckoning: at the same time as \
    this moment, in the frame in which I rest. Nobody sees it: it differs from τ, which is seen, by the \
    light's delay, and it changes with my velocity.";

/// Shows beside the clock that is seen what that clock shows now, as whoever rides reckons.
fn reckoned(ui: &mut Ui, state: &State, point: &Point) {
    let (settings, time) = (&state.document.settings, state.document.time);
    let diagram = Diagram::new(settings, &point.track, time, ObserverVelocity::REST).ok();
    let shows = diagram.map_or(f64::NAN, |diagram| diagram.point.proper_time(diagram.other_now()));
    let unit = state.measures().time;
    ui.label(RichText::new(unit.label("τ now, reckoned")).weak()).on_hover_text(RECKONED_TIP);
    let name = format!("Proper time now, by my reckoning: {}", unit.text(shows, 4));
    named_text(ui, unit.number(shows, 4), name).on_hover_text(RECKONED_TIP);
    ui.label("");
    ui.end_row();
}

/// Sightings of both eyes of the selected point now.
struct SelectedSightings {
    /// Sightings as the views show them.
    shown: [Option<Sighting>; 2],
    /// Exact sighting of the right eye, where that is not shown.
    exact: Option<Sighting>,
}

impl SelectedSightings {
    /// `tip`, and for an eye that is not shown exactly what it receives exactly, in the words of `text`.
    fn tip(&self, eye: Eye, tip: &str, text: impl Fn(&Sighting) -> String) -> String {
        match &self.exact {
            Some(exact) if eye == Eye::Right => format!("{tip}\n{}", exactly(&text(exact))),
            _ => tip.to_owned(),
        }
    }
}

/// The exact value beside a published one.
fn exactly(value: &str) -> String {
    format!("Published; exact: {value}")
}

/// Returns the exact disparity of the selected point, where the views show the published model.
fn exact_beside(state: &State) -> Option<Disparity> {
    let track = state.document.points.selected().track;
    let is_published = matches!(state.document.settings.shown_model(), Model::Published(_));
    is_published.then(|| state.document.settings.disparity(&track, state.document.time).ok()).flatten()
}

/// Shows the stereo gain and position.
fn stereo(ui: &mut Ui, state: &State) {
    const AXES: [&str; 3] = ["x", "y", "z"];
    let found = state.stereo(state.document.points.selected());
    let (unit, colour) = (state.measures().length, theme::stereo_colour(ui.visuals()));
    if let Err(ObserverError::Stereo(StereoError::Apart)) = found {
        let text = RichText::new(APART).color(colour);
        named_text(ui, text, APART.to_owned()).on_hover_text(APART_TIP);
        return;
    }
    let found = found.ok();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let is_published = matches!(state.document.settings.shown_model(), Model::Published(_));
        let gain = if is_published { "exact stereo gain" } else { "stereo gain" };
        ui.label(RichText::new(gain).color(colour)).on_hover_text(Quantity::StereoGain.row().about);
        let gain = number_text::fixed_or_none(found.map(|found| found.gain), 3);
        named_text(ui, gain.as_str(), format!("Stereo gain: {gain}"))
            .on_hover_text(Quantity::StereoGain.row().about);
        ui.add_space(6.0);
        ui.label(RichText::new(unit.label("position")).color(colour)).on_hover_text(STEREO_TIP);
        for (axis, name) in AXES.into_iter().enumerate() {
            let value = found.map_or(f64::NAN, |found| found.position[axis]);
            let name = format!("Stereo {name}: {}", unit.text(value, 2));
            named_text(ui, unit.number(value, 2), name).on_hover_text(STEREO_TIP);
        }
        let is_turning = state.document.points.selected().track.spin.is_some();
        if is_turning || !state.document.settings.baseline().is_along_motion() {
            let text = unit.text(found.map_or(f64::NAN, |found| found.miss), 3);
            ui.label(RichText::new("lines of sight pass").color(colour)).on_hover_text(MISS_TIP);
            named_text(ui, format!("{text} apart"), format!("Lines of sight pass: {text} apart"))
                .on_hover_text(MISS_TIP);
        }
    });
}

const APART: &str = "The lines of sight diverge: they do not meet in front of the eyes.";

const APART_TIP: &str = "The eyes receive two events of the point, between which it moved. The two lines \
    of sight to them need not meet anywhere.";

const MISS_TIP: &str = "With the head tilted or turned, and for a point that turns with a wheel, the two \
    lines of sight pass each other. The stereo position is the middle of their shortest connection; this \
    is its length.";

const STEREO_TIP: &str = "The stereo position: where the lines of sight of both eyes meet, and so where \
    two eyes place the point. x, y, z from the middle between the eyes. Two eyes see the contraction, as \
    depth.";

/// The title, which folds the table away.
fn fold(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut window = state.document.settings.window;
    let sign = if window.readout { "▾" } else { "▸" };
    let (name, tip) = match state.document.settings.shown_model() {
        Model::OneCone => (
            "One light cone",
            "What each eye would receive of the selected point now if both received the same events: those \
                of the middle between them. Click to fold the table away.",
        ),
        Model::Published(_) => ("Published", PUBLISHED_TIP),
        Model::Exact => {
            ("Seen", "What each eye receives of the selected point now. Click to fold the table away.")
        }
    };
    let title = egui::Button::new(RichText::new(format!("{sign} {name}")).strong()).frame(false);
    window.readout = !window.readout;
    ui.add(title)
        .on_hover_text(tip)
        .accessible_name("Readout")
        .on_click(commands, SettingsCommand::Window(window));
}

const PUBLISHED_TIP: &str = "What the views show of the selected point now. The left eye receives it \
    exactly; in the published model the right eye has what the left one sees at T − ΔT, measured from the \
    left eye. Point at a number for the exact one. Click to fold the table away.";

/// Number of decimals in the row of T.
const TIME_DECIMALS: u8 = 4;

/// A row of numbers of a point that turns with a wheel.
struct OfWheel {
    symbol: &'static str,
    name: &'static str,
    tip: &'static str,
    text: fn(&OnWheel) -> String,
}

const TURNING: [OfWheel; 2] = [
    OfWheel {
        symbol: "angle on wheel",
        name: "Angle on the wheel",
        tip: "Where on its wheel the point was as the light left it: from +x (0°) over the top (90°).",
        text: |wheel| angle_text(wheel.angle),
    },
    OfWheel {
        symbol: "speed on ground",
        name: "Speed on the ground",
        tip: "Speed of the point on the ground when the light left it, turning and carried along: from 0 \
            at the bottom to 2β/(1 + β²) at the top of a wheel that rolls. D includes this motion.",
        text: |wheel| number_text::fixed(wheel.on_ground, 4) + " c",
    },
];

impl OfWheel {
    fn row(&self, ui: &mut Ui, state: &State, received: &SelectedSightings) {
        let track = state.document.points.selected().track;
        ui.label(RichText::new(self.symbol).weak()).on_hover_text(self.tip);
        let text = |seen: &Sighting| {
            state.on_wheel(&track, seen.proper_time).map_or_else(String::new, |wheel| (self.text)(&wheel))
        };
        for (eye, seen) in Eye::BOTH.into_iter().zip(&received.shown) {
            let shown = seen.as_ref().map_or_else(|| number_text::fixed_or_none(None, 0), text);
            let tip = received.tip(eye, self.tip, text);
            named_text(ui, shown.as_str(), format!("{}, {}: {shown}", eye.name(), self.name))
                .on_hover_text(tip);
        }
        ui.end_row();
    }
}

/// Shows the row of a quantity that each eye has.
fn row(ui: &mut Ui, state: &State, received: &SelectedSightings, quantity: Quantity) {
    let &Row { name, about, decimals, of, .. } = quantity.row();
    let unit = quantity.unit(&state.measures());
    let axes = state.document.settings.baseline_at(state.document.time).axes();
    let value_of = |seen: &Sighting| match of {
        Of::Sighting(of) => of(seen),
        Of::Conformal(of) => axes.conformal(seen.position).map_or(f64::NAN, |seen| of(&seen)),
        Of::Pair(_) | Of::ConformalPair(_) | Of::Stereo(_) => f64::NAN,
    };
    ui.label(RichText::new(unit.label(name)).weak()).on_hover_text(about);
    for (eye, seen) in Eye::BOTH.into_iter().zip(&received.shown) {
        let value = seen.as_ref().map_or(f64::NAN, value_of);
        let shown = format!("{}, {name}: {}", eye.name(), unit.text(value, decimals));
        let tip = received.tip(eye, about, |exact| unit.text(value_of(exact), decimals));
        named_text(ui, unit.number(value, decimals), shown).on_hover_text(tip);
    }
    ui.end_row();
}

/// Shows the row of the observer's own time, at which both eyes receive what they see.
fn received_time(ui: &mut Ui, state: &State, received: &SelectedSightings) {
    let (unit, TimeName { name, tip }) = (state.measures().time, state.clock().received);
    ui.label(RichText::new(unit.label(name)).weak()).on_hover_text(tip);
    for (eye, seen) in Eye::BOTH.into_iter().zip(&received.shown) {
        let time = seen.as_ref().map_or(f64::NAN, |_| state.document.time);
        let shown = format!("{}, {name}: {}", eye.name(), unit.text(time, TIME_DECIMALS));
        named_text(ui, unit.number(time, TIME_DECIMALS), shown).on_hover_text(tip);
    }
    ui.end_row();
}

fn wavelengths(ui: &mut Ui, received: &SelectedSightings, at_rest_nm: f64) {
    let tip = format!(
        "Received wavelength; at rest {} nm.\nλ received = λ at rest / D",
        number_text::fixed(at_rest_nm, 0)
    );
    ui.label(RichText::new("λ / nm").weak()).on_hover_text(&tip);
    let of = |seen: &Sighting| received_wavelength(at_rest_nm, seen.doppler_factor);
    for (eye, seen) in Eye::BOTH.into_iter().zip(&received.shown) {
        let wavelength = seen.as_ref().map(of);
        let text = number_text::fixed_or_none(wavelength, 1);
        let tip = received.tip(eye, &tip, |exact| number_text::fixed(of(exact), 1) + " nm");
        let name = format!("{}, Received wavelength: {text} nm", eye.name());
        let colour = wavelength.map(colour::linear_srgb).map(|linear| linear.map(colour::srgb_level));
        with_swatch(ui, colour, &text, name, &tip);
    }
    ui.end_row();
}

/// The colours that the eyes see of light of many wavelengths.
fn colours(ui: &mut Ui, light: &PointLight) {
    let tip = "The colour that the picture shows of this light, on a surface that faces it, at the present \
        exposure: red, green and blue of sRGB, two hexadecimal digits each.";
    ui.label(RichText::new("colour").weak()).on_hover_text(tip);
    for eye in Eye::BOTH {
        let colour = light.seen_by(eye);
        let text = colour
            .map_or_else(|| number_text::NONE.to_owned(), |[r, g, b]| format!("#{r:02X}{g:02X}{b:02X}"));
        with_swatch(ui, colour, &text, format!("{}, Colour: {text}", eye.name()), tip);
    }
    ui.end_row();
}

/// A reading, read out by its `name`, beside a box of its `colour`: a struck-out one where nothing is to be
/// seen.
fn with_swatch(ui: &mut Ui, colour: Option<[u8; 3]>, text: &str, name: String, tip: &str) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        named_text(ui, text, name).on_hover_text(tip);
        let (rect, _) = ui.allocate_exact_size(vec2(14.0, 12.0), Sense::hover());
        let [r, g, b] = colour.unwrap_or_default();
        let stroke = ui.visuals().widgets.noninteractive.bg_stroke;
        let painter = ui.painter();
        painter.rect(rect, 2.0, Color32::from_rgb(r, g, b), stroke, egui::StrokeKind::Inside);
        if [r, g, b] == [0, 0, 0] {
            let stroke = egui::Stroke::new(1.0, ui.visuals().weak_text_color());
            painter.line_segment([rect.left_bottom(), rect.right_top()], stroke);
        }
    });
}

/// The disparities, large: what the binocular observer measures.
fn differences(ui: &mut Ui, state: &State) {
    let (both, exact) = (state.disparity(state.document.points.selected()), exact_beside(state));
    let parts = Quantity::DISPARITIES.map(|quantity| {
        let values = [both, exact].map(|both| both.and_then(|both| quantity.seen(&both)));
        (quantity.row().symbol, values, quantity.row().about)
    });
    ui.horizontal(|ui| {
        ui.label(RichText::new("disparity").weak()).on_hover_text("How differently the eyes see the point.");
        for (symbol, [value, exact], tip) in parts {
            ui.label(RichText::new(symbol).weak()).on_hover_text(tip);
            let text = number_text::fixed_or_none(value, 5);
            let name = format!("Disparity {symbol}: {text} rad");
            let degrees = value.map_or_else(String::new, number_text::degrees);
            let shown = RichText::new(format!("{text} rad")).strong();
            let exact = exact.map(|exact| exactly(&format!("{} rad", number_text::fixed(exact, 5))));
            let beside = exact.map_or_else(String::new, |exact| format!("\n{exact}"));
            named_text(ui, shown, name).on_hover_text(format!("{tip} = {degrees}{beside}"));
            ui.add_space(8.0);
        }
    });
}
