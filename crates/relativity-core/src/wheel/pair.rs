//! A point of a wheel as two apertures see it.
//!
//! No difference of two sightings is formed. By the clocks of the rest frame, the time Delta between the two
//! emissions and the chord q from the second place to the first satisfy
//!
//! ```text
//! gamma Delta (1 + v sin(h)/h u.n) = -((P_l + P_r).b + (R_l + R_r) s)/(q_l + q_r),    h = omega Delta/2
//! q = v Delta sin(h)/h u
//! ```
//!
//! where u = (sin a, 0, -cos a), a is the mean of both angles, n the sum of both places over the sum of both
//! distances in the rest frame, P and R are from each aperture to its event on the ground, b is from one
//! aperture to the other, and s by how much later the second one looks. On the ground the events are gamma
//! (`q_x` + beta Delta) apart in x, and `q_z` in z.

use crate::aperture::Aperture;
use crate::apparent::LightCone;
use crate::cone_pair::{ConePair, SightPair};
use crate::disparity::Disparity;
use crate::math;
use crate::published::{self, PublishedVariant};
use crate::source::WheelPoint;
use crate::speed::Speed;
use crate::stereo::{self, Stereo, StereoError, cross};
use crate::wheel::seen::{Hub, SeenWheelPoint, WheelCircle};

/// A point of a wheel before two apertures.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SeenPair {
    /// The point as the primary and as the secondary aperture see it.
    pub each: [SeenWheelPoint<f64>; 2],
    pub lines: SightPair<f64>,
}

/// From one aperture to the other, and by how much later that one looks.
#[derive(Debug, Clone, Copy)]
struct ApertureStep {
    baseline: [f64; 3],
    later: f64,
}

/// From the event that the secondary aperture sees to the primary's, on the ground.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EventStep {
    pub place: [f64; 3],
    pub time: f64,
    /// Time of the step less its x.
    pub time_less_x: f64,
}

impl SeenPair {
    fn new(
        speed: &Speed,
        circle: &WheelCircle<f64>,
        each: [SeenWheelPoint<f64>; 2],
        step: ApertureStep,
    ) -> Self {
        let cones = each.map(|seen| seen.cone);
        let places = cones.map(|LightCone { y, z, solution, .. }| [solution.x, y, z]);
        let mean: [f64; 3] = std::array::from_fn(|i| 0.5 * (places[0][i] + places[1][i]));
        let ApertureStep { baseline, later } = step;
        let sum_r = cones[0].solution.r + cones[1].solution.r;
        let along = baseline[0] * mean[0] + baseline[1] * mean[1] + baseline[2] * mean[2];
        let excess = between_events(speed, circle, &each, along + 0.5 * later * sum_r).place;
        let difference: [f64; 3] = std::array::from_fn(|i| baseline[i] + excess[i]);
        // P_l x P_r from the shorter of both, in which less cancels.
        let [left, right] = cones.map(|cone| cone.solution.r);
        let normal = cross(difference, places[usize::from(right < left)]);
        let lines = SightPair { each: places, mean, difference, normal, excess };
        Self { each, lines }
    }

    /// (Delta-phi, Delta-theta), from the sines and cosines of the differences.
    pub fn angle_differences(&self) -> (f64, f64) {
        self.lines.angle_differences()
    }
}

/// Returns how far the events lie apart that two apertures see. `along` is the step from one aperture's event
/// to the other's along the mean of both lines of sight, b.P + s R on the ground: the same number in every
/// frame.
pub(crate) fn between_events(
    speed: &Speed,
    circle: &WheelCircle<f64>,
    each: &[SeenWheelPoint<f64>; 2],
    along: f64,
) -> EventStep {
    let [left, right] = each;
    let sum_q = left.cone.solution.q + right.cone.solution.q;
    if sum_q == 0.0 {
        return EventStep { place: [0.0; 3], time: 0.0, time_less_x: 0.0 };
    }
    let delay = 2.0 * along / sum_q;
    let angle = 0.5 * (left.angle + right.angle);
    let away = |seen: &SeenWheelPoint<f64>| {
        let LightCone { s, y, z, ref solution } = seen.cone;
        circle.turned_away(angle, [speed.gamma() * s, y, z]) * solution.q
    };
    let away = (away(left) + away(right)) / sum_q;
    // By the difference of both times, which tells well enough how far the chord is from the arc.
    let half_turn = 0.5 * circle.omega * (left.proper_time - right.proper_time);
    let slope = circle.below_light + circle.speed * (slack(half_turn) + chord(half_turn) * away);
    let stretched = -delay / slope; // gamma Delta
    let half_turn = 0.5 * circle.omega * (stretched / speed.gamma());
    let (sine, cosine) = math::sin_cos(angle);
    let forward = sine * circle.omega.signum();
    // 1 + forward; it is 0 on the road.
    let rising = if forward < 0.0 { cosine * cosine / (1.0 - forward) } else { 1.0 + forward };
    let velocity = circle.slip + circle.speed * (slack(half_turn) + chord(half_turn) * rising);
    // 1 - forward, and 1 - the velocity along the chord.
    let falling = if forward > 0.0 { cosine * cosine / (1.0 + forward) } else { 1.0 - forward };
    let chord_lag = circle.below_light + circle.speed * (slack(half_turn) + chord(half_turn) * falling);
    let chord_velocity = circle.speed * chord(half_turn) * forward;
    EventStep {
        place: [stretched * velocity, 0.0, -2.0 * circle.r * math::sin(half_turn) * cosine],
        time: stretched * (1.0 + speed.beta() * chord_velocity),
        time_less_x: stretched * speed.one_minus_beta() * chord_lag,
    }
}

impl WheelPoint {
    /// Returns the point as two apertures see it at one time. The baseline may be known better than by the
    /// difference of both.
    pub(crate) fn seen_by_pair(
        &self,
        speed: &Speed,
        pair: [Aperture; 2],
        time: f64,
        baseline: [f64; 3],
    ) -> SeenPair {
        let (coefficients, circle) = (speed.coefficients(), self.circle(speed));
        let [left, right] = pair;
        let hub = ConePair::new(&coefficients, self.hub, left, right, time);
        let seen = |aperture: Aperture, cone: &LightCone<f64>| {
            SeenWheelPoint::new(&coefficients, &circle, &self.before(cone, aperture.x, time))
        };
        let each = [seen(left, &hub.left), seen(right, &hub.right)];
        SeenPair::new(speed, &circle, each, ApertureStep { baseline, later: 0.0 })
    }

    /// Returns the point in the published model: seen by the left aperture of a `pair` along x, and again
    /// later by the second number.
    pub(crate) fn seen_as_published(
        &self,
        speed: &Speed,
        [left, right]: [Aperture; 2],
        time: f64,
        variant: PublishedVariant,
    ) -> (SeenPair, f64) {
        let (coefficients, circle) = (speed.coefficients(), self.circle(speed));
        let seen = |time: f64| {
            let hub = LightCone::new(speed, self.hub, left, time);
            SeenWheelPoint::new(&coefficients, &circle, &self.before(&hub, left.x, time))
        };
        let first = seen(time);
        let later = published::shift(speed, right.x - left.x, &first.cone, variant);
        let each = [first, seen(time + later)];
        (SeenPair::new(speed, &circle, each, ApertureStep { baseline: [0.0; 3], later }), later)
    }

    fn before(&self, hub: &LightCone<f64>, aperture_x: f64, observation_time: f64) -> Hub<f64> {
        Hub { x0: self.hub.x0, aperture_x, observation_time, from: [hub.s, hub.y, hub.z] }
    }
}

/// A share of a wheel's radius whose square counts as nothing.
const HAIR: f64 = 1e-20;

impl WheelPoint {
    /// Returns the disparity of the point for two apertures.
    pub(crate) fn disparity(&self, speed: &Speed, pair: [Aperture; 2], observation_time: f64) -> Disparity {
        let seen = self.seen_by_pair(speed, pair, observation_time, baseline(pair));
        self.disparity_of(speed, &seen, [observation_time; 2])
    }

    /// Returns the disparity of the point for two apertures in a published model.
    pub(crate) fn published_disparity(
        &self,
        speed: &Speed,
        pair: [Aperture; 2],
        observation_time: f64,
        variant: PublishedVariant,
    ) -> Disparity {
        let (seen, later) = self.seen_as_published(speed, pair, observation_time, variant);
        self.disparity_of(speed, &seen, [observation_time, observation_time + later])
    }

    fn disparity_of(&self, speed: &Speed, seen: &SeenPair, times: [f64; 2]) -> Disparity {
        let [primary, secondary] = [0, 1].map(|i| self.sighting(speed, &seen.each[i], times[i]));
        let (dphi, dtheta) = seen.angle_differences();
        Disparity { primary, secondary, dphi, dtheta }
    }

    /// Returns the stereo position of the point. Two apertures in one place stand for the limit of those
    /// along x.
    pub(crate) fn stereo(
        &self,
        speed: &Speed,
        pair: [Aperture; 2],
        observation_time: f64,
    ) -> Result<Stereo, StereoError> {
        let mut baseline = baseline(pair);
        if baseline == [0.0; 3] {
            baseline[0] = HAIR * self.radius;
        }
        let SeenPair { lines, .. } = self.seen_by_pair(speed, pair, observation_time, baseline);
        stereo::meeting(&lines, baseline).ok_or(StereoError::Apart)
    }
}

/// From the first to the second aperture.
pub(crate) fn baseline([left, right]: [Aperture; 2]) -> [f64; 3] {
    [right.x - left.x, right.y - left.y, right.z - left.z]
}

/// sin(h)/h: how long a chord is against its arc, h being half the angle that both span.
fn chord(h: f64) -> f64 {
    if h == 0.0 { 1.0 } else { math::sin(h) / h }
}

/// 1 - sin(h)/h, without the difference where h is small.
fn slack(h: f64) -> f64 {
    if h.abs() > 1.0 {
        return 1.0 - chord(h);
    }
    // h^2/3! (1 - h^2/(4 5) (1 - h^2/(6 7) (1 - ...)))
    let square = h * h;
    let series = (2_u32..9).rev().map(|k| f64::from(2 * k * (2 * k + 1)));
    square / 6.0 * series.fold(1.0, |inner, factor| 1.0 - square / factor * inner)
}
