//! The section of light: what bodies send, what of it is received, shading and background.

use clap::{Args, ValueEnum};
use relativity_core::doppler::BOLOMETRIC_INTENSITY_EXPONENT;
use relativity_render::{Appearance, Colour, Shading, StreetColours};
use serde::Serialize;

use crate::flags::{Exposure, IntensityExponent, OnOff, switch, temperature};

/// The light that bodies send, the part of it that is received, shading and background.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Light")]
pub struct LightSettings {
    /// Light that the bodies send, and how it becomes a colour.
    #[arg(long, alias = "color", value_enum)]
    pub colour: Colour,
    /// Temperature of bodies that glow, in kelvin, or in degrees Celsius like 1000C.
    #[arg(long, value_name = "K", value_parser = temperature)]
    pub temperature: f64,
    /// Whether the Doppler effect shifts the wavelength: λ received = λ at rest / D.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub doppler_shift: OnOff,
    /// Exponent n of the received intensity Dⁿ of light of one wavelength: `surface` (4, the radiance of a
    /// surface), `photons` (3, their number, or the power per unit of frequency), `paper` (2, the flux of a
    /// point source relative to what a camera riding along receives), a number from -10 to 10, or `off`.
    #[arg(long, value_name = "surface|photons|paper|N|off", allow_hyphen_values = true)]
    pub intensity_exponent: IntensityExponent,
    /// Exposure: light is multiplied by 2^EV, EV from -100 to 100; the brightest is compressed, not clipped.
    /// `auto` finds it from the speeds and the lights of the scene, so that it is steady while time runs:
    /// midway between the light at rest and the brightest that can be seen.
    ///
    /// In a scene in sunlight it is found for what stands there alone: 0 for eyes at rest.
    ///
    /// `auto` brightens what glows by at most 6 EV, for what passes abreast. What glows at 1000 degrees
    /// Celsius and recedes at 0.9 c needs about 80.
    #[arg(long, value_name = "auto|EV", allow_hyphen_values = true)]
    pub exposure: Exposure,
    /// Whether what is received as ultraviolet or infrared keeps its form, in hatched grey (rising lines for
    /// infrared, falling ones for ultraviolet); eyes see nothing there.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub invisible: OnOff,
    /// Shading of the bodies.
    #[arg(long, value_enum)]
    pub shading: Shading,
    /// Whether what rests around the scene is drawn: its groups that do not move, such as houses and lamp
    /// posts.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub surroundings: OnOff,
    /// Whether the scene's ground is drawn: its road, or a grid of one line per unit of length. A soft shadow
    /// lies on the road where wheels touch it: exact there, since both are one event, and only suggested
    /// around it.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub ground: OnOff,
    /// Whether the sky behind the scene is a gradient; otherwise it is plain.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub sky: OnOff,
    /// Colours of road, ground, house fronts and sky as a rider sees them: smooth paint in measured daylight.
    /// Eyes at rest see them as painted.
    #[arg(long, alias = "street-colors", value_enum)]
    pub street_colours: StreetColours,
    /// Whether sky and ground are light. Those of a scene in sunlight always are.
    #[arg(long, value_enum)]
    pub light: Daylight,
}

impl Default for LightSettings {
    /// The intensity of a surface that shines in one wavelength, and every effect.
    fn default() -> Self {
        Self {
            colour: Colour::OneWavelength,
            temperature: Appearance::TEMPERATURE_K,
            doppler_shift: true,
            intensity_exponent: IntensityExponent(Some(BOLOMETRIC_INTENSITY_EXPONENT)),
            exposure: Exposure(None),
            invisible: true,
            shading: Shading::Form,
            surroundings: true,
            ground: true,
            sky: true,
            street_colours: StreetColours::Shifted,
            light: Daylight::Theme,
        }
    }
}

/// Brightness of sky and ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Daylight {
    /// Follows the window's theme; dark where there is none.
    #[default]
    Theme,
    /// Light, like a page.
    On,
    /// Dark, like a night.
    Off,
}
