//! What a scene is made of: solid shapes at rest in the frame of their group.

/// A solid shape in the rest frame. Lengths in the scene's unit; `[x, y, z]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A ball.
    Sphere {
        /// Centre.
        center: [f64; 3],
        /// Radius, above 0.
        radius: f64,
    },
    /// A cylinder with rounded ends (a capsule).
    Tube {
        /// Centre of one rounded end.
        from: [f64; 3],
        /// Centre of the other.
        to: [f64; 3],
        /// Radius, above 0.
        radius: f64,
    },
    /// A torus.
    Ring {
        /// Centre.
        center: [f64; 3],
        /// Unit vector along the axis of symmetry.
        axis: [f64; 3],
        /// Radius of the circle in the middle of the tube, above `tube_radius`.
        radius: f64,
        /// Radius of the tube, above 0.
        tube_radius: f64,
    },
    /// A box: three pairs of flat faces at right angles.
    Box {
        /// Centre.
        center: [f64; 3],
        /// Half its lengths along its own axes, above 0.
        half: [f64; 3],
        /// Unit quaternion `[x, y, z, w]` that turns its own axes into those of the rest frame.
        turn: [f64; 4],
    },
    /// A cylinder with flat ends.
    Cylinder {
        /// Centre of one flat end.
        from: [f64; 3],
        /// Centre of the other, elsewhere.
        to: [f64; 3],
        /// Radius, above 0.
        radius: f64,
    },
}

impl Shape {
    /// The shape moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        let moved = |[x, y, z]: [f64; 3]| [x + offset[0], y + offset[1], z + offset[2]];
        match self {
            Self::Sphere { center, radius } => Self::Sphere { center: moved(center), radius },
            Self::Tube { from, to, radius } => Self::Tube { from: moved(from), to: moved(to), radius },
            Self::Ring { center, axis, radius, tube_radius } => {
                Self::Ring { center: moved(center), axis, radius, tube_radius }
            }
            Self::Box { center, half, turn } => Self::Box { center: moved(center), half, turn },
            Self::Cylinder { from, to, radius } => {
                Self::Cylinder { from: moved(from), to: moved(to), radius }
            }
        }
    }
}

/// A shape that glows: isotropically in the rest frame, at one wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Where it is and what form it has.
    pub shape: Shape,
    /// Wavelength of its light in the rest frame, nm.
    pub rest_wavelength_nm: f64,
}

impl Body {
    /// A plain body of this `shape` and `rest_wavelength_nm`, above 0.
    #[must_use]
    pub const fn new(shape: Shape, rest_wavelength_nm: f64) -> Self {
        Self { shape, rest_wavelength_nm }
    }

    /// The body moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        Self { shape: self.shape.moved(offset), ..self }
    }
}
