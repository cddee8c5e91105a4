//! The kinds of shape in the shaders: each has its own ray test, and its own corners of triangles.

use crate::shaders::{Source, source};

/// The shader of the rays for a kind with these files, of which the last draws a picture.
macro_rules! impostor {
    ([$($test:literal),+], [$($pixels:literal),+], $picture:literal) => {
        source!(
            "frame", "passage", "rest_ray", "tables", "colour", "body", "turning", "course", "daylight", "pattern", "sighting", "footprint", "impostor", $($test),+, $($pixels),+, $picture
        )
    };
}

/// Defines the kinds: one line each, with its name and its files in `shaders/` for the ray test and patterns,
/// for the pixels of these, for those where shaders choose the samples of a pixel, and for the corners.
macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident: [$($test:literal),+], [$($pixels:literal),+], $chosen:literal, [$($corners:literal),+];)+) => {
        /// A kind of shape.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Kind {
            $($(#[$doc])* $kind,)+
        }

        impl Kind {
            /// Every kind of shape.
            pub const ALL: &[Self] = &[$(Self::$kind),+];

            /// Returns the shader of the rays, which chooses the samples of a pixel.
            pub const fn impostor(self) -> Source {
                match self {
                    $(Self::$kind => impostor!([$($test),+], [$($pixels),+], $chosen),)+
                }
            }

            /// Returns the shader of the rays where each sample is drawn as a pixel.
            pub const fn impostor_as_pixels(self) -> Source {
                match self {
                    $(Self::$kind => impostor!([$($test),+], [$($pixels),+], "impostor_as_pixels"),)+
                }
            }

            /// The mesh renderer's shader.
            pub const fn mesh(self) -> Source {
                match self {
                    $(Self::$kind => source!(
                        "frame", "passage", "rest_ray", "tables", "colour", "body", "turning", "course", "daylight", "pattern", "sighting", $($test),+, "mesh", "mesh_turning", $($corners),+
                    ),)+
                }
            }
        }
    };
}

kinds! {
    /// A tube with rounded ends; a ball is one without a length.
    Tube: ["tube", "turning_shape"], ["impostor_shape"], "impostor_shape_chosen", ["mesh_tube", "mesh_shape"];
    /// A torus, as the shape `Ring`.
    Ring: ["ring", "turning_shape"], ["impostor_shape"], "impostor_shape_chosen", ["mesh_ring", "mesh_shape"];
    /// A box, as the shape `Box`.
    Box: ["box", "pattern_box", "turning_shape"], ["impostor_shape"], "impostor_shape_chosen", ["mesh_box", "mesh_shape"];
    /// A cylinder with flat ends.
    Cylinder: ["cylinder", "turning_shape"], ["impostor_shape"], "impostor_shape_chosen", ["mesh_cylinder", "mesh_shape"];
    /// A model of triangles, in its box.
    Model: ["models", "textures", "model", "pattern_box"], ["models_turning", "impostor_model"], "impostor_model_chosen", ["mesh_model"];
}
