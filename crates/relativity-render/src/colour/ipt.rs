//! Hue as people see it, in the colour space IPT, and the purest screen colour of a hue.
//!
//! Adding white to a colour, or dimming it, keeps its hue in IPT nearly as well as people judge it; on the
//! straight line to white in linear sRGB the red end of the spectrum would turn pink.
//!
//! Reference: F. Ebner and M. D. Fairchild, *Development and testing of a color space (IPT) with improved hue
//! uniformity*, IS&T/SID Sixth Color Imaging Conference, 8-13 (1998).

use std::f64::consts::{PI, TAU};

use relativity_core::math::{atan2, powf};

/// To the responses of the three kinds of cones, 1 each for white (D65).
const CONES_FROM_XYZ: [[f64; 3]; 3] =
    [[0.4002, 0.7075, -0.0807], [-0.2280, 1.1500, 0.0612], [0.0, 0.0, 0.9184]];
/// Exponent that compresses the responses.
const COMPRESSION: f64 = 0.43;
/// From compressed responses to the two opponent colours: P, red against green, and T, yellow against blue.
const OPPONENTS: [[f64; 3]; 2] = [[4.4550, -4.8510, 0.3960], [0.8056, 0.3572, -1.1628]];
/// The corners of the purest screen colours, in the order of their hues: red, yellow, green, cyan, blue,
/// magenta.
const CORNERS: [[f64; 3]; 6] =
    [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0]];
/// Halvings after which a place on an edge is known to 2e-11.
const HALVINGS: u32 = 36;

/// Hue angle of a CIE XYZ colour, radians in (-pi, pi]; it does not depend on the brightness.
pub fn hue(xyz: [f64; 3]) -> f64 {
    let compressed = CONES_FROM_XYZ.map(|row| {
        let response = dot(row, xyz);
        response.signum() * powf(response.abs(), COMPRESSION)
    });
    let [p, t] = OPPONENTS.map(|row| dot(row, compressed));
    atan2(t, p)
}

/// The most saturated linear sRGB colour of this `hue`: its largest component is 1, its smallest 0.
pub fn purest_srgb(hue: f64) -> [f64; 3] {
    let edges = (0..CORNERS.len()).map(|i| [CORNERS[i], CORNERS[(i + 1) % CORNERS.len()]]);
    // How far the hue lies beyond the start of an edge, of which no edge spans half a turn.
    let beyond = |start: [f64; 3]| (hue - srgb_hue(start)).rem_euclid(TAU);
    let nearest = edges.min_by(|a, b| beyond(a[0]).total_cmp(&beyond(b[0])));
    let [start, end] = nearest.expect("there are six edges");
    let mut span = [0.0, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (span[0] + span[1]);
        let is_before = beyond(between(start, end, middle)) < PI;
        span[usize::from(!is_before)] = middle;
    }
    between(start, end, span[0])
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

fn between(start: [f64; 3], end: [f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|i| start[i] + (end[i] - start[i]) * t)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
