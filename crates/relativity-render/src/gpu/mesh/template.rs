//! The grids of triangles that bodies are drawn as: one over each kind of unit shape, and one of each model.

use std::sync::Arc;

use crate::geometry::corners::Template;
use crate::geometry::kind::Kind;
use crate::geometry::shape;
use crate::geometry::triangles::Triangles;
use crate::scene::prepared_body::PreparedBody;

/// The grid that a body is drawn as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Grid {
    /// The grid over a shape of this kind.
    Shape(Kind),
    /// The grid of the model with this fingerprint.
    Model(u64),
}

impl Grid {
    /// Returns the grid of `body`.
    pub fn of(body: &PreparedBody) -> Self {
        body.triangles.as_ref().map_or(Self::Shape(body.kind), |model| Self::Model(model.fingerprint()))
    }

    /// The kind of shape that it is of.
    pub fn kind(self) -> Kind {
        match self {
            Self::Shape(kind) => kind,
            Self::Model(_) => Kind::Model,
        }
    }

    /// Returns corners and triangles; of a model those of the one among `models` that it is of.
    pub fn template<'a>(self, mut models: impl Iterator<Item = &'a Arc<Triangles>>) -> Template {
        match self {
            Self::Shape(kind) => shape::template(kind),
            Self::Model(fingerprint) => {
                let model = models.find(|model| model.fingerprint() == fingerprint);
                model.map_or_else(Template::default, |model| model.template())
            }
        }
    }
}
