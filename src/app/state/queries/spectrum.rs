//! The spectrum of the selected point: as its light leaves, and as each eye receives it.

use relativity_core::math;
use relativity_render::colour::srgb_level;
use relativity_render::{Appearance, Facing, FallingDaylight, Light, Paint};

use crate::app::state::State;
use crate::app::state::document::Document;
use crate::eye::Eye;

/// Wavelengths among which the peak of a spectrum is looked for, nm, and the number of them.
const SEARCHED_NM: [f64; 2] = [10.0, 1e6];
const SEARCHED: u32 = 4000;

/// The light of a point as it leaves and arrives.
#[derive(Debug, Clone, Copy)]
pub struct PointLight {
    /// The point's light at rest.
    pub light: Light,
    /// Received over emitted frequency for each eye: 1 where the picture shows no shift, `None` where nothing
    /// is seen.
    pub doppler_factors: [Option<f64>; 2],
    appearance: Appearance,
    /// Motion of the point through the street's daylight, if that lights it, when its light leaves for each
    /// eye.
    facings: [Option<Facing>; 2],
}

impl PointLight {
    /// Returns this `light`, received with these factors and shown with `appearance`.
    #[must_use]
    pub fn new(light: Light, doppler_factors: [Option<f64>; 2], appearance: Appearance) -> Self {
        let shifted = |factor: f64| if appearance.doppler_shift { factor } else { 1.0 };
        let doppler_factors = doppler_factors.map(|factor| factor.map(shifted));
        Self { light, doppler_factors, appearance, facings: [None, None] }
    }

    /// Returns the colour that the picture shows of what leaves for `eye`, or would at rest, and is received
    /// with this factor: sRGB, where it faces the light.
    #[must_use]
    pub fn colour(&self, eye: Option<Eye>, doppler_factor: f64) -> [u8; 3] {
        let facing = eye.and_then(|eye| self.facings[eye.index()]);
        let shown = self.light.shown_facing(&self.appearance, doppler_factor, facing, Paint::WHITE);
        shown.colour.map(srgb_level)
    }

    /// Returns the colour that `eye` sees, sRGB; `None` where it sees nothing.
    #[must_use]
    pub fn seen_by(&self, eye: Eye) -> Option<[u8; 3]> {
        Some(self.colour(Some(eye), self.doppler_factors[eye.index()]?))
    }
}

/// The spectrum of a point's light.
#[derive(Debug, Clone)]
pub struct PointSpectrum {
    /// The light whose spectrum it is.
    pub of: PointLight,
    /// Greatest radiance of the light at rest; `None` of light without a spectrum.
    peak: Option<f64>,
    /// The street's daylight on the point, if it moves through that, when its light leaves for each eye.
    lit: [Option<Lit>; 2],
}

/// The street's daylight on the surface at a point that moves through it.
#[derive(Debug, Clone)]
struct Lit {
    daylight: FallingDaylight,
    /// Greatest radiance of what it sends.
    peak: Option<f64>,
}

impl PointSpectrum {
    /// The spectrum of this light.
    #[must_use]
    pub fn new(of: PointLight) -> Self {
        let lit = |facing: Facing| {
            let daylight = facing.daylight();
            Lit { peak: peak(of.light, Some(&daylight)), daylight }
        };
        let left = of.facings[0].map(lit);
        let right = if of.facings[1] == of.facings[0] { left.clone() } else { of.facings[1].map(lit) };
        Self { of, peak: peak(of.light, None), lit: [left, right] }
    }

    /// The eyes for which light leaves that differs: none of a point that is lit as at rest.
    #[must_use]
    pub fn eyes_apart(&self) -> &'static [Eye] {
        match self.of.facings {
            [None, None] => &[],
            [left, right] if left == right => &Eye::BOTH[..1],
            _ => &Eye::BOTH,
        }
    }

    /// Returns the Doppler factor with which the point receives the street's daylight on average, when its
    /// light leaves for `eye`: power over photons, both relative to rest. `None` where it is lit as at rest.
    #[must_use]
    pub fn falls_with(&self, eye: Eye) -> Option<f64> {
        Some(math::exp2(self.of.facings[eye.index()]?.mean_octaves()))
    }

    fn lit_for(&self, eye: Option<Eye>) -> Option<&Lit> {
        self.lit[eye?.index()].as_ref()
    }

    /// Returns the radiance per wavelength of light received with this Doppler factor at a wavelength, nm, as
    /// a multiple of the peak at rest: D⁵ L(λD). The light is what leaves for `eye`, or would leave at rest.
    /// `None` of light without a spectrum.
    #[must_use]
    pub fn received(&self, eye: Option<Eye>, doppler_factor: f64, nm: f64) -> Option<f64> {
        Some(self.sent(eye, nm * doppler_factor)? / self.peak? * times_as_bright(doppler_factor))
    }

    /// Returns the same as a multiple of its own peak: the spectrum as it leaves, D times as far to the left.
    #[must_use]
    pub fn of_own_peak(&self, eye: Option<Eye>, doppler_factor: f64, nm: f64) -> Option<f64> {
        let peak = self.lit_for(eye).map_or(self.peak, |lit| lit.peak)?;
        Some(self.sent(eye, nm * doppler_factor)? / peak)
    }

    /// The radiance that is sent to `eye`, or would be at rest.
    fn sent(&self, eye: Option<Eye>, nm: f64) -> Option<f64> {
        self.of.light.radiance(nm, self.lit_for(eye).map(|lit| &lit.daylight))
    }
}

/// Returns the greatest radiance of `light` where daylight is `falling` so; `None` of none.
fn peak(light: Light, falling: Option<&FallingDaylight>) -> Option<f64> {
    let ratio = math::log2(SEARCHED_NM[1] / SEARCHED_NM[0]) / f64::from(SEARCHED);
    let searched = (0..=SEARCHED).map(|step| SEARCHED_NM[0] * math::exp2(ratio * f64::from(step)));
    searched.filter_map(|nm| light.radiance(nm, falling)).reduce(f64::max).filter(|peak| *peak > 0.0)
}

/// Returns the factor between the radiances, per wavelength, that are received and emitted at the same part
/// of a spectrum: D⁵.
#[must_use]
pub fn times_as_bright(doppler_factor: f64) -> f64 {
    math::powf(doppler_factor, 5.0)
}

impl State {
    /// Returns the light of the selected point now, as a picture in a light or a dark window shows it.
    #[must_use]
    pub fn point_light(&self, light_window: bool) -> PointLight {
        let appearance = self.appearance(light_window);
        let Document { points, prepared, scene, .. } = &self.document;
        let point = points.selected();
        let light = Light::new(self.emission(point), &appearance);
        let facing = |eye| {
            let view = self.view(eye, self.frame.picture.size);
            prepared.facing_at(&view, &appearance, point.body_in(scene)?, point.track.point())
        };
        let is_lit = matches!(light, Light::Painted(_));
        let facings = if is_lit { Eye::BOTH.map(facing) } else { [None, None] };
        PointLight { facings, ..PointLight::new(light, self.moment().doppler_factors(), appearance) }
    }
}

#[cfg(test)]
mod tests {
    use relativity_core::doppler::{intensity_factor, received_wavelength};
    use relativity_render::{Emission, Material, Paint};

    use super::*;

    fn spectrum(emission: Emission) -> PointSpectrum {
        let appearance = Appearance::default();
        let appearance = Appearance { colour: relativity_render::Colour::White, ..appearance };
        PointSpectrum::new(PointLight::new(Light::new(emission, &appearance), [Some(1.0); 2], appearance))
    }

    fn spectra() -> impl Iterator<Item = PointSpectrum> {
        let paints = [Paint::Smooth([0.6, 0.1, 0.05]), Paint::Measured(Material::ALL[3])];
        paints.map(Emission::Painted).into_iter().chain([Emission::Glowing(2700.0)]).map(spectrum)
    }

    /// The sum over wavelengths of what is received is D⁴ of what is emitted, as that of any light is.
    #[test]
    fn all_that_is_received_is_d_to_the_fourth_of_what_is_emitted() {
        let total = |of: &dyn Fn(f64) -> f64| -> f64 {
            let step = math::log2(1e6 / 10.0) / 40_000.0;
            let nm = |step_number: u32| 10.0 * math::exp2(step * f64::from(step_number));
            (0..40_000).map(|number| of(nm(number)) * nm(number)).sum()
        };
        for spectrum in spectra() {
            for factor in [0.3, 0.8, 1.0, 1.7, 3.2] {
                let [emitted, received] = [1.0, factor]
                    .map(|factor| total(&|nm| spectrum.received(None, factor, nm).expect("a spectrum")));
                let expected = intensity_factor(factor, 4.0);
                assert!((received / emitted / expected - 1.0).abs() < 2e-3, "{received} {emitted} {factor}");
            }
        }
    }

    /// The second method is the core's formula for the received wavelength.
    #[test]
    fn the_received_spectrum_is_the_emitted_one_at_the_wavelengths_of_the_core() {
        for spectrum in spectra() {
            for factor in [0.2, 0.9, 1.5, 4.0] {
                for nm in [310.0, 550.0, 720.0, 1600.0] {
                    let emitted = spectrum.of_own_peak(None, 1.0, nm).expect("a spectrum");
                    let received = spectrum.of_own_peak(None, factor, received_wavelength(nm, factor));
                    assert!((received.expect("a spectrum") - emitted).abs() < 1e-9, "{nm} {factor}");
                }
            }
        }
    }

    /// The published peak of a black body, 2.897771955e6 nm K / T, and of sunlight, 451 nm (ASTM G173-03).
    #[test]
    fn peaks_are_where_they_are_known_to_be() {
        let at_peak =
            |spectrum: &PointSpectrum, nm: f64| spectrum.of_own_peak(None, 1.0, nm).expect("a spectrum");
        let glowing = spectrum(Emission::Glowing(2700.0));
        let peak = 2.897_771_955e6 / 2700.0;
        assert!((at_peak(&glowing, peak) - 1.0).abs() < 1e-5, "{}", at_peak(&glowing, peak));
        assert!(at_peak(&glowing, 0.9 * peak) < 0.99 && at_peak(&glowing, 1.1 * peak) < 0.99);
        let white = spectrum(Emission::WHITE);
        assert!(
            at_peak(&white, 451.0) > 0.9 && at_peak(&white, 310.0) < 0.1 && at_peak(&white, 1400.0) < 0.01
        );
    }

    #[test]
    fn light_of_one_wavelength_has_no_spectrum() {
        let appearance = Appearance::default();
        let light = Light::new(Emission::Wavelength(550.0), &appearance);
        let spectrum = PointSpectrum::new(PointLight::new(light, [Some(2.0), None], appearance));
        assert_eq!(light, Light::Line(550.0));
        assert_eq!(
            (spectrum.received(None, 2.0, 275.0), spectrum.of_own_peak(None, 1.0, 550.0)),
            (None, None)
        );
    }
}
