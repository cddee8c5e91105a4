//! Clusters of bodies: neighbours of one kind and about one size, for renderers that decide on many at once.

use std::collections::{BTreeMap, HashSet};
use std::ops::Range;

use super::prepared_body::PreparedBody;
use crate::geometry::capsule::Capsule;
use crate::geometry::extent::Extent;
use crate::geometry::hierarchy::{Beam, BodyPart, Hierarchy, pieces};
use crate::geometry::intersect::Solid;
use crate::geometry::kind::Kind;

/// The bodies of a scene as clusters are made of them: those of all groups, by their numbers, and the extent
/// of the group that is meant.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bodies<'a> {
    pub all: &'a [PreparedBody],
    pub solids: &'a [Solid],
    pub capsules: &'a [Capsule],
    /// A ball around each body.
    pub balls: &'a [Capsule],
    pub extent: &'a Extent,
}

/// The bodies of a group that keep their places, in clusters.
#[derive(Debug)]
pub(crate) struct Clusters {
    all: Vec<Cluster>,
    /// Boxes around the clusters.
    hierarchy: Hierarchy,
    /// The numbers of the bodies, cluster by cluster, those that [`Cluster::are_simple`] before all others.
    bodies: Vec<u32>,
    /// Number of the simple ones.
    simple: usize,
}

/// Bodies that are near each other, as many as there are boxes in a node of a hierarchy at most.
#[derive(Debug)]
pub(crate) struct Cluster {
    /// Properties that all of the bodies have in common.
    pub alike: Alike,
    /// Range of the cluster in the group's list of bodies.
    pub range: Range<usize>,
    /// A ball around all, rest frame.
    pub ball: Capsule,
    /// The greatest radius of a ball around a body.
    pub largest: f64,
    /// Boxes around the bodies.
    pub hierarchy: Hierarchy,
    /// The least and the greatest radius of the bodies themselves: that of their [`Placement`].
    ///
    /// [`Placement`]: super::prepared_body::Placement
    pub radii: [f64; 2],
}

/// The common properties of the bodies of a cluster, in the order of clusters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Alike {
    /// Whether some may turn, are models, or share an end with others, among which the first is to be drawn.
    is_special: bool,
    /// Kind of their shapes.
    pub kind: Kind,
    /// Whether any of them carries a pattern.
    pub is_patterned: bool,
    /// Whether a ball hides them from all eyes outside of balls.
    is_inside: bool,
    /// log4 of their sizes, and log2 of their own radii.
    size: u64,
    thickness: u64,
}

impl Bodies<'_> {
    /// Boxes around the bodies with these numbers.
    fn hierarchy(&self, numbers: &[u32]) -> Hierarchy {
        let bodies = numbers.iter().map(|&number| &self.all[number as usize]);
        let parts = |body: &PreparedBody| {
            let (solid, capsules) = (&self.solids[body.number], &self.capsules[body.capsules.clone()]);
            pieces(solid, capsules, body.number as u32, self.extent)
        };
        Hierarchy::new(bodies.flat_map(parts), self.extent.middle)
    }
}

impl Alike {
    fn of(body: &PreparedBody, around: &Capsule, is_inside: bool) -> Self {
        let is_joined = body.joint.as_it_is || body.joint.widened;
        Self {
            is_special: is_joined || body.spin.is_some() || body.kind == Kind::Model,
            kind: body.kind,
            is_patterned: body.is_patterned,
            is_inside,
            // Half of the binary exponent, and the whole.
            size: around.radius.to_bits() >> 53,
            thickness: radius_of(body).to_bits() >> 52,
        }
    }
}

impl Clusters {
    /// Takes those of `bodies` with the `standing` numbers, each with whether a ball hides it from the eyes
    /// outside.
    pub fn new(bodies: Bodies<'_>, standing: impl Iterator<Item = (u32, bool)>) -> Self {
        let mut by_alike: BTreeMap<Alike, Vec<u32>> = BTreeMap::new();
        for (number, is_inside) in standing {
            let (body, ball) = (&bodies.all[number as usize], &bodies.balls[number as usize]);
            by_alike.entry(Alike::of(body, ball, is_inside)).or_default().push(number);
        }
        let (mut all, mut numbers, mut seen) = (Vec::new(), Vec::new(), HashSet::new());
        for (alike, own) in by_alike {
            for neighbours in bodies.hierarchy(&own).bodies_by_node() {
                let first = numbers.len();
                numbers.extend(neighbours.filter(|&body| seen.insert(body)));
                // Of surfaces that coincide the first body's is seen.
                numbers[first..].sort_unstable();
                if first < numbers.len() {
                    all.push(Cluster::new(bodies, alike, first, &numbers[first..]));
                }
            }
        }
        let simple = all.iter().filter(|cluster: &&Cluster| cluster.are_simple());
        let simple = simple.map(|cluster| cluster.range.len()).sum();
        let boxes = (0..).zip(&all).map(|(number, cluster): (_, &Cluster)| {
            let Capsule { from: centre, radius, .. } = cluster.ball;
            BodyPart { body: number, is_one_of_some: false, corners: [centre - radius, centre + radius] }
        });
        let hierarchy = Hierarchy::new(boxes, bodies.extent.middle);
        Self { all, hierarchy, bodies: numbers, simple }
    }

    /// Puts the numbers of the clusters into `out`, in order, that may be met by a `beam`, or all without
    /// one, from an eye that is in one of the balls that hide bodies, or is not.
    pub fn find(&self, beam: Option<&Beam>, is_in_a_ball: bool, out: &mut Vec<u32>) {
        out.clear();
        match beam {
            Some(beam) => self.hierarchy.add_along(beam, out),
            None => out.extend(0..self.all.len() as u32),
        }
        out.retain(|&number| is_in_a_ball || !self.all[number as usize].alike.is_inside);
        out.sort_unstable();
    }

    /// The cluster of this number.
    pub fn cluster(&self, number: u32) -> &Cluster {
        &self.all[number as usize]
    }

    /// The numbers of the bodies of `cluster`.
    pub fn bodies_of(&self, cluster: &Cluster) -> &[u32] {
        &self.bodies[cluster.range.clone()]
    }

    /// The numbers of all bodies that [`Cluster::are_simple`].
    pub fn simple_bodies(&self) -> &[u32] {
        &self.bodies[..self.simple]
    }
}

impl Cluster {
    fn new(bodies: Bodies<'_>, alike: Alike, first: usize, numbers: &[u32]) -> Self {
        let balls: Vec<_> = numbers.iter().map(|&number| bodies.balls[number as usize]).collect();
        let radii = numbers.iter().map(|&number| radius_of(&bodies.all[number as usize]));
        Self {
            alike,
            range: first..first + numbers.len(),
            ball: Capsule::ball_around(&balls),
            hierarchy: bodies.hierarchy(numbers),
            largest: balls.iter().map(|ball| ball.radius).fold(0.0, f64::max),
            radii: radii.fold([f64::INFINITY, 0.0], |[low, high], r| [r.min(low), r.max(high)]),
        }
    }

    /// Whether the bodies stand still, are no models and share no end with others: they may be drawn in any
    /// order, and their data never change.
    pub const fn are_simple(&self) -> bool {
        !self.alike.is_special
    }
}

fn radius_of(body: &PreparedBody) -> f64 {
    body.placement.place_radius[3].into()
}
