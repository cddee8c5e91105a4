//! Which bodies each part of a picture can show.
//!
//! The picture is halved again and again; each half keeps those bodies of the whole whose cones meet
//! its own. Neighbouring rays so share the search. A tree of boxes over the bodies, searched anew for every
//! ray, measured three to six times slower on crowds of 64 to 6,400 (`benches/reference.rs` compares with
//! a plain loop).

use std::f64::consts::FRAC_PI_2;

use relativity_core::math::atan2;

use crate::camera::{Camera, LinesOfSight};
use crate::cone::Cone;

/// Side of a tile that is not halved any more, pixels; those at the right and lower edge may be smaller.
pub const TILE_SIDE: u32 = 8;

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    /// Column and row of its top left pixel.
    pub corner: [u32; 2],
    /// Width and height, pixels.
    pub size: [u32; 2],
}

impl Tile {
    /// Its pixels, row by row.
    pub fn pixels(self) -> impl Iterator<Item = [u32; 2]> {
        let Self { corner: [left, top], size: [width, height] } = self;
        (top..top + height).flat_map(move |v| (left..left + width).map(move |u| [u, v]))
    }

    fn halves(self) -> [Self; 2] {
        let longer = usize::from(self.size[1] > self.size[0]);
        let [mut first, mut second] = [self; 2];
        first.size[longer] = (self.size[longer] / 2).next_multiple_of(TILE_SIDE);
        second.size[longer] = self.size[longer] - first.size[longer];
        second.corner[longer] += first.size[longer];
        [first, second]
    }

    /// The cone around its lines of sight.
    pub fn cone(self, lines_of_sight: &LinesOfSight) -> Cone {
        let [left, top] = self.corner.map(f64::from);
        let [width, height] = self.size.map(f64::from);
        let through = |x: f64, y: f64| lines_of_sight.through([left + x * width, top + y * height]);
        let axis = through(0.5, 0.5);
        let corners = [through(0.0, 0.0), through(1.0, 0.0), through(0.0, 1.0), through(1.0, 1.0)];
        // No line of sight is further from the axis than a corner's: not in a flat picture, nor in one by longitude and
        // latitude, where along each edge the cosine of that angle rises to one maximum and falls. That holds below a
        // right angle; in no more than the largest tiles of a picture is it wider.
        let half_angle =
            corners.into_iter().map(|corner| atan2(axis.cross(corner).length(), axis.dot(corner)));
        let half_angle = half_angle.fold(0.0, f64::max);
        if half_angle < FRAC_PI_2 { Cone { axis, half_angle } } else { Cone::WHOLE_SKY }
    }
}

/// The tiles of `camera`'s picture, each with those of the bodies (numbers into `cones`, in order) that
/// it can show; one list for every [`TILE_SIDE`] rows of pixels.
pub fn bands(camera: &Camera, cones: &[Cone]) -> Vec<Vec<(Tile, Vec<u32>)>> {
    let whole = Tile { corner: [0, 0], size: camera.size };
    let mut bands = vec![Vec::new(); camera.size[1].div_ceil(TILE_SIDE) as usize];
    if camera.size.contains(&0) {
        return bands;
    }
    let everything: Vec<u32> = (0..cones.len() as u32).collect();
    divide(whole, &everything, &LinesOfSight::new(camera), cones, &mut bands);
    bands
}

fn divide(
    tile: Tile,
    candidates: &[u32],
    lines_of_sight: &LinesOfSight,
    cones: &[Cone],
    bands: &mut [Vec<(Tile, Vec<u32>)>],
) {
    let cone = tile.cone(lines_of_sight);
    let visible = candidates.iter().copied().filter(|&body| cones[body as usize].meets(&cone)).collect();
    if tile.size[0].max(tile.size[1]) <= TILE_SIDE {
        bands[(tile.corner[1] / TILE_SIDE) as usize].push((tile, visible));
        return;
    }
    for half in tile.halves() {
        divide(half, &visible, lines_of_sight, cones, bands);
    }
}
