//! Light of the street, the house fronts and the sky, as a camera receives it that moves along the street.
//!
//! All of them rest on the ground and reflect daylight. Their paints count as grey: light of the Doppler
//! factor D is daylight as a black body of D times 6504 K, times the paint's linear sRGB at rest. The
//! approximation is called *grey paint*. Of what white paint would reflect in a primary it is off by at most
//! the greatest difference between the paint's own primaries, 0.07 for walls and 0.32 for the sky; a test
//! below holds it against spectra of daylight reflected by smooth paints.
//!
//! The shaders' `received_from_street` and `cpu/packets/street/backdrop.rs` do the same by a row of the
//! tables of `palette.rs`.

use relativity_core::math::{exp2, log2};

use super::tone::{toned, untoned};
use crate::colour::false_colour;
use crate::colour::planck::{DAYLIGHT_KELVIN, black_body};
use crate::view::{Appearance, Colour, StreetColours};

/// Row of `palette.rs` that has grey in daylight that is shifted, its strongest primary as at rest; its
/// logarithm is that of the brightness.
pub(crate) const DAYLIT_ROW: usize = 6;
/// Row of grey in false colours.
pub(crate) const FALSE_ROW: usize = 7;

/// The way from a colour of the street at rest to the colour that is received.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StreetLight {
    tint: Tint,
    /// Weight of log2 of the brightness of shifted daylight: 1 or 0.
    level: f64,
    /// n of the factor D^n, where light is not shifted.
    exponent: f64,
    exposure_ev: f64,
}

/// The change of a colour by a Doppler factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tint {
    /// Nothing but a change of brightness, or nothing at all.
    None,
    /// Daylight, shifted as a black body's light is.
    Daylight,
    /// The false colour of the Doppler factor takes the place of grey.
    False,
}

impl StreetLight {
    /// Colours as they are painted, whatever the motion.
    pub const PAINTED: Self = Self { tint: Tint::None, level: 0.0, exponent: 0.0, exposure_ev: 0.0 };

    /// Returns the light of a street that is seen to move, in a picture with `appearance`.
    pub fn new(appearance: &Appearance) -> Self {
        let Appearance { colour, street, doppler_shift, intensity_exponent, exposure_ev, .. } = *appearance;
        match (street, colour) {
            (StreetColours::Painted, _) => Self::PAINTED,
            (_, Colour::False) => Self { tint: Tint::False, ..Self::PAINTED },
            (StreetColours::Shifted, _) if doppler_shift => Self { tint: Tint::Daylight, ..Self::PAINTED },
            (StreetColours::Shifted, _) => Self::PAINTED,
            (StreetColours::Received, _) if doppler_shift => {
                Self { tint: Tint::Daylight, level: 1.0, exponent: 0.0, exposure_ev }
            }
            (StreetColours::Received, _) => {
                Self { exponent: intensity_exponent.unwrap_or(0.0), exposure_ev, ..Self::PAINTED }
            }
        }
    }

    /// Returns the linear sRGB that is received of a surface of this `colour` (linear sRGB) at
    /// `doppler_factor`.
    pub fn received(&self, colour: [f64; 3], doppler_factor: f64) -> [f64; 3] {
        if *self == Self::PAINTED {
            return colour;
        }
        let octaves = log2(doppler_factor);
        let [red, green, blue, level] = match self.tint {
            Tint::None => [1.0, 1.0, 1.0, 0.0],
            Tint::Daylight => daylit(octaves),
            Tint::False => coloured_false(octaves),
        };
        let log2_factor = self.level * level + self.exponent * octaves + self.exposure_ev;
        // A product that overflows is as bright as can be, not infinite: black times infinity is no number.
        let factor = exp2(log2_factor.clamp(-MOST_LOG2, MOST_LOG2));
        let light = untoned(colour);
        toned([light[0] * red * factor, light[1] * green * factor, light[2] * blue * factor])
    }

    /// Row of the tables from which the shaders take colours; 0 where they stay as painted.
    pub fn row(&self) -> usize {
        match self.tint {
            _ if *self == Self::PAINTED => 0,
            Tint::None | Tint::Daylight => DAYLIT_ROW,
            Tint::False => FALSE_ROW,
        }
    }

    /// Packs the weights of log2 of the Doppler factor, for the place in that row, and of the row's
    /// logarithm, each 1 or 0; n; and log2 of the exposure.
    pub fn packed(&self) -> [f32; 4] {
        let shift = f32::from(u8::from(self.tint != Tint::None));
        [shift, self.level as f32, self.exponent as f32, self.exposure_ev as f32]
    }
}

/// The most that a factor of brightness is, and one over the least, octaves.
const MOST_LOG2: f64 = 100.0;

/// Linear sRGB of grey in daylight that is shifted by `octaves`, its strongest primary as at rest; and log2
/// of its brightness beside that.
///
/// The strongest primary is held and not the luminance: deep red of a white's luminance is beyond what a
/// screen shows, and a street behind a fast rider would lose all its contrast.
pub(crate) fn daylit(octaves: f64) -> [f64; 4] {
    let [at_rest, shifted] = [0.0, octaves].map(|octaves| black_body(log2(DAYLIGHT_KELVIN) + octaves));
    let hue: [f64; 3] = std::array::from_fn(|i| shifted.hue[i] / at_rest.hue[i]);
    let strongest = hue.into_iter().fold(0.0, f64::max);
    let [red, green, blue] = hue.map(|part| part / strongest);
    [red, green, blue, shifted.log2_level - at_rest.log2_level + log2(strongest)]
}

/// Linear sRGB of grey in the false colour of a Doppler factor of 2^`octaves`; and 0.
pub(crate) fn coloured_false(octaves: f64) -> [f64; 4] {
    let [grey, shown] = [0.0, octaves].map(false_colour);
    [shown[0] / grey[0], shown[1] / grey[1], shown[2] / grey[2], 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::ipt::srgb_from_xyz;
    use crate::colour::planck::SECOND_RADIATION_NM_K;
    use crate::colour::{colour_matching, luminance};
    use crate::light::screen_light::Light;
    use crate::scene::body::Emission;

    const PAINTS: [[f64; 3]; 4] =
        [[0.66, 0.635, 0.59], [0.48, 0.62, 0.80], [0.17, 0.20, 0.24], [0.30, 0.24, 0.15]];

    fn light(street: StreetColours) -> StreetLight {
        StreetLight::new(&Appearance { street, exposure_ev: -3.0, ..Appearance::default() })
    }

    #[test]
    fn white_paint_is_a_white_body() {
        let appearance = Appearance {
            colour: Colour::White,
            street: StreetColours::Received,
            exposure_ev: -3.0,
            invisible: false,
            ..Appearance::default()
        };
        let body = Light::new(Emission::WHITE, &appearance);
        let white = Appearance { exposure_ev: 0.0, ..appearance };
        let paint = body.shown(&white, 1.0).colour;
        for doppler_factor in [0.3, 0.7, 1.0, 1.9, 4.36, 19.9] {
            let found = StreetLight::new(&appearance).received(paint, doppler_factor);
            let expected = body.shown(&appearance, doppler_factor).colour;
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9, "D = {doppler_factor}: {found} for {expected}");
            }
        }
    }

    #[test]
    fn shifted_paint_keeps_its_contrast() {
        for doppler_factor in [0.1, 0.5, 1.0, 2.0, 20.0] {
            for grey in [0.02, 0.3, 0.9] {
                let found = light(StreetColours::Shifted).received([grey; 3], doppler_factor);
                let strongest = found.into_iter().fold(0.0, f64::max);
                assert!((strongest / grey - 1.0).abs() < 1e-9, "D = {doppler_factor}: {found:?}");
            }
        }
    }

    #[test]
    fn paint_that_is_not_shifted_is_as_painted() {
        for street in [StreetColours::Painted, StreetColours::Shifted] {
            for paint in PAINTS {
                let found = light(street).received(paint, 1.0);
                assert!(found.iter().zip(paint).all(|(found, paint)| (found - paint).abs() < 1e-12));
            }
        }
    }

    #[test]
    fn no_doppler_factor_gives_a_colour_that_is_none() {
        for exponent in -100..=100 {
            for street in [StreetColours::Shifted, StreetColours::Received] {
                for paint in PAINTS.into_iter().chain([[0.0; 3], [1.0; 3]]) {
                    let shown = light(street).received(paint, exp2(f64::from(exponent)));
                    assert!(shown.into_iter().all(|part| (0.0..=1.0).contains(&part)), "{shown:?}");
                }
            }
        }
    }

    /// Linear sRGB of daylight shifted by `doppler_factor`, which a paint of this linear sRGB reflects
    /// smoothly: three broad bands that overlap, one for each primary.
    fn reflected(paint: [f64; 3], doppler_factor: f64) -> [f64; 3] {
        let bands = [[610.0, 60.0], [545.0, 45.0], [455.0, 40.0]];
        let share = |nm: f64, band: usize| (-0.5 * ((nm - bands[band][0]) / bands[band][1]).powi(2)).exp();
        let mut xyz = [0.0; 3];
        for nm in (380..=780).map(f64::from) {
            let at_rest_nm = (nm * doppler_factor).clamp(380.0, 780.0);
            let total: f64 = (0..3).map(|band| share(at_rest_nm, band)).sum();
            let reflectance: f64 = (0..3).map(|band| paint[band] * share(at_rest_nm, band) / total).sum();
            let kelvin = DAYLIGHT_KELVIN * doppler_factor;
            let power = nm.powi(-5) / (SECOND_RADIATION_NM_K / (nm * kelvin)).exp_m1();
            let matching = colour_matching(nm).expect("inside the table");
            xyz = std::array::from_fn(|i| xyz[i] + reflectance * power * matching[i]);
        }
        srgb_from_xyz(xyz)
    }

    /// The error of grey paint: how far the share of each primary in what is received is from that of smooth
    /// paints in daylight. It is at most the greatest difference between a paint's own primaries, since a
    /// shift only moves these into each other's places; primaries weigh a little light negatively, for which
    /// a hundredth is left.
    #[test]
    fn grey_paint_is_off_smooth_paints_by_no_more_than_their_primaries_differ() {
        for paint in PAINTS {
            let [low, high] = [f64::min, f64::max].map(|end| paint.into_iter().reduce(end).expect("three"));
            let mut worst: f64 = 0.0;
            for doppler_factor in [0.5, 0.7, 1.0, 1.4, 2.0, 4.36] {
                let white = reflected([1.0; 3], doppler_factor);
                let smooth = reflected(paint, doppler_factor);
                for part in (0..3).filter(|&part| white[part] > 0.01 * luminance(white)) {
                    worst = worst.max((smooth[part] / white[part] - paint[part]).abs());
                }
            }
            println!("{paint:?}: at most {worst:.3} of what white paint reflects");
            assert!(worst <= high - low + 0.01, "{paint:?}: {worst}");
        }
    }
}
