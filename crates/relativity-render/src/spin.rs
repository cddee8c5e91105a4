//! How bodies turn within their group, as parts of a wheel, and the points that they are made of.

use glam::DVec3;
use relativity_core::math;
use relativity_core::{Source, Turning, WheelPoint};

use crate::body::Shape;
use crate::velocity::Velocity;

/// How a body turns about an axle along y, which rests in the frame of its group.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spin {
    /// Where the axle is: any point of it, in the rest frame.
    pub hub: [f64; 3],
    /// W, the radius on which the wheel rolls, above 0. Nothing that turns with it is farther from the axle.
    pub radius: f64,
    /// How fast it turns.
    pub turning: Turning,
}

/// A point of a body: where it is at t' = 0, and how it turns from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaterialPoint {
    /// Where it is at t' = 0 by the clocks of the rest frame; always, if it does not turn.
    pub rest: DVec3,
    /// How it turns; `None` if it stays there.
    pub spin: Option<Spin>,
}

impl Spin {
    /// The same about an axle moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        Self { hub: (DVec3::from(self.hub) + DVec3::from(offset)).to_array(), ..self }
    }

    /// How fast it turns where its group moves so on the ground: about +y, radians per unit of the rest frame's time.
    #[must_use]
    pub fn omega(&self, on_ground: &Velocity) -> f64 {
        self.turning.rim_speed(on_ground.beta()) / self.radius
    }

    /// From the axle to `place`, across it.
    pub(crate) fn off_axle(&self, place: DVec3) -> DVec3 {
        let [x, _, z] = self.hub;
        DVec3::new(place.x - x, 0.0, place.z - z)
    }

    /// The angle about the axle at which `place` is: radians from +x towards +z.
    #[must_use]
    pub fn angle(&self, place: DVec3) -> f64 {
        let DVec3 { x, z, .. } = self.off_axle(place);
        math::atan2(z, x)
    }

    /// Where a point of the wheel at `place` is once it has turned by `angle` (radians, about +y, as a wheel does that
    /// rolls towards +x).
    #[must_use]
    pub fn turned(&self, place: DVec3, angle: f64) -> DVec3 {
        let off_axle = self.off_axle(place);
        place - off_axle + about_y(off_axle, angle)
    }

    /// Whether turning leaves `shape` as it is: a body of revolution about the axle.
    #[must_use]
    pub fn keeps(&self, shape: &Shape) -> bool {
        let is_on_axle = |place: [f64; 3]| self.off_axle(place.into()) == DVec3::ZERO;
        match *shape {
            Shape::Sphere { center, .. } => is_on_axle(center),
            Shape::Tube { from, to, .. } | Shape::Cylinder { from, to, .. } => {
                is_on_axle(from) && is_on_axle(to)
            }
            Shape::Ring { center, axis: [x, _, z], .. } => is_on_axle(center) && x == 0.0 && z == 0.0,
            Shape::Box { .. } => false,
        }
    }
}

/// `v` turned by `angle` about +y: from z towards x.
pub(crate) fn about_y(v: DVec3, angle: f64) -> DVec3 {
    let (sine, cosine) = math::sin_cos(angle);
    DVec3::new(v.x * cosine + v.z * sine, v.y, v.z * cosine - v.x * sine)
}

impl MaterialPoint {
    /// The same moved by `offset`, and its axle with it.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        Self { rest: self.rest + DVec3::from(offset), spin: self.spin.map(|spin| spin.moved(offset)) }
    }
}

impl From<DVec3> for MaterialPoint {
    fn from(rest: DVec3) -> Self {
        Self { rest, spin: None }
    }
}

impl From<[f64; 3]> for MaterialPoint {
    fn from(rest: [f64; 3]) -> Self {
        DVec3::from(rest).into()
    }
}

impl Velocity {
    /// The worldline of `point`, at rest in the frame that moves so or turning there, reflected to move along +x.
    #[must_use]
    pub fn reflected_source(&self, point: impl Into<MaterialPoint>) -> Source {
        let MaterialPoint { rest, spin } = point.into();
        let Some(spin) = spin else { return self.reflected_point(rest.to_array()).into() };
        let off_axle = self.reflected(spin.off_axle(rest));
        let hub = self.reflected_point((rest - spin.off_axle(rest)).to_array());
        let turning = match spin.turning {
            Turning::Rolling => Turning::Rolling,
            Turning::RimSpeed(speed) => Turning::RimSpeed(self.direction() * speed),
        };
        // What is on the rim by rounding is.
        let rho = (math::hypot(off_axle.x, off_axle.z) / spin.radius).min(1.0);
        let angle = math::atan2(off_axle.z, off_axle.x);
        WheelPoint { hub, radius: spin.radius, rho, angle, turning }.into()
    }
}
