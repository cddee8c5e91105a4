//! How a picture looks: the flags, and the `Appearance` they make.

use clap::Args;
use relativity_core::doppler::PAPER_INTENSITY_EXPONENT;
use relativity_render::{Appearance, Colour, Shading};

use crate::flags::choices::{NumberOrOff, Switch, word};
use crate::flags::finite_number;

/// Flags of colour and effects.
#[derive(Debug, Clone, Args)]
pub struct LookArgs {
    /// How a wavelength becomes a colour.
    #[arg(long, value_enum, default_value = "visible", help_heading = "Looks")]
    colour: Colour,
    /// Whether the Doppler effect shifts the wavelength.
    #[arg(long, value_enum, default_value = "on", value_name = "ON|OFF", help_heading = "Looks")]
    doppler_shift: Switch,
    /// Exponent n of the received intensity D^n (the paper's 2; 3 or 4 in the literature), or `off`.
    #[arg(long, default_value_t = NumberOrOff(Some(PAPER_INTENSITY_EXPONENT)), value_name = "N|off", allow_hyphen_values = true, help_heading = "Looks")]
    intensity_exponent: NumberOrOff,
    /// Exposure: light is multiplied by 2^EV.
    #[arg(long, default_value_t = 0.0, value_name = "EV", value_parser = finite_number, allow_hyphen_values = true, help_heading = "Looks")]
    exposure: f64,
    /// How form is shown.
    #[arg(long, value_enum, default_value = "form", help_heading = "Looks")]
    shading: Shading,
    /// Whether the scene's ground is drawn, with a grid of one line per unit of length.
    #[arg(long, value_enum, default_value = "on", value_name = "ON|OFF", help_heading = "Looks")]
    ground: Switch,
    /// Whether the sky is a gradient, else it is plain.
    #[arg(long, value_enum, default_value = "on", value_name = "ON|OFF", help_heading = "Looks")]
    sky: Switch,
    /// Whether sky and ground are light, else they are dark.
    #[arg(long, value_enum, default_value = "off", value_name = "ON|OFF", help_heading = "Looks")]
    light: Switch,
}

impl LookArgs {
    /// The appearance of a scene whose ground lies at `ground_z`, if it has one.
    #[must_use]
    pub fn appearance(&self, ground_z: Option<f64>) -> Appearance {
        Appearance {
            colour: self.colour,
            doppler_shift: self.doppler_shift == Switch::On,
            intensity_exponent: self.intensity_exponent.0,
            exposure_ev: self.exposure,
            shading: self.shading,
            ground_z: ground_z.filter(|_| self.ground == Switch::On),
            sky: self.sky == Switch::On,
            light: self.light == Switch::On,
        }
    }

    /// The flags that make the same look again.
    #[must_use]
    pub fn flags(&self) -> Vec<(&'static str, String)> {
        vec![
            ("colour", word(&self.colour)),
            ("doppler-shift", word(&self.doppler_shift)),
            ("intensity-exponent", self.intensity_exponent.to_string()),
            ("exposure", self.exposure.to_string()),
            ("shading", word(&self.shading)),
            ("ground", word(&self.ground)),
            ("sky", word(&self.sky)),
            ("light", word(&self.light)),
        ]
    }
}
