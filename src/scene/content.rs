//! The contents of a scene.

use std::collections::BTreeSet;
use std::ops::Range;

use gamow_platform::messages;
use relativity_render::{Body, Group, MaterialPoint, Motion, PreparedScene, Spin, Velocity};
use serde::{Deserialize, Serialize};

use super::model::ModelReport;
use super::table::coincide;
use crate::similar::{NEAREST, nearest};

/// Distance from a body's surface up to which a point is taken to be on it: coordinates may be rounded to
/// three decimals.
const ON_BODY: f64 = 1e-3;
/// Number of ambiguous names that an error message lists.
const CHOICES: usize = 4;

/// A scene: groups of bodies, each at rest in a frame of its own, and the ground they pass over. Lengths in
/// the scene's unit, rest-frame coordinates `[x, y, z]` with x along the motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// Name of the scene, as shown.
    pub name: String,
    /// The bodies of all groups, numbered from 0; at least one.
    pub bodies: Vec<Body>,
    /// The name of each body, such as `front tyre`: it follows "the" in a sentence. A file's names mean one
    /// body each.
    pub names: Vec<String>,
    /// Groups of bodies that move alike: one after the other, without gaps.
    pub groups: Vec<SceneGroup>,
    /// The point that is selected and followed at first: the forward-most one (largest x) unless the
    /// file chooses another.
    pub tracked: [f64; 3],
    /// Word for whatever rides past, after which its frame is called.
    pub rider: String,
    /// Length of the scene's unit in metres, if the file gives it.
    pub metres: Option<f64>,
    /// Height of the resting ground, if there is one.
    pub ground_z: Option<f64>,
    /// The street on it, along x, in place of a grid: y of the near and of the far kerb of its road, and of
    /// the house fronts beyond.
    pub street: Option<[f64; 3]>,
    /// Whether its paint has the light and the shadows of a sunny day, so that sky and ground are light in a
    /// dark window too.
    pub sunlit: bool,
    /// The models that were read from files.
    pub models: Vec<ModelReport>,
}

/// Bodies that move alike.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneGroup {
    /// Name, by which bodies of one name in two groups are told apart; of the scene's own group the preset
    /// that it consists of, or the scene.
    pub name: String,
    /// Its motion along x: the scene's, or one of its own.
    pub motion: Motion,
    /// Number of the scene group's first body.
    pub first: usize,
    /// Number of the scene group's bodies.
    pub count: usize,
}

impl Scene {
    /// Returns the reports on the models of the scene, a line each.
    pub fn reports(&self) -> impl Iterator<Item = String> {
        self.models.iter().map(ModelReport::line)
    }
}

impl SceneGroup {
    /// The numbers of the scene group's bodies.
    #[must_use]
    pub fn bodies(&self) -> Range<usize> {
        self.first..self.first + self.count
    }
}

/// A point of a scene: where it rests in the frame of its group, and how that moves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Track {
    /// Rest coordinates, as in the scene file; of a point that turns, those at t' = 0.
    pub rest: [f64; 3],
    /// Motion of the point's group.
    pub motion: Motion,
    /// Turning of the body that the point is on.
    pub spin: Option<Spin>,
}

impl Track {
    /// Returns the point of the axle that this point turns about; the point itself if it does not turn.
    #[must_use]
    pub fn carrier(&self) -> Self {
        Self { rest: self.axle(), spin: None, ..*self }
    }

    /// The point in the frame of the track's group.
    #[must_use]
    pub fn point(&self) -> MaterialPoint {
        MaterialPoint { rest: self.rest.into(), spin: self.spin }
    }

    /// Returns the place of the axle that it turns about, beside it; its own place if it does not turn.
    #[must_use]
    pub fn axle(&self) -> [f64; 3] {
        let [x, y, z] = self.rest;
        self.spin.map_or([x, y, z], |spin| [spin.hub[0], y, spin.hub[2]])
    }
}

impl Scene {
    /// The scene's own tracked point, which belongs to its first group; another `point` of that group in its
    /// place, if there is one. It turns with the body that it is on.
    #[must_use]
    pub fn track(&self, point: Option<[f64; 3]>) -> Track {
        let rest = point.unwrap_or(self.tracked);
        let on_body = self.body_at(rest).and_then(|body| self.track_at(rest, body));
        on_body.unwrap_or(Track { rest, motion: self.groups[0].motion, spin: None })
    }

    /// The number of the body of the first group that the `place` at rest lies on or in, if there is one: of
    /// several the one whose surface is nearest.
    #[must_use]
    pub fn body_at(&self, place: [f64; 3]) -> Option<usize> {
        let off = |body: &usize| self.bodies[*body].shape.distance(place.into());
        let own = self.groups[0].bodies().map(|body| (body, off(&body)));
        let here = own.filter(|(_, off)| *off <= ON_BODY);
        here.min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs())).map(|(body, _)| body)
    }

    /// Returns the number of the body that `name` means: the one called so, else the one called so but for
    /// capitals, else the one that has it as its number.
    ///
    /// # Errors
    /// A name of none, with the most similar ones; a name that several could be meant by, with theirs.
    pub fn body_called(&self, name: &str) -> Result<usize, String> {
        let lower = name.to_lowercase();
        let found = |is_it: &dyn Fn(&str) -> bool| -> Vec<usize> {
            (0..self.bodies.len()).filter(|&body| is_it(self.name_of(body))).collect()
        };
        let exact = found(&|known| known == name);
        let called = if exact.is_empty() { found(&|known| known.to_lowercase() == lower) } else { exact };
        if let [body] = called[..] {
            return Ok(body);
        }
        if let Some(body) = name.parse().ok().filter(|&body| body < self.bodies.len() && called.is_empty()) {
            return Ok(body);
        }
        let owned = format!("{lower} (");
        let meant = found(&|known| {
            let known = known.to_lowercase();
            known == lower || known.starts_with(&owned)
        });
        match meant[..] {
            [] => Err(self.no_body_named(name)),
            _ => Err(self.several_named(name, &meant)),
        }
    }

    /// The error message for a `name` by which each of these bodies could be meant.
    fn several_named(&self, name: &str, meant: &[usize]) -> String {
        let each =
            meant.iter().take(CHOICES).map(|&body| format!("`{}`", messages::excerpt(self.name_of(body))));
        let more = if meant.len() > CHOICES { ", ..." } else { "" };
        format!(
            "`{}` could be any of {} bodies: write {}{more}",
            messages::excerpt(name),
            meant.len(),
            each.collect::<Vec<_>>().join(" or ")
        )
    }

    /// The names of the scene's bodies, each once, in alphabetical order.
    #[must_use]
    pub fn body_names(&self) -> BTreeSet<&str> {
        self.names.iter().map(String::as_str).collect()
    }

    /// Returns the error for a `name` that no body has: it suggests the most similar names, and how to list
    /// them all.
    fn no_body_named(&self, name: &str) -> String {
        let known = self.body_names();
        let nearest = nearest(known.iter().copied(), name);
        let (scene, name) = (messages::excerpt(&self.name), messages::excerpt(name));
        match known.len() {
            ..=NEAREST => format!("{scene} has no body called `{name}`: there are {nearest}"),
            count => format!(
                "{scene} has no body called `{name}`: there are {count}; the nearest are {nearest}; `gamow \
                    --list --scene` with the scene lists all"
            ),
        }
    }

    /// The forward-most point of the body of this number, if there is such a body.
    #[must_use]
    pub fn track_on(&self, body: usize) -> Option<Track> {
        self.track_at(self.bodies.get(body)?.forward_most().into(), body)
    }

    /// The point that rests at this place of the body of this number, if there is one that can be followed;
    /// or that turns with it, and is there at t' = 0.
    #[must_use]
    pub fn track_at(&self, rest: [f64; 3], body: usize) -> Option<Track> {
        // What is on the axle stays there.
        let is_moved = |spin: &Spin| !coincide([rest[0], spin.hub[1], rest[2]], spin.hub);
        let motion = self.motion_of(body).filter(|motion| *motion != Motion::WithEyes)?;
        Some(Track { rest, motion, spin: self.bodies[body].spin.filter(is_moved) })
    }

    /// Returns the motion of the body of this number, if there is one.
    fn motion_of(&self, body: usize) -> Option<Motion> {
        self.groups.iter().find(|group| group.bodies().contains(&body)).map(|group| group.motion)
    }

    /// Returns the scene without its surroundings: the groups that do not move, except the first.
    #[must_use]
    pub fn without_surroundings(self) -> Self {
        let rests = |group: &SceneGroup| group.motion == Motion::Own(Velocity::REST);
        let kept: Vec<_> =
            self.groups.iter().enumerate().filter(|(number, group)| *number == 0 || !rests(group)).collect();
        let numbers = || kept.iter().flat_map(|(_, group)| group.bodies());
        let (bodies, names) =
            numbers().map(|body| (self.bodies[body].clone(), self.names[body].clone())).unzip();
        let mut first = 0;
        let groups = kept.iter().map(|(_, group)| {
            let moved = SceneGroup { first, ..(*group).clone() };
            first += group.count;
            moved
        });
        Self { groups: groups.collect(), bodies, names, ..self }
    }

    /// Returns the scene with all of `own` riding along with the eyes, its bodies last.
    #[must_use]
    pub fn with_riding_along(mut self, own: Self) -> Self {
        let (name, first, count) = (own.name, self.bodies.len(), own.bodies.len());
        self.groups.push(SceneGroup { name, motion: Motion::WithEyes, first, count });
        self.bodies.extend(own.bodies);
        self.names.extend(own.names);
        self
    }

    /// The groups that pass the eyes or are passed by them: all but what rides along with them.
    pub fn passing(&self) -> impl Iterator<Item = &SceneGroup> {
        self.groups.iter().filter(|group| group.motion != Motion::WithEyes)
    }

    /// Returns the name of the body of this number: the one in its file, else its shape and number.
    #[must_use]
    pub fn name_of(&self, body: usize) -> &str {
        &self.names[body]
    }

    /// Returns the name of the group of this number, as of something that is seen: of its one body, else its
    /// own.
    #[must_use]
    pub fn name_of_group(&self, group: usize) -> Option<&str> {
        let group = self.groups.get(group)?;
        Some(if group.count == 1 { self.name_of(group.first) } else { &group.name })
    }

    /// The number of what is in this version of the scene what `body` is in the version `old`: of the same
    /// name, and moving alike. Of several the one of the same shape.
    #[must_use]
    pub fn counterpart(&self, old: &Self, body: usize) -> Option<usize> {
        let (name, motion) = (old.names.get(body)?, old.motion_of(body)?);
        let is_alike = |&new: &usize| self.names[new] == *name && self.motion_of(new) == Some(motion);
        let alike = || (0..self.bodies.len()).filter(is_alike);
        alike().find(|&new| self.bodies[new].shape == old.bodies[body].shape).or_else(|| alike().next())
    }

    /// The number of the body that the scene's own tracked point is on, if it is on one.
    #[must_use]
    pub fn tracked_body(&self) -> Option<usize> {
        self.body_at(self.tracked)
    }

    /// Prepares the scene for drawing.
    #[must_use]
    pub fn prepared(&self) -> PreparedScene {
        let group = |group: &SceneGroup| Group { motion: group.motion, bodies: &self.bodies[group.bodies()] };
        PreparedScene::new(self.groups.iter().map(group))
    }
}
