//! Which effects a picture has, as far as they choose a pipeline: what is off is not computed.

use crate::view::{Appearance, Shading};

/// The effects of `colour.wgsl`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Effects {
    doppler_shift: bool,
    intensity: Intensity,
    form: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Intensity {
    Off,
    Integer(u8),
    Real,
}

impl Effects {
    /// None at all.
    pub const NONE: Self = Self { doppler_shift: false, intensity: Intensity::Off, form: false };

    /// Those of `appearance`; without a Doppler effect (D = 1) what depends on it is off.
    pub fn new(has_doppler_effect: bool, appearance: &Appearance) -> Self {
        let intensity = match appearance.intensity_exponent.filter(|_| has_doppler_effect) {
            None => Intensity::Off,
            Some(n) if [2.0, 3.0, 4.0].contains(&n) => Intensity::Integer(n as u8),
            Some(_) => Intensity::Real,
        };
        let form = match appearance.shading {
            Shading::Emission => false,
            Shading::Form => true,
        };
        Self { doppler_shift: appearance.doppler_shift && has_doppler_effect, intensity, form }
    }

    /// The shader's constants.
    pub fn constants(self) -> [Constant; 3] {
        let intensity = match self.intensity {
            Intensity::Off => 0.0,
            Intensity::Integer(n) => f64::from(n),
            Intensity::Real => 1.0,
        };
        [("DOPPLER_SHIFT", number(self.doppler_shift)), ("INTENSITY", intensity), ("FORM", number(self.form))]
    }
}

/// A constant that a shader leaves open: its name there, and its value.
pub type Constant = (&'static str, f64);

/// A boolean constant.
pub fn number(on: bool) -> f64 {
    f64::from(u8::from(on))
}
