//! The kinds of shape that shaders tell apart: each has its own ray test, and its own corners of triangles.

use crate::shaders::source;
use crate::shape::Shape;

/// One line for each kind: its name, and its files in `shaders/` for the ray test, for the corners and for patterns.
macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident: $test:literal, $corners:literal, $pattern:literal;)+) => {
        /// A kind of shape.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Kind {
            $($(#[$doc])* $kind,)+
        }

        impl Kind {
            /// Every kind.
            pub const ALL: &[Self] = &[$(Self::$kind),+];

            /// The rays' shader.
            pub const fn impostor(self) -> &'static str {
                match self {
                    $(Self::$kind => source!(
                        "frame", "rest_ray", "colour", "body", "turning", "course", "daylight", "pattern", "impostor", $test, $pattern
                    ),)+
                }
            }

            /// The mesh renderer's shader.
            pub const fn mesh(self) -> &'static str {
                match self {
                    $(Self::$kind => source!(
                        "frame", "rest_ray", "colour", "body", "turning", "course", "daylight", "pattern", $test, "mesh", "mesh_turning", $corners, $pattern
                    ),)+
                }
            }
        }
    };
}

kinds! {
    /// A tube with rounded ends; a ball is one without a length.
    Tube: "tube", "mesh_tube", "pattern_tube";
    /// A torus.
    Ring: "ring", "mesh_ring", "pattern_ring";
    /// A box.
    Box: "box", "mesh_box", "pattern_box";
    /// A cylinder with flat ends.
    Cylinder: "cylinder", "mesh_cylinder", "pattern_cylinder";
}

impl Kind {
    /// The kind of `shape`.
    pub const fn of(shape: &Shape) -> Self {
        match shape {
            Shape::Sphere { .. } | Shape::Tube { .. } => Self::Tube,
            Shape::Ring { .. } => Self::Ring,
            Shape::Box { .. } => Self::Box,
            Shape::Cylinder { .. } => Self::Cylinder,
        }
    }
}
