//! The Light tab: the spectrum of the selected point as it is emitted, and as each eye receives it, over the
//! logarithm of the wavelength. A Doppler factor slides it along.

use std::fmt::Write as _;

use eframe::egui::{
    self, Align2, Color32, Rect, Sense, Stroke, StrokeKind, TextStyle, Ui, Visuals, accesskit::Role, pos2,
    vec2,
};
use egui_plot::{Line, PlotBounds, PlotPoint, PlotResponse, PlotUi, VLine};
use relativity_core::doppler::received_wavelength;
use relativity_core::math;
use relativity_render::Light;
use relativity_render::colour::spectrum::VISIBLE_NM;

use super::axes::{Ruler, frame, still_plot};
use super::chart::RIGHT_DASHES;
use super::drawn::{css, style};
use crate::app::state::State;
use crate::app::state::queries::spectrum::{PointSpectrum, times_as_bright};
use crate::app::widgets::theme;
use crate::app::widgets::wavelength_colour::{SCALE_NM, paint_strip, places, visible_colour};
use crate::caption::in_words;
use crate::eye::Eye;
use crate::number_text;
use crate::plot::{self, BLACK, Dash, Panel};

/// Wavelengths along the plot at which spectra are worked out, less one: in the visible they are about as far
/// apart as the data of daylight, 1 nm.
const STEPS: u32 = 2400;
/// Highest value of the plot, in peaks.
const TOP: f64 = 1.08;
/// Height of the strip of visible colours, points.
const STRIP: f32 = 8.0;
/// Least height of a plot in which the bands beside the visible are named, points.
const LEAST_WITH_BANDS: f32 = 110.0;
/// Side of a patch of colour, points.
const PATCH: f32 = 14.0;

/// A curve of the plot, or a line of one wavelength.
struct SpectrumTrace {
    name: String,
    /// Received over emitted frequency; 1 of what is emitted.
    doppler_factor: f64,
    /// The eye for which the light leaves; `None` of what would leave at rest.
    leaves_for: Option<Eye>,
    /// The eye that receives it; `None` of what is emitted.
    eye: Option<Eye>,
    dash: Dash,
}

impl SpectrumTrace {
    fn colour(&self, visuals: &Visuals) -> Color32 {
        self.eye.map_or_else(|| visuals.weak_text_color(), |eye| theme::eye_colour(eye, visuals))
    }

    /// The name and how the light is received.
    fn words(&self, spectrum: &PointSpectrum) -> String {
        let at = match spectrum.of.light {
            Light::Line(nm) => format!(", {}", in_words(&[received_wavelength(nm, self.doppler_factor)])),
            _ => String::new(),
        };
        if self.eye.is_none() {
            let falls_with = self.leaves_for.and_then(|eye| spectrum.falls_with(eye));
            let lit = falls_with
                .map(|factor| format!(": lit with D = {} on average", number_text::fixed(factor, 3)));
            return format!("{}{}{at}", self.name, lit.unwrap_or_default());
        }
        let factor = number_text::fixed(self.doppler_factor, 3);
        let brighter = number_text::significant(times_as_bright(self.doppler_factor), 3);
        match spectrum.of.light {
            Light::Line(_) => format!("{}: D = {factor}{at}", self.name),
            _ => format!("{}: D = {factor}, D⁵ = {brighter}", self.name),
        }
    }
}

/// The curves: as emitted, and as each eye receives the light; of a point that moves through the street's
/// daylight also as it would be emitted at rest.
fn traces(spectrum: &PointSpectrum) -> Vec<SpectrumTrace> {
    let emitted = |name: String, leaves_for, dash| SpectrumTrace {
        name,
        doppler_factor: 1.0,
        leaves_for,
        eye: None,
        dash,
    };
    let mut traces = match spectrum.eyes_apart() {
        [] => vec![emitted("Emitted".to_owned(), None, Dash::Solid)],
        [eye] => vec![emitted("Emitted".to_owned(), Some(*eye), Dash::Solid)],
        eyes => eyes
            .iter()
            .map(|&eye| {
                emitted(format!("Emitted to the {}", eye.name().to_lowercase()), Some(eye), dashes(eye))
            })
            .collect(),
    };
    if traces[0].leaves_for.is_some() {
        traces.insert(0, emitted("Emitted at rest".to_owned(), None, Dash::Dotted));
    }
    traces.extend(Eye::BOTH.into_iter().filter_map(|eye| {
        let factor =
            spectrum.of.doppler_factors[eye.index()].filter(|factor| factor.is_finite() && *factor > 0.0)?;
        Some(SpectrumTrace {
            name: eye.name().to_owned(),
            doppler_factor: factor,
            leaves_for: Some(eye),
            eye: Some(eye),
            dash: dashes(eye),
        })
    }));
    traces
}

const fn dashes(eye: Eye) -> Dash {
    match eye {
        Eye::Left => Dash::Solid,
        Eye::Right => RIGHT_DASHES,
    }
}

/// Wavelengths along the plot, nm.
fn wavelengths() -> impl Iterator<Item = f64> {
    let [first, last] = SCALE_NM.map(math::log10);
    (0..=STEPS).map(move |step| math::powf(10.0, first + (last - first) * f64::from(step) / f64::from(STEPS)))
}

/// Shows the spectra of the selected point, their names with the colours that are seen, and the visible band.
pub fn show(ui: &mut Ui, state: &State) {
    let spectrum = PointSpectrum::new(state.point_light(!ui.visuals().dark_mode));
    let point = state.name_of(state.document.points.selected());
    let traces = traces(&spectrum);
    if spectrum.of.light == Light::Map {
        ui.label(
            "False colours show Doppler factors and no light: choose other colours to see its spectrum.",
        );
        return;
    }
    ui.horizontal_wrapped(|ui| {
        for trace in &traces {
            entry(ui, trace, &spectrum);
        }
    });
    let size = ui.available_size().max(vec2(20.0, 20.0));
    let [along, up] = [Ruler::of_powers_along(size.x), Ruler::of_height(size.y)];
    let visuals = ui.visuals().clone();
    let response = up.beside(along.below(still_plot(ui, "light", size))).show(ui, |plot| {
        let [first, last] = SCALE_NM.map(math::log10);
        plot.set_plot_bounds(PlotBounds::from_min_max([first, 0.0], [last, TOP]));
        for trace in &traces {
            draw(plot, trace, &spectrum, &visuals);
        }
    });
    annotate(ui, &response, &format!("Spectrum of {point}"));
}

/// Names a trace, with a sample of its line and the colour that the picture shows.
fn entry(ui: &mut Ui, trace: &SpectrumTrace, spectrum: &PointSpectrum) {
    let text = trace.words(spectrum);
    let [r, g, b] = spectrum.of.colour(trace.leaves_for, trace.doppler_factor);
    let (rect, response) = ui.allocate_exact_size(vec2(PATCH, PATCH), Sense::hover());
    ui.painter().rect_filled(rect, 2.0, Color32::from_rgb(r, g, b));
    let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
    ui.painter().rect_stroke(rect, 2.0, stroke, StrokeKind::Inside);
    let tip =
        "The colour that a picture shows of this light, on a surface that faces it, at the present exposure.";
    let name = format!("Colour, {}: #{r:02X}{g:02X}{b:02X}", trace.name.to_lowercase());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Image, true, &name));
    response.on_hover_text(tip);
    let tip = match (trace.eye, spectrum.of.light) {
        (None, Light::Painted(_)) if trace.leaves_for.is_some() => {
            "The street's daylight as it falls on the surface, bluer from ahead and redder from behind, times \
                the reflectance of the paint at each wavelength."
        }
        (None, Light::Painted(_)) => "Sunlight, times the reflectance of the paint at each wavelength.",
        (None, _) => "The point's own light, as it shines at rest.",
        (Some(_), Light::Line(_)) => "λ received = λ emitted / D",
        (Some(_), _) => {
            "The emitted spectrum with all wavelengths divided by D. It is D⁵ times as bright per nanometre; \
                each curve is drawn as high as the others."
        }
    };
    ui.colored_label(trace.colour(ui.visuals()), text).on_hover_text(tip);
    ui.add_space(theme::GAP);
}

fn draw(plot: &mut PlotUi<'_>, trace: &SpectrumTrace, spectrum: &PointSpectrum, visuals: &Visuals) {
    let (colour, width) = (trace.colour(visuals), if trace.eye.is_some() { 2.0 } else { 1.5 });
    if let Light::Line(nm) = spectrum.of.light {
        let at = math::log10(received_wavelength(nm, trace.doppler_factor));
        let line = VLine::new(&trace.name, at).color(colour).width(width).style(style(trace.dash));
        plot.vline(line.allow_hover(false));
        return;
    }
    let points: Vec<[f64; 2]> = curve(trace, spectrum).map(|[nm, value]| [math::log10(nm), value]).collect();
    let line = Line::new(&trace.name, points).allow_band(false).allow_hover(false);
    plot.line(line.color(colour).width(width).style(style(trace.dash)));
}

/// The points of a curve: wavelengths, nm, and radiances over their peak.
fn curve(trace: &SpectrumTrace, spectrum: &PointSpectrum) -> impl Iterator<Item = [f64; 2]> {
    let value = |nm| spectrum.of_own_peak(trace.leaves_for, trace.doppler_factor, nm);
    wavelengths().filter_map(move |nm| Some([nm, value(nm)?]))
}

/// Draws the strip of visible colours along the plot and its ends, and names the axes and the plot.
fn annotate(ui: &Ui, response: &PlotResponse<()>, name: &str) {
    let area = *response.transform.frame();
    let x = |nm: f64| response.transform.position_from_point(&PlotPoint::new(math::log10(nm), 0.0)).x;
    let [violet, red] = VISIBLE_NM.map(x);
    let painter = ui.painter().with_clip_rect(area);
    let strip = Rect::from_min_max(pos2(violet, area.max.y - STRIP), pos2(red, area.max.y));
    let nm_at = |x: f32| math::powf(10.0, response.transform.value_from_position(pos2(x, area.min.y)).x);
    let behind = ui.visuals().extreme_bg_color;
    paint_strip(&painter, strip, places(strip).map(|x| (x, visible_colour(nm_at(x), behind))));
    let weak = ui.visuals().weak_text_color();
    for end in [violet, red] {
        painter.vline(end, area.y_range(), Stroke::new(1.0, weak.gamma_multiply(0.6)));
    }
    let small = TextStyle::Small.resolve(ui.style());
    let inside = area.shrink2(vec2(6.0, 3.0));
    let axes = [
        (inside.right_top(), Align2::RIGHT_TOP, "wavelength / nm"),
        (inside.left_top(), Align2::LEFT_TOP, "radiance per nm / peak"),
    ];
    let bands = [
        (pos2(violet - 4.0, inside.max.y), Align2::RIGHT_BOTTOM, "ultraviolet"),
        (pos2(red + 4.0, inside.max.y), Align2::LEFT_BOTTOM, "infrared"),
    ];
    let shown = if area.height() < LEAST_WITH_BANDS { &[][..] } else { &bands };
    for &(place, align, text) in axes.iter().chain(shown) {
        painter.text(place, align, text, small.clone(), weak);
    }
    frame(ui, response);
    response.response.widget_info(|| egui::WidgetInfo::labeled(Role::GraphicsObject, true, name));
}

/// The plot for a drawing, in the colours of a light window.
pub fn panel(state: &State) -> Panel {
    let visuals = Visuals::light();
    let spectrum = PointSpectrum::new(state.point_light(true));
    let traces = traces(&spectrum);
    let point = state.name_of(state.document.points.selected());
    let line = |trace: &SpectrumTrace| {
        let points = match spectrum.of.light {
            Light::Line(nm) => {
                let nm = received_wavelength(nm, trace.doppler_factor);
                vec![[nm, 0.0], [nm, 1.0]]
            }
            _ => curve(trace, &spectrum).collect(),
        };
        let colour = if trace.eye.is_some() { css(trace.colour(&visuals)) } else { BLACK.to_owned() };
        plot::Line::solid(trace.words(&spectrum), colour, points).with(plot::LineStroke::Line(trace.dash))
    };
    let [shortest, longest] = VISIBLE_NM;
    Panel {
        is_logarithmic: [true, false],
        ranges: [Some(SCALE_NM.map(math::log10)), Some([0.0, TOP])],
        marks: vec![(shortest, format!("{shortest} nm")), (longest, format!("{longest} nm"))],
        width: 720.0,
        ..Panel::new(
            format!("Spectrum of {point}"),
            ["wavelength / nm", "radiance per nm / peak"],
            traces.iter().map(line).collect(),
        )
    }
}

/// The spectra as a table: radiances per wavelength as multiples of the greatest that is emitted at rest,
/// with D⁵; of light of one wavelength, the wavelengths.
pub fn csv(state: &State) -> String {
    let spectrum = PointSpectrum::new(state.point_light(true));
    let traces = traces(&spectrum);
    let names = traces.iter().map(|trace| trace.name.to_lowercase());
    if let Light::Line(nm) = spectrum.of.light {
        let head: Vec<String> = names.map(|name| format!("{name} / nm")).collect();
        let row: Vec<String> = traces
            .iter()
            .map(|trace| number_text::shortest(received_wavelength(nm, trace.doppler_factor)))
            .collect();
        return format!("{}\n{}\n", head.join(","), row.join(","));
    }
    let mut table = format!("wavelength / nm,{}\n", names.collect::<Vec<_>>().join(","));
    for nm in wavelengths() {
        table.push_str(&number_text::shortest(nm));
        for trace in &traces {
            let value = spectrum.received(trace.leaves_for, trace.doppler_factor, nm);
            let _ = write!(table, ",{}", value.map_or_else(String::new, number_text::shortest));
        }
        table.push('\n');
    }
    table
}
