//! What lies behind the bodies: a sky and a grid on the ground, at rest with the aperture.
//!
//! Never shifted, dimmed or exposed: it gives motion something to be seen against.
//! `shaders/backdrop.wgsl` draws the same, with the same constants.

use glam::{DVec2, DVec3};
use relativity_core::math;

use crate::camera::{Axes, Camera};
use crate::colour::mix;
use crate::effects::{Constant, number};
use crate::view::Appearance;

/// Half the width of the grid's lines, one per unit of length along x and along y.
const LINE_HALF_WIDTH: f64 = 0.012;
/// Half the width of the two lines through the origin.
const AXIS_HALF_WIDTH: f64 = 0.02;
/// Where a pixel is p units wide on the ground, the share of the grid drawn is the first less p times the second:
/// all of it where four pixels lie between two lines, none where only two do and lines would merge.
const GRID_FADE: [f64; 2] = [2.0, 4.0];
/// Of the ground at the distance s the share 1/(1 + `HAZE` s^2) is seen, half of it 20 units away: so the plane
/// ends in the sky and not in a line, and the flicker of far grid lines with it.
const HAZE: f64 = 0.0025;
/// The sky is the zenith's colour above the height z of a line of sight of 1/`SKY_RISE`, 46 degrees: a picture
/// that looks straight ahead shows all of the gradient.
const SKY_RISE: f64 = 1.4;

/// Linear sRGB colours of a backdrop.
#[derive(Debug, Clone, Copy)]
struct Palette {
    plain: [f64; 3],
    horizon: [f64; 3],
    zenith: [f64; 3],
    earth: [f64; 3],
    grid_line: [f64; 3],
    axis_line: [f64; 3],
}

// Dusk, not night: what is shifted out of the visible is black, and must stand out.
const DARK: Palette = Palette {
    plain: [0.055, 0.062, 0.075],
    horizon: [0.190, 0.225, 0.275],
    zenith: [0.045, 0.062, 0.105],
    earth: [0.050, 0.056, 0.066],
    grid_line: [0.145, 0.165, 0.195],
    axis_line: [0.270, 0.305, 0.350],
};

const LIGHT: Palette = Palette {
    plain: [0.880, 0.890, 0.910],
    horizon: [0.860, 0.890, 0.920],
    zenith: [0.480, 0.620, 0.800],
    earth: [0.640, 0.665, 0.680],
    grid_line: [0.400, 0.430, 0.460],
    axis_line: [0.190, 0.220, 0.260],
};

/// The shader's constants; `has_ground` is whether any ground is to be seen.
pub(crate) fn constants(has_ground: bool) -> [Constant; 7] {
    [
        ("GROUND", number(has_ground)),
        ("LINE_HALF_WIDTH", LINE_HALF_WIDTH),
        ("AXIS_HALF_WIDTH", AXIS_HALF_WIDTH),
        ("GRID_FADE_START", GRID_FADE[0]),
        ("GRID_FADE_RATE", GRID_FADE[1]),
        ("HAZE", HAZE),
        ("SKY_RISE", SKY_RISE),
    ]
}

/// The backdrop of one camera's picture.
#[derive(Debug, Clone, Copy)]
pub struct Backdrop {
    palette: Palette,
    aperture: DVec2,
    /// Height of the ground from the aperture, below 0: ground above the eye would hide everything.
    ground: Option<f64>,
    axes: Axes,
    focal_length_px: f64,
}

impl Backdrop {
    /// What `camera` has behind the bodies.
    #[must_use]
    pub fn new(camera: &Camera, appearance: &Appearance) -> Self {
        let aperture = camera.aperture;
        Self {
            palette: palette(appearance),
            aperture: DVec2::new(aperture.x, aperture.y),
            ground: appearance.ground_z.map(|z| z - aperture.z).filter(|z| *z < 0.0),
            axes: camera.gaze.axes(),
            focal_length_px: camera.focal_length_px(),
        }
    }

    /// Linear sRGB of the horizon, the zenith, the ground, the grid's lines and the axes.
    pub(crate) fn colours(&self) -> [[f64; 3]; 5] {
        let Palette { horizon, zenith, earth, grid_line, axis_line, .. } = self.palette;
        [horizon, zenith, earth, grid_line, axis_line]
    }

    /// Height of the ground from the aperture, below 0; `None` if there is none to be seen.
    pub(crate) fn ground_height(&self) -> Option<f64> {
        self.ground
    }

    /// Linear sRGB of the sky along `line_of_sight` (unit vector).
    #[must_use]
    pub fn sky(&self, line_of_sight: DVec3) -> [f64; 3] {
        let nearness = 1.0 - (SKY_RISE * line_of_sight.z.abs()).min(1.0);
        mix(self.palette.zenith, self.palette.horizon, nearness * nearness)
    }

    /// Distance of the ground along `line_of_sight` (unit vector), if it is met.
    pub(crate) fn ground_distance(&self, line_of_sight: DVec3) -> Option<f64> {
        let distance = self.ground? / line_of_sight.z;
        (distance > 0.0 && distance.is_finite()).then_some(distance)
    }

    /// Linear sRGB of the ground met at `distance` along `line_of_sight`.
    pub(crate) fn ground(&self, line_of_sight: DVec3, distance: f64) -> [f64; 3] {
        let n = line_of_sight;
        let foot = self.aperture + n.truncate() * distance;
        // The line of sight turns by this from one pixel to the next along `across`.
        let turn =
            |across: DVec3| (across - n * n.dot(across)) * (n.dot(self.axes.forward) / self.focal_length_px);
        let shift = |turn: DVec3| (turn.truncate() - n.truncate() * (turn.z / n.z)) * distance;
        let [right, down] = [self.axes.right, -self.axes.up].map(|across| shift(turn(across)));
        let pixel = DVec2::new(math::hypot(right.x, down.x), math::hypot(right.y, down.y));
        let grid = grid_cover(foot.x, pixel.x).max(grid_cover(foot.y, pixel.y));
        let axes = axis_cover(foot.x, pixel.x).max(axis_cover(foot.y, pixel.y));
        let Palette { earth, grid_line, axis_line, .. } = self.palette;
        let painted = mix(mix(earth, grid_line, grid), axis_line, axes);
        mix(self.sky(n), painted, 1.0 / (1.0 + HAZE * distance * distance))
    }
}

/// The colours for `appearance`; where the sky is plain, it has one colour.
fn palette(appearance: &Appearance) -> Palette {
    let palette = if appearance.light { LIGHT } else { DARK };
    if appearance.sky {
        return palette;
    }
    Palette { horizon: palette.plain, zenith: palette.plain, ..palette }
}

/// Share of a pixel, `pixel` wide on the ground, that the lines at whole numbers cover. A line thinner than a
/// pixel is faded rather than broken up; a grid finer than pixels is left out.
fn grid_cover(coordinate: f64, pixel: f64) -> f64 {
    let off_line = (coordinate - coordinate.round()).abs();
    line_cover(off_line, LINE_HALF_WIDTH, pixel) * (GRID_FADE[0] - GRID_FADE[1] * pixel).clamp(0.0, 1.0)
}

/// Share of a pixel that the line at 0 covers.
fn axis_cover(coordinate: f64, pixel: f64) -> f64 {
    line_cover(coordinate.abs(), AXIS_HALF_WIDTH, pixel)
}

fn line_cover(off_line: f64, half_width: f64, pixel: f64) -> f64 {
    let half = half_width.max(0.5 * pixel);
    ((half - off_line) / pixel.max(1e-6) + 0.5).clamp(0.0, 1.0) * (half_width / half)
}
