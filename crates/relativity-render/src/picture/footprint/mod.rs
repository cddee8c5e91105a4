//! Footprints: rectangles in the picture that surely contain a piece of a body.
//!
//! A ball at rest in the moving frame subtends a circular cone of directions, and aberration maps circular
//! cones to circular cones (Penrose 1959): as c.n* >= h with h = sqrt(|c|^2 - r^2) becomes C.n >= H, where
//! (H, C) is the Lorentz transform of (h, c), the ball looks exactly as a ball of the same radius r around
//! C would look at rest on the ground. A tube, swept by a ball, looks as a tube of the same radius swept
//! along the curve C(t), which departs from its chord along x only. A cone projects to a conic, whose
//! extent along any direction of the picture is the root of a quadratic.

mod block;
mod conformal;
mod projection;

use crate::geometry::block::Block;
use crate::geometry::capsule::Capsule;
pub use projection::{Footprint, FootprintMap, Rectangle};

/// A bound: it contains a body, or a piece of one, and can be halved.
pub trait Bound: Sized {
    /// Returns the footprint of the bound; `None` if it has none as a whole.
    fn footprint(&self, projection: &FootprintMap) -> Option<Footprint>;
    /// Returns both halves of the bound.
    fn halves(&self) -> [Self; 2];
    /// Whether halves would be no smaller.
    fn is_point(&self) -> bool;
}

impl Bound for Capsule {
    fn footprint(&self, projection: &FootprintMap) -> Option<Footprint> {
        projection.footprint(self)
    }

    fn halves(&self) -> [Self; 2] {
        self.halves()
    }

    fn is_point(&self) -> bool {
        self.from == self.to
    }
}

impl Bound for Block {
    fn footprint(&self, projection: &FootprintMap) -> Option<Footprint> {
        projection.footprint_of_block(self)
    }

    fn halves(&self) -> [Self; 2] {
        self.halves()
    }

    fn is_point(&self) -> bool {
        false
    }
}
