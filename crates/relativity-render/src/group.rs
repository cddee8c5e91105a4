//! How a group of bodies moves along x, and how a view sees it.
//!
//! A group rests in a frame of its own, in which its bodies stand still and rays are straight. Where it moves towards
//! -x, everything is reflected there and back (x to -x), so that each formula is written for motion along +x alone.

use glam::DVec3;
use relativity_core::{
    Aperture, MAX_GAMMA, PublishedVariant, SourcePoint, Speed, SpeedError, aberration, published_disparity,
    sighting,
};

use crate::camera::Camera;
use crate::view::{Geometry, View};

/// A velocity along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocity {
    /// Its magnitude.
    pub speed: Speed,
    /// Whether it points towards -x.
    pub is_backward: bool,
}

/// How a group of bodies moves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Motion {
    /// At the scene's speed along +x.
    #[default]
    Scene,
    /// At a velocity of its own; [`Velocity::REST`] rests on the ground.
    Own(Velocity),
}

impl Velocity {
    /// At rest.
    pub const REST: Self = Self::forward(Speed::REST);

    /// At `speed` along +x.
    #[must_use]
    pub const fn forward(speed: Speed) -> Self {
        Self { speed, is_backward: false }
    }

    /// From beta in (-1, 1), negative towards -x.
    ///
    /// # Errors
    ///
    /// A beta out of range.
    pub fn from_beta(beta: f64) -> Result<Self, SpeedError> {
        let speed = Speed::from_beta(beta.abs()).map_err(|_| SpeedError::Beta(beta))?;
        Ok(Self { speed, is_backward: beta < 0.0 })
    }

    /// v/c, negative towards -x.
    #[must_use]
    pub fn beta(&self) -> f64 {
        if self.is_backward { -self.speed.beta() } else { self.speed.beta() }
    }

    /// Whether it is none.
    #[must_use]
    pub fn is_rest(&self) -> bool {
        self.speed == Speed::REST
    }

    /// `v` reflected where the velocity points towards -x: from the ground to where it points along +x, and back.
    #[must_use]
    pub fn reflected(&self, v: DVec3) -> DVec3 {
        if self.is_backward { DVec3::new(-v.x, v.y, v.z) } else { v }
    }

    /// The line of sight (unit vector) in the frame that moves so, of one on the ground.
    #[must_use]
    pub fn rest_from_ground(&self, line_of_sight: DVec3) -> DVec3 {
        let n = self.reflected(line_of_sight).to_array();
        self.reflected(aberration::rest_from_ground(n, &self.speed).into())
    }

    /// The line of sight (unit vector) on the ground, of one in the frame that moves so.
    #[must_use]
    pub fn ground_from_rest(&self, line_of_sight: DVec3) -> DVec3 {
        let n = self.reflected(line_of_sight).to_array();
        self.reflected(aberration::ground_from_rest(n, &self.speed).into())
    }

    /// Doppler factor of light from what moves so, received along the ground's `line_of_sight` (unit vector).
    #[must_use]
    pub fn doppler_factor(&self, line_of_sight: DVec3) -> f64 {
        aberration::doppler_factor(self.reflected(line_of_sight).to_array(), &self.speed)
    }

    /// This velocity as a camera sees it that moves at `camera`: rapidities subtract.
    fn seen_from(self, camera: Self) -> Self {
        if camera.is_rest() {
            return self;
        }
        if self.is_rest() {
            return Self { is_backward: !camera.is_backward, ..camera };
        }
        let signed = |v: Self| if v.is_backward { -v.speed.rapidity() } else { v.speed.rapidity() };
        let rapidity = signed(self) - signed(camera);
        // Two that fly apart at the greatest gamma part no faster than that.
        let speed = Speed::from_rapidity(rapidity.abs()).or(Speed::from_gamma(MAX_GAMMA));
        Self { speed: speed.unwrap_or(Speed::REST), is_backward: rapidity < 0.0 }
    }
}

/// A ray in the rest frame of a group, where it is straight and the bodies stand still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestRay {
    /// Where the camera's event is.
    pub origin: DVec3,
    /// When it is, by the group's own clocks; light was there earlier by the distance along the ray.
    pub time: f64,
    /// Unit vector towards the source.
    pub direction: DVec3,
    /// Ground distance per rest-frame distance along the ray.
    pub ground_per_rest: f64,
    /// Doppler factor of light received along the ray.
    pub doppler_factor: f64,
}

/// How one view sees one group: as it moves against the camera, from where the camera is in the group's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupView {
    /// The camera.
    pub camera: Camera,
    /// Which geometry shows the group: [`Geometry::Rest`] wherever it rests with the camera, since no ray is
    /// turned then.
    pub geometry: Geometry,
    /// The group's velocity as the camera sees it.
    pub velocity: Velocity,
    /// Where the camera's event is in the group's frame: (gamma (a - beta T), `a_y`, `a_z`).
    pub origin: DVec3,
    /// When it is there: gamma (T - beta a).
    pub time: f64,
}

impl GroupView {
    /// How `view` sees a group that moves so.
    #[must_use]
    pub fn new(view: &View, motion: Motion) -> Self {
        let scene = Velocity::forward(view.speed);
        let on_ground = match motion {
            Motion::Scene => scene,
            Motion::Own(velocity) => velocity,
        };
        let rides_along = view.geometry == Geometry::Rest;
        let velocity = on_ground.seen_from(if rides_along { scene } else { Velocity::REST });
        let geometry = match (view.geometry, motion) {
            (Geometry::Rest, Motion::Scene) => Geometry::Rest,
            (_, Motion::Own(_)) if velocity.is_rest() => Geometry::Rest,
            // What does not ride along passes a camera that does.
            (Geometry::Rest, Motion::Own(_)) => Geometry::Seen,
            (geometry, _) => geometry,
        };
        let aperture = on_ground.reflected(position(view.camera.aperture));
        let (beta, gamma, received) =
            (on_ground.speed.beta(), on_ground.speed.gamma(), view.observation_time);
        let origin = DVec3::new(gamma * (aperture.x - beta * received), aperture.y, aperture.z);
        Self {
            camera: view.camera,
            geometry,
            velocity,
            origin: on_ground.reflected(origin),
            time: gamma * (received - beta * aperture.x),
        }
    }

    /// The rest-frame ray of the camera's `line_of_sight` (unit vector).
    #[must_use]
    pub fn rest_ray(&self, line_of_sight: DVec3) -> RestRay {
        let Self { origin, time, velocity, .. } = *self;
        let speed = &velocity.speed;
        match self.geometry {
            Geometry::Seen | Geometry::Published => {
                let doppler_factor = velocity.doppler_factor(line_of_sight);
                let direction = velocity.rest_from_ground(line_of_sight);
                // s* = s gamma (1 + beta n_x) = s / D.
                RestRay { origin, time, direction, ground_per_rest: doppler_factor, doppler_factor }
            }
            Geometry::Contracted => {
                let n = line_of_sight;
                let stretched = DVec3::new(speed.gamma() * n.x, n.y, n.z);
                let rest_per_ground = stretched.length();
                RestRay {
                    origin,
                    time,
                    direction: stretched / rest_per_ground,
                    ground_per_rest: 1.0 / rest_per_ground,
                    doppler_factor: 1.0,
                }
            }
            Geometry::Rest => {
                RestRay { origin, time, direction: line_of_sight, ground_per_rest: 1.0, doppler_factor: 1.0 }
            }
        }
    }

    /// From the aperture to where the group's point at `rest` appears; `None` outside the domain of the core.
    ///
    /// The core is asked in coordinates whose origin is the camera's event, which serves a camera that rides along, too.
    #[must_use]
    pub fn apparent_position(&self, rest: DVec3) -> Option<DVec3> {
        let from_camera = rest - self.origin;
        let speed = &self.velocity.speed;
        let point = SourcePoint::from_rest(self.velocity.reflected(from_camera).to_array(), speed);
        let position = match self.geometry {
            Geometry::Rest => from_camera,
            Geometry::Contracted => DVec3::new(from_camera.x / speed.gamma(), from_camera.y, from_camera.z),
            Geometry::Seen => {
                let seen = sighting(speed, point, Aperture::default(), 0.0).ok()?;
                self.velocity.reflected(seen.position.into())
            }
            Geometry::Published => {
                let separation = self.published_separation();
                let from_middle = SourcePoint { x0: point.x0 - 0.5 * separation, ..point };
                let variant = PublishedVariant::AppendixA;
                let both = published_disparity(speed, from_middle, separation, 0.0, variant).ok()?;
                self.velocity.reflected(both.secondary.position.into())
            }
        };
        position.is_finite().then_some(position)
    }

    /// d of the published model: of the pair at -d/2 and d/2 on the x axis whose left aperture is the camera's;
    /// reflected as the group is, below 0 where it moves towards -x.
    #[must_use]
    pub fn published_separation(&self) -> f64 {
        let separation = -2.0 * self.camera.aperture.x;
        if self.velocity.is_backward { -separation } else { separation }
    }
}

fn position(aperture: Aperture) -> DVec3 {
    DVec3::new(aperture.x, aperture.y, aperture.z)
}
