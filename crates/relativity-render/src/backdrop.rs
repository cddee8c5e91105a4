//! What lies behind the bodies: a sky and a grid on the ground, at rest with the aperture.
//!
//! Never shifted, dimmed or exposed: it gives motion something to be seen against. The formulas use only
//! + - * / and sqrt, so that a shader can repeat them to the last few bits.

use glam::DVec3;

use crate::camera::Camera;
use crate::colour::mix;
use crate::view::Appearance;

/// Plain backdrop, linear sRGB.
pub const PLAIN: [f64; 3] = [0.010, 0.010, 0.012];
/// Sky at the horizon, linear sRGB.
pub const HORIZON: [f64; 3] = [0.050, 0.062, 0.085];
/// Sky overhead and underfoot, linear sRGB.
pub const ZENITH: [f64; 3] = [0.006, 0.009, 0.020];
/// Ground between the grid's lines near the aperture, linear sRGB.
pub const GROUND: [f64; 3] = [0.016, 0.017, 0.018];
/// Lines of the grid, linear sRGB.
pub const GRID_LINE: [f64; 3] = [0.13, 0.14, 0.15];
/// Distance at which the ground is half lost in the haze of the horizon.
pub const HAZE_DISTANCE: f64 = 40.0;
/// Half the width of a line; the grid has one line per unit of length along x and along y.
pub const LINE_HALF_WIDTH: f64 = 0.012;

/// Linear sRGB of what `camera` sees along `line_of_sight` (unit vector) behind all bodies.
#[must_use]
pub fn backdrop(camera: &Camera, appearance: &Appearance, line_of_sight: DVec3) -> [f64; 3] {
    let behind = if appearance.sky { sky(line_of_sight.z) } else { PLAIN };
    let Some(ground_z) = appearance.ground_z else { return behind };
    let aperture = camera.aperture;
    let distance = (ground_z - aperture.z) / line_of_sight.z;
    if !(distance > 0.0 && distance.is_finite()) {
        return behind;
    }
    let foot = DVec3::new(aperture.x, aperture.y, 0.0) + line_of_sight * distance;
    // Moving the line of sight by the angle of a pixel moves its foot along x by up to
    // distance * angle * sqrt(1 + (n_x / n_z)^2), and along y alike.
    let footprint = |n: f64| {
        let steepness = n / line_of_sight.z;
        distance / camera.focal_length_px() * (1.0 + steepness * steepness).sqrt()
    };
    let along_x = grid_line(foot.x, footprint(line_of_sight.x));
    let along_y = grid_line(foot.y, footprint(line_of_sight.y));
    let surface = mix(GROUND, GRID_LINE, along_x.max(along_y));
    mix(surface, if appearance.sky { HORIZON } else { PLAIN }, distance / (distance + HAZE_DISTANCE))
}

/// Sky at the height `n_z` of the line of sight, -1 to 1.
fn sky(n_z: f64) -> [f64; 3] {
    let height = n_z.abs();
    mix(HORIZON, ZENITH, height * (2.0 - height))
}

/// Strength, 0 to 1, of the lines at whole numbers for a pixel that covers `footprint` about
/// `coordinate`. Lines fade out before a pixel covers half a cell.
fn grid_line(coordinate: f64, footprint: f64) -> f64 {
    let off_line = (coordinate - coordinate.round()).abs();
    let reach = footprint.max(LINE_HALF_WIDTH);
    (1.0 - off_line / reach).max(0.0) * (1.0 - 2.0 * footprint).max(0.0)
}
