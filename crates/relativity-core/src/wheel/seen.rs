//! The light cone of one aperture, solved for a point of a wheel.

use crate::aperture::Aperture;
use crate::apparent::{LightCone, Sighting, Solution};
use crate::math::{self, Elementary};
use crate::source::{Turning, WheelPoint};
use crate::speed::{Coefficients, Speed};

use super::root::seen_later;

/// Greatest number of corrections of the time of emission; one is enough unless the aperture is in the wheel.
const CORRECTIONS: u32 = 3;

/// The circle on which a point of a wheel turns, in the precision it is solved in.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WheelCircle<F> {
    /// Radius of the circle, rho W.
    pub r: F,
    /// At t' = 0.
    pub angle: F,
    pub omega: F,
    /// v = |omega| r.
    pub speed: F,
    /// 1 - v, without the subtraction.
    pub below_light: F,
    /// beta - v, likewise.
    pub slip: F,
}

impl<F: Elementary> WheelCircle<F> {
    /// From the hub to the point at `angle`: x and z.
    pub fn place(&self, angle: F) -> [F; 2] {
        let (sine, cosine) = math::sin_cos(angle);
        [self.r * cosine, self.r * sine]
    }

    /// 1 + u.n', u being the direction in which the point moves at `angle`, and n' that of `from`, where it
    /// is from the aperture in the rest frame; as a sum of positive terms. 1 in the aperture, where n' is
    /// none.
    pub fn turned_away(&self, angle: F, [x, y, z]: [F; 3]) -> F {
        let (sine, cosine) = math::sin_cos(angle);
        let distance = (x * x + y * y + z * z).sqrt();
        if distance.is_zero() {
            return F::one();
        }
        let along = (x * sine - z * cosine) * self.omega.signum();
        let outward = x * cosine + z * sine;
        if along < F::zero() {
            ((y * y + outward * outward) / (distance - along)) / distance
        } else {
            F::one() + along / distance
        }
    }

    /// Returns the factor by which the point's own motion multiplies the Doppler factor, `slope` being 1 +
    /// v.n'.
    pub fn own_doppler(&self, slope: F) -> F {
        (self.below_light * (F::one() + self.speed)).sqrt() / slope
    }
}

/// A hub before an aperture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hub<F> {
    /// Objective x at t = 0.
    pub x0: F,
    pub aperture_x: F,
    pub observation_time: F,
    /// From the aperture: S, y and z.
    pub from: [F; 3],
}

/// A point of a wheel as one aperture sees it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SeenWheelPoint<F> {
    /// The light cone of a point that rests where it is when it is seen.
    pub cone: LightCone<F>,
    /// When, by the clocks of the rest frame.
    pub proper_time: F,
    /// Angle of the point at that time.
    pub angle: F,
    /// Slope 1 + v.n'.
    pub slope: F,
}

impl<F: Elementary> SeenWheelPoint<F> {
    /// Solves for the time: the root from the hub, improved until it agrees with the one from the point's own
    /// place, which is as accurate as for any resting point, even where the hub is then far from the
    /// aperture.
    pub fn new(coefficients: &Coefficients<F>, circle: &WheelCircle<F>, hub: &Hub<F>) -> Self {
        let [s, y, z] = hub.from;
        let gamma = coefficients.gamma;
        let at_hub = LightCone::at(coefficients, s, y, z);
        let hub_time = at_hub.proper_time(coefficients, hub.x0, hub.aperture_x, hub.observation_time);
        let phase = circle.angle - circle.omega * hub_time;
        let at = |time: F| {
            let angle = circle.angle - circle.omega * time;
            let [qx, qz] = circle.place(angle);
            let along = qx * coefficients.inverse_gamma;
            let cone = LightCone::at(coefficients, s + along, y, z + qz);
            let away = circle.turned_away(angle, [gamma * cone.s, y, cone.z]);
            // The time that goes with the rounded angle, to which the equation holds.
            let proper_time =
                cone.proper_time(coefficients, hub.x0 + along, hub.aperture_x, hub.observation_time);
            Self { cone, proper_time, angle, slope: circle.below_light + circle.speed * away }
        };
        let later = seen_later([gamma * s, y, z], circle.r, phase, circle.omega);
        let mut time = hub_time + later;
        let mut seen = at(time);
        for _ in 0..CORRECTIONS {
            let better = time + (seen.proper_time - time) / seen.slope;
            if (better - time).abs() <= F::epsilon() * time.abs() {
                break;
            }
            time = better;
            seen = at(time);
        }
        seen.place_on_worldline(coefficients, circle, hub, time);
        seen
    }

    /// Takes the apparent X from where the point is on the ground at `time`, if that is better known than
    /// from the light cone: near the road it hardly depends on when light leaves it.
    fn place_on_worldline(
        &mut self,
        coefficients: &Coefficients<F>,
        circle: &WheelCircle<F>,
        hub: &Hub<F>,
        time: F,
    ) {
        let &Coefficients { beta, gamma, .. } = coefficients;
        let Solution { q, r, .. } = self.cone.solution;
        let [qx, qz] = circle.place(self.angle);
        let by_angle = qz * (circle.angle.abs() + (circle.omega * time).abs());
        let by_place = [gamma * hub.x0, qx, beta * time, by_angle]
            .iter()
            .fold(hub.aperture_x.abs(), |sum, term| sum + gamma * term.abs());
        let by_cone = (hub.x0.abs() + hub.aperture_x.abs() + (beta * hub.observation_time).abs()) * (r / q);
        if by_place < by_cone {
            let x = gamma * (gamma * hub.x0 + (qx + beta * time)) - hub.aperture_x;
            let LightCone { y, z, .. } = self.cone;
            self.cone.solution.x = x;
            self.cone.solution.r = (x * x + y * y + z * z).sqrt();
        }
    }
}

impl WheelPoint {
    /// Returns the circle of the point, in the precision `F`.
    pub(crate) fn circle<F: Elementary>(&self, speed: &Speed) -> WheelCircle<F> {
        let rim = self.turning.rim_speed(speed.beta());
        let [below_light, slip] = match self.turning {
            Turning::Rolling => {
                let slip = speed.beta() * (1.0 - self.rho);
                [speed.one_minus_beta() + slip, slip]
            }
            Turning::RimSpeed(rim) => [1.0, speed.beta()].map(|limit| (-self.rho).mul_add(rim.abs(), limit)),
        };
        let to = |value: f64| F::from(value).unwrap_or_else(F::infinity);
        WheelCircle {
            r: to(self.rho * self.radius),
            angle: to(self.angle),
            omega: to(rim / self.radius),
            speed: to(self.rho * rim.abs()),
            below_light: to(below_light),
            slip: to(slip),
        }
    }

    /// Returns the point as `aperture` sees it at `observation_time`.
    pub(crate) fn seen(
        &self,
        speed: &Speed,
        aperture: Aperture,
        observation_time: f64,
    ) -> SeenWheelPoint<f64> {
        let from = [
            (self.hub.x0 - aperture.x) + speed.beta() * observation_time,
            self.hub.y - aperture.y,
            self.hub.z - aperture.z,
        ];
        let hub = Hub { x0: self.hub.x0, aperture_x: aperture.x, observation_time, from };
        SeenWheelPoint::new(&speed.coefficients(), &self.circle(speed), &hub)
    }

    /// Returns the sighting that belongs to `seen`.
    pub(crate) fn sighting(
        &self,
        speed: &Speed,
        seen: &SeenWheelPoint<f64>,
        observation_time: f64,
    ) -> Sighting {
        let LightCone { y, z, ref solution, .. } = seen.cone;
        let own_doppler = self.circle(speed).own_doppler(seen.slope);
        Sighting {
            position: [solution.x, y, z],
            distance: solution.r,
            retarded_time: observation_time - solution.r,
            proper_time: seen.proper_time,
            doppler_factor: solution.doppler_factor * own_doppler,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::source::SourcePoint;
    use crate::source::Turning;

    /// The Doppler factor of the hub's motion and that of the turning: each may be as small as 1/gamma or as
    /// large as gamma.
    #[test]
    fn both_doppler_factors_of_a_point_on_the_road_multiply_to_one_without_cancelling() {
        let hub = SourcePoint { x0: 0.0, y: 0.0, z: 1.0 };
        let (rho, angle, turning) = (1.0, -FRAC_PI_2, Turning::Rolling);
        let point = WheelPoint { hub, radius: 1.0, rho, angle, turning };
        for gamma in [1.0, 1.5, 10.0, 1e3, 1e4] {
            let speed = Speed::from_gamma(gamma).expect("a speed");
            let circle = point.circle(&speed);
            for s in [-1e6, -3.0, -1e-3, 0.0, 1e-4, 0.2, 5.0, 1e6] {
                for [y, z] in [[3.0, -2.0], [-0.1, 0.0], [0.0, -1e-3], [40.0, 7.0]] {
                    let cone: LightCone<f64> = LightCone::at(&speed.coefficients(), s, y, z);
                    let away = circle.turned_away(angle, [gamma * s, y, z]);
                    let own = circle.own_doppler(circle.below_light + circle.speed * away);
                    let error = (cone.solution.doppler_factor * own - 1.0).abs();
                    assert!(error < 1e-12, "{error:e} at gamma = {gamma}, {s} {y} {z}");
                }
            }
        }
    }
}
