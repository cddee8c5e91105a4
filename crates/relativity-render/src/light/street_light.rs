//! Light of the street, the house fronts and the sky, as a camera receives it that moves along the street.
//!
//! All of them rest on the ground and reflect daylight as smooth paint: light of the Doppler factor D is that
//! of [`sunlit`], whose colours are linear in those at rest, so that mixtures of paints in a pixel stay
//! exact. The sky, and the haze before what is far, shine with the sky's own spectrum instead, as far as it
//! is in their colour.
//!
//! The shaders' `received_from_street` and `cpu/packets/street/backdrop.rs` do the same by rows of the tables
//! of `palette.rs`.

use relativity_core::math::{exp2, log2};

use super::palette::{FIRST_SUNLIT, Row, coloured_false};
use super::tone::{toned, untoned};
use crate::colour::paint::Paint;
use crate::colour::sunlit::{self, on_screen};
use crate::view::{Appearance, Colour, StreetColours};

/// Row of `palette.rs` that has red paint in daylight, before those of green and of blue paint.
pub(crate) const DAYLIT_ROW: usize = FIRST_SUNLIT;
/// Row of grey in false colours.
pub(crate) const FALSE_ROW: usize = Row::FalseGrey.number();

/// A colour of paint at rest, linear sRGB, which holds none of the sky's light.
pub(crate) const fn painted([red, green, blue]: [f64; 3]) -> [f64; 4] {
    [red, green, blue, 0.0]
}

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
    /// Daylight, which smooth paint reflects.
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

    /// Returns the linear sRGB that is received, at `doppler_factor`, of what has this colour at rest: linear
    /// sRGB, and the [share of the sky's light](sunlit::share_of_sky) in it.
    pub fn received(&self, at_rest: [f64; 4], doppler_factor: f64) -> [f64; 3] {
        if *self == Self::PAINTED {
            let [red, green, blue, _] = at_rest;
            return [red, green, blue];
        }
        let octaves = log2(doppler_factor);
        let [red, green, blue, sky] = untoned(at_rest);
        let light = [red, green, blue];
        let (light, level) = match self.tint {
            Tint::None => (light, 0.0),
            Tint::Daylight => {
                let [paint, beside] =
                    [sunlit::colour(Paint::Smooth(light), octaves), sunlit::sky_beside_paint(octaves)];
                (std::array::from_fn(|part| paint[part] + sky * beside[part]), sunlit::log2_level(octaves))
            }
            Tint::False => {
                let grey = coloured_false(octaves);
                (std::array::from_fn(|part| light[part] * grey[part]), 0.0)
            }
        };
        let log2_factor = self.level * level + self.exponent * octaves + self.exposure_ev;
        // A product that overflows is as bright as can be, not infinite: black times infinity is no number.
        let factor = exp2(log2_factor.clamp(-MOST_LOG2, MOST_LOG2));
        toned(on_screen(light.map(|part| part * factor)))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::luminance;
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
            let found = StreetLight::new(&appearance).received(painted(paint), doppler_factor);
            let expected = body.shown(&appearance, doppler_factor).colour;
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9, "D = {doppler_factor}: {found} for {expected}");
            }
        }
    }

    /// Sunlight begins at 280 nm, which is received as 700 nm at D = 0.4.
    #[test]
    fn white_is_dark_where_sunlight_has_ended() {
        for doppler_factor in [0.05, 0.1, 0.39] {
            let found = light(StreetColours::Shifted).received(painted([1.0; 3]), doppler_factor);
            assert!(found.iter().all(|part| *part < 1e-3), "D = {doppler_factor}: {found:?}");
        }
    }

    #[test]
    fn shifted_paint_keeps_its_contrast() {
        for doppler_factor in [0.5, 1.0, 2.0, 20.0] {
            for grey in [0.02, 0.3, 0.9] {
                let found = light(StreetColours::Shifted).received(painted([grey; 3]), doppler_factor);
                let strongest = found.into_iter().fold(0.0, f64::max);
                assert!((strongest / grey - 1.0).abs() < 1e-9, "D = {doppler_factor}: {found:?}");
            }
        }
    }

    #[test]
    fn paint_that_is_not_shifted_is_as_painted() {
        for street in [StreetColours::Painted, StreetColours::Shifted] {
            for paint in PAINTS {
                let found = light(street).received(painted(paint), 1.0);
                assert!(found.iter().zip(paint).all(|(found, paint)| (found - paint).abs() < 1e-12));
            }
        }
    }

    /// Skylight has little infrared, so ahead it is bluer and darker than paint of its colour.
    #[test]
    fn the_sky_is_darker_than_paint_ahead() {
        let light = light(StreetColours::Shifted);
        let [red, green, blue] = [0.0556, 0.0668, 0.1];
        let sky = |doppler_factor| light.received([red, green, blue, 0.1], doppler_factor);
        let paint = |doppler_factor| light.received(painted([red, green, blue]), doppler_factor);
        assert!(sky(1.0).iter().zip([red, green, blue]).all(|(found, rest)| (found - rest).abs() < 1e-9));
        for doppler_factor in [1.3, 1.7, 2.5, 4.0] {
            let [sky, paint] = [sky(doppler_factor), paint(doppler_factor)];
            assert!(luminance(sky) < luminance(paint), "{sky:?} {paint:?}");
            assert!(sky[0] / sky[2] < paint[0] / paint[2], "{sky:?} {paint:?}");
        }
    }

    #[test]
    fn no_doppler_factor_gives_a_colour_that_is_none() {
        for exponent in -100..=100 {
            for street in [StreetColours::Shifted, StreetColours::Received] {
                for paint in PAINTS.into_iter().chain([[0.0; 3], [1.0; 3]]) {
                    let shown = light(street).received(painted(paint), exp2(f64::from(exponent)));
                    assert!(shown.into_iter().all(|part| (0.0..=1.0).contains(&part)), "{shown:?}");
                }
            }
        }
    }
}
