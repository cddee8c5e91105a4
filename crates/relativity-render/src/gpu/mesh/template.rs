//! The grids of triangles that bodies are drawn as: some over each kind of unit shape, and one of each model.

use std::sync::Arc;

use crate::geometry::corners::{Coarseness, Template};
use crate::geometry::kind::Kind;
use crate::geometry::shape;
use crate::geometry::triangles::Triangles;
use crate::scene::prepared_body::PreparedBody;

/// The grid that a body is drawn as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Grid {
    /// A grid over a shape of this kind.
    Shape(Kind, Coarseness),
    /// The grid of the model with this fingerprint.
    Model(u64),
}

impl Grid {
    /// Returns the grid of `body`, whose own shape has one as coarse as `coarseness` returns.
    pub fn of(body: &PreparedBody, coarseness: impl FnOnce() -> Coarseness) -> Self {
        let model = body.triangles.as_ref().map(|model| Self::Model(model.fingerprint()));
        model.unwrap_or_else(|| Self::Shape(body.kind, coarseness()))
    }

    /// The kind of shape that it is of.
    pub fn kind(self) -> Kind {
        match self {
            Self::Shape(kind, _) => kind,
            Self::Model(_) => Kind::Model,
        }
    }

    /// Returns corners and triangles; of a model those of the one among `models` that it is of.
    pub fn template<'a>(self, mut models: impl Iterator<Item = &'a Arc<Triangles>>) -> Template {
        match self {
            Self::Shape(kind, coarseness) => shape::template(kind, coarseness),
            Self::Model(fingerprint) => {
                let model = models.find(|model| model.fingerprint() == fingerprint);
                model.map_or_else(Template::default, |model| model.template())
            }
        }
    }
}
