//! Events of a wheel's points: at a time by the clocks of its rest frame, at one time of the ground, and as
//! they pass a plane.
//!
//! Each place is given as a point that rests in the moving frame and is at the same event, so that everything
//! known of such points holds for it.

use super::root::{measured_later, root};
use super::seen::WheelCircle;
use crate::aperture::Aperture;
use crate::math;
use crate::source::{Source, SourcePoint, WheelPoint};
use crate::speed::Speed;

impl WheelPoint {
    /// Returns the place of the point at this `angle` in the moving frame, as a point that rests there.
    fn place_at_angle(&self, speed: &Speed, angle: f64) -> SourcePoint {
        let r = self.rho * self.radius;
        let (sine, cosine) = math::sin_cos(angle);
        let SourcePoint { x0, y, z } = self.hub;
        SourcePoint { x0: x0 + r * cosine / speed.gamma(), y, z: z + r * sine }
    }

    /// Returns the place of the point at `proper_time`, by the clocks of the rest frame (those of
    /// [`Sighting::proper_time`](crate::Sighting)), as a point that rests in the moving frame.
    #[must_use]
    pub fn place_at(&self, speed: &Speed, proper_time: f64) -> SourcePoint {
        self.place_at_angle(speed, self.angle_at(speed, proper_time))
    }

    /// Returns the place of the point at `time` on the ground, as [`Self::place_at`]: at x = `x0` + beta
    /// `time`.
    ///
    /// For a rolling wheel this is Kepler's equation, with beta rho as the eccentricity.
    #[must_use]
    pub fn place_when_measured(&self, speed: &Speed, time: f64) -> SourcePoint {
        let (r, omega) = (self.rho * self.radius, self.omega(speed));
        let phase = self.angle_at(speed, self.hub.worldline(speed).proper_time(time));
        let later = measured_later(speed.beta(), r, phase, omega);
        self.place_at_angle(speed, phase - omega * later)
    }

    /// Returns the speed of the point on the ground where it is at this `angle` in the moving frame:
    /// velocities compose so that the lowest point of a wheel that rolls rests, at any speed.
    ///
    /// # Accuracy
    ///
    /// As [`crate::sighting`]. Measured for wheels that roll (`tests/oracle`, 15,000 inputs): median 0.1, 99
    /// % 2.3, worst 4 units.
    #[must_use]
    pub fn speed_on_ground(&self, speed: &Speed, angle: f64) -> f64 {
        let WheelCircle { omega, speed: own, below_light, slip, .. } = self.circle::<f64>(speed);
        let (sine, cosine) = math::sin_cos(angle);
        // It moves at v s along the motion and at v cos up. 1 + s without a difference where that is near 0.
        let s = sine * omega.signum();
        let lift = if s < 0.0 { cosine * cosine / (1.0 - s) } else { 1.0 + s };
        let beta = speed.beta();
        // beta + v s, and 1 + beta v s.
        let along = slip + own * lift;
        let added = speed.one_minus_beta() + beta * below_light + beta * own * lift;
        math::hypot(along, own * cosine / speed.gamma()) / added
    }

    /// Returns the place of the point, as [`Self::place_at`], where it passes the plane through `middle` on
    /// the ground that is across `normal`. `None` if it rests, and for a plane along the motion. A point of a
    /// rolling wheel passes a plane across the motion once; where it passes a slanted one several times, this
    /// is one of these.
    #[must_use]
    pub fn place_when_passing(
        &self,
        speed: &Speed,
        middle: Aperture,
        normal: [f64; 3],
    ) -> Option<SourcePoint> {
        let [nx, ny, nz] = normal;
        let (r, omega, beta) = (self.rho * self.radius, self.omega(speed), speed.beta());
        let SourcePoint { x0, y, z } = self.hub.relative_to(middle);
        let [y_share, z_share] = [ny / nx, nz / nx];
        let hub_passes = -(x0 + y_share * y + z_share * z) / beta;
        // From then on by the rest frame's clocks, with q from the hub: beta later + q_x + z_share
        // q_z/gamma = 0.
        let (along, up) = (r / beta, r * z_share / (beta * speed.gamma()));
        let longest = math::hypot(along, up);
        if !(longest.is_finite() && hub_passes.is_finite()) {
            return None;
        }
        let phase = self.angle_at(speed, self.hub.worldline(speed).proper_time(hub_passes));
        let later = root([-longest, longest], |later| {
            let (sine, cosine) = math::sin_cos(phase - omega * later);
            (later + along * cosine + up * sine, 1.0 + omega * (along * sine - up * cosine))
        });
        Some(self.place_at_angle(speed, phase - omega * later))
    }
}

impl Source {
    /// Returns the place of the point at `time` on the ground: at x = `x0` + beta `time`, and at y and z.
    #[must_use]
    pub fn place_when_measured(&self, speed: &Speed, time: f64) -> SourcePoint {
        match self {
            Self::Point(point) => *point,
            Self::Wheel(wheel) => wheel.place_when_measured(speed, time),
        }
    }

    /// When it is at x = 0 on the ground; of a point of a wheel that does not roll, when it is there once.
    /// `None` if it rests.
    #[must_use]
    pub fn time_at_origin(&self, speed: &Speed) -> Option<f64> {
        let place = match self {
            Self::Point(point) => *point,
            Self::Wheel(wheel) => wheel.place_when_passing(speed, Aperture::default(), [1.0, 0.0, 0.0])?,
        };
        place.worldline(speed).time_at(0.0)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, TAU};

    use super::*;
    use crate::source::Turning;
    use crate::{Baseline, equidistance_time, sighting};

    fn speed(beta: f64) -> Speed {
        Speed::from_beta(beta).expect("in range")
    }

    /// The street's front wheel: its hub's rest place is (-0.525, 3, 2).
    fn wheel(speed: &Speed, rho: f64, angle: f64) -> WheelPoint {
        let hub = SourcePoint::from_rest([-0.525, 3.0, 2.0], speed);
        WheelPoint { hub, radius: 0.525, rho, angle, turning: Turning::Rolling }
    }

    /// A wheel that rolls draws a cycloid: measured on the ground, a turn on a circle of circumference gamma
    /// 2 pi W, of which its frame has one of 2 pi W. The point on the ground rests there: it is at one place
    /// at the beginning of a turn and at the next gamma 2 pi W further on, and never moves back.
    #[test]
    fn a_rolling_wheel_is_measured_on_a_cycloid() {
        for beta in [0.1, 0.9, 0.999] {
            let speed = speed(beta);
            let point = wheel(&speed, 1.0, -FRAC_PI_2);
            let x = |time: f64| {
                let place = point.place_when_measured(&speed, time);
                [place.x0 + beta * time, place.z]
            };
            // The hub is at x = 0 and its angle -pi/2 when its own clock shows 0, which is at x0 + beta t =
            // gamma^2 x0.
            let start = (speed.gamma().powi(2) - 1.0) * point.hub.x0 / beta;
            let turn = TAU * 0.525 * speed.gamma() / beta;
            for turns in [0.0, 1.0, 5.0] {
                let [along, z] = x(start + turns * turn);
                let place = speed.gamma() * (turns * TAU * 0.525 - 0.525);
                assert!(
                    (along - place).abs() < 1e-9 * (1.0 + place.abs()),
                    "beta = {beta}: {along} for {place}"
                );
                assert!((z - (2.0 - 0.525)).abs() < 1e-12);
            }
            let mut before = x(start)[0];
            for step in 1..=2000 {
                let along = x(start + turn * f64::from(step) / 1000.0)[0];
                assert!(along >= before - 1e-12 * (1.0 + before.abs()), "beta = {beta}, step {step}");
                before = along;
            }
        }
    }

    /// Both apertures see what passes the plane between them equally far, and at once.
    #[test]
    fn what_is_seen_equally_far_is_one_event() {
        for beta in [0.01, 0.5, 0.9, 0.9999] {
            let speed = speed(beta);
            for (roll, turn) in [(0.0, 0.0), (0.4, 0.0), (-0.7, 0.9)] {
                for angle in [-3.0, -1.6, 0.0, 0.7, 2.0] {
                    let point = wheel(&speed, 0.94, angle);
                    let pair = Baseline { separation: 0.3, roll, turn }.apertures();
                    let pair = pair.map(|eye| Aperture { x: eye.x + 0.8, z: eye.z - 0.4, ..eye });
                    let time =
                        equidistance_time(&speed, point, pair).expect("in the domain").expect("it moves");
                    let [left, right] =
                        pair.map(|eye| sighting(&speed, point, eye, time).expect("in the domain"));
                    let off = (left.distance - right.distance).abs() / left.distance;
                    assert!(off < 1e-13, "beta = {beta}, roll {roll}, angle {angle}: {off:e}");
                    let event = (left.retarded_time - right.retarded_time).abs() / left.distance;
                    assert!(event < 1e-12, "beta = {beta}: {event:e}");
                }
            }
        }
    }

    /// Light that one aperture sees at x = 0 left there at t = T - R, as measured.
    #[test]
    fn what_is_seen_was_where_it_is_measured() {
        for beta in [0.01, 0.5, 0.9, 0.9999] {
            let speed = speed(beta);
            for angle in [-3.0, -1.6, 0.0, 0.7, 2.0] {
                let point = wheel(&speed, 1.0, angle);
                for time in [-3.0, 0.0, 3.6, 8.0] {
                    let seen = sighting(&speed, point, Aperture::default(), time).expect("in the domain");
                    let place = point.place_when_measured(&speed, seen.retarded_time);
                    let there = [place.x0 + beta * seen.retarded_time, place.y, place.z];
                    let off = there.iter().zip(seen.position).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    // t is known to its rounding, from which gamma^2 and the slope 1/(1 - rho) of the place
                    // make this.
                    let known = 1e-15 * (1.0 + seen.retarded_time.abs()) * speed.gamma().powi(2);
                    assert!(off < 16.0 * known.max(1e-14), "beta = {beta}, T = {time}: {off:e}");
                }
                let time = Source::from(point).time_at_origin(&speed).expect("it moves");
                let measured = point.place_when_measured(&speed, time);
                assert!((measured.x0 + beta * time).abs() < 1e-13 * speed.gamma(), "beta = {beta}");
            }
        }
    }

    #[test]
    fn what_rests_passes_nothing() {
        let rest = Speed::REST;
        for speed in [rest, speed(1e-310)] {
            assert_eq!(Source::from(wheel(&speed, 1.0, 0.0)).time_at_origin(&speed), None);
        }
        let (fast, up) = (speed(0.9), [0.0, 0.0, 1.0]);
        assert_eq!(wheel(&fast, 1.0, 0.0).place_when_passing(&fast, Aperture::default(), up), None);
    }
}
