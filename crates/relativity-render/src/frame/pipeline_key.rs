//! The keys of pipelines that draw bodies: what each draws, with every effect decided.

use crate::geometry::kind::Kind;
use crate::scene::wheel::packed::Turns;
use crate::view::effects::Effects;
use crate::view::group_view::{GroupView, reference_of_depths};
use crate::view::{Appearance, Geometry};

/// A pipeline that draws bodies: the vertex stage of its technique, and its key.
pub type BodyPipeline = (&'static str, Key);

/// The key of a pipeline: everything it draws, with each effect decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Key {
    /// Bodies of this kind.
    pub kind: Kind,
    /// Geometry that shows the bodies.
    pub geometry: Geometry,
    /// Whether the picture is conformal.
    pub is_conformal: bool,
    /// Whether groups of the picture move past the camera otherwise than along x.
    pub is_oblique: bool,
    /// Comparison of depths with those of other groups, if there are any.
    pub among_others: Option<AmongOthers>,
    /// Turning of the bodies.
    pub turns: Turns,
    /// Output that is wanted.
    pub output: Output,
}

/// The place of a group among others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct AmongOthers {
    /// Whether it is the reference of depths.
    pub is_reference: bool,
    /// Geometry that shows the reference group.
    pub reference: Geometry,
}

/// The output of a pipeline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Output {
    /// Colours; bodies thinner than a pixel are blended by how much of it they cover.
    Picture { is_thin: bool, is_patterned: bool, effects: Effects },
    /// Hits: numbers of what the centre of each pixel shows.
    Hits,
}

impl Key {
    /// For bodies of this `kind` that turn so, in the group of this number among those that `views` show.
    pub fn new(kind: Kind, turns: Turns, views: &[GroupView], group: usize, output: Output) -> Self {
        let among_others = AmongOthers::new(views, group);
        let GroupView { geometry, camera, .. } = views[group];
        let is_conformal = camera.projection.is_conformal();
        let is_oblique = views.iter().any(|view| view.velocity.oblique_axes().is_some());
        Self { kind, geometry, is_conformal, is_oblique, among_others, turns, output }
    }
}

impl AmongOthers {
    /// Returns the place of the group of this number among those that `views` show; `None` if it is the only
    /// one.
    pub fn new(views: &[GroupView], group: usize) -> Option<Self> {
        Self::beside(views, reference_of_depths(views), group)
    }

    /// Returns the place of the group of this number among those that `views` show, of which `reference` is
    /// the number of the reference of depths; `None` if it is the only one.
    pub fn beside(views: &[GroupView], reference: usize, group: usize) -> Option<Self> {
        let reference_geometry = views[reference].geometry;
        (views.len() > 1).then_some(Self { is_reference: reference == group, reference: reference_geometry })
    }
}

impl Output {
    /// Whether bodies thinner than a pixel are drawn.
    pub const fn is_thin(self) -> bool {
        matches!(self, Self::Picture { is_thin: true, .. })
    }

    /// Returns the key for `view` of bodies that turn in this way: a picture with `appearance`, or numbers.
    pub fn new(
        view: &GroupView,
        turns: Turns,
        appearance: Option<&Appearance>,
        is_thin: bool,
        is_patterned: bool,
    ) -> Self {
        appearance.map_or(Self::Hits, |appearance| {
            let effects = view.effects(turns, appearance);
            Self::Picture { is_thin, is_patterned, effects }
        })
    }
}
