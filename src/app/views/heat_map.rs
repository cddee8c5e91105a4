//! Colours for how far a picture is off, pixel by pixel.

use std::ops::RangeInclusive;

use colorous::VIRIDIS;
use eframe::egui::{Color32, ColorImage};
use relativity_core::math;
use serde::{Deserialize, Serialize};

use crate::accuracy::{ARCSECONDS, Difference, PixelDifference};
use crate::app::tools::image;

/// Powers of ten of a pixel, from the darkest to the brightest colour.
pub const DECADES: RangeInclusive<f64> = -8.0..=0.0;
/// Colour of places where another body is seen.
pub const WRONG_BODY: Color32 = Color32::from_rgb(0xFF, 0x38, 0x60);
/// Colour of places where nothing is seen: the picture shows through.
const NOTHING: Color32 = Color32::from_black_alpha(170);

/// The colour of 10 to this power of a pixel.
#[must_use]
pub fn colour(decade: f64) -> Color32 {
    let (first, last) = DECADES.into_inner();
    let colorous::Color { r, g, b } =
        VIRIDIS.eval_continuous(((decade - first) / (last - first)).clamp(0.0, 1.0));
    Color32::from_rgb(r, g, b)
}

/// The error of a picture, pixel by pixel, in colours.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct HeatMap {
    /// Width and height, pixels.
    size: [u32; 2],
    /// Red, green, blue (sRGB-encoded) and opacity of each pixel, row by row from the top left.
    rgba: Vec<[u8; 4]>,
}

impl HeatMap {
    /// The map of `difference`, whose pictures have `pixels_per_radian` at their centre.
    #[must_use]
    pub fn new(difference: &Difference, pixels_per_radian: f64) -> Self {
        let colours = difference.pixels.iter().map(|pixel| match *pixel {
            PixelDifference::Nothing => NOTHING,
            PixelDifference::WrongBody => WRONG_BODY,
            PixelDifference::SameBody { arcseconds, .. } => {
                colour(math::log10(arcseconds / ARCSECONDS * pixels_per_radian))
            }
        });
        let rgba = colours.map(|colour| colour.to_srgba_unmultiplied()).collect();
        Self { size: difference.size, rgba }
    }

    /// Returns the map as an image for the window.
    #[must_use]
    pub fn image(&self) -> ColorImage {
        image::of_pixels(self.size, &self.rgba)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::DifferenceFigures;

    #[test]
    fn every_kind_of_pixel_has_its_colour() {
        let seen = |arcseconds| PixelDifference::SameBody { arcseconds, doppler: 0.0 };
        let pixels_per_radian = 100.0;
        let one_pixel = ARCSECONDS / pixels_per_radian;
        let pixels = vec![
            PixelDifference::Nothing,
            PixelDifference::WrongBody,
            seen(one_pixel),
            seen(0.0),
            seen(f64::NAN),
        ];
        let figures = DifferenceFigures {
            covered_pixels: 4,
            wrong_pixels: 1,
            wrong_pixels_off_outlines: 0,
            line_of_sight_arcseconds: None,
            doppler_relative: None,
        };
        let map = HeatMap::new(&Difference { size: [5, 1], pixels, figures }, pixels_per_radian);
        let (image, darkest, brightest) = (map.image(), colour(-8.0), colour(0.0));
        assert_eq!(image.size, [5, 1]);
        assert_eq!(image.pixels[..4], [NOTHING, WRONG_BODY, brightest, darkest]);
        assert!(image.pixels[4].is_opaque());
    }
}
