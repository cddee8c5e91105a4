//! What a scene is made of: solid shapes at rest in the frame of their group.

use glam::{DQuat, DVec3};

use crate::wheel::spin::{Spin, about_y};

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
    /// Whether it stays as it is while it turns: a body of revolution about the axle of `spin`.
    #[must_use]
    pub fn is_round_about(&self, spin: &Spin) -> bool {
        let is_on_axle = |place: [f64; 3]| spin.off_axle(place.into()) == DVec3::ZERO;
        match *self {
            Self::Sphere { center, .. } => is_on_axle(center),
            Self::Tube { from, to, .. } | Self::Cylinder { from, to, .. } => {
                is_on_axle(from) && is_on_axle(to)
            }
            Self::Ring { center, axis: [x, _, z], .. } => is_on_axle(center) && x == 0.0 && z == 0.0,
            Self::Box { .. } => false,
        }
    }
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

    /// The shape turned by `angle` about the axle of `spin`, as [`Spin::turned`].
    #[must_use]
    pub(crate) fn turned(self, spin: &Spin, angle: f64) -> Self {
        let turned = |place: [f64; 3]| spin.turned(place.into(), angle).to_array();
        match self {
            Self::Sphere { center, radius } => Self::Sphere { center: turned(center), radius },
            Self::Tube { from, to, radius } => Self::Tube { from: turned(from), to: turned(to), radius },
            Self::Ring { center, axis, radius, tube_radius } => {
                let axis = about_y(axis.into(), angle).to_array();
                Self::Ring { center: turned(center), axis, radius, tube_radius }
            }
            Self::Box { center, half, turn } => {
                let turn = DQuat::from_rotation_y(angle) * DQuat::from_array(turn);
                Self::Box { center: turned(center), half, turn: turn.to_array() }
            }
            Self::Cylinder { from, to, radius } => {
                Self::Cylinder { from: turned(from), to: turned(to), radius }
            }
        }
    }
}

/// What light a body sends, alike in all directions in its rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Emission {
    /// Light of one wavelength, nm, above 0.
    Wavelength(f64),
    /// White light: daylight, which a grey body reflects.
    White,
}

impl Emission {
    /// Its wavelength in the rest frame, nm; white light has none.
    #[must_use]
    pub const fn wavelength_nm(self) -> Option<f64> {
        match self {
            Self::Wavelength(nm) => Some(nm),
            Self::White => None,
        }
    }
}

/// A pattern on a body. The own z axis of a tube (from `from` to `to`), of a cylinder and of a ring is its axis; a ball
/// has the axes of the rest frame, a box its own.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Pattern {
    /// None.
    #[default]
    Plain,
    /// The faces of a die on a box: 1 at the end of its x axis, 2 of y, 3 of z; opposite faces sum to 7. Plain on all
    /// others.
    Faces,
    /// Meridians around the axis, and parallels across it. On the side of a tube or cylinder parallels follow from its
    /// beginning at as long an arc, on its ends and on a ring's tube as well. Those at multiples of 90
    /// degrees are twice as wide.
    /// Plain on a box.
    Graticule {
        /// From one line to the next, degrees, a divisor of 90.
        step_degrees: f64,
    },
    /// Squares, light and dark in turn. On a box they count from its lowest corner; along a tube or cylinder from its
    /// beginning, and around it there are as many as come closest to `step`, an even number, as around a ball or ring
    /// (where they are equal parts of both circles).
    Chequer {
        /// Side of a square, above 0.
        step: f64,
    },
    /// Bands across the z axis, light and dark in turn: from the beginning of a tube or cylinder, or a ball's middle.
    /// On a box they lie across its x axis, from its low end; on a ring along its middle circle, from its own x axis.
    Stripes {
        /// Width of a band, above 0.
        step: f64,
    },
}

/// A shape, and the light it sends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Where it is and what form it has.
    pub shape: Shape,
    /// Its light in the rest frame.
    pub emission: Emission,
    /// Brightness beside other bodies, above 0 and at most 1.
    pub brightness: f64,
    /// What it carries.
    pub pattern: Pattern,
    /// How it turns within its group; `None` if it stands still there.
    pub spin: Option<Spin>,
}

impl Body {
    /// A plain body of this `shape` and `rest_wavelength_nm`, above 0.
    #[must_use]
    pub const fn new(shape: Shape, rest_wavelength_nm: f64) -> Self {
        Self::of_light(shape, Emission::Wavelength(rest_wavelength_nm))
    }

    /// A plain white body of this `shape`.
    #[must_use]
    pub const fn white(shape: Shape) -> Self {
        Self::of_light(shape, Emission::White)
    }

    const fn of_light(shape: Shape, emission: Emission) -> Self {
        Self { shape, emission, brightness: 1.0, pattern: Pattern::Plain, spin: None }
    }

    /// The body with this `pattern`.
    #[must_use]
    pub const fn with_pattern(self, pattern: Pattern) -> Self {
        Self { pattern, ..self }
    }

    /// The body, turning so.
    #[must_use]
    pub const fn turning(self, spin: Spin) -> Self {
        Self { spin: Some(spin), ..self }
    }

    /// How it turns, if that changes where its surface is.
    #[must_use]
    pub fn displacing_spin(&self) -> Option<Spin> {
        self.spin.filter(|spin| !self.shape.is_round_about(spin))
    }

    /// The body moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        let spin = self.spin.map(|spin| spin.moved(offset));
        Self { shape: self.shape.moved(offset), spin, ..self }
    }
}
