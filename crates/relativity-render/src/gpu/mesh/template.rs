//! The divisions of bodies: which grid of corners over a unit shape each is placed on.

use std::sync::Arc;

use crate::geometry::corners::Template;
use crate::geometry::kind::Kind;
use crate::geometry::shape;
use crate::geometry::triangles::Triangles;

/// The division of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Division {
    /// A shape of this kind: its numbers of segments each way, in the order of the shape's file.
    Shape { kind: Kind, segments: [u32; 3] },
    /// The model with this fingerprint: segments along any side of its box, if they were as long as edges may be.
    Model { fingerprint: u64, segments: u32 },
}

impl Division {
    /// The kind of shape that it divides.
    pub fn kind(self) -> Kind {
        match self {
            Self::Shape { kind, .. } => kind,
            Self::Model { .. } => Kind::Model,
        }
    }

    /// Returns corners and triangles; of a model those of the one among `models` that it divides.
    pub fn template<'a>(self, mut models: impl Iterator<Item = &'a Arc<Triangles>>) -> Template {
        match self {
            Self::Shape { kind, segments } => shape::template(kind, segments),
            Self::Model { fingerprint, segments } => {
                let model = models.find(|model| model.fingerprint() == fingerprint);
                model.map_or_else(Template::default, |model| model.template(segments))
            }
        }
    }
}
