//! The standing spectrum: the received colour of everything that moves with the scene, column by column.
//!
//! D = cosh u/cosh(u + eta) depends on the column alone.

use std::sync::Arc;

use eframe::egui::{Align2, Color32, FontId, Galley, Painter, Rect, Stroke, pos2, vec2};
use relativity_core::math::{atanh, cosh, ln, sinh, tanh};
use relativity_core::{Speed, aberration};
use relativity_render::colour::spectrum::VISIBLE_NM;
use relativity_render::colour::srgb_level;
use relativity_render::{Appearance, Colour, Geometry, Light};

use super::columns::PixelColumns;
use super::sliding_view::SlidingView;
use crate::app::state::State;
use crate::app::widgets::theme;
use crate::app::widgets::wavelength_colour::{paint_strip, places, visible_colour};
use crate::caption::{RestLight, in_words};
use crate::number_text;
use crate::plot::LabelPlaces;

/// Between the lines of a hatch, points.
const HATCH: f32 = 6.0;
const INVISIBLE: Color32 = Color32::from_gray(58);
const HATCH_COLOUR: Color32 = Color32::from_gray(120);
/// Least space between two names, points.
const BETWEEN: f32 = 6.0;
/// The Doppler factors that are named where light is not of one wavelength.
const NAMED: [f64; 7] = [1.0, 2.0, 0.5, 4.0, 0.25, 10.0, 0.1];

/// Draws it into its place among the `columns`; `with_names` has Doppler factors named in it where it shows
/// no wavelengths. Returns whether it has colours.
pub fn paint(
    painter: &Painter,
    state: &State,
    slide: &SlidingView,
    columns: &PixelColumns,
    with_names: bool,
) -> bool {
    let strip = columns.strip;
    let speed = match slide.view.geometry {
        Geometry::Seen => state.speed(),
        _ => Speed::REST,
    };
    match StripLight::new(state) {
        StripLight::Line(nm) => {
            painter.rect_filled(strip, 0.0, INVISIBLE);
            paint_colours(painter, columns, strip, |u| nm / doppler_factor(&speed, u));
            return true;
        }
        StripLight::Broad(light) => {
            let appearance = state.appearance(false);
            paint_broad(painter, columns, strip, (light, &appearance), |u| doppler_factor(&speed, u));
        }
        StripLight::Unknown => return false,
    }
    if with_names {
        paint_factors(painter, columns, strip, &speed);
    }
    true
}

/// The light whose colours the strip shows.
enum StripLight {
    /// Light of this wavelength at rest, nm, whose brightness is left out.
    Line(f64),
    /// Light of many wavelengths, or false colours, as bright as on a surface that faces the light.
    Broad(Light),
    /// The street's daylight, whose colours depend on which way a surface faces, too.
    Unknown,
}

impl StripLight {
    /// Returns the light of the selected point.
    fn new(state: &State) -> Self {
        if let Some(nm) = rest_wavelength(state).filter(|_| !is_false(state)) {
            return Self::Line(nm);
        }
        if state.document.settings.light.colour == Colour::StreetDaylight {
            return Self::Unknown;
        }
        let emission = state.emission(state.document.points.selected());
        Self::Broad(Light::new(emission, &state.appearance(false)))
    }
}

/// The strip in words.
pub fn description(state: &State) -> String {
    match StripLight::new(state) {
        StripLight::Broad(Light::Map) => "the false colour of each column".to_owned(),
        StripLight::Line(nm) => format!("the spectrum of light of {}", in_words(&[nm])),
        StripLight::Broad(_) => "the colour and the Doppler factor of each column".to_owned(),
        StripLight::Unknown => "the Doppler factor of each column".to_owned(),
    }
}

/// Whether the bodies are drawn in false colours, which show their Doppler factors.
fn is_false(state: &State) -> bool {
    let light = &state.document.settings.light;
    light.colour == Colour::False && light.doppler_shift
}

/// The Doppler factors that have names, and their columns at this `speed`, the first to be named first.
pub fn named_factors(speed: &Speed) -> impl Iterator<Item = (f64, f64)> + use<> {
    let speed = *speed;
    NAMED.into_iter().filter_map(move |factor| Some((factor, column_of(&speed, factor)?)))
}

/// The name of a Doppler factor.
pub fn factor_text(factor: f64) -> String {
    format!("D = {}", number_text::trimmed(factor, 2))
}

/// The wavelength at rest of the selected point, if its light has one and that is shown.
fn rest_wavelength(state: &State) -> Option<f64> {
    match state.moment().source {
        RestLight::Line(nm) if state.document.settings.light.doppler_shift => Some(nm),
        _ => None,
    }
}

/// The Doppler factor D in the column `u`.
fn doppler_factor(speed: &Speed, u: f64) -> f64 {
    aberration::doppler_factor([tanh(u), 1.0 / cosh(u), 0.0], speed)
}

/// The column with this Doppler factor; `None` where there is none.
fn column_of(speed: &Speed, doppler_factor: f64) -> Option<f64> {
    // 1/D = cosh eta + sinh eta tanh u.
    let eta = speed.rapidity();
    let aside = (1.0 / doppler_factor - cosh(eta)) / sinh(eta);
    if doppler_factor == 1.0 {
        return Some(-0.5 * eta);
    }
    let is_there = eta > 0.0 && ln(doppler_factor).abs() < eta;
    is_there.then(|| atanh(aside)).filter(|u| u.is_finite() && tanh(*u).abs() < 1.0)
}

fn paint_colours(painter: &Painter, columns: &PixelColumns, strip: Rect, wavelength: impl Fn(f64) -> f64) {
    let received: Vec<_> = places(strip).map(|x| (x, wavelength(columns.u(x)))).collect();
    paint_strip(painter, strip, received.iter().map(|&(x, nm)| (x, visible_colour(nm, INVISIBLE))));
    let mut hatched: Vec<(f32, bool)> = Vec::new();
    for (x, nm) in received {
        let is_next = hatched.last().is_none_or(|(other, _)| x - other >= HATCH);
        if is_next && !(VISIBLE_NM[0]..=VISIBLE_NM[1]).contains(&nm) {
            hatched.push((x, nm > VISIBLE_NM[1]));
        }
    }
    let half = 0.5 * strip.height();
    for (x, is_infrared) in hatched {
        let rise = if is_infrared { -half } else { half };
        let ends = [pos2(x - half, strip.center().y - rise), pos2(x + half, strip.center().y + rise)];
        painter
            .with_clip_rect(strip.intersect(painter.clip_rect()))
            .line_segment(ends, Stroke::new(1.0, HATCH_COLOUR));
    }
}

/// Fills `strip` with the colour that `light` has in each column on the bodies, with this appearance.
fn paint_broad(
    painter: &Painter,
    columns: &PixelColumns,
    strip: Rect,
    (light, appearance): (Light, &Appearance),
    factor: impl Fn(f64) -> f64,
) {
    let colour = |x: f32| {
        let [r, g, b] = light.shown(appearance, factor(columns.u(x))).colour.map(srgb_level);
        Color32::from_rgb(r, g, b)
    };
    paint_strip(painter, strip, places(strip).map(|x| (x, colour(x))));
}

/// Draws a tick across the strip at `x`, which is seen on colours of any brightness.
pub fn paint_tick(painter: &Painter, strip: Rect, x: f32) {
    for (width, colour) in [(4.0, Color32::from_black_alpha(130)), (1.5, Color32::WHITE)] {
        painter.vline(x, strip.y_range(), Stroke::new(width, colour));
    }
}

/// Writes a Doppler factor at `place`, on a ground that sets it off from colours of any brightness.
fn write_factor(painter: &Painter, place: Rect, galley: Arc<Galley>) {
    painter.rect_filled(place, 2.0, Color32::from_black_alpha(150));
    painter.galley(place.min, galley, Color32::WHITE);
}

fn paint_factors(painter: &Painter, columns: &PixelColumns, strip: Rect, speed: &Speed) {
    let font = FontId::proportional(columns.scale * theme::SMALL_SIZE);
    if speed.beta() == 0.0 {
        let galley = painter.layout_no_wrap("D = 1 everywhere".to_owned(), font, Color32::WHITE);
        let place = Align2::CENTER_CENTER.anchor_size(strip.center(), galley.size());
        return write_factor(painter, place, galley);
    }
    let mut labels = LabelPlaces::new(strip.expand2(vec2(0.0, strip.height())), BETWEEN);
    for (factor, u) in named_factors(speed) {
        let x = columns.x(u);
        let galley = painter.layout_no_wrap(factor_text(factor), font.clone(), Color32::WHITE);
        let place = Align2::LEFT_CENTER.anchor_size(pos2(x + 3.0, strip.center().y), galley.size());
        if labels.take_free([place]).is_some() {
            paint_tick(painter, strip, x);
            write_factor(painter, place, galley);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the closed form of a Mercator map.
    #[test]
    fn each_column_has_one_doppler_factor() {
        for beta in [0.0, 0.3, 0.9, 0.9999] {
            let speed = Speed::from_beta(beta).expect("below 1");
            for u in [-4.0, -1.3, 0.0, 0.7, 5.0] {
                let expected = cosh(u) / cosh(u + speed.rapidity());
                let found = doppler_factor(&speed, u);
                assert!((found / expected - 1.0).abs() < 1e-12, "{beta} {u}: {found} for {expected}");
                if beta > 0.0 {
                    let column = column_of(&speed, found).expect("it is between both ends");
                    assert!((column - u).abs() < 1e-6, "{beta} {u}: {column}");
                }
            }
        }
    }

    #[test]
    fn the_greatest_speeds_have_colours_too() {
        let speed = Speed::from_gamma(1e30).expect("in range");
        for u in [-80.0, -8.0, 0.0, 8.0] {
            assert!(doppler_factor(&speed, u).is_finite());
        }
        assert_eq!(column_of(&speed, 1.0), Some(-0.5 * speed.rapidity()));
    }
}
