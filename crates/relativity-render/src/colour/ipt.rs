//! Hue as people see it, in the colour space IPT, and the way of a colour that a screen cannot show into what
//! it can.
//!
//! Adding white to a colour, or dimming it, keeps its hue in IPT nearly as well as people judge it; on the
//! straight line to white in linear sRGB the red end of the spectrum would turn pink.
//!
//! Reference: F. Ebner and M. D. Fairchild, *Development and testing of a color space (IPT) with improved hue
//! uniformity*, IS&T/SID Sixth Color Imaging Conference, 8-13 (1998).

use std::f64::consts::TAU;
use std::sync::LazyLock;

use relativity_core::math::{atan2, powf};

/// To the responses of the three kinds of cones, 1 each for white (D65).
const CONES_FROM_XYZ: [[f64; 3]; 3] =
    [[0.4002, 0.7075, -0.0807], [-0.2280, 1.1500, 0.0612], [0.0, 0.0, 0.9184]];
/// Exponent that compresses the responses.
const COMPRESSION: f64 = 0.43;
/// From compressed responses to the two opponent colours: P, red against green, and T, yellow against blue.
const OPPONENTS: [[f64; 3]; 2] = [[4.4550, -4.8510, 0.3960], [0.8056, 0.3572, -1.1628]];
/// Of red, green and blue: over how much of another component, in linear light, the two that are least take
/// over from each other. Without it green would leave 0 with a corner beside the purest blue, which the sRGB
/// curve shows as a jump of 107 of 255 levels between 453 nm and 454 nm.
const ROUNDINGS: [f64; 3] = [0.02, 0.06, 0.08];
/// Halvings after which a place on an edge is known to 2e-11.
const HALVINGS: u32 = 37;

/// Hue angle of a CIE XYZ colour, radians in (-pi, pi]; it does not depend on the brightness.
pub fn hue(xyz: [f64; 3]) -> f64 {
    let compressed = CONES_FROM_XYZ.map(|row| {
        let response = dot(row, xyz);
        response.signum() * powf(response.abs(), COMPRESSION)
    });
    let [p, t] = OPPONENTS.map(|row| dot(row, compressed));
    atan2(t, p)
}

/// Linear sRGB of a CIE XYZ colour as a screen shows it, the largest component 1: a colour that is too pure
/// for the screen moves towards neutral, at its hue and as bright as before.
pub fn in_gamut(xyz: [f64; 3]) -> [f64; 3] {
    let purest = purest_srgb(hue(xyz));
    let linear = srgb_from_xyz(xyz);
    let [least, largest] = [f64::min, f64::max].map(|of| linear.into_iter().fold(linear[0], of));
    let is_inside = largest > 0.0 && least / largest >= purest.into_iter().fold(1.0, f64::min);
    if is_inside { linear.map(|part| part / largest) } else { purest }
}

/// The purest linear sRGB colour of this `hue` that is shown: its largest component is 1, its least at most
/// 0.04. From hue to hue it changes without a corner.
pub fn purest_srgb(hue: f64) -> [f64; 3] {
    // No primary's part of the circle spans half a turn.
    static STARTS: LazyLock<[f64; 3]> =
        LazyLock::new(|| [0, 1, 2].map(|primary| srgb_hue(about(primary, -1.0))));
    let turn = |hue: f64, primary: usize| (hue - STARTS[primary]).rem_euclid(TAU);
    let primary = (0..3).min_by(|&a, &b| turn(hue, a).total_cmp(&turn(hue, b))).unwrap_or_default();
    let sought = turn(hue, primary);
    let mut span = [-1.0, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (span[0] + span[1]);
        let is_before = turn(srgb_hue(about(primary, middle)), primary) < sought;
        span[usize::from(!is_before)] = middle;
    }
    about(primary, span[0])
}

/// The colour at `place` of those about this primary (0 red, 1 green, 2 blue): at -1 as much of the one
/// before is in it, at 1 of the one after.
fn about(primary: usize, place: f64) -> [f64; 3] {
    let rounding = ROUNDINGS[primary];
    let rounded = |x: f64| 0.5 * (x + (x * x + rounding * rounding).sqrt());
    let [none, all] = [-1.0, 1.0].map(rounded);
    let part = |x: f64| (rounded(x) - none) / (all - none);
    let mut colour = [1.0; 3];
    colour[(primary + 1) % 3] = part(place);
    colour[(primary + 2) % 3] = part(-place);
    colour
}

fn srgb_hue(linear: [f64; 3]) -> f64 {
    hue(xyz_from_srgb(linear))
}

/// CIE XYZ of a linear sRGB colour.
fn xyz_from_srgb([red, green, blue]: [f64; 3]) -> [f64; 3] {
    [
        0.412_456_4 * red + 0.357_576_1 * green + 0.180_437_5 * blue,
        0.212_672_9 * red + 0.715_152_2 * green + 0.072_175_0 * blue,
        0.019_333_9 * red + 0.119_192_0 * green + 0.950_304_1 * blue,
    ]
}

/// Linear sRGB of a CIE XYZ colour; components may be negative.
pub(crate) fn srgb_from_xyz([x, y, z]: [f64; 3]) -> [f64; 3] {
    [
        3.240_454_2 * x - 1.537_138_5 * y - 0.498_531_4 * z,
        -0.969_266_0 * x + 1.876_010_8 * y + 0.041_556_0 * z,
        0.055_643_4 * x - 0.204_025_9 * y + 1.057_225_2 * z,
    ]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
