//! Where a place of the world is on a chart, and the other way round.

/// How the user looks at a map: as it is fitted, or nearer, or at another part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viewpoint {
    /// What the scale is multiplied by.
    pub zoom: f64,
    /// What the middle is moved by, in units of the world: x, y, z of the space face; x, t of spacetime.
    pub shift: [f64; 3],
}

impl Viewpoint {
    /// Least and greatest zoom.
    pub const ZOOM: [f64; 2] = [1e-3, 1e3];
}

impl Default for Viewpoint {
    /// All of it, as it is fitted.
    fn default() -> Self {
        Self { zoom: 1.0, shift: [0.0; 3] }
    }
}

/// A rectangle of points, in which a plane of the world is drawn upright: one scale for both axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chart {
    /// The middle of the rectangle, points to the right and down.
    pub middle: [f64; 2],
    /// Half its width and height, points.
    pub half: [f64; 2],
    /// What is there in the middle: to the right and up, units.
    pub center: [f64; 2],
    /// Points per unit, above 0.
    pub scale: f64,
}

impl Chart {
    /// Where on screen a place of the world is, points.
    #[must_use]
    pub fn screen(&self, [right, up]: [f64; 2]) -> [f64; 2] {
        [
            self.middle[0] + self.scale * (right - self.center[0]),
            self.middle[1] - self.scale * (up - self.center[1]),
        ]
    }

    /// Which place of the world is there on screen.
    #[must_use]
    pub fn world(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.center[0] + (x - self.middle[0]) / self.scale,
            self.center[1] - (y - self.middle[1]) / self.scale,
        ]
    }

    /// From the leftmost to the rightmost coordinate, and from the lowest to the highest.
    #[must_use]
    pub fn range(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|axis| {
            let reach = self.half[axis] / self.scale;
            [self.center[axis] - reach, self.center[axis] + reach]
        })
    }
}
