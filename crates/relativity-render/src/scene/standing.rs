//! The bodies of a group that stand still in it: boxes around them, and which of them no eye outside sees.
//!
//! A body inside of a ball is hidden by it from all eyes that are not in it themselves: where a ray meets
//! that body, it has met the ball before. Bodies one in the other cost no more than the outermost.

use std::collections::HashSet;
use std::sync::OnceLock;

use glam::DVec3;

use super::clusters::Clusters;
use super::prepared_body::PreparedBody;
use crate::geometry::capsule::Capsule;
use crate::geometry::extent::Extent;
use crate::geometry::hierarchy::{Hierarchy, pieces};
use crate::geometry::intersect::Solid;
use crate::geometry::shape::Shape;

/// Greatest number of balls, the largest of a group, in which other bodies are looked for.
const MOST_BALLS: usize = 16;
/// Least depth of hidden bodies below a ball's surface, as a part of its radius: more than f32 loses.
const ROOM: f64 = 1e-5;

/// Boxes around the bodies of a group that stand still.
#[derive(Debug, Default)]
pub(crate) struct StandingBodies {
    all: Hierarchy,
    /// Bodies that no ball hides, if any ball hides others.
    outside: Option<Outside>,
    /// Clusters of the bodies, from the first time that a renderer asks for them.
    pub clusters: OnceLock<Clusters>,
}

/// The bodies that are seen from outside of balls.
#[derive(Debug)]
struct Outside {
    /// Balls that hide others, of these centres and radii.
    balls: Vec<Ball>,
    hierarchy: Hierarchy,
}

/// A ball in the rest frame of the group.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ball {
    middle: DVec3,
    radius: f64,
}

impl StandingBodies {
    /// Takes those of the `bodies` of a group of this `extent`, with all solids and capsules of the scene.
    pub fn new(bodies: &[PreparedBody], extent: &Extent, solids: &[Solid], capsules: &[Capsule]) -> Self {
        let standing = || bodies.iter().filter(|body| is_standing(body));
        let boxes = |body: &PreparedBody| {
            pieces(&solids[body.number], &capsules[body.capsules.clone()], body.number as u32, extent)
        };
        let all = Hierarchy::new(standing().flat_map(boxes), extent.middle);
        let around = |body: &PreparedBody| Ball::around(&solids[body.number]);
        let mut balls: Vec<_> =
            standing().filter(|body| matches!(body.shape, Shape::Sphere { .. })).map(around).collect();
        balls.sort_by(|one, other| other.radius.total_cmp(&one.radius));
        balls.truncate(MOST_BALLS);
        balls.retain(|ball| standing().any(|body| ball.hides(&around(body))));
        let is_outside = |body: &&PreparedBody| !balls.iter().any(|ball| ball.hides(&around(body)));
        let outside = (!balls.is_empty())
            .then(|| Hierarchy::new(standing().filter(is_outside).flat_map(boxes), extent.middle));
        let outside = outside.map(|hierarchy| Outside { balls, hierarchy });
        Self { all, outside, clusters: OnceLock::new() }
    }

    /// Returns the numbers of those of the group's `bodies` that stand still, and whether a ball hides each
    /// from the eyes outside.
    pub fn numbers(&self, bodies: &[PreparedBody]) -> impl Iterator<Item = (u32, bool)> {
        let outside: Option<HashSet<u32>> =
            self.outside.as_ref().map(|outside| outside.hierarchy.bodies_by_node().flatten().collect());
        let numbers = bodies.iter().filter(|body| is_standing(body)).map(|body| body.number as u32);
        numbers.map(move |body| (body, outside.as_ref().is_some_and(|outside| !outside.contains(&body))))
    }

    /// Returns the boxes of what may be seen by an `eye` in the rest frame of the group.
    pub fn seen_from(&self, eye: DVec3) -> &Hierarchy {
        let outside = self.outside.as_ref().filter(|_| !self.is_in_a_ball(eye));
        outside.map_or(&self.all, |outside| &outside.hierarchy)
    }

    /// Whether an `eye` in the rest frame of the group is in one of the balls that hide bodies.
    pub fn is_in_a_ball(&self, eye: DVec3) -> bool {
        self.outside.iter().flat_map(|outside| &outside.balls).any(|ball| ball.holds(eye))
    }
}

/// Whether a body is drawn at its place: it neither turns out of it nor repeats another body.
const fn is_standing(body: &PreparedBody) -> bool {
    !body.is_turned && !body.is_repeated
}

impl Ball {
    fn around(solid: &Solid) -> Self {
        Self { middle: solid.centre(), radius: solid.bounding_radius() }
    }

    /// Whether all of another ball is well inside of this one.
    fn hides(&self, other: &Self) -> bool {
        other.radius + self.middle.distance(other.middle) < self.radius * (1.0 - ROOM)
    }

    /// Whether a place is in it, or about at its surface.
    fn holds(&self, place: DVec3) -> bool {
        self.middle.distance(place) <= self.radius * (1.0 + ROOM)
    }
}
