//! A point of a wheel before a moving observer.
//!
//! Each eye receives what an eye at rest would receive at its event on the ground; the line of sight is
//! transformed. By how much both differ is told from the step between the two events of emission, not by
//! subtraction.

use super::eye::EyeOnGround;
use super::motion::Observer;
use super::velocity::ObserverVelocity;
use crate::aperture::Aperture;
use crate::apparent::Sighting;
use crate::cone_pair::SightPair;
use crate::disparity::Disparity;
use crate::source::WheelPoint;
use crate::speed::Speed;
use crate::stereo::{Stereo, cross, dot, meeting, smallest_terms};
use crate::wheel::{EventStep, baseline, between_events};

/// A point of a wheel before both eyes.
pub(super) struct WheelView {
    each: [Sighting; 2],
    lines: SightPair<f64>,
    baseline: [f64; 3],
}

impl WheelView {
    /// The point before the `pair` of apertures in the axes of `observer`, who is at its event.
    pub fn new(speed: &Speed, observer: &Observer, wheel: &WheelPoint, pair: [Aperture; 2]) -> Self {
        let velocity = &observer.velocity;
        let events = pair.map(|eye| EyeOnGround::new(speed, observer, eye).event(observer));
        let seen = events.map(|(eye, time)| wheel.seen(speed, eye, time));
        let each = [0, 1].map(|i| in_observer_frame(velocity, wheel.sighting(speed, &seen[i], events[i].1)));

        let baseline = baseline(pair);
        let [left, right] = each.map(|seen| seen.position);
        let mean = std::array::from_fn(|i| 0.5 * (left[i] + right[i]));
        let step = between_events(speed, &wheel.circle(speed), &seen, dot(baseline, mean));
        let excess = in_observer_axes(velocity, &step);
        let difference: [f64; 3] = std::array::from_fn(|i| baseline[i] + excess[i]);
        let shorter = if each[1].distance < each[0].distance { right } else { left };
        let normal = cross(difference, shorter);
        let lines = SightPair { each: [left, right], mean, difference, normal, excess };
        Self { each, lines, baseline }
    }

    pub fn disparity(&self) -> Disparity {
        let (dphi, dtheta) = self.lines.angle_differences();
        let [primary, secondary] = self.each;
        Disparity { primary, secondary, dphi, dtheta }
    }

    /// The stereo position; `None` where the lines of sight do not meet.
    pub fn stereo(&self) -> Option<Stereo> {
        meeting(&self.lines, self.baseline)
    }
}

/// The part of a step between two events on the ground that is a step in space to an observer.
///
/// Along the velocity it is Gamma (p - V t), t and p being the step's time and its part along the velocity.
fn in_observer_axes(velocity: &ObserverVelocity, step: &EventStep) -> [f64; 3] {
    let (direction, own) = (velocity.direction(), velocity.speed());
    let EventStep { place, time, time_less_x } = *step;
    let ahead = dot(place, direction);
    let stretch = own.gamma_minus_one() * ahead - own.proper() * time;
    if direction[0] <= 0.0 {
        return std::array::from_fn(|i| place[i] + stretch * direction[i]);
    }
    // p - V t from what all of them lack to the speed of light.
    let aside = place[1] * direction[1] + place[2] * direction[2];
    let lead = own.one_minus_beta() * time - time_less_x - velocity.one_minus_x() * place[0] + aside;
    let across = cross(direction, cross(place, direction));
    std::array::from_fn(|i| {
        let along = own.gamma() * lead * direction[i];
        smallest_terms(&[place[i], stretch * direction[i]], &[across[i], along])
    })
}

/// The sighting by an eye that moves at `velocity`, from that of an eye at rest at the same event.
pub(super) fn in_observer_frame(velocity: &ObserverVelocity, seen: Sighting) -> Sighting {
    let (direction, own, line, r) = (velocity.direction(), velocity.speed(), seen.position, seen.distance);
    let along = dot(line, direction);
    let across = cross(direction, cross(line, direction));
    let (beta, gamma) = (own.beta(), own.gamma());
    let (along, distance) = if along >= 0.0 {
        (gamma * (along + beta * r), gamma * (r + beta * along))
    } else {
        // The same, without differences that cancel.
        let (ahead, aside) = (along * along / gamma, gamma * dot(across, across));
        ((ahead - beta * beta * aside) / (along - beta * r), (ahead + aside) / (r - beta * along))
    };
    let doppler_factor = if r > 0.0 { seen.doppler_factor * (distance / r) } else { seen.doppler_factor };
    let position = std::array::from_fn(|i| across[i] + along * direction[i]);
    Sighting { position, distance, doppler_factor, ..seen }
}
