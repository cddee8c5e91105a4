//! Light in words: its wavelengths and their colours, or how it is shifted where it has many.

use relativity_core::doppler::received_wavelength;
use relativity_render::spectrum::{self, Band};

use super::numbers::told_apart;

/// From this wavelength on, nm, micrometres are easier to read.
const MICROMETRES_FROM: f64 = 10_000.0;
/// Decimals of a Doppler factor.
const DOPPLER_DECIMALS: u8 = 2;

/// What is received with these `doppler_factors`, of the left and the right eye or of one, of light with this
/// wavelength at rest or with many; none where they are no numbers.
pub fn described(rest_wavelength_nm: Option<f64>, doppler_factors: &[f64]) -> Option<String> {
    let are_numbers = doppler_factors.iter().all(|factor| factor.is_finite() && *factor > 0.0);
    are_numbers.then(|| match rest_wavelength_nm {
        Some(wavelength) => {
            let received = |factor: &f64| received_wavelength(wavelength, *factor);
            line(&doppler_factors.iter().map(received).collect::<Vec<_>>())
        }
        None => shift(doppler_factors),
    })
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
    format!("{} {unit}", told_apart(&scaled, decimals).join(" and "))
}

/// `606 and 567 nm, orange and yellow`.
fn line(wavelengths_nm: &[f64]) -> String {
    let mut names: Vec<_> = wavelengths_nm.iter().map(|wavelength| spectrum::name(*wavelength)).collect();
    names.dedup();
    let are_seen = wavelengths_nm.iter().map(|wavelength| Band::of(*wavelength) == Band::Visible);
    let unseen = match are_seen.collect::<Vec<_>>()[..] {
        [false] | [false, false] => ": eyes see nothing",
        [false, true] => ": the left eye sees nothing",
        [true, false] => ": the right eye sees nothing",
        _ => "",
    };
    format!("{}, {}{unseen}", in_words(wavelengths_nm), names.join(" and "))
}

/// `many wavelengths, all divided by D = 1.16 and 1.24: bluer than at rest`.
fn shift(doppler_factors: &[f64]) -> String {
    let texts = told_apart(doppler_factors, DOPPLER_DECIMALS);
    let word = |factor: &f64| if *factor > 1.0 { "bluer" } else { "redder" };
    let mut words: Vec<_> = doppler_factors.iter().filter(|factor| **factor != 1.0).map(word).collect();
    words.dedup();
    let than = if words.is_empty() {
        "as at rest".to_owned()
    } else {
        format!("{} than at rest", words.join(" and "))
    };
    format!("its wavelengths divided by D = {}, {than}", texts.join(" and "))
}
