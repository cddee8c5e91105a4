//! Places of the world on a chart, and the other way round.

/// The user's look at a map: as it is fitted, or nearer, or at another part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viewpoint {
    /// Factor of the scale.
    pub zoom: f64,
    /// Shift of the middle, in units of the world: x, y, z of the space face; x, t of spacetime.
    pub shift: [f64; 3],
}

impl Viewpoint {
    /// Least and greatest zoom.
    pub const ZOOM: [f64; 2] = [1e-3, 1e3];
}

impl Default for Viewpoint {
    /// The whole map, as it is fitted.
    fn default() -> Self {
        Self { zoom: 1.0, shift: [0.0; 3] }
    }
}

/// A rectangle of points, in which a plane of the world is drawn upright: one scale for both axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chart {
    /// The middle of the rectangle, points to the right and down.
    pub middle: [f64; 2],
    /// Half the chart's width and height, points.
    pub half: [f64; 2],
    /// Place in the middle of the chart: to the right and up, units.
    pub centre: [f64; 2],
    /// Points per unit, above 0.
    pub scale: f64,
}

impl Chart {
    /// Returns the place on screen of a place of the world, points.
    #[must_use]
    pub fn screen(&self, [right, up]: [f64; 2]) -> [f64; 2] {
        [
            self.middle[0] + self.scale * (right - self.centre[0]),
            self.middle[1] - self.scale * (up - self.centre[1]),
        ]
    }

    /// Returns the place of the world at a place on screen.
    #[must_use]
    pub fn world(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.centre[0] + (x - self.middle[0]) / self.scale,
            self.centre[1] - (y - self.middle[1]) / self.scale,
        ]
    }

    /// From the leftmost to the rightmost coordinate, and from the lowest to the highest.
    #[must_use]
    pub fn range(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|axis| {
            let reach = self.half[axis] / self.scale;
            [self.centre[axis] - reach, self.centre[axis] + reach]
        })
    }
}
