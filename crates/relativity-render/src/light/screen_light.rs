//! The light of a body on its way to the screen, for one way to show it.
//!
//! Twice the same: `Light::shown` in f64 for one Doppler factor, and `Light::packed`, from which
//! `shaders/colour.wgsl` works it out for each pixel by the tables of `palette.rs`.

use relativity_core::doppler::intensity_factor;
use relativity_core::math::{exp2, log2};

use super::daylight::Facing;
use super::falling::FallingDaylight;
use super::palette::Row;
use super::sky::{self, Reflected};
use super::tone::toned;
use crate::colour::paint::Paint;
use crate::colour::planck::{self, black_body};
use crate::colour::spectra::{daylight, reflectance};
use crate::colour::spectrum::Band;
use crate::colour::sunlit::{self, on_screen};
use crate::colour::{false_colour, linear_srgb, luminance, unseen_daylight, unseen_glow, unseen_line};
use crate::scene::body::Emission;
use crate::view::effects::{Effects, Spectrum};
use crate::view::{Appearance, Colour};

/// log2 of how bright black is beside white, dark at any exposure.
const LOG2_DARKNESS: f64 = -1e4;
/// The most that light is, before any exposure and after it.
const MOST_LIGHT: f64 = 1e300;

/// A body's light as a picture takes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// A single wavelength, nm.
    Line(f64),
    /// A black body, K.
    Glow(f64),
    /// Daylight, reflected by paint.
    Painted(Paint),
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

impl Light {
    /// Returns the light of `emission`, as `appearance` takes it.
    #[must_use]
    pub fn new(emission: Emission, appearance: &Appearance) -> Self {
        match (appearance.colour, emission) {
            (Colour::False, _) => Self::Map,
            (Colour::Glowing, _) => Self::Glow(appearance.temperature_k),
            (_, Emission::Glowing(kelvin)) => Self::Glow(kelvin),
            (_, Emission::Painted(paint)) => Self::Painted(paint),
            (Colour::OneWavelength, Emission::Wavelength(nm)) => Self::Line(nm),
            (Colour::White | Colour::StreetDaylight, Emission::Wavelength(nm)) => match linear_srgb(nm) {
                // No paint has a colour that eyes do not see: such a body shines by its own light.
                [0.0, 0.0, 0.0] => Self::Line(nm),
                colour => Self::Painted(Paint::Smooth(colour)),
            },
        }
    }

    /// Returns the radiance per wavelength at `nm` where the light leaves: daylight, `falling` as it does or
    /// as it does on what rests, times the reflectance of the paint, or that of a black body, each in units
    /// of its own. `None` of light without a spectrum.
    #[must_use]
    pub fn radiance(self, nm: f64, falling: Option<&FallingDaylight>) -> Option<f64> {
        match self {
            Self::Glow(kelvin) => Some(planck::radiance(nm, kelvin)),
            Self::Painted(paint) => {
                let falling = falling.map_or_else(|| daylight(nm), |falling| falling.at(nm));
                Some(falling * reflectance(paint, nm))
            }
            Self::Line(_) | Self::Map => None,
        }
    }

    /// Returns the light where a surface has the paint of a model besides, and the factors of linear sRGB by
    /// which that changes light that is no daylight.
    fn on_paint(self, paint: Paint) -> (Self, [f64; 3]) {
        match (self, paint) {
            (Self::Painted(Paint::Smooth(own)), Paint::Smooth(paint)) => {
                (Self::Painted(Paint::Smooth(std::array::from_fn(|part| own[part] * paint[part]))), [1.0; 3])
            }
            (Self::Painted(Paint::Smooth(_)), Paint::Measured(_)) => (Self::Painted(paint), [1.0; 3]),
            (light, paint) => (light, sunlit::colour(paint, 0.0)),
        }
    }

    /// Returns the band in which this light is received at `doppler_factor`: visible, infrared or
    /// ultraviolet.
    pub(crate) fn band(self, appearance: &Appearance, doppler_factor: f64) -> Band {
        let shift = if appearance.doppler_shift { doppler_factor } else { 1.0 };
        match self {
            Self::Line(nm) => Band::from_wavelength(nm / shift),
            Self::Glow(kelvin) => Band::of_glow(kelvin * shift),
            Self::Painted(_) if unseen_daylight(log2(shift)) > 0.5 => Band::Infrared,
            // False colours leave nothing dark.
            Self::Painted(_) | Self::Map => Band::Visible,
        }
    }

    /// Returns the colour and the unseen share at `doppler_factor`, for a surface that faces the light.
    #[must_use]
    pub fn shown(self, appearance: &Appearance, doppler_factor: f64) -> ScreenLight {
        self.shown_facing(appearance, doppler_factor, None, Paint::WHITE)
    }

    /// Returns colour and unseen share, on this `paint` of a model; `facing` the street's daylight, if that
    /// lights it.
    #[must_use]
    pub fn shown_facing(
        self,
        appearance: &Appearance,
        doppler_factor: f64,
        facing: Option<Facing>,
        paint: Paint,
    ) -> ScreenLight {
        let (light, tint) = self.on_paint(paint);
        if self == Self::Map {
            let colour = false_colour(log2(doppler_factor));
            return ScreenLight { colour: colour.map(|part| part * luminance(tint)), unseen: 0.0 };
        }
        let shift = if appearance.doppler_shift { log2(doppler_factor) } else { 0.0 };
        let exposed = light.exposed(appearance, doppler_factor, facing);
        let colour = toned(std::array::from_fn(|part| exposed[part] * tint[part]));
        let unseen = if appearance.invisible { left_dark(colour) * light.unseen(shift, facing) } else { 0.0 };
        ScreenLight { colour, unseen }
    }

    /// Linear sRGB, 0 or more, of this light as it is exposed.
    fn exposed(self, appearance: &Appearance, doppler_factor: f64, facing: Option<Facing>) -> [f64; 3] {
        let shift = if appearance.doppler_shift { log2(doppler_factor) } else { 0.0 };
        // A product that overflows is as bright as can be, not infinite: black times infinity is no number.
        let exposed = |part: f64| (part * exp2(appearance.exposure_ev)).clamp(-MOST_LIGHT, MOST_LIGHT);
        on_screen(self.received(shift, self.log2_intensity(appearance, doppler_factor), facing).map(exposed))
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
            Self::Glow(_) | Self::Painted(_) if appearance.doppler_shift => 0.0,
            _ => appearance.intensity_exponent.unwrap_or(0.0),
        }
    }

    /// Linear sRGB before any exposure, for light shifted by `shift` octaves; `facing` the street's daylight,
    /// if that lights it. At rest its largest component is about 1, of white paint.
    fn received(self, shift: f64, log2_intensity: f64, facing: Option<Facing>) -> [f64; 3] {
        match self {
            Self::Line(nm) => linear_srgb(exp2(log2(nm) - shift)).map(|part| part * exp2(log2_intensity)),
            Self::Glow(kelvin) => glow(kelvin, shift, log2_intensity - black_body(log2(kelvin)).log2_level),
            Self::Painted(paint) => {
                let (colour, log2_level) = match facing {
                    None => (sunlit::colour(paint, shift), sunlit::log2_level(shift)),
                    Some(facing) => in_sky(paint, shift, facing),
                };
                let level = exp2((log2_level + log2_intensity).min(1e3));
                colour.map(|part| part * level)
            }
            Self::Map => [0.0; 3],
        }
    }

    /// Returns its unseen share; for the street's daylight, that of its mean.
    fn unseen(self, shift: f64, facing: Option<Facing>) -> f64 {
        match self {
            Self::Line(nm) => unseen_line(exp2(log2(nm) - shift)),
            Self::Glow(kelvin) => unseen_glow(log2(kelvin) + shift),
            Self::Painted(_) => unseen_daylight(shift + facing.map_or(0.0, Facing::mean_octaves)),
            Self::Map => 0.0,
        }
    }

    /// Returns the light as the shaders read it, before any exposure: see `exposed` and `colour_of` there.
    ///
    /// Smooth paint that is not grey is the shares of red and green in it, the exponent n of D^n, and log2 of
    /// the sum of its primaries. Any other light is one less than the negative of its row in the tables, its
    /// place there at rest, n, and log2 of a factor. At rest it is linear sRGB, and the unseen share.
    pub(crate) fn packed(self, appearance: &Appearance, effects: Effects) -> [f32; 4] {
        self.unexposed(appearance, effects).map(|part| part as f32)
    }

    fn unexposed(self, appearance: &Appearance, effects: Effects) -> [f64; 4] {
        let exponent = self.exponent(appearance);
        let in_row = |row: Row, log2: f64, level: f64| {
            let number = -1.0 - row.number() as f64;
            [number, row.range().place(log2), exponent, level]
        };
        match (effects.spectrum(), self) {
            (_, Self::Map) => [0.0; 4],
            (Spectrum::AtRest, _) => {
                let [red, green, blue] = on_screen(self.received(0.0, 0.0, None));
                let unseen = if appearance.invisible { self.unseen(0.0, None) } else { 0.0 };
                [red, green, blue, unseen]
            }
            (_, Self::Line(nm)) => in_row(Row::Line, log2(nm), 0.0),
            (_, Self::Glow(kelvin)) => in_row(Row::Glow, log2(kelvin), -black_body(log2(kelvin)).log2_level),
            (_, Self::Painted(Paint::Measured(material))) => {
                in_row(Row::Sunlit(sunlit::row_of(material)), 0.0, 0.0)
            }
            (_, Self::Painted(Paint::Smooth(paint))) => {
                let [red, green, blue] = paint;
                if red == green && green == blue {
                    let level = if red > 0.0 { log2(red) } else { LOG2_DARKNESS };
                    return in_row(Row::Sunlit(sunlit::WHITE), 0.0, level);
                }
                let sum = red + green + blue;
                [red / sum, green / sum, exponent, log2(sum)]
            }
        }
    }
}

/// The greatest factor of an exposure: floats hold its product with light.
const MOST_EXPOSED: f64 = 1e30;

/// Returns log2 of the exposure and its factor, as the shaders read them.
pub(crate) fn packed_exposure(appearance: &Appearance) -> [f32; 4] {
    let factor = exp2(appearance.exposure_ev).min(MOST_EXPOSED);
    [appearance.exposure_ev as f32, factor as f32, 0.0, 0.0]
}

/// A black body of the temperature `kelvin` at rest, times 2^`log2_factor`.
fn glow(kelvin: f64, shift: f64, log2_factor: f64) -> [f64; 3] {
    let light = black_body(log2(kelvin) + shift);
    light.hue.map(|part| part * exp2((light.log2_level + log2_factor).min(1e3)))
}

/// Linear sRGB of what `paint` reflects of the street's daylight where it is `facing` that so, seen shifted
/// by `shift` octaves, over the level of white paint; and log2 of that. See [`sunlit`].
fn in_sky(paint: Paint, shift: f64, facing: Facing) -> ([f64; 3], f64) {
    let stand_in = sunlit::in_daylight(paint, shift);
    let (colour, smooth) = (sunlit::colour(paint, shift), sunlit::lit_by_shifted(stand_in, shift));
    let Reflected { primaries, log2_level } = sky::reflected(facing, shift);
    let seen = sunlit::mixed(stand_in, primaries);
    (std::array::from_fn(|part| seen[part] + colour[part] - smooth[part]), log2_level)
}

/// Returns the share of the hatch that shows over `colour`: much only where that is all but black.
fn left_dark(colour: [f64; 3]) -> f64 {
    (1.0 - colour.into_iter().fold(0.0, f64::max)).powi(4)
}

/// Received over rest intensity of this `emission` at `doppler_factor`, before any exposure: D^n of light of
/// one wavelength, else the luminance beside that at rest, of black paint that of white.
#[must_use]
pub fn received_intensity(emission: Emission, appearance: &Appearance, doppler_factor: f64) -> f64 {
    let light = match Light::new(emission, appearance) {
        Light::Painted(Paint::Smooth([0.0, 0.0, 0.0])) => Light::Painted(Paint::WHITE),
        light => light,
    };
    let of_exponent = |exponent| intensity_factor(doppler_factor, exponent);
    if matches!(light, Light::Line(_) | Light::Map) || !appearance.doppler_shift {
        return appearance.intensity_exponent.map_or(1.0, of_exponent);
    }
    let [received, at_rest] =
        [log2(doppler_factor), 0.0].map(|shift| luminance(on_screen(light.received(shift, 0.0, None))));
    received / at_rest
}

/// Applies an exposure of [`packed_exposure`] to light of [`Light::packed`]: its log2 is added to that of
/// light that is looked up in tables, light at rest is multiplied. `shaders/colour.wgsl` computes the same.
pub(crate) fn exposed(light: [f32; 4], exposure: [f32; 4], is_looked_up: bool) -> [f32; 4] {
    let [log2_exposure, factor, _, _] = exposure;
    let [x, y, z, w] = light;
    if is_looked_up { [x, y, z, w + log2_exposure] } else { [x * factor, y * factor, z * factor, w] }
}

/// log2 of how bright a glow is at `doppler_factor`, beside itself at rest.
pub(crate) fn log2_glow(kelvin: f64, doppler_factor: f64) -> f64 {
    black_body(log2(kelvin * doppler_factor)).log2_level - black_body(log2(kelvin)).log2_level
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::paint::Material;
    use crate::light::tone::shoulder;

    #[test]
    fn light_at_rest_is_as_bright_as_a_screen_before_the_shoulder() {
        let lights = [Light::Line(700.0), Light::Glow(1273.15), Light::Painted(Paint::WHITE)];
        for light in lights {
            let largest = light.received(0.0, 0.0, None).into_iter().fold(0.0, f64::max);
            assert!((largest - 1.0).abs() < 1e-9, "{light:?}: {largest}");
            assert!((shoulder(largest) - 0.8).abs() < 1e-9);
        }
    }

    #[test]
    fn what_shines_outside_the_visible_shines_in_daylight_where_it_is_shifted_into_view() {
        let appearance =
            Appearance { colour: Colour::White, intensity_exponent: None, ..Appearance::default() };
        let shown = |nm: f64, doppler_factor: f64| {
            Light::new(Emission::Wavelength(nm), &appearance).shown(&appearance, doppler_factor)
        };
        assert_eq!(shown(1000.0, 1.0), ScreenLight { colour: [0.0; 3], unseen: 1.0 });
        let line = Light::Line(1000.0).shown(&appearance, 1.7).colour;
        assert!(shown(1000.0, 1.7).colour == line && line.into_iter().any(|part| part > 0.5), "{line:?}");
        let mut pairs = shown(600.0, 1.0).colour.into_iter().zip(toned(linear_srgb(600.0)));
        assert!(pairs.all(|(shown, paint)| (shown - paint).abs() < 1e-9));
    }

    #[test]
    fn no_doppler_factor_gives_a_colour_that_is_none() {
        let appearance = Appearance { intensity_exponent: Some(4.0), ..Appearance::default() };
        let lights = [
            Light::Line(700.0),
            Light::Line(1e-6),
            Light::Glow(300.0),
            Light::Glow(1e5),
            Light::Painted(Paint::WHITE),
            Light::Painted(Paint::Smooth([0.7, 0.0, 0.1])),
            Light::Painted(Paint::Measured(Material::ALL[10])),
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
