//! What lies behind the bodies: a sky and a grid on the ground, at rest with the aperture.
//!
//! Never shifted, dimmed or exposed: it gives motion something to be seen against. The formulas use only
//! + - * / and sqrt, so that a shader can repeat them to the last few bits.

use glam::DVec3;

use crate::camera::Camera;
use crate::colour::mix;
use crate::view::Appearance;

/// Colours of a backdrop, linear sRGB.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Palette {
    /// All of it, where the sky is plain.
    pub plain: [f64; 3],
    /// Sky at the horizon; the far ground fades into it.
    pub horizon: [f64; 3],
    /// Sky overhead and underfoot.
    pub zenith: [f64; 3],
    /// Ground between the grid's lines, near the aperture.
    pub ground: [f64; 3],
    /// Lines of the grid.
    pub grid_line: [f64; 3],
    /// The lines x = 0 and y = 0.
    pub axis_line: [f64; 3],
}

/// For a dark window.
pub const DARK: Palette = Palette {
    plain: [0.010, 0.010, 0.012],
    horizon: [0.060, 0.076, 0.105],
    zenith: [0.006, 0.009, 0.020],
    ground: [0.014, 0.016, 0.019],
    grid_line: [0.085, 0.098, 0.118],
    axis_line: [0.200, 0.230, 0.270],
};

/// For a light window.
pub const LIGHT: Palette = Palette {
    plain: [0.880, 0.890, 0.910],
    horizon: [0.860, 0.890, 0.920],
    zenith: [0.480, 0.620, 0.800],
    ground: [0.640, 0.665, 0.680],
    grid_line: [0.400, 0.430, 0.460],
    axis_line: [0.190, 0.220, 0.260],
};

/// Distance at which the ground is half lost in the haze of the horizon.
pub const HAZE_DISTANCE: f64 = 40.0;
/// Half the width of a line; the grid has one line per unit of length along x and along y.
pub const LINE_HALF_WIDTH: f64 = 0.012;
/// Half the width of the lines x = 0 and y = 0.
pub const AXIS_HALF_WIDTH: f64 = 0.024;

/// The colours that suit `appearance`.
#[must_use]
pub fn palette(appearance: &Appearance) -> &'static Palette {
    if appearance.light { &LIGHT } else { &DARK }
}

/// Linear sRGB of what `camera` sees along `line_of_sight` (unit vector) behind all bodies.
#[must_use]
pub fn backdrop(camera: &Camera, appearance: &Appearance, line_of_sight: DVec3) -> [f64; 3] {
    let palette = palette(appearance);
    let behind = if appearance.sky { sky(palette, line_of_sight.z) } else { palette.plain };
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
    let [reach_x, reach_y] = [footprint(line_of_sight.x), footprint(line_of_sight.y)];
    let grid = grid_line(foot.x, reach_x).max(grid_line(foot.y, reach_y));
    let axes = line(foot.x, AXIS_HALF_WIDTH, reach_x).max(line(foot.y, AXIS_HALF_WIDTH, reach_y));
    let surface = mix(mix(palette.ground, palette.grid_line, grid), palette.axis_line, axes);
    let haze = if appearance.sky { palette.horizon } else { palette.plain };
    mix(surface, haze, distance / (distance + HAZE_DISTANCE))
}

/// Sky at the height `n_z` of the line of sight, -1 to 1.
fn sky(palette: &Palette, n_z: f64) -> [f64; 3] {
    let height = n_z.abs();
    mix(palette.horizon, palette.zenith, height * (2.0 - height))
}

/// Strength, 0 to 1, of the lines at whole numbers for a pixel that covers `footprint` about
/// `coordinate`. Lines fade out before a pixel covers half a cell.
fn grid_line(coordinate: f64, footprint: f64) -> f64 {
    line(coordinate - coordinate.round(), LINE_HALF_WIDTH, footprint) * (1.0 - 2.0 * footprint).max(0.0)
}

/// Strength, 0 to 1, of one line at 0. Thinner than a pixel, it is drawn a pixel wide and fainter.
fn line(off_line: f64, half_width: f64, footprint: f64) -> f64 {
    let half_pixel = 0.5 * footprint;
    let drawn = half_width.max(half_pixel);
    let edge = (drawn - off_line.abs()) / footprint + 0.5;
    edge.clamp(0.0, 1.0) * (half_width / drawn)
}
