//! The tiles of a picture.

use crate::camera::lines_of_sight::LinesOfSight;
use crate::view::cap::Cap;

/// Side of a tile that is not halved any more, pixels; those at the right and lower edge may be smaller.
pub const TILE_SIDE: u32 = 8;

/// Margin around a tile, px: whatever is thinner than a pixel is widened to one.
const ROOM: f64 = 0.4;

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tile {
    /// Column and row of its top left pixel.
    pub corner: [u32; 2],
    /// Width and height, pixels.
    pub size: [u32; 2],
}

impl Tile {
    /// Returns the pixels of the tile, row by row.
    pub fn pixels(self) -> impl Iterator<Item = [u32; 2]> {
        let Self { corner: [left, top], size: [width, height] } = self;
        (top..top + height).flat_map(move |v| (left..left + width).map(move |u| [u, v]))
    }

    /// Returns the parts of the tile of at most this `side`, row by row.
    pub fn parts(self, side: u32) -> impl Iterator<Item = Self> {
        let Self { corner: [left, top], size: [width, height] } = self;
        let starts = move |length: u32| (0..length).step_by(side as usize);
        starts(height).flat_map(move |y| {
            starts(width).map(move |x| Self {
                corner: [left + x, top + y],
                size: [side.min(width - x), side.min(height - y)],
            })
        })
    }

    /// Whether it is not halved any more.
    pub fn is_least(self) -> bool {
        self.size[0].max(self.size[1]) <= TILE_SIDE
    }

    /// Across its longer side.
    pub fn halves(self) -> [Self; 2] {
        let longer = usize::from(self.size[1] > self.size[0]);
        let [mut first, mut second] = [self; 2];
        first.size[longer] = (self.size[longer] / 2).next_multiple_of(TILE_SIDE);
        second.size[longer] = self.size[longer] - first.size[longer];
        second.corner[longer] += first.size[longer];
        [first, second]
    }

    /// The cap of the sky around its lines of sight.
    ///
    /// No line of sight is further from the middle one than a corner's: not in a flat picture, nor in one by
    /// longitude and latitude (a conformal one has them about the baseline), where along each edge the cosine
    /// of that angle rises to one maximum and falls. That holds below a right angle; in no more than the
    /// largest tiles of a picture is it wider.
    pub fn cap(self, lines_of_sight: &LinesOfSight) -> Cap {
        let low = self.corner.map(|place| f64::from(place) - ROOM);
        let high = [0, 1].map(|axis| f64::from(self.corner[axis] + self.size[axis]) + ROOM);
        let (middle, corners) = lines_of_sight.around(low, high);
        Cap::around(middle, corners)
    }
}
