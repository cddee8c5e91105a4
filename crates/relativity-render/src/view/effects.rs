//! Effects of a picture, as far as they choose a pipeline: an effect that is off is not computed.

use super::{Appearance, Colour, Shading};

/// The effects of `colour.wgsl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Effects {
    spectrum: Spectrum,
    /// Whether the Doppler factor shifts the wavelength.
    pub(crate) doppler_shift: bool,
    /// Whether what eyes do not see keeps its form.
    pub(crate) invisible: bool,
    /// Whether form is shown by shading.
    pub(crate) form: bool,
}

/// The shaders' way from a Doppler factor to a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Spectrum {
    /// Not at all: each body has its colour at rest.
    AtRest,
    /// By a place in the tables: light of one wavelength, of a black body, or of paint in daylight.
    Received,
    /// By several places, for the street's daylight in the parts of [`crate::light::daylight`].
    StreetDaylight,
    /// By the Doppler factor alone.
    Map,
}

impl Effects {
    /// No effects at all.
    pub const NONE: Self =
        Self { spectrum: Spectrum::AtRest, doppler_shift: false, invisible: false, form: false };

    /// Returns the effects of `appearance`; without a Doppler effect (D = 1) everything that depends on it is
    /// off.
    pub fn new(has_doppler_effect: bool, appearance: &Appearance) -> Self {
        let Appearance { doppler_shift, intensity_exponent, .. } = *appearance;
        let form = match appearance.shading {
            Shading::Emission => false,
            Shading::Form => true,
        };
        let spectrum = match appearance.colour {
            Colour::False if has_doppler_effect => Spectrum::Map,
            _ if !has_doppler_effect || !(doppler_shift || intensity_exponent.is_some()) => Spectrum::AtRest,
            _ => Spectrum::Received,
        };
        let invisible = appearance.invisible && matches!(spectrum, Spectrum::AtRest | Spectrum::Received);
        Self { spectrum, doppler_shift, invisible, form }
    }

    /// Returns the effects for what the street's daylight lights.
    pub(crate) fn in_street_daylight(self) -> Self {
        Self { spectrum: Spectrum::StreetDaylight, ..self }
    }

    /// Returns the shaders' way to find colours.
    pub const fn spectrum(self) -> Spectrum {
        self.spectrum
    }

    /// Returns the constants of the shader.
    pub fn constants(self) -> [Constant; 4] {
        let spectrum = match self.spectrum {
            Spectrum::AtRest => 0.0,
            Spectrum::Received => 1.0,
            Spectrum::StreetDaylight => 2.0,
            Spectrum::Map => 3.0,
        };
        [
            ("SPECTRUM", spectrum),
            ("DOPPLER_SHIFT", number(self.doppler_shift)),
            ("INVISIBLE", number(self.invisible)),
            ("FORM", number(self.form)),
        ]
    }
}

/// A constant that a shader leaves open: its name there, and its value.
pub type Constant = (&'static str, f64);

/// Returns a boolean as a shader's constant.
pub fn number(on: bool) -> f64 {
    f64::from(u8::from(on))
}
