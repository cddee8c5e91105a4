//! The turning of a body for the shaders: the pipelines it needs, and its start in one view.

use glam::{DQuat, DVec3};
use relativity_core::Turning;

use crate::geometry::shape::Shape;
use crate::kinematics::spin::{MaterialPoint, Spin};
use crate::kinematics::velocity::Velocity;
use crate::scene::prepared_body::{Placement, PreparedBody};
use crate::view::effects::{Constant, Effects};
use crate::view::group_view::GroupView;
use crate::view::{Appearance, Geometry};

/// The turning of a body within its group, as far as it chooses a pipeline: a still body is drawn as if
/// nothing could turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Turns {
    /// The body does not turn.
    Not,
    /// The body turns, but its surface stays where it is.
    InPlace,
    /// The surface of the body turns.
    About,
}

/// A body as one view has the shaders begin with it: as it is when the view shows the middle of its axle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningStart {
    /// Placement of the body at that time.
    pub placement: Placement,
    /// The middle of its axle, from the middle of its group; and omega, about +y.
    pub spin: [f32; 4],
    /// 1 less the speed of the rim, and the rim's speed less that of a ring's outermost circle; both counted
    /// along the motion of the group.
    pub rim: [f32; 2],
}

impl Turns {
    /// Whether a body that turns so has another Doppler factor than 1 in this geometry.
    pub fn has_doppler_effect(self, geometry: Geometry) -> bool {
        geometry.has_doppler_effect() || self != Self::Not && geometry == Geometry::Rest
    }

    /// Returns the constant of the shaders.
    pub fn constant(self) -> Constant {
        let number = match self {
            Self::Not => 0.0,
            Self::InPlace => 1.0,
            Self::About => 2.0,
        };
        ("TURNS", number)
    }
}

impl GroupView {
    /// The effects of a picture, for what turns so.
    pub(crate) fn effects(&self, turns: Turns, appearance: &Appearance) -> Effects {
        let is_lit = self.is_lit_by_the_street(appearance);
        let effects = Effects::new(is_lit || turns.has_doppler_effect(self.geometry), appearance);
        if is_lit { effects.in_street_daylight() } else { effects }
    }

    /// Returns the turning of `body`, one of the group.
    pub(crate) fn turns(&self, body: &PreparedBody) -> Turns {
        match body.spin {
            Some(spin) if spin.omega(self.on_ground.beta()) == 0.0 => Turns::Not,
            Some(_) if body.is_turned => Turns::About,
            Some(_) => Turns::InPlace,
            None => Turns::Not,
        }
    }

    /// The point of `body`, one of the group, that the corner of a triangle over it is which the shaders put
    /// at `place`. Over one that turns in its place corners stay where they are; but in the published model
    /// two events show each point.
    pub(crate) fn corner(&self, body: &PreparedBody, place: DVec3) -> MaterialPoint {
        match (body.spin, self.turns(body)) {
            (Some(spin), Turns::InPlace) if self.geometry == Geometry::Published => {
                let rest = spin.turned(place, -self.turn_at(&spin, place));
                MaterialPoint { rest, spin: Some(spin) }
            }
            (spin, Turns::About) => MaterialPoint { rest: place, spin },
            (_, Turns::Not | Turns::InPlace) => place.into(),
        }
    }

    /// `body`, one of the group, whose middle is `middle`, for the shaders.
    pub(crate) fn shown(&self, body: &PreparedBody, middle: DVec3) -> TurningStart {
        let Some(spin) = body.spin.filter(|_| self.turns(body) != Turns::Not) else {
            return TurningStart { placement: body.placement, spin: [0.0; 4], rim: [0.0; 2] };
        };
        let hub = DVec3::from(spin.hub);
        let omega = spin.omega(self.on_ground.beta());
        let angle = omega * self.time_at(hub);
        let turn = DQuat::from_rotation_y(angle) * body.turn;
        let direction = self.velocity.sign();
        let outermost = match body.shape {
            Shape::Ring { radius, tube_radius, .. } => radius + tube_radius,
            _ => spin.radius,
        };
        let lag = direction * omega * (spin.radius - outermost);
        let mut placement = Placement::new(&body.shape.turned(&spin, angle), turn, middle);
        if body.triangles.is_some() {
            placement.form[3] = spin.radius as f32;
        }
        TurningStart {
            placement,
            spin: (hub - middle).as_vec3().extend(omega as f32).to_array(),
            rim: [below_light(&spin, &self.on_ground, direction), lag].map(|v| v as f32),
        }
    }
}

/// 1 less the speed of the rim along `direction`, without the difference where it rolls forwards.
fn below_light(spin: &Spin, on_ground: &Velocity, direction: f64) -> f64 {
    match spin.turning {
        Turning::Rolling if direction == on_ground.direction() => on_ground.speed.one_minus_beta(),
        turning => 1.0 - direction * turning.rim_speed(on_ground.beta()),
    }
}
