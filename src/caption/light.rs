//! Light in words: its wavelengths and their colours, or how it is shifted where it has many.

use relativity_core::doppler::received_wavelength;
use relativity_render::colour::spectrum::{self, Band};
use relativity_render::{Colour, Emission};

use super::numbers::distinct_texts;
use crate::settings::LightSettings;

/// From this wavelength on, nm, micrometres are easier to read.
const MICROMETRES_FROM: f64 = 10_000.0;
/// Decimals of a Doppler factor.
const DOPPLER_DECIMALS: u8 = 2;

/// The light of a point where it is at rest, as a picture takes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RestLight {
    /// Light of one wavelength, nm.
    Line(f64),
    /// Light of a body that glows at this temperature, K.
    Glow(f64),
    /// Light of many wavelengths.
    Broad,
}

impl RestLight {
    /// Returns the light of a body with this `emission`, shown with the settings `light`.
    #[must_use]
    pub fn new(emission: Emission, light: &LightSettings) -> Self {
        match (light.colour, emission) {
            (Colour::OneWavelength | Colour::False, Emission::Wavelength(nm)) => Self::Line(nm),
            (Colour::Glowing, _) => Self::Glow(light.temperature),
            _ => Self::Broad,
        }
    }

    /// Describes the light as received with these `doppler_factors`, of the left and the right eye or of one;
    /// `None` where they are no numbers.
    pub(super) fn described(self, doppler_factors: &[f64]) -> Option<String> {
        let are_numbers = doppler_factors.iter().all(|factor| factor.is_finite() && *factor > 0.0);
        let times = |value: f64| doppler_factors.iter().map(|factor| value * factor).collect::<Vec<_>>();
        let divided = |nm| doppler_factors.iter().map(move |factor| received_wavelength(nm, *factor));
        (are_numbers && !doppler_factors.is_empty()).then(|| match self {
            Self::Line(nm) => line(&divided(nm).collect::<Vec<_>>()),
            Self::Glow(kelvin) => glow(kelvin, &times(kelvin)),
            Self::Broad => shift(doppler_factors),
        })
    }
}

impl RestLight {
    /// Describes without a number how the light with these `doppler_factors` looks to the left and the right
    /// eye: `looks orange to the left eye, yellow to the right`; `None` where they are no numbers.
    pub(super) fn looks(self, doppler_factors: [f64; 2]) -> Option<String> {
        let look = |factor: f64| match self {
            Self::Line(nm) => line_look(received_wavelength(nm, factor)),
            Self::Glow(_) | Self::Broad if factor > 1.0 => "bluer than at rest".to_owned(),
            Self::Glow(_) | Self::Broad if factor < 1.0 => "redder than at rest".to_owned(),
            Self::Glow(_) | Self::Broad => "as at rest".to_owned(),
        };
        let are_numbers = doppler_factors.iter().all(|factor| factor.is_finite() && *factor > 0.0);
        let [left, right] = doppler_factors.map(look);
        let is_alike = left == right;
        let beside = if is_alike { String::new() } else { format!(" to the left eye, {right} to the right") };
        are_numbers.then(|| format!("looks {left}{beside}"))
    }
}

/// The colour of a wavelength, or why it has none.
fn line_look(wavelength_nm: f64) -> String {
    let name = spectrum::name(wavelength_nm);
    match Band::from_wavelength(wavelength_nm) {
        Band::Visible => name.to_owned(),
        _ => format!("{name} (eyes see nothing)"),
    }
}

/// `wavelengths` with unit, `606 and 567 nm`.
#[must_use]
pub fn in_words(wavelengths_nm: &[f64]) -> String {
    let [shortest, longest] =
        [f64::min, f64::max].map(|of| wavelengths_nm.iter().copied().reduce(of).unwrap_or(0.0));
    let (unit, scale) = if longest >= MICROMETRES_FROM { ("µm", 1e-3) } else { ("nm", 1.0) };
    let decimals = match scale * shortest {
        100.0.. => 0,
        10.0.. => 1,
        1.0.. => 2,
        _ => 3,
    };
    let scaled: Vec<f64> = wavelengths_nm.iter().map(|wavelength| scale * wavelength).collect();
    format!("{} {unit}", distinct_texts(&scaled, decimals).join(" and "))
}

/// `606 and 567 nm, orange and yellow`.
fn line(wavelengths_nm: &[f64]) -> String {
    let mut names: Vec<_> = wavelengths_nm.iter().map(|wavelength| spectrum::name(*wavelength)).collect();
    names.dedup();
    let unseen = unseen(wavelengths_nm.iter().map(|wavelength| Band::from_wavelength(*wavelength)));
    format!("{}, {}{unseen}", in_words(wavelengths_nm), names.join(" and "))
}

/// `a glow of 1273 K, received as of 1476 and 1578 K`.
fn glow(kelvin: f64, received: &[f64]) -> String {
    let unseen = unseen(received.iter().map(|kelvin| Band::of_glow(*kelvin)));
    let [kelvin, received] = [&[kelvin], received].map(|values| distinct_texts(values, 0).join(" and "));
    format!("a glow of {kelvin} K, received as of {received} K{unseen}")
}

/// Returns which eye sees nothing of light that arrives in these bands at the left and the right eye, or at
/// both.
fn unseen(bands: impl Iterator<Item = Band>) -> &'static str {
    match bands.map(|band| band == Band::Visible).collect::<Vec<_>>()[..] {
        [false] | [false, false] => ": eyes see nothing",
        [false, true] => ": the left eye sees nothing",
        [true, false] => ": the right eye sees nothing",
        _ => "",
    }
}

/// `wavelengths 1.16 and 1.24 times shorter, so bluer than at rest`.
fn shift(doppler_factors: &[f64]) -> String {
    let times = |factors: &[f64]| distinct_texts(factors, DOPPLER_DECIMALS).join(" and ");
    let are_all = |is: fn(f64) -> bool| doppler_factors.iter().all(|factor| is(*factor));
    if are_all(|factor| factor == 1.0) {
        "wavelengths as at rest".to_owned()
    } else if are_all(|factor| factor >= 1.0) {
        format!("wavelengths {} times shorter, so bluer than at rest", times(doppler_factors))
    } else if are_all(|factor| factor <= 1.0) {
        let longer: Vec<_> = doppler_factors.iter().map(|factor| 1.0 / factor).collect();
        format!("wavelengths {} times longer, so redder than at rest", times(&longer))
    } else {
        format!(
            "wavelengths divided by {}, so bluer for one eye and redder for the other",
            times(doppler_factors)
        )
    }
}
