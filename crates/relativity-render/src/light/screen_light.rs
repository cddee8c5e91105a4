//! The light of a body on its way to the screen, for one way to show it.
//!
//! Twice the same: `Light::shown` in f64 for one Doppler factor, and `Light::packed`, from which
//! `shaders/colour.wgsl` works it out for each pixel by the tables of `palette.rs`.

use relativity_core::doppler::intensity_factor;
use relativity_core::math::{exp2, log2};

use super::daylight::{DaylightPart, log2_more};
use super::palette;
use super::tone::toned;
use crate::colour::planck::{DAYLIGHT_KELVIN, band, black_body};
use crate::colour::spectrum::Band;
use crate::colour::{false_colour, linear_srgb, luminance, unseen_glow, unseen_line};
use crate::scene::body::Emission;
use crate::view::effects::{Effects, Spectrum};
use crate::view::{Appearance, Colour};

/// Share of daylight that a tinted body reflects at every wavelength; the rest it reflects only near its own.
const WHITE_SHARE: f64 = 0.25;
/// Exponent of the radiance per wavelength, by which a band rises where it is received: `I_lambda lambda^5`
/// is the same for all.
const BAND_EXPONENT: f64 = 5.0;
/// log2 of what is dark at any exposure.
const LOG2_DARK: f64 = -1e4;

/// A body's light as a picture takes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// A single wavelength, nm.
    Line(f64),
    /// A black body, K.
    Glow(f64),
    /// Daylight, of which a body reflects more about a wavelength, nm; without one, all alike.
    Daylight(Option<f64>),
    /// No light: the colour shows the Doppler factor.
    Map,
}

/// Light as a screen shows it: what eyes see of it, and how much of the hatch lies over that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScreenLight {
    /// Linear sRGB, in [0, 1].
    pub colour: [f64; 3],
    /// The unseen share, with the sign of [`crate::light::hatch`].
    pub unseen: f64,
}

/// The levels of light of a broad spectrum for one Doppler factor.
struct Levels {
    /// log2 of the brightness of its glowing part.
    glow: f64,
    /// log2 of the brightness of its band.
    band: f64,
}

impl Light {
    /// Returns the light of `emission`, as `appearance` takes it.
    #[must_use]
    pub fn new(emission: Emission, appearance: &Appearance) -> Self {
        match (appearance.colour, emission) {
            (Colour::False, _) => Self::Map,
            (Colour::Glowing, _) => Self::Glow(appearance.temperature_k),
            (Colour::OneWavelength, Emission::Wavelength(nm)) => Self::Line(nm),
            (Colour::OneWavelength, Emission::Glowing(kelvin)) => Self::Glow(kelvin),
            (Colour::OneWavelength, Emission::Painted(_)) => Self::Glow(DAYLIGHT_KELVIN),
            (Colour::White | Colour::StreetDaylight, emission) => Self::Daylight(emission.wavelength_nm()),
        }
    }

    /// Returns the band in which this light is received at `doppler_factor`: visible, infrared or
    /// ultraviolet.
    pub(crate) fn band(self, appearance: &Appearance, doppler_factor: f64) -> Band {
        let shift = if appearance.doppler_shift { doppler_factor } else { 1.0 };
        match self {
            Self::Line(nm) => Band::from_wavelength(nm / shift),
            Self::Glow(kelvin) => Band::of_glow(kelvin * shift),
            Self::Daylight(_) => Band::of_glow(DAYLIGHT_KELVIN * shift),
            // False colours leave nothing dark.
            Self::Map => Band::Visible,
        }
    }

    /// Returns the colour and the unseen share at `doppler_factor`, for a surface that faces the light.
    #[must_use]
    pub fn shown(self, appearance: &Appearance, doppler_factor: f64) -> ScreenLight {
        self.shown_in_parts(appearance, doppler_factor, &[DaylightPart::OWN])
    }

    /// Returns colour and unseen share where daylight is received in these `parts`, the hottest first.
    pub(crate) fn shown_in_parts(
        self,
        appearance: &Appearance,
        doppler_factor: f64,
        parts: &[DaylightPart],
    ) -> ScreenLight {
        if self == Self::Map {
            return ScreenLight { colour: false_colour(log2(doppler_factor)), unseen: 0.0 };
        }
        let shift = if appearance.doppler_shift { log2(doppler_factor) } else { 0.0 };
        // A product that overflows is as bright as can be, not infinite: black times infinity is no number.
        let exposed = |part: f64| (part * exp2(appearance.exposure_ev)).min(f64::MAX);
        let received = self.received(shift, self.log2_intensity(appearance, doppler_factor), parts);
        let colour = toned(received.map(exposed));
        let unseen = if appearance.invisible { left_dark(colour) * self.unseen(shift, parts) } else { 0.0 };
        ScreenLight { colour, unseen }
    }

    /// Returns log2 of the part of the received intensity that its colour does not contain: D^n of one
    /// wavelength, and of all where colours stay as they are at rest.
    fn log2_intensity(self, appearance: &Appearance, doppler_factor: f64) -> f64 {
        if self.exponent(appearance) == 0.0 {
            return 0.0;
        }
        (self.exponent(appearance) * log2(doppler_factor)).clamp(-1e3, 1e3)
    }

    fn exponent(self, appearance: &Appearance) -> f64 {
        match self {
            Self::Glow(_) | Self::Daylight(_) if appearance.doppler_shift => 0.0,
            _ => appearance.intensity_exponent.unwrap_or(0.0),
        }
    }

    /// Linear sRGB before any exposure, for light shifted by `shift` octaves, where daylight is received in
    /// these `parts`. At rest its largest component is about 1.
    fn received(self, shift: f64, log2_intensity: f64, parts: &[DaylightPart]) -> [f64; 3] {
        match self {
            Self::Line(nm) => linear_srgb(exp2(log2(nm) - shift)).map(|part| part * exp2(log2_intensity)),
            Self::Glow(kelvin) => glow(kelvin, shift, log2_intensity - black_body(log2(kelvin)).log2_level),
            Self::Daylight(tint) => {
                let of_part = |part: &DaylightPart| {
                    let light = reflected(tint, shift, log2_intensity, part.log2_doppler);
                    light.map(|component| component * part.share)
                };
                parts
                    .iter()
                    .map(of_part)
                    .fold([0.0; 3], |sum, part| std::array::from_fn(|i| sum[i] + part[i]))
            }
            Self::Map => [0.0; 3],
        }
    }

    /// Returns its unseen share; for daylight, that of its hottest part.
    fn unseen(self, shift: f64, parts: &[DaylightPart]) -> f64 {
        match self {
            Self::Line(nm) => unseen_line(exp2(log2(nm) - shift)),
            Self::Glow(kelvin) => unseen_glow(log2(kelvin) + shift),
            Self::Daylight(_) => {
                let hottest = parts.first().map_or(0.0, |part| part.log2_doppler);
                unseen_glow(log2(DAYLIGHT_KELVIN) + shift + hottest)
            }
            Self::Map => 0.0,
        }
    }

    /// Returns the light as the shaders read it: see `received_colour` there.
    pub(crate) fn packed(self, appearance: &Appearance, effects: Effects) -> [f64; 4] {
        let (exponent, exposure) = (self.exponent(appearance), appearance.exposure_ev);
        match (effects.spectrum(), self) {
            (Spectrum::AtRest, _) => {
                let ScreenLight { colour: [red, green, blue], unseen } = self.shown(appearance, 1.0);
                [red, green, blue, unseen]
            }
            (_, Self::Line(nm)) => {
                [palette::LINE.place(log2(nm)), -palette::LINE.per_octave(), exponent, exposure]
            }
            (_, Self::Glow(kelvin)) => {
                let level = exposure - black_body(log2(kelvin)).log2_level;
                [palette::GLOW.place(log2(kelvin)), palette::GLOW.per_octave(), exponent, level]
            }
            (_, Self::Daylight(tint)) => {
                let levels = daylight(tint);
                let place = palette::BAND.place(log2(tint.unwrap_or(1.0)));
                let own = if appearance.doppler_shift { BAND_EXPONENT } else { exponent };
                [place, levels.band + exposure, levels.glow + exposure, own]
            }
            (_, Self::Map) => [0.0; 4],
        }
    }
}

/// A black body of the temperature `kelvin` at rest, times 2^`log2_factor`.
fn glow(kelvin: f64, shift: f64, log2_factor: f64) -> [f64; 3] {
    let light = black_body(log2(kelvin) + shift);
    light.hue.map(|part| part * exp2((light.log2_level + log2_factor).min(1e3)))
}

/// Linear sRGB of what a body with this `tint` reflects of daylight that it receives shifted by
/// `received_shift` octaves, shifted by `shift` more.
fn reflected(tint: Option<f64>, shift: f64, log2_intensity: f64, received_shift: f64) -> [f64; 3] {
    let levels = daylight(tint);
    let white = glow(DAYLIGHT_KELVIN, shift + received_shift, log2_intensity + levels.glow);
    let Some(nm) = tint else { return white };
    let own = band(log2(nm) - shift);
    let more = if received_shift == 0.0 { 0.0 } else { log2_more(log2(nm), received_shift) };
    let level = own.log2_level + levels.band + BAND_EXPONENT * shift + log2_intensity + more;
    std::array::from_fn(|i| white[i] + own.hue[i] * exp2(level.min(1e3)))
}

/// Returns the scales of the parts of daylight with this `tint` that give a largest component of 1 at rest.
fn daylight(tint: Option<f64>) -> Levels {
    let white = -black_body(log2(DAYLIGHT_KELVIN)).log2_level;
    let Some(nm) = tint else { return Levels { glow: white, band: LOG2_DARK } };
    let own = band(log2(nm));
    // In daylight of the largest component 1 a band at green would have one of about 1, too.
    let visible = own.log2_level.max(band(log2(nm.clamp(420.0, 680.0))).log2_level);
    let parts: [f64; 3] = std::array::from_fn(|i| {
        let paper = black_body(log2(DAYLIGHT_KELVIN)).hue[i];
        WHITE_SHARE * paper + (1.0 - WHITE_SHARE) * own.hue[i] * exp2(own.log2_level - visible)
    });
    let scale = -log2(parts.into_iter().fold(0.0, f64::max));
    Levels { glow: white + log2(WHITE_SHARE) + scale, band: log2(1.0 - WHITE_SHARE) + scale - visible }
}

/// Returns the share of the hatch that shows over `colour`: much only where that is all but black.
fn left_dark(colour: [f64; 3]) -> f64 {
    (1.0 - colour.into_iter().fold(0.0, f64::max)).powi(4)
}

/// Received over rest intensity of this `emission` at `doppler_factor`, before any exposure: D^n of light of
/// one wavelength, else the luminance beside that at rest.
#[must_use]
pub fn received_intensity(emission: Emission, appearance: &Appearance, doppler_factor: f64) -> f64 {
    let light = Light::new(emission, appearance);
    let of_exponent = |exponent| intensity_factor(doppler_factor, exponent);
    if matches!(light, Light::Line(_) | Light::Map) || !appearance.doppler_shift {
        return appearance.intensity_exponent.map_or(1.0, of_exponent);
    }
    let [received, at_rest] =
        [log2(doppler_factor), 0.0].map(|shift| luminance(light.received(shift, 0.0, &[DaylightPart::OWN])));
    received / at_rest
}

/// log2 of how bright daylight or a glow is at `doppler_factor`, beside itself at rest.
pub(crate) fn log2_glow(kelvin: f64, doppler_factor: f64) -> f64 {
    black_body(log2(kelvin * doppler_factor)).log2_level - black_body(log2(kelvin)).log2_level
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::light::tone::shoulder;

    #[test]
    fn light_at_rest_is_as_bright_as_a_screen_before_the_shoulder() {
        let lights =
            [Light::Line(700.0), Light::Glow(1273.15), Light::Daylight(None), Light::Daylight(Some(600.0))];
        for light in lights {
            let largest = light.received(0.0, 0.0, &[DaylightPart::OWN]).into_iter().fold(0.0, f64::max);
            assert!((largest - 1.0).abs() < 1e-9, "{light:?}: {largest}");
            assert!((shoulder(largest) - 0.8).abs() < 1e-9);
        }
    }

    #[test]
    fn no_doppler_factor_gives_a_colour_that_is_none() {
        let appearance = Appearance { intensity_exponent: Some(4.0), ..Appearance::default() };
        let lights = [
            Light::Line(700.0),
            Light::Line(1e-6),
            Light::Glow(300.0),
            Light::Glow(1e5),
            Light::Daylight(None),
            Light::Daylight(Some(1e6)),
            Light::Map,
        ];
        for light in lights {
            for exponent in -100..=100 {
                let shown = light.shown(&appearance, exp2(f64::from(exponent)));
                let is_shown = shown.colour.into_iter().all(|part| (0.0..=1.0).contains(&part));
                assert!(is_shown && shown.unseen.abs() <= 1.0, "{light:?} at D = 2^{exponent}: {shown:?}");
            }
        }
    }
}
