//! The view of a group of bodies in motion.
//!
//! A group rests in a frame of its own, in which its bodies stand still and rays are straight. Each formula
//! is written for motion along +x alone, in axes along the group's motion past the camera: see
//! `kinematics/relative_velocity.rs`.

use glam::DVec3;
use relativity_core::{
    Aperture, Event, Model, ObserverVelocity, PublishedVariant, Reception, SourcePoint, published_disparity,
    sighting,
};

use super::{Appearance, Geometry, View};
use crate::camera::Camera;
use crate::camera::axes::position;
use crate::kinematics::relative_velocity::RelativeVelocity;
use crate::kinematics::spin::MaterialPoint;
use crate::kinematics::velocity::{Motion, Velocity};

/// A ray in the rest frame of a group, where it is straight and the bodies stand still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestRay {
    /// Place of the camera's event.
    pub origin: DVec3,
    /// When it is, by the group's own clocks; light was there earlier by the distance along the ray.
    pub time: f64,
    /// Unit vector towards the source.
    pub direction: DVec3,
    /// Ground distance per rest-frame distance along the ray.
    pub ground_per_rest: f64,
    /// Doppler factor of light received along the ray.
    pub doppler_factor: f64,
    /// Unit vector along which the light is received, in the camera's frame: the line of sight, or where both
    /// eyes have one light cone, that of the middle between them.
    pub received_along: DVec3,
}

/// A rapidity that is as good as none.
const STANDING: f64 = 1e-9;

/// The view of one group: its motion against the camera, and the camera's place in the group's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupView {
    /// Camera of the view.
    pub camera: Camera,
    /// Geometry that shows the group: [`Geometry::Rest`] where a group with a velocity of its own rests with
    /// the camera, since no ray is turned then; [`Geometry::Seen`] where it passes a camera that rides along
    /// with the scene.
    pub geometry: Geometry,
    /// Geometry of the view.
    pub(crate) view_geometry: Geometry,
    /// The group's velocity as the camera sees it.
    pub velocity: RelativeVelocity,
    /// The group's velocity on the ground, on which its wheels roll.
    pub on_ground: Velocity,
    /// Camera's event in the group's frame: (gamma (`a_x` - beta T), `a_y`, `a_z`), with the group's
    /// beta on the ground. Where both eyes have one light cone, that of the middle between them.
    pub origin: DVec3,
    /// When it is there: gamma (T - beta `a_x`).
    pub time: f64,
    /// The camera's event there once more, reflected so that the group moves along +x on the ground: light is
    /// received at it.
    pub(crate) reception: Reception,
    /// Observation time T.
    pub(crate) observation_time: f64,
}

impl GroupView {
    /// Returns the view of a group with this `motion` by `view`.
    pub(crate) fn new(view: &View, motion: Motion) -> Self {
        let scene = Velocity::forward(view.speed);
        let on_ground = match motion {
            Motion::Scene => scene,
            Motion::Own(velocity) => velocity,
            Motion::WithEyes => return Self::with_eyes(view),
        };
        let velocity = RelativeVelocity::new(on_ground, &view.observer_velocity());
        let geometry = match (view.geometry, motion) {
            (Geometry::Rest, Motion::Scene) => Geometry::Rest,
            (_, Motion::Own(_)) if velocity.is_rest() => Geometry::Rest,
            (Geometry::Rest, Motion::Own(_)) => Geometry::Seen,
            (geometry, _) => geometry,
        };
        let (place, received) = if geometry == Geometry::OneCone {
            view.camera.event_of_middle(view.observation_time)
        } else {
            (position(view.camera.aperture), view.observation_time)
        };
        let aperture = on_ground.reflected(place);
        let reception = Reception::new(Event { x: aperture.x, t: received }, &on_ground.speed);
        let Event { x, t: time } = reception.event();
        Self {
            camera: view.camera,
            geometry,
            view_geometry: view.geometry,
            velocity,
            on_ground,
            origin: on_ground.reflected(DVec3 { x, ..aperture }),
            time,
            reception,
            observation_time: received,
        }
    }

    /// Returns the view of what rides along with the eyes: at rest before them, in the frame that has the
    /// middle between them as its origin. Its clock is set so that a wheel that rolls has turned by as much
    /// street as has gone by.
    fn with_eyes(view: &View) -> Self {
        let Camera { velocity, rolled, off_middle: origin, .. } = view.camera;
        // Who stands does not turn wheels back. Whoever moves anywhere rolls forwards.
        let along = Velocity::along_street(&velocity).unwrap_or(Velocity::forward(*velocity.speed()));
        let on_ground = if velocity.is_rest() { Velocity::from_rapidity(STANDING) } else { along };
        let time = rolled / on_ground.beta();
        let x = on_ground.direction() * origin.x;
        Self {
            camera: view.camera,
            geometry: Geometry::Rest,
            view_geometry: view.geometry,
            velocity: Velocity::REST.into(),
            on_ground,
            origin,
            time,
            reception: Reception::in_frame(Event { x, t: time }),
            observation_time: view.observation_time,
        }
    }

    /// Whether daylight that rests on the street shows on the group otherwise than a lamp that rides along:
    /// not where nothing shifts wavelengths, nor if the camera rides along with the scene.
    pub(crate) fn is_lit_by_the_street(&self, appearance: &Appearance) -> bool {
        let is_lit = appearance.is_lit_by_the_street(self.view_geometry) && !self.on_ground.is_rest();
        is_lit && !self.rides_aside()
    }

    /// The view by an eye at rest at the camera's event, whose light is the same; `None` of what is measured
    /// by a camera that moves, which is no light.
    pub(crate) fn seen_from_street(&self) -> Option<Self> {
        if self.camera.velocity.is_rest() {
            return Some(*self);
        }
        let camera = Camera { velocity: ObserverVelocity::REST, ..self.camera };
        let geometry = if self.on_ground.is_rest() { Geometry::Rest } else { Geometry::Seen };
        let on_street = Self { camera, geometry, velocity: self.on_ground.into(), ..*self };
        (self.geometry != Geometry::Contracted).then_some(on_street)
    }

    /// Whether the group rides along with eyes that do not move along the street.
    pub(crate) fn rides_aside(&self) -> bool {
        self.velocity.is_rest() && Velocity::along_street(&self.camera.velocity).is_none()
    }

    /// From the camera's event to `place`, both in the group's frame, in the axes along the group's motion.
    pub(crate) fn along_motion_from_camera(&self, place: DVec3) -> DVec3 {
        self.velocity.motion_from_group(place - self.origin)
    }

    /// Whether what is seen along a line of sight lies on a straight ray in the group's frame.
    pub(crate) fn has_straight_rays(&self) -> bool {
        matches!(self.geometry, Geometry::Seen | Geometry::Contracted | Geometry::Rest)
    }

    /// Whether that is so though it is not of all groups in such a view.
    pub(crate) fn is_straight_among_bent(&self) -> bool {
        self.has_straight_rays() && matches!(self.view_geometry, Geometry::Published | Geometry::OneCone)
    }

    /// The rest-frame ray of the camera's `line_of_sight` (unit vector); of [`Geometry::OneCone`] the limit
    /// of [`Self::rest_ray_at`] at great distances.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::{Aperture, Speed};
    /// use relativity_render::{Camera, Gaze, Geometry, Motion, Velocity, View};
    ///
    /// let aperture = Aperture::default();
    /// let camera = Camera::new(aperture, Gaze::STRAIGHT_AHEAD, 1.0, [8, 8]);
    /// let speed = Speed::from_beta(0.6)?;
    /// let view = View { camera, speed, observation_time: 0.0, geometry: Geometry::Seen };
    ///
    /// // What is seen straight ahead left the rider when it was behind: aberration, D = 1/gamma.
    /// let ray = view.of_group(Motion::Scene).rest_ray([0.0, 1.0, 0.0].into());
    /// assert!((ray.direction.x - 0.6).abs() < 1e-15 && (ray.doppler_factor - 0.8).abs() < 1e-15);
    /// // A street at rest is seen where it is.
    /// let street = view.of_group(Motion::Own(Velocity::REST)).rest_ray([0.0, 1.0, 0.0].into());
    /// assert_eq!((street.direction.x, street.doppler_factor), (0.0, 1.0));
    /// # Ok::<(), relativity_core::SpeedError>(())
    /// ```
    #[must_use]
    pub fn rest_ray(&self, line_of_sight: DVec3) -> RestRay {
        let Self { origin, time, velocity, .. } = *self;
        let speed = &velocity.speed;
        match self.geometry {
            Geometry::Seen | Geometry::Published => {
                let doppler_factor = velocity.doppler_factor(line_of_sight);
                let direction = velocity.rest_from_ground(line_of_sight);
                // s* = s gamma (1 + beta n_x) = s / D.
                let (ground_per_rest, received_along) = (doppler_factor, line_of_sight);
                RestRay { origin, time, direction, ground_per_rest, doppler_factor, received_along }
            }
            Geometry::OneCone => self.one_cone_ray(line_of_sight, None),
            Geometry::Contracted => {
                let n = velocity.motion_from_camera(line_of_sight);
                let stretched = DVec3::new(speed.gamma() * n.x, n.y, n.z);
                let rest_per_ground = stretched.length();
                RestRay {
                    origin,
                    time,
                    direction: velocity.group_from_motion(stretched / rest_per_ground),
                    ground_per_rest: 1.0 / rest_per_ground,
                    doppler_factor: 1.0,
                    received_along: line_of_sight,
                }
            }
            Geometry::Rest => RestRay {
                origin,
                time,
                direction: line_of_sight,
                ground_per_rest: 1.0,
                doppler_factor: 1.0,
                received_along: line_of_sight,
            },
        }
    }

    /// Returns the ray in the rest frame for what is at `distance` (ground frame, 0 or more). Where both eyes
    /// have one light cone the events along a line of sight lie on a curve in the rest frame: the ray touches
    /// it there.
    #[must_use]
    pub fn rest_ray_at(&self, line_of_sight: DVec3, distance: f64) -> RestRay {
        if self.geometry != Geometry::OneCone {
            return self.rest_ray(line_of_sight);
        }
        self.one_cone_ray(line_of_sight, Some(distance))
    }

    /// Returns the shift in the rest frame of the place that is seen along `ray` when the line of sight turns
    /// by `turn`, without its part along the ray: per ground distance, since at the greatest speeds only that
    /// is a moderate number.
    pub(crate) fn shift(&self, ray: &RestRay, turn: DVec3) -> DVec3 {
        let Self { velocity, .. } = self;
        let speed = &velocity.speed;
        match self.geometry {
            Geometry::Seen | Geometry::Published => {
                // The differential of aberration, conformal with scale D.
                let turn = velocity.motion_from_camera(turn);
                let direction = velocity.motion_from_group(ray.direction);
                let along = speed.beta() * speed.gamma() * turn.x;
                velocity.group_from_motion(DVec3::new(
                    ray.doppler_factor * turn.x,
                    turn.y - along * direction.y,
                    turn.z - along * direction.z,
                ))
            }
            Geometry::OneCone => self.one_cone_shift(ray, turn),
            Geometry::Contracted => {
                let turn = velocity.motion_from_camera(turn);
                velocity.group_from_motion(DVec3::new(speed.gamma() * turn.x, turn.y, turn.z))
            }
            Geometry::Rest => turn,
        }
    }

    /// From the aperture to where the group's `point` appears; `None` outside the domain of the core.
    ///
    /// The core is asked in coordinates whose origin is [`Self::origin`], which serves a camera that rides
    /// along, too.
    #[must_use]
    pub fn apparent_position(&self, point: impl Into<MaterialPoint>) -> Option<DVec3> {
        let point = point.into();
        if self.geometry == Geometry::Published && point.spin.is_some() {
            return self.published_position(point);
        }
        let rest = self.place_when_shown(point);
        let from_camera = rest - self.origin;
        let speed = &self.velocity.speed;
        let along_motion = self.along_motion_from_camera(rest);
        let point = SourcePoint::from_rest(along_motion.to_array(), speed);
        let position = match self.geometry {
            Geometry::Rest => from_camera,
            Geometry::Contracted => self.velocity.camera_from_motion(DVec3 { x: point.x0, ..along_motion }),
            Geometry::Seen => {
                let seen = sighting(speed, point, Aperture::default(), 0.0).ok()?;
                self.velocity.camera_from_motion(seen.position.into())
            }
            Geometry::OneCone => {
                let seen = sighting(speed, point, Aperture::default(), 0.0).ok()?;
                self.velocity.camera_from_motion(seen.position.into()) - self.camera.off_middle
            }
            Geometry::Published => {
                let separation = self.published_separation();
                let from_middle = SourcePoint { x0: point.x0 - 0.5 * separation, ..point };
                let variant = PublishedVariant::AppendixA;
                let both = published_disparity(speed, from_middle, separation, 0.0, variant).ok()?;
                self.velocity.camera_from_motion(both.secondary.position.into())
            }
        };
        position.is_finite().then_some(position)
    }

    /// Returns the place where the published model's right eye sees a turning point: where the left one sees
    /// it earlier or later.
    fn published_position(&self, point: MaterialPoint) -> Option<DVec3> {
        let Aperture { x, y, z } = self.camera.aperture;
        let pair = [x, -x].map(|x| Aperture { x, y: 0.0, z: 0.0 });
        let model = Model::Published(PublishedVariant::AppendixA);
        let both =
            self.on_ground.disparity(model, point.moved([0.0, -y, -z]), pair, self.observation_time).ok()?;
        Some(both.secondary.position.into()).filter(|position: &DVec3| position.is_finite())
    }

    /// d of the published model: of the pair at -d/2 and d/2 on the x axis whose left aperture is the
    /// camera's; reflected as the group is, below 0 where it moves towards -x.
    pub(crate) fn published_separation(&self) -> f64 {
        let separation = -2.0 * self.camera.aperture.x;
        self.velocity.sign() * separation
    }
}

impl View {
    /// Returns the view of a group with this `motion`.
    #[must_use]
    pub fn of_group(&self, motion: Motion) -> GroupView {
        GroupView::new(self, motion)
    }

    /// From the aperture to where `point` appears, which moves at the scene's speed; `None` outside the
    /// domain of the core.
    #[must_use]
    pub fn apparent_position(&self, point: impl Into<MaterialPoint>) -> Option<DVec3> {
        self.of_group(Motion::Scene).apparent_position(point)
    }
}

/// The fastest of the groups that `views` show (of equally fast ones the first): the reference, among whose
/// bodies the depths of all others are told; why, and what that costs these, is said at `depth` in
/// `shaders/rest_ray.wgsl`.
pub(crate) fn reference_of_depths(views: &[GroupView]) -> usize {
    let gamma = |group: usize| views[group].velocity.speed.gamma();
    let faster = |fastest, group| if gamma(group) > gamma(fastest) { group } else { fastest };
    (0..views.len()).fold(0, faster)
}
