//! Composition of one picture from those of two eyes.
//!
//! A mixture gives each of its pixels the weighted sum of red, green, blue and the largest of these of both
//! pictures there, in linear light: an anaglyph or an overlay. Interleaved rows and halves take whole pixels
//! of one or the other. `shaders/compose.wgsl` has the same.
//!
//! # References
//!
//! - E. Dubois, *A projection method to generate anaglyph stereo images*, Proc. IEEE ICASSP 2001, vol. 3,
//!   1661-1664.
//! - E. Dubois, *Conversion of a Stereo Pair to Anaglyph with the Least-Squares Projection Method*
//!   (University of Ottawa, March 2009): the numbers for red-cyan glasses, for linear sRGB; what comes out is
//!   clipped component by component.

use std::array::from_fn;
use std::sync::LazyLock;

use bytemuck::{Pod, Zeroable};

use super::pixels::{Picture, encoded};
use crate::colour::{hue_preserving_clip, srgb_decoded};
use crate::view::effects::{Constant, number};

/// A way to compose two pictures of one size, the first and the second, into one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Composition {
    /// Anaglyph: the largest component of the first in red, of the second in green and blue. This measures
    /// brightness where one wavelength fills the picture, and so no colour is lost behind the glasses.
    Anaglyph,
    /// For red-cyan glasses, by least squares: what the eyes see behind them is as near to the colours as can
    /// be.
    Dubois,
    /// The largest component of each in a colour of its own (sRGB-encoded), added; hues are kept where that
    /// is too bright.
    Overlay([[u8; 3]; 2]),
    /// Rows of the first and of the second in turn.
    Rows {
        /// Picture of the topmost row.
        top: Top,
    },
    /// The first squeezed into the left half and the second into the right one: pairs of columns averaged in
    /// linear light.
    HalfSideBySide,
    /// The first squeezed into the upper half and the second into the lower one: pairs of rows averaged in
    /// linear light.
    HalfOverUnder,
}

/// The picture that interleaved rows begin with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Top {
    /// With one of the first picture.
    #[default]
    First,
    /// With one of the second.
    Second,
}

/// Weights of red, green, blue and the largest of them in each component.
type Weights = [[f64; 4]; 3];

/// Dubois' least-squares matrices for red-cyan glasses, of the left and the right eye, as published: to three
/// decimals.
const DUBOIS: [[[f64; 3]; 3]; 2] = [
    [[0.437, 0.449, 0.164], [-0.062, -0.062, -0.024], [-0.048, -0.050, -0.017]],
    [[-0.011, -0.032, -0.007], [0.377, 0.761, 0.009], [-0.026, -0.093, 1.234]],
];

/// Components of pixels in linear light.
static LINEAR: LazyLock<[f64; 256]> = LazyLock::new(|| from_fn(|level| srgb_decoded(level as f64 / 255.0)));

impl Composition {
    /// Width and height of what is made of pictures of `size`, pixels: the same, but halves are of one size.
    #[must_use]
    pub const fn size(self, [width, height]: [u32; 2]) -> [u32; 2] {
        match self {
            Self::HalfSideBySide => [2 * width.div_ceil(2), height],
            Self::HalfOverUnder => [width, 2 * height.div_ceil(2)],
            _ => [width, height],
        }
    }

    /// The picture that is made of the first and the second of `pictures`, which have one size.
    #[must_use]
    pub fn picture(self, pictures: [&Picture; 2]) -> Picture {
        let size = self.size(pictures[0].size);
        let [width, height] = size.map(|side| side as usize);
        let weights = self.weights();
        let pixel = |column: usize, row: usize| match self {
            Self::Anaglyph | Self::Dubois | Self::Overlay(_) => {
                let mixed = mixed(&weights, pictures.map(|picture| at(picture, column, row)));
                encoded(if self.keeps_hue() { hue_preserving_clip(mixed) } else { clipped(mixed) })
            }
            Self::Rows { top } => at(pictures[(row + top as usize) % 2], column, row),
            Self::HalfSideBySide => {
                let half = width / 2;
                let [column, picture] = [column % half, column / half];
                mean([2 * column, 2 * column + 1].map(|column| at(pictures[picture], column, row)))
            }
            Self::HalfOverUnder => {
                let half = height / 2;
                let [row, picture] = [row % half, row / half];
                mean([2 * row, 2 * row + 1].map(|row| at(pictures[picture], column, row)))
            }
        };
        Picture { size, rgba: (0..width * height).map(|i| pixel(i % width, i / width)).collect() }
    }

    /// The weights of both pictures' colours in those of a mixture.
    fn weights(self) -> [Weights; 2] {
        let of_largest = |colour: [f64; 3]| colour.map(|part| [0.0, 0.0, 0.0, part]);
        match self {
            Self::Anaglyph => [of_largest([1.0, 0.0, 0.0]), of_largest([0.0, 1.0, 1.0])],
            Self::Dubois => dubois().map(|matrix| matrix.map(|[r, g, b]| [r, g, b, 0.0])),
            Self::Overlay(colours) => colours.map(|colour| of_largest(linear(colour))),
            Self::Rows { .. } | Self::HalfSideBySide | Self::HalfOverUnder => [[[0.0; 4]; 3]; 2],
        }
    }

    /// Whether a mixture that is too bright is darkened, not clipped.
    const fn keeps_hue(self) -> bool {
        matches!(self, Self::Overlay(_))
    }

    /// The variant of the shader that draws it.
    pub(crate) const fn form(self) -> ComposeVariant {
        match self {
            Self::Anaglyph | Self::Dubois => ComposeVariant::Clipped,
            Self::Overlay(_) => ComposeVariant::HueKept,
            Self::Rows { .. } => ComposeVariant::Rows,
            Self::HalfSideBySide => ComposeVariant::HalvesBeside,
            Self::HalfOverUnder => ComposeVariant::HalvesAbove,
        }
    }

    /// Returns the parameters of the shader.
    pub(crate) fn composing(self) -> Composing {
        let top = if let Self::Rows { top } = self { top as u32 } else { 0 };
        let [first, second] =
            self.weights().map(|weights| weights.map(|row| row.map(|weight| weight as f32)));
        Composing { first, second, top: [top, 0, 0, 0] }
    }
}

/// Mirror of the shader's `Composing`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Composing {
    /// Weights of the first picture's red, green, blue and largest component in those of a mixture.
    pub first: [[f32; 4]; 3],
    /// Weights of the second picture.
    pub second: [[f32; 4]; 3],
    /// `top[0]`: which picture the topmost of interleaved rows comes from; the rest is padding.
    pub top: [u32; 4],
}

/// A variant of the shader. It is a pipeline constant because Mesa's software GPU recompiles a shader for
/// every new value of a uniform that it branches on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ComposeVariant {
    /// A mixture, clipped component by component.
    Clipped,
    /// A mixture that keeps its hue.
    HueKept,
    /// Rows of both in turn.
    Rows,
    /// Two halves beside each other.
    HalvesBeside,
    /// Two halves one above the other.
    HalvesAbove,
}

impl ComposeVariant {
    /// Values of the pipeline constants that select this variant.
    pub(crate) fn constants(self) -> [Constant; 4] {
        let of = |name, form| (name, number(self == form));
        [
            of("HUE_KEPT", Self::HueKept),
            of("BY_ROWS", Self::Rows),
            of("HALVES_BESIDE", Self::HalvesBeside),
            of("HALVES_ABOVE", Self::HalvesAbove),
        ]
    }
}

/// Dubois' matrices, so that what is grey in both pictures stays as it is: rounded as they are published, the
/// weights of green sum to 0.999. Each component's are divided by their sum.
fn dubois() -> [[[f64; 3]; 3]; 2] {
    let sum: [f64; 3] = from_fn(|row| DUBOIS.iter().flat_map(|matrix| matrix[row]).sum());
    DUBOIS.map(|matrix| from_fn(|row| matrix[row].map(|weight| weight / sum[row])))
}

/// The weighted sum of a pixel of both pictures, in linear light.
fn mixed(weights: &[Weights; 2], pixels: [[u8; 4]; 2]) -> [f64; 3] {
    let colours = pixels.map(|[r, g, b, _]| {
        let [red, green, blue] = linear([r, g, b]);
        [red, green, blue, red.max(green).max(blue)]
    });
    let sum = |weights: &[f64; 4], colour: &[f64; 4]| -> f64 {
        weights.iter().zip(colour).map(|(weight, part)| weight * part).sum()
    };
    from_fn(|part| sum(&weights[0][part], &colours[0]) + sum(&weights[1][part], &colours[1]))
}

fn clipped(linear: [f64; 3]) -> [f64; 3] {
    linear.map(|part| part.clamp(0.0, 1.0))
}

fn mean(pixels: [[u8; 4]; 2]) -> [u8; 4] {
    let [a, b] = pixels.map(|[r, g, b, _]| linear([r, g, b]));
    encoded(from_fn(|part| 0.5 * (a[part] + b[part])))
}

fn linear(encoded: [u8; 3]) -> [f64; 3] {
    encoded.map(|part| LINEAR[usize::from(part)])
}

/// The pixel there, or the nearest at the edge.
fn at(picture: &Picture, column: usize, row: usize) -> [u8; 4] {
    let [width, height] = picture.size.map(|side| side as usize);
    picture.rgba[row.min(height - 1) * width + column.min(width - 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(rgb: [u8; 3]) -> Picture {
        let [r, g, b] = rgb;
        Picture { size: [1, 1], rgba: vec![[r, g, b, u8::MAX]] }
    }

    fn composed(composition: Composition, left: [u8; 3], right: [u8; 3]) -> [u8; 4] {
        composition.picture([&one(left), &one(right)]).rgba[0]
    }

    #[test]
    fn the_rows_of_both_dubois_matrices_sum_to_1() {
        let [left, right] = dubois();
        for part in 0..3 {
            let sum: f64 = left[part].iter().chain(&right[part]).sum();
            assert!((sum - 1.0).abs() < 1e-15, "{part}: {sum}");
        }
        // No weight moved by more than it is published to.
        for (ours, published) in dubois().iter().flatten().flatten().zip(DUBOIS.iter().flatten().flatten()) {
            assert!((ours - published).abs() < 1e-3, "{ours} for {published}");
        }
    }

    #[test]
    fn grey_stays_grey_in_every_mixture_for_glasses() {
        for level in [0, 1, 17, 128, 200, 255] {
            for composition in [Composition::Anaglyph, Composition::Dubois] {
                let grey = [level; 3];
                assert_eq!(composed(composition, grey, grey), [level, level, level, 255], "{composition:?}");
            }
        }
    }

    #[test]
    fn dubois_mixes_linear_light() {
        // By hand: red of the left eye alone, half as bright as full.
        let [r, g, b, _] = composed(Composition::Dubois, [188, 0, 0], [0, 0, 0]);
        let expected = 0.437 * srgb_decoded(188.0 / 255.0);
        assert!((srgb_decoded(f64::from(r) / 255.0) - expected).abs() < 0.004 && g == 0 && b == 0);
        // Green to both: (0.761 - 0.062)/0.999 of linear light is 218 of 255 levels.
        assert_eq!(composed(Composition::Dubois, [0, 255, 0], [0, 255, 0])[1], 218);
    }

    #[test]
    fn an_anaglyph_has_the_largest_components_to_the_last_level() {
        for level in 0..=255 {
            assert_eq!(
                composed(Composition::Anaglyph, [3, level.max(3), 0], [level, 0, 0]),
                [level.max(3), level, level, 255]
            );
        }
    }

    #[test]
    fn rows_and_halves_take_turns() {
        let picture =
            |base: u8| Picture { size: [3, 3], rgba: (0..9).map(|i| [base + i, base, base, 255]).collect() };
        let (first, second) = (picture(0), picture(100));
        let reds = |composition: Composition| -> (Vec<u8>, [u32; 2]) {
            let made = composition.picture([&first, &second]);
            (made.rgba.iter().map(|pixel| pixel[0]).collect(), made.size)
        };
        let rows = |top| reds(Composition::Rows { top }).0;
        assert_eq!(rows(Top::First), [0, 1, 2, 103, 104, 105, 6, 7, 8]);
        assert_eq!(rows(Top::Second), [100, 101, 102, 3, 4, 5, 106, 107, 108]);
        let (beside, size) = reds(Composition::HalfSideBySide);
        assert_eq!(size, [4, 3]);
        // Of an odd number of columns the last stands for itself.
        assert_eq!([beside[1], beside[3], beside[5]], [2, 102, 5]);
        assert!((100..=101).contains(&beside[2]));
        let (above, size) = reds(Composition::HalfOverUnder);
        assert_eq!((size, &above[3..6], &above[9..]), ([3, 4], &[6, 7, 8][..], &[106, 107, 108][..]));
    }

    #[test]
    fn halves_average_light_and_not_its_encoding() {
        let picture = Picture { size: [2, 1], rgba: vec![[0, 0, 0, 255], [255, 255, 255, 255]] };
        let made = Composition::HalfSideBySide.picture([&picture, &picture]);
        assert_eq!(made.rgba, vec![[188, 188, 188, 255]; 2]);
    }
}
