//! Kerbs, and shadows on road and pavements. All of it rests, and so does the sun: the shadows are part of
//! the ground's paint. They lie where the sun throws the middles of things; of a ball it is a disc instead of
//! an ellipse, and less of it at a kerb. In a shadow the light is dimmer, but not bluer, and no body shades
//! another.

use super::objects::Objects;

/// By how much a shadow is aside of what casts it, along x and y, per height: the sun stands 33 degrees high
/// in the late afternoon, over the beginning of the street.
pub const SUN: [f64; 2] = [1.5, 0.36];
/// Height of the shadows over the ground.
const ABOVE: f64 = 0.014;
/// Share of the light that reaches the ground in a shadow: that of the sky.
const SHADE: f64 = 0.42;
/// Kerbs of the road, and the fronts.
pub const KERBS: [f64; 2] = [2.0, 9.0];
pub const FRONTS: [f64; 2] = [-2.0, 13.0];
/// Width and height of the kerb stones.
const KERB: [f64; 2] = [0.25, 0.1];
/// Less of a disc than this is left out.
const LEAST: f64 = 0.25;

/// Returns where the shadow of a place falls.
pub fn fallen([x, y, z]: [f64; 3]) -> [f64; 2] {
    [x + SUN[0] * z, y + SUN[1] * z]
}

/// The paint of the shadow on the ground at this y, and the range of y in which that is.
fn ground_at(y: f64) -> (&'static str, [f64; 2]) {
    match y {
        _ if y < KERBS[0] => ("pavement", [FRONTS[0], KERBS[0] - KERB[0]]),
        _ if y > KERBS[1] => ("pavement", [KERBS[1] + KERB[0], FRONTS[1]]),
        _ => ("road", KERBS),
    }
}

/// Adds a round shadow, on that side of a kerb on which its middle lies.
pub fn disc(objects: &mut Objects, [x, y]: [f64; 2], radius: f64) {
    let (material, [low, high]) = ground_at(y + objects.at[1]);
    let radius = radius.min(y + objects.at[1] - low).min(high - y - objects.at[1]);
    objects.part = "shadow";
    if radius > LEAST {
        objects.shaded(SHADE, |objects| objects.cylinder(material, [x, y, -0.1], [x, y, ABOVE], radius));
    }
}

/// Adds the shadow of what is upright and as wide as this along the street, up to this height.
pub fn wall(objects: &mut Objects, [from, to]: [f64; 2], y: f64, height: f64) {
    let [ahead, across] = fallen([0.0, y, height]);
    objects.part = "shadow";
    for part in [[FRONTS[0], KERBS[0] - KERB[0]], KERBS] {
        let [low, high] = [part[0].max(y), part[1].min(across)];
        if low < high {
            let (material, _) = ground_at(0.5 * (low + high) + objects.at[1]);
            let [low, high] = [[from + ahead, low, -0.1], [to + ahead, high, ABOVE]];
            objects.shaded(SHADE, |objects| objects.block(material, low, high));
        }
    }
}

/// Adds the shadow of a post, up to the next kerb.
pub fn post(objects: &mut Objects, radius: f64, height: f64) {
    let (material, [_, high]) = ground_at(objects.at[1]);
    let most = ((high - objects.at[1]) / SUN[1]).min(height);
    let [x, y] = fallen([0.0, 0.0, most]);
    let below = ABOVE - radius;
    objects.part = "shadow";
    objects.shaded(SHADE, |objects| objects.tube(material, [0.0, 0.0, below], [x, y, below], radius));
}

/// Adds the kerb stones.
pub fn kerbs(objects: &mut Objects, [from, to]: [f64; 2]) {
    let [width, height] = KERB;
    objects.part = "kerb";
    for low in [KERBS[0] - width, KERBS[1]] {
        objects.block("stone", [from, low, 0.0], [to, low + width, height]);
    }
}
