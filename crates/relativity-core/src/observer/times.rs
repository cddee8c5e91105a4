//! When the light that a moving eye receives was emitted.

use super::{Observer, RidersView};
use crate::aperture::Aperture;
use crate::apparent::{LightCone, sighting_inside_domain};
use crate::math;
use crate::source::SourcePoint;
use crate::speed::Speed;
use crate::stereo::{cross, dot, smallest_terms};

/// Emission as an eye receives it: t by the ground's clocks, and tau by the point's own.
#[derive(Debug, Clone, Copy)]
pub(super) struct EmissionTimes {
    pub retarded_time: f64,
    pub own_time: f64,
}

/// The point as the middle between the eyes sees it, from which the eyes' times are told.
#[derive(Debug, Clone, Copy)]
pub(super) struct Middle {
    cone: LightCone<f64>,
    /// Its line of sight, in the observer's axes.
    line: [f64; 3],
    retarded_time: f64,
    own_time: f64,
}

impl Middle {
    /// The middle of `observer`, who is at its event: a resting aperture there receives the same light.
    pub fn new(view: &RidersView) -> Self {
        let RidersView { speed, point, observer, .. } = *view;
        let [x, y, z] = observer.place;
        let seen = sighting_inside_domain(speed, point, Aperture { x, y, z }, observer.time);
        let (cone, line) = view.line_of_sight(Aperture::default());
        Self { cone, line, retarded_time: seen.retarded_time, own_time: seen.own_time }
    }

    /// The times of what `eye` receives through its `cone`, at the event of `observer`.
    ///
    /// The eye's clock of the point is ahead of the middle's by b.(P + `P_m`)/(r + `r_m`), with b from the middle to the eye, P
    /// the places where both see it and r its distances in the point's rest frame. Of three sums for t the one with
    /// the smallest terms is taken.
    pub fn times_of_eye(
        &self,
        view: &RidersView,
        eye: Aperture,
        cone: &LightCone<f64>,
        line: [f64; 3],
    ) -> EmissionTimes {
        let RidersView { speed, point, observer, relative, .. } = view;
        let there = relative.aperture(eye);
        let (seen, middle) = (&cone.solution, &self.cone.solution);
        let rest_distances = relative.speed.gamma() * (seen.q + middle.q);
        let sum = [seen.x + middle.x, cone.y + self.cone.y, cone.z + self.cone.z];
        let along = [there.x * sum[0], there.y * sum[1], there.z * sum[2]];
        let sum: [f64; 3] = std::array::from_fn(|i| line[i] + self.line[i]);
        let along = smallest_terms(&along, &[eye.x * sum[0], eye.y * sum[1], eye.z * sum[2]]);
        let ahead = if rest_distances > 0.0 { along / rest_distances } else { 0.0 };
        let from_middle = [self.retarded_time, speed.gamma() * ahead, 0.0, 0.0, 0.0];
        let on_ground = EyeOnGround::new(speed, observer, eye);
        let [t_by_cone, own_by_cone] = on_ground.by_light_cone(speed, observer, *point);
        let by_distance = on_ground.by_distance(observer, line, seen.r);
        let own_from_middle = [self.own_time, ahead, 0.0, 0.0, 0.0];
        EmissionTimes {
            retarded_time: sum_that_cancels_least(t_by_cone, &[from_middle, by_distance]),
            own_time: sum_that_cancels_least(own_by_cone, &[own_from_middle]),
        }
    }
}

/// The terms of a sum, how large they are telling how much of it may cancel.
type Terms = [f64; 5];

/// One of several sums for the same number: `direct`, unless another has far smaller terms. (The others start from what the
/// middle between the eyes sees, which may be known less well.)
fn sum_that_cancels_least(direct: Terms, others: &[Terms]) -> f64 {
    let size = |terms: &Terms| terms.iter().map(|term| term.abs()).sum::<f64>();
    let smaller = |a, b| if FAR_SMALLER * size(b) < size(a) { b } else { a };
    others.iter().fold(&direct, smaller).iter().sum()
}

/// By how much terms have to be smaller.
const FAR_SMALLER: f64 = 4.0;

/// An eye on the ground, from the middle between both.
pub(super) struct EyeOnGround {
    /// dt, by how much later than the middle's its event is.
    later: f64,
    /// From the middle's place to its own.
    offset: [f64; 3],
    /// dt - dx and dt + dx.
    later_less_x: f64,
    later_plus_x: f64,
    /// dx - beta dt.
    x_less_motion: f64,
}

impl EyeOnGround {
    pub fn new(speed: &Speed, observer: &Observer, Aperture { x, y, z }: Aperture) -> Self {
        let velocity = &observer.velocity;
        let (own, direction, aside) = (velocity.speed(), velocity.direction(), velocity.one_minus_x());
        let [vx, ..] = direction;
        let along = dot([x, y, z], direction);
        let across = cross(direction, cross([x, y, z], direction));
        let stretched = own.gamma() * along;
        let [lag, own_lag] = [speed, own].map(Speed::one_minus_beta);
        let (v_less_x, x_less_motion) = if vx > 0.0 {
            (aside - own_lag, lag + speed.beta() * own_lag - aside)
        } else {
            (own.beta() - vx, vx - speed.beta() * own.beta())
        };
        Self {
            later: stretched * own.beta(),
            offset: std::array::from_fn(|i| across[i] + stretched * direction[i]),
            later_less_x: stretched * v_less_x - across[0],
            later_plus_x: stretched * (own.beta() + vx) + across[0],
            x_less_motion: across[0] + stretched * x_less_motion,
        }
    }

    /// Place on the ground, and T there.
    pub fn event(&self, observer: &Observer) -> (Aperture, f64) {
        let [x, y, z] = std::array::from_fn(|i| observer.place[i] + self.offset[i]);
        (Aperture { x, y, z }, observer.time + self.later)
    }

    /// The terms of t = T - R on the ground.
    fn by_distance(&self, observer: &Observer, line: [f64; 3], distance: f64) -> Terms {
        let own = observer.velocity.speed();
        let along = dot(line, observer.velocity.direction());
        [observer.time, self.later, -own.gamma() * distance, own.proper() * along, 0.0]
    }

    /// The terms of t, and of tau, from the light cone of the eye on the ground.
    fn by_light_cone(&self, speed: &Speed, observer: &Observer, point: SourcePoint) -> [Terms; 2] {
        let (beta, gamma, lag) = (speed.beta(), speed.gamma(), speed.one_minus_beta());
        let [ox, oy, oz] = observer.place;
        let time = observer.time;
        let s = ((point.x0 - ox) + beta * time) - self.x_less_motion;
        let rho = math::hypot(point.y - oy - self.offset[1], point.z - oz - self.offset[2]);
        let sum = math::hypot(s, rho / gamma) + s.abs();
        let beyond = if sum > 0.0 { rho * (rho / sum) } else { 0.0 };
        let (terms, x0, near, far) = if s <= 0.0 {
            ([time, -ox, self.later_less_x], point.x0, lag, 1.0 + beta)
        } else {
            ([time, ox, self.later_plus_x], -point.x0, 1.0 + beta, lag)
        };
        let [a, b, c] = terms.map(|term| term / near);
        let retarded_time = [a, b, c, x0 / near, -beyond];
        let [a, b, c] = terms.map(|term| gamma * far * term);
        [retarded_time, [a, b, c, gamma * x0, -beyond / gamma]]
    }
}
