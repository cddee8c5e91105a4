//! A scene ready to be drawn: bodies placed and boxed once, whatever speed, time, eye, gaze and colour are.

use std::ops::Range;
use std::slice;
use std::sync::Arc;

use super::body::{Body, Emission};
use super::clusters::{Bodies, Clusters};
use super::prepared_body::{PreparedBody, find_joints, find_patterned, find_repeated, number_emissions};
use super::standing::StandingBodies;
use super::wheel::solid::TurningSolid;
use crate::geometry::capsule::Capsule;
use crate::geometry::extent::Extent;
use crate::geometry::hierarchy::{Beam, Hierarchy};
use crate::geometry::intersect::{Entry, Solid};
use crate::geometry::ray::Ray;
use crate::geometry::triangles::Triangles;
use crate::kinematics::spin::Spin;
use crate::kinematics::velocity::Motion;
use crate::view::View;
use crate::view::cap::Cap;
use crate::view::group_view::GroupView;

/// Bodies that move alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Group<'a> {
    /// Motion of the bodies.
    pub motion: Motion,
    /// Bodies of the group, at rest in its frame, whose origin passes the ground's at t = 0.
    pub bodies: &'a [Body],
}

/// Distance, as a part of the group's size along a ray, within which two surfaces of one group count as one:
/// the body with the lower number is seen, since which comes out nearer is a matter of rounding.
const TIE: f64 = 1e-12;

/// Marks the absence of a place.
const NONE: u32 = u32::MAX;

/// A scene prepared for every way to draw it, for hits and for picking. Clones share it; equal are those that
/// do.
///
/// Bodies may overlap; the nearest surface is seen, of equally near ones that of the lowest number.
///
/// # Examples
///
/// ```
/// use relativity_render::{Body, Group, Motion, PreparedScene, Shape, Velocity};
///
/// let ball = |x| Body::new(Shape::Sphere { centre: [x, 3.0, 0.0], radius: 0.5 }, 550.0);
/// let (rider, street) = ([ball(0.0)], [ball(-2.0), ball(2.0)]);
/// let scene = PreparedScene::new([
///     Group { motion: Motion::Scene, bodies: &rider },
///     Group { motion: Motion::Own(Velocity::REST), bodies: &street },
/// ]);
/// assert_eq!(scene.motion_of(2), Motion::Own(Velocity::REST));
/// assert_eq!(scene.bodies()[2].group, 1);
/// ```
#[derive(Debug, Clone)]
pub struct PreparedScene(Arc<Prepared>);

#[derive(Debug)]
struct Prepared {
    groups: Vec<PreparedGroup>,
    bodies: Vec<PreparedBody>,
    /// Shapes of the bodies for rays, side by side: a ray tests many, and reads nothing else of them.
    solids: Vec<Solid>,
    /// Shapes of the bodies that turn out of their places.
    turning: Vec<TurningSolid>,
    /// For each body its place among those, [`NONE`] if it is not there; none at all where no body is.
    turning_places: Vec<u32>,
    /// For each group those of its bodies that keep their places.
    standing: Vec<StandingBodies>,
    /// The numbers of bodies that turn, whether out of their places or not.
    spinning: Vec<u32>,
    /// Light that bodies emit, each kind once.
    emissions: Vec<Emission>,
    /// The numbers of all bodies.
    numbers: Vec<u32>,
    capsules: Vec<Capsule>,
    /// A ball around each body.
    balls: Vec<Capsule>,
    /// Triangles of bodies that are made of these, with the numbers of the bodies, which ascend.
    models: Vec<(usize, Arc<Triangles>)>,
    /// Groups from which it was prepared.
    #[cfg(feature = "serde")]
    source: Vec<(Motion, Vec<Body>)>,
}

/// A group, and the box around it.
#[derive(Debug, Clone)]
pub struct PreparedGroup {
    /// Motion of the group.
    pub motion: Motion,
    /// The numbers of its bodies.
    pub bodies: Range<usize>,
    /// Extent of all bodies together: distances along rays count from near its middle.
    pub extent: Extent,
}

impl PreparedScene {
    /// Prepares `groups`; their bodies are numbered from 0, in this order.
    #[must_use]
    pub fn new<'a>(groups: impl IntoIterator<Item = Group<'a>>) -> Self {
        let (mut bodies, mut solids, mut capsules) = (Vec::new(), Vec::new(), Vec::new());
        let (mut turning, mut turning_places) = (Vec::<TurningSolid>::new(), Vec::new());
        let mut prepared = Vec::new();
        #[cfg(feature = "serde")]
        let mut source = Vec::new();
        for (number, Group { motion, bodies: own }) in groups.into_iter().enumerate() {
            let first = bodies.len();
            solids.extend(own.iter().map(|body| Solid::new(&body.shape)));
            let boxes =
                own.iter().zip(&solids[first..]).enumerate().map(|(i, (body, solid)): (_, (_, &Solid))| {
                    let Some(spin) = body.displacing_spin() else { return solid.bounds() };
                    let moved = TurningSolid::of_body(*solid, spin, body.triangles.as_deref());
                    turning_places.resize(first + i, NONE);
                    turning_places.push(turning.len() as u32);
                    turning.push(moved);
                    turning[turning.len() - 1].bounds()
                });
            let extent = Extent::new(boxes);
            for (i, body) in own.iter().enumerate() {
                bodies.push(PreparedBody::new(first + i, number, body, &extent, &mut capsules));
            }
            find_joints(&mut bodies[first..], &solids[first..]);
            find_patterned(&mut bodies[first..]);
            find_repeated(&mut bodies[first..], &solids[first..]);
            prepared.push(PreparedGroup { motion, bodies: first..bodies.len(), extent });
            #[cfg(feature = "serde")]
            source.push((motion, own.to_vec()));
        }
        if prepared.is_empty() {
            prepared.push(PreparedGroup { motion: Motion::Scene, bodies: 0..0, extent: Extent::new([]) });
        }
        let place = |body: &PreparedBody| turning_places.get(body.number).copied().unwrap_or(NONE);
        let ball = |body: &PreparedBody| ball_around(body, turning.get(place(body) as usize), &capsules);
        let balls = bodies.iter().map(ball).collect();
        let spinning = bodies.iter().filter(|body| body.spin.is_some());
        let spinning = spinning.map(|body| body.number as u32).collect();
        let emissions = number_emissions(&mut bodies);
        let standing = |group: &PreparedGroup| {
            StandingBodies::new(&bodies[group.bodies.clone()], &group.extent, &solids, &capsules)
        };
        let standing = prepared.iter().map(standing).collect();
        let numbers = (0..bodies.len() as u32).collect();
        let models = bodies.iter().filter_map(|body| Some((body.number, body.triangles.clone()?))).collect();
        Self(Arc::new(Prepared {
            groups: prepared,
            bodies,
            solids,
            turning,
            turning_places,
            standing,
            spinning,
            emissions,
            numbers,
            capsules,
            balls,
            models,
            #[cfg(feature = "serde")]
            source,
        }))
    }

    /// Prepares one group of `bodies`, which move at the scene's speed.
    #[must_use]
    pub fn moving(bodies: &[Body]) -> Self {
        Self::new([Group { motion: Motion::Scene, bodies }])
    }

    /// Returns the groups of the scene.
    #[must_use]
    pub fn groups(&self) -> &[PreparedGroup] {
        &self.0.groups
    }

    /// The bodies of all groups, by their number.
    #[must_use]
    pub fn bodies(&self) -> &[PreparedBody] {
        &self.0.bodies
    }

    /// The shape of the body of this number.
    pub(crate) fn solid(&self, body: usize) -> &Solid {
        &self.0.solids[body]
    }

    /// The shape of the body of this number if it turns out of its place.
    pub(crate) fn turning(&self, body: usize) -> Option<&TurningSolid> {
        self.0.turning.get(*self.0.turning_places.get(body)? as usize)
    }

    /// Returns the entry of `ray` into the body of this number, which keeps its place.
    pub(crate) fn standing_entry(&self, body: usize, ray: &Ray) -> Option<Entry> {
        match self.triangles(body) {
            Some(triangles) => triangles.entry(self.solid(body), ray),
            None => self.solid(body).entry(ray),
        }
    }

    /// Returns the entry of `ray` into the body of this number, whose turning this is, and its distance along
    /// the ray, or that of the place where the ray passes, as [`TurningSolid::entry`] does.
    pub(crate) fn turning_entry(
        &self,
        body: usize,
        turning: &TurningSolid,
        ray: &Ray,
        view: &GroupView,
        touches: Option<f64>,
    ) -> (Option<Entry>, f64) {
        match self.triangles(body) {
            Some(triangles) if turning.turns_in(view) => {
                turning.triangle_entry(triangles, ray, view, touches)
            }
            Some(triangles) => passing(triangles.entry(self.solid(body), ray), ray, self.solid(body)),
            None => turning.entry(ray, view, touches),
        }
    }

    /// The triangles that the body of this number is made of, if it is. In a scene without models nothing is
    /// looked up.
    pub(crate) fn triangles(&self, body: usize) -> Option<&Triangles> {
        let place = self.0.models.binary_search_by_key(&body, |(number, _)| *number).ok()?;
        Some(&self.0.models[place].1)
    }

    /// The triangles of each body that is made of these, by its number.
    pub(crate) fn models(&self) -> impl Iterator<Item = &Arc<Triangles>> {
        self.0.models.iter().map(|(_, triangles)| triangles)
    }

    /// Boxes around the bodies of the group of this number that keep their places in it, without those that
    /// its `view` does not show wherever it looks.
    pub(crate) fn hierarchy(&self, group: usize, view: &GroupView) -> &Hierarchy {
        self.0.standing[group].seen_from(view.origin)
    }

    /// The bodies of the group of this number that keep their places in it, in clusters.
    pub(crate) fn clusters(&self, group: usize) -> &Clusters {
        let standing = &self.0.standing[group];
        standing.clusters.get_or_init(|| {
            let Prepared { bodies: all, solids, capsules, balls, groups, .. } = &*self.0;
            let bodies = Bodies { all, solids, capsules, balls, extent: &groups[group].extent };
            Clusters::new(bodies, standing.numbers(&all[groups[group].bodies.clone()]))
        })
    }

    /// Puts the numbers of those clusters of the group of this number into `out`, in order, that its `view`
    /// may show along a `beam`, or without one wherever it looks.
    pub(crate) fn find_clusters(
        &self,
        group: usize,
        view: &GroupView,
        beam: Option<&Beam>,
        out: &mut Vec<u32>,
    ) {
        let is_in_a_ball = self.0.standing[group].is_in_a_ball(view.origin);
        self.clusters(group).find(beam, is_in_a_ball, out);
    }

    /// Returns the beam of rays within `cap` as `view` has them in the group of this number; `None` where
    /// there is none.
    pub(crate) fn beam(&self, group: usize, view: &GroupView, cap: &Cap) -> Option<Beam> {
        Beam::new(view, cap, self.groups()[group].extent.middle)
    }

    /// The numbers of all bodies.
    pub(crate) fn numbers(&self) -> &[u32] {
        &self.0.numbers
    }

    /// Capsules that contain `body`, one of these, unless it has a block.
    pub(crate) fn capsules(&self, body: &PreparedBody) -> &[Capsule] {
        &self.0.capsules[body.capsules.clone()]
    }

    /// Capsules that contain `body`, one of these: its own, or for one with a block [`Self::ball_around`] it.
    pub(crate) fn around(&self, body: &PreparedBody) -> &[Capsule] {
        if body.block.is_some() { slice::from_ref(self.ball_around(body)) } else { self.capsules(body) }
    }

    /// The ball around `body`, one of these, at every angle to which it turns.
    pub(crate) fn ball_around(&self, body: &PreparedBody) -> &Capsule {
        &self.0.balls[body.number]
    }

    /// Returns the turning of the body of this number. Where no body turns, nothing is looked up.
    pub(crate) fn spin(&self, body: usize) -> Option<Spin> {
        if self.spinning().is_empty() { None } else { self.bodies()[body].spin }
    }

    /// The numbers of the bodies that turn, whether out of their places or not.
    pub(crate) fn spinning(&self) -> &[u32] {
        &self.0.spinning
    }

    /// The numbers of those among `bodies` that turn out of their places, each that is seen.
    pub(crate) fn turning_in(&self, bodies: Range<usize>) -> impl Iterator<Item = usize> {
        let spinning = self.spinning().iter().map(|&body| body as usize);
        let own =
            spinning.skip_while(move |&body| body < bodies.start).take_while(move |&body| body < bodies.end);
        own.filter(|&body| self.turning(body).is_some() && !self.bodies()[body].is_repeated)
    }

    /// Returns the light that bodies emit, each kind once, by its number.
    pub(crate) fn emissions(&self) -> &[Emission] {
        &self.0.emissions
    }

    /// The number of the group that the body of this number is in.
    #[must_use]
    pub fn group_of(&self, body: usize) -> usize {
        self.0.bodies[body].group
    }

    /// Returns the motion of the body of this number.
    #[must_use]
    pub fn motion_of(&self, body: usize) -> Motion {
        self.0.groups[self.group_of(body)].motion
    }

    /// The subject of the scene: all groups that move past, whether at the scene's speed or their own; all
    /// that do not ride along with the eyes if none does.
    pub fn subject(&self) -> impl Iterator<Item = &PreparedGroup> {
        let moves = |group: &PreparedGroup| match group.motion {
            Motion::Scene => true,
            Motion::Own(velocity) => !velocity.is_rest(),
            Motion::WithEyes => false,
        };
        let any_moves = self.0.groups.iter().any(moves);
        let passes = |group: &PreparedGroup| group.motion != Motion::WithEyes;
        self.0.groups.iter().filter(move |group| if any_moves { moves(group) } else { passes(group) })
    }

    /// Returns the view of each group by `view`.
    #[must_use]
    pub fn group_views(&self, view: &View) -> Vec<GroupView> {
        self.0.groups.iter().map(|group| view.of_group(group.motion)).collect()
    }
}

/// The `entry` of a ray into a body that keeps its place, and its distance, or that of the place where the
/// ray passes the body.
pub(crate) fn passing(entry: Option<Entry>, ray: &Ray, solid: &Solid) -> (Option<Entry>, f64) {
    let along = entry.map_or_else(|| ray.nearest_to(solid.centre()).1, |entry| entry.distance);
    (entry, along)
}

impl PartialEq for PreparedScene {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// The written form of a scene: its groups, from which reading prepares it anew.
#[cfg(feature = "serde")]
mod saved {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::{Body, Group, Motion, PreparedScene};

    impl Serialize for PreparedScene {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            self.0.source.serialize(serializer)
        }
    }

    impl<'de> Deserialize<'de> for PreparedScene {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let groups = Vec::<(Motion, Vec<Body>)>::deserialize(deserializer)?;
            Ok(Self::new(groups.iter().map(|(motion, bodies)| Group { motion: *motion, bodies })))
        }
    }
}

impl PreparedGroup {
    /// Length below which surfaces coincide.
    pub(crate) fn tie(&self) -> f64 {
        TIE * 2.0 * self.extent.reach
    }
}

/// A ball around `body`, at every angle if it is `turning`.
fn ball_around(body: &PreparedBody, turning: Option<&TurningSolid>, capsules: &[Capsule]) -> Capsule {
    match (turning, &body.block) {
        (Some(turning), _) => {
            let (centre, radius) = turning.ball_around();
            Capsule::ball(centre, radius)
        }
        (None, Some(block)) => block.ball_around(),
        (None, None) => Capsule::ball_around(&capsules[body.capsules.clone()]),
    }
}
