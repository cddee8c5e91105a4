//! One light cone for both eyes: the reference traces, from where each eye is, the events that the
//! middle between the eyes receives.
//!
//! Along the line of sight n from the eye at e, from the middle, the event at distance l has the time
//! T - |e + l n|. In the rest frame these events lie on a curve, with the tangent (gamma (`n_x` + beta n.u),
//! `n_y`, `n_z`), u being the unit vector from the middle: straight for great l. A ray is traced along the
//! tangent at the last known distance, and again along the one where it met the body. That is Newton's
//! iteration: what is off is squared each time.

use std::f64::consts::PI;

use glam::DVec3;
use relativity_core::aberration;
use relativity_core::math::{self, atan2};

use super::first_entry::Found;
use super::prepared_scene::{PreparedGroup, PreparedScene, passing};
use crate::geometry::capsule::Capsule;
use crate::geometry::intersect::Entry;
use crate::geometry::ray::Ray;
use crate::view::cone::Cone;
use crate::view::group_view::{GroupView, RestRay};
use crate::view::{Geometry, View};

/// Greatest number of tangents that are tried. Two or three are enough except for bodies about as near as the
/// eyes are to each other.
const ROUNDS: u32 = 12;
/// A tangent serves this far from where it touches, in parts of the distance: it is off by the square.
const SETTLED: f64 = 1e-7;
/// Error of a distance from a plane, in parts of the terms that it is the sum of.
const ROUNDING: f64 = 1e-12;
/// Distances closer than this, as parts of themselves, are compared along the ray, where they have more
/// digits.
const ALIKE: f64 = 1e-9;

impl GroupView {
    /// The ray that touches, at `distance`, the curve of events along `line_of_sight`; without one, its
    /// limit.
    ///
    /// The ray's origin, from the middle's event, is (gamma (`e_x` + beta e.u), `e_y`, `e_z`): in l
    /// (n.u) - |e + l n| = -e.u nothing is left of l.
    pub(crate) fn one_cone_ray(&self, line_of_sight: DVec3, distance: Option<f64>) -> RestRay {
        let Self { velocity, .. } = self;
        let eye = self.camera.off_middle;
        let from_middle = distance.map(|distance| eye + line_of_sight * distance);
        let received_along = from_middle.map_or(line_of_sight, |place| place.normalize_or(line_of_sight));
        // n.u from the sine between both, which does not come out of a difference.
        let sine = from_middle.map_or(0.0, |place| line_of_sight.cross(eye).length() / place.length());
        let doppler_factor = velocity.doppler_factor(received_along);
        let straight = velocity.rest_from_ground(line_of_sight) / velocity.doppler_factor(line_of_sight);
        let tangent = straight - self.bend(line_of_sight.dot(received_along), sine);
        let rest_per_ground = tangent.length();
        // By how much longer light takes to the middle than from where the ray touches to its origin.
        let ahead = velocity.speed.beta() * velocity.motion_from_camera(eye).x;
        let lag = match (distance, from_middle) {
            (Some(distance), Some(place)) => place.length() / doppler_factor - distance * rest_per_ground,
            _ => velocity.speed.gamma() * (eye.dot(line_of_sight) + ahead),
        };
        RestRay {
            origin: self.origin + self.origin_from_middle(eye, received_along, doppler_factor),
            time: self.time - lag,
            direction: tangent / rest_per_ground,
            ground_per_rest: 1.0 / rest_per_ground,
            doppler_factor,
            received_along,
        }
    }

    /// gamma (`e_x` + beta e.u) is `e_x`/D + gamma beta (`e_y u_y` + `e_z u_z`).
    fn origin_from_middle(&self, eye: DVec3, received_along: DVec3, doppler_factor: f64) -> DVec3 {
        let Self { velocity, .. } = self;
        let [eye, along] = [eye, received_along].map(|v| velocity.motion_from_camera(v));
        let aside = eye.y * along.y + eye.z * along.z;
        let later = velocity.speed.gamma() * velocity.speed.beta() * aside;
        velocity.group_from_motion(DVec3 { x: eye.x / doppler_factor + later, ..eye })
    }

    /// gamma beta (1 - n.u) along the motion, from the cosine and the sine of the angle between both.
    fn bend(&self, cosine: f64, sine: f64) -> DVec3 {
        let gap = if cosine > 0.0 { sine * sine / (1.0 + cosine) } else { 1.0 - cosine };
        let speed = &self.velocity.speed;
        self.velocity.group_from_motion(DVec3::X * (speed.gamma() * speed.beta() * gap))
    }

    /// Returns the shift of [`Self::shift`] for one light cone.
    pub(crate) fn one_cone_shift(&self, ray: &RestRay, turn: DVec3) -> DVec3 {
        let Self { velocity, .. } = self;
        let later = velocity.speed.beta() * ray.received_along.dot(turn);
        let turn = velocity.motion_from_camera(turn);
        let direction = velocity.motion_from_group(ray.direction);
        let moved = DVec3::new(velocity.speed.gamma() * (turn.x + later), turn.y, turn.z);
        let across = moved - direction * moved.dot(direction);
        if direction.x.abs() < 0.5 {
            return velocity.group_from_motion(across);
        }
        // At great speeds most of it was along the motion, and along the ray.
        let DVec3 { y, z, .. } = across;
        let x = -(y * direction.y + z * direction.z) / direction.x;
        velocity.group_from_motion(DVec3 { x, y, z })
    }
}

/// Least and greatest delay by which the eye of `view` itself sees what it is shown of the subject of
/// `scene`: no more than light takes to it from the middle.
pub(crate) fn delays(scene: &PreparedScene, view: &View) -> [f64; 2] {
    let most = view.camera.off_middle.length();
    let ranges = scene.subject().flat_map(|group| {
        let group_view = view.of_group(group.motion);
        scene.bodies()[group.bodies.clone()].iter().map(move |body| {
            let ball = scene.ball_around(body);
            group_view.delays(ball.from, ball.radius).unwrap_or([-most, most])
        })
    });
    let wider = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
    ranges.reduce(wider).map_or([-most, most], |range| range.map(|delay| delay.clamp(-most, most)))
}

impl GroupView {
    /// Returns the range of delays for what is in the rest-frame ball at `centre`; `None` where it is not
    /// much farther than the eye.
    ///
    /// An event at P, from the middle, reaches the eye |P - e| - |P| later than the middle, which is -e.u and
    /// at most e^2/(2 (|P| - |e|)) more. The ball has exactly the directions u of a cone, and |P| is D times
    /// as far as in the rest frame.
    fn delays(&self, centre: DVec3, radius: f64) -> Option<[f64; 2]> {
        let eye = self.camera.off_middle;
        let reach = eye.length();
        let geometry = if self.geometry == Geometry::OneCone { Geometry::Seen } else { self.geometry };
        let Cone { axis, half_angle } = Cone::of_sight(&Self { geometry, ..*self }, centre, radius);
        // The greatest and the least cosine of the angles from a direction.
        let cosines = |direction: DVec3| {
            let between = atan2(axis.cross(direction).length(), axis.dot(direction));
            [between - half_angle, between + half_angle].map(|angle| math::sin_cos(angle.clamp(0.0, PI)).1)
        };
        let least_doppler = cosines(self.velocity.forward())
            .map(|x| aberration::doppler_factor([x, (1.0 - x * x).sqrt(), 0.0], &self.velocity.speed));
        let nearest = (centre.distance(self.origin) - radius) * least_doppler[0].min(least_doppler[1]);
        let later = reach * reach / (2.0 * (nearest - reach));
        let [one, other] = cosines(eye).map(|cosine| -reach * cosine);
        (nearest > 2.0 * reach).then(|| [one.min(other), one.max(other) + later])
    }
}

/// The plane of the rest frame that holds all events along a line of sight: they are off the ray's limit
/// along the motion alone. What does not reach it is met nowhere, however the ray bends.
struct PlaneOfEvents {
    /// A place of the plane.
    origin: DVec3,
    /// Unit vector; 0 along the motion, where each place counts as in the plane.
    normal: DVec3,
    /// Error of distances from it, by rounding.
    rounding: f64,
}

impl PlaneOfEvents {
    /// The plane of this `line_of_sight`, whose ray has this `limit`.
    fn new(view: &GroupView, line_of_sight: DVec3, limit: &RestRay) -> Self {
        let along = view.velocity.motion_from_camera(line_of_sight);
        let normal = DVec3::new(0.0, 0.0 - along.z, along.y).normalize_or_zero();
        let normal = view.velocity.group_from_motion(normal);
        let rounding = ROUNDING * (1.0 + (limit.origin * normal).abs().element_sum());
        Self { origin: limit.origin, normal, rounding }
    }

    /// Whether one of these `capsules` reaches it.
    fn meets(&self, capsules: &[Capsule]) -> bool {
        capsules.iter().any(|capsule| {
            let [from, to] = [capsule.from, capsule.to].map(|end| (end - self.origin).dot(self.normal));
            let reach = capsule.radius + self.rounding;
            from.min(to) <= reach && from.max(to) >= -reach
        })
    }
}

/// The meeting of a line of sight with a body.
struct BodyMeeting {
    body: usize,
    entry: Entry,
    /// Distance in the ground frame.
    distance: f64,
    /// Along the ray's limit at great distances, from the middle of the group.
    depth: f64,
}

impl PreparedScene {
    /// Returns the first of the `bodies` of a group that is seen where both eyes have one light cone: its
    /// number, the place where the line of sight enters it, the distance of that on the ground, and the ray
    /// that touches there.
    pub(crate) fn first_entry_in_one_cone(
        &self,
        prepared: &PreparedGroup,
        bodies: &[u32],
        group_view: &GroupView,
        line_of_sight: DVec3,
    ) -> Option<(Found, f64, RestRay)> {
        let (middle, tie) = (prepared.extent.middle, prepared.tie());
        let limit = group_view.rest_ray(line_of_sight);
        let plane = PlaneOfEvents::new(group_view, line_of_sight, &limit);
        let meetings = bodies.iter().filter_map(|&body| {
            let body = body as usize;
            if !plane.meets(self.around_at_every_angle(body)) {
                return None;
            }
            let (entry, distance) = self.meeting(body, group_view, line_of_sight, limit, middle)?;
            let depth = (entry.position - middle).dot(limit.direction);
            Some(BodyMeeting { body, entry, distance, depth })
        });
        let first = meetings.reduce(|first, next| if next.is_before(&first, tie) { next } else { first })?;
        let BodyMeeting { body, entry, distance, .. } = first;
        Some(((body, entry), distance, group_view.rest_ray_at(line_of_sight, distance)))
    }

    /// Capsules that contain the body of this number, whatever the angle to which it turns.
    fn around_at_every_angle(&self, body: usize) -> &[Capsule] {
        let prepared = &self.bodies()[body];
        if prepared.spin.is_some() {
            std::slice::from_ref(self.ball_around(prepared))
        } else {
            self.around(prepared)
        }
    }

    /// Returns the place where `line_of_sight`, whose ray has this `limit` at great distances, enters the
    /// `body` of this number, and its distance on the ground. Rays are counted from near the `middle` of the
    /// group.
    fn meeting(
        &self,
        body: usize,
        view: &GroupView,
        line_of_sight: DVec3,
        limit: RestRay,
        middle: DVec3,
    ) -> Option<(Entry, f64)> {
        let mut ray = limit;
        let mut touched = f64::INFINITY;
        let mut found = None;
        for _ in 0..ROUNDS {
            let near = Ray::new(ray.origin, ray.direction).counted_from(middle);
            let touches = touched.is_finite().then(|| touched / ray.ground_per_rest - near.from_camera);
            let (entry, along) = self.entry_or_passage(body, &near, view, touches);
            let distance = ((near.from_camera + along) * ray.ground_per_rest).max(0.0);
            found = entry.map(|entry| (entry, distance));
            if (distance - touched).abs() <= SETTLED * distance {
                break;
            }
            touched = distance;
            ray = view.rest_ray_at(line_of_sight, distance);
        }
        found
    }

    /// Returns the entry of `ray`, which `touches` the curve of events that far along it, into the `body` of
    /// this number, and the distance of the entry along the ray, or else of the passage.
    fn entry_or_passage(
        &self,
        body: usize,
        ray: &Ray,
        view: &GroupView,
        touches: Option<f64>,
    ) -> (Option<Entry>, f64) {
        match self.turning(body) {
            Some(turning) => self.turning_entry(body, turning, ray, view, touches),
            None => passing(self.standing_entry(body, ray), ray, self.solid(body)),
        }
    }
}

impl BodyMeeting {
    fn is_before(&self, other: &Self, tie: f64) -> bool {
        let are_alike = (self.distance - other.distance).abs() <= ALIKE * other.distance;
        if are_alike { self.depth < other.depth - tie } else { self.distance < other.distance }
    }
}
