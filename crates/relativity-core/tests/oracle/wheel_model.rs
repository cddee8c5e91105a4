//! A point of a wheel from its definition: a worldline on the ground, and the event on it whose light
//! arrives.

use std::cell::RefCell;

use dashu_float::ops::Abs;

use crate::arithmetic::{Big, big, sqrt, square};
use crate::model::{Parameter, View, angle_differences, difference, speed};

/// The last root of an equation: a start for the next one.
pub type Start = RefCell<Option<Big>>;

/// A seen event: its place, and its time by the clocks of the rest frame.
pub struct Sight {
    pub view: View,
    pub proper_time: Big,
}

/// A wheel that rolls.
pub struct Wheel {
    pub speed: (Big, Big),
    /// x0, y and z of the hub.
    pub hub: [Big; 3],
    /// rho W.
    r: Big,
    omega: Big,
    rim: Big,
    angle: Big,
}

impl Wheel {
    /// `inputs`: speed parameter, x0, y, z of the hub, W, rho, angle.
    pub fn new(parameter: Parameter, inputs: &[Big]) -> Self {
        let speed = speed(parameter, &inputs[0]);
        let [radius, rho, angle] = [4, 5, 6].map(|i| inputs[i].clone());
        Self {
            hub: [1, 2, 3].map(|i| inputs[i].clone()),
            omega: &speed.0 / &radius,
            rim: &speed.0 * &rho,
            r: rho * radius,
            angle,
            speed,
        }
    }

    /// Returns the event that an aperture sees: the root of T - t - |P - a| along the worldline, by the time
    /// of the rest frame.
    pub fn seen(&self, aperture: &[Big], time: &Big, start: &Start) -> Sight {
        let (beta, gamma) = &self.speed;
        let [x0, y, z] = &self.hub;
        let from_aperture = difference(&self.hub, aperture);
        let hub = View::new(&self.speed, from_aperture, time);
        let hub_time = hub.proper_time(&self.speed, &(x0 - &aperture[0])) - gamma * beta * &aperture[0];
        let at = |own: &Big| {
            let (sine, cosine) = (&self.angle - &self.omega * own).sin_cos();
            let x = gamma * x0 + &self.r * &cosine;
            let event = gamma * (own + beta * &x);
            let from = [
                gamma * (&x + beta * own) - &aperture[0],
                y - &aperture[1],
                z + &self.r * &sine - &aperture[2],
            ];
            let distance = sqrt(&(square(&from[0]) + square(&from[1]) + square(&from[2])));
            let velocity = [&self.rim * sine, -(&self.rim * cosine)];
            let along = &from[0] * gamma * (&velocity[0] + beta) + &from[2] * &velocity[1];
            let slope = gamma * (big(1.0) + beta * &velocity[0]) + along / &distance;
            (time - event - &distance, slope, from, distance)
        };
        let (mut low, mut high) = (&hub_time - &self.r, &hub_time + &self.r);
        let margin = (&high - &low) * big(1e-50);
        (low, high) = (low - &margin, high + &margin);
        let mut own = start.borrow().clone().filter(|own| *own > low && *own < high).unwrap_or(hub_time);
        let smallest = (big(1.0) + own.clone().abs()) * Big::from_parts(1.into(), -330);
        for _ in 0..2000 {
            let (value, slope, ..) = at(&own);
            if value < Big::ZERO {
                high.clone_from(&own);
            } else {
                low.clone_from(&own);
            }
            let newton = &own + value / slope;
            let is_inside = newton >= low && newton <= high;
            let next = if is_inside { newton } else { (&low + &high) / big(2.0) };
            let step = (&next - &own).abs();
            own = next;
            if step < smallest {
                break;
            }
        }
        let (value, slope, [x, y, z], r) = at(&own);
        let (_, gamma) = &self.speed;
        assert!(value.abs() < (gamma + time.clone().abs()) * Big::from_parts(1.into(), -220));
        start.replace(Some(own.clone()));
        let doppler = sqrt(&(big(1.0) - square(&self.rim))) / slope;
        Sight { view: View { x, y, z, t: time - &r, r, doppler }, proper_time: own }
    }
}

/// X, z, t, tau, R, D, phi, theta. `inputs`: speed parameter, x0, y, z of the hub, W, rho, angle, aperture x,
/// y, z, T.
pub fn sighting(parameter: Parameter, inputs: &[Big], start: &Start) -> [Big; 8] {
    let Sight { view, proper_time } = Wheel::new(parameter, inputs).seen(&inputs[7..10], &inputs[10], start);
    let (phi, theta) = (view.phi(), view.theta());
    [view.x, view.z, view.t, proper_time, view.r, view.doppler, phi, theta]
}

/// dphi, dtheta. `inputs`: those of [`sighting`], and the secondary aperture.
pub fn disparity(parameter: Parameter, inputs: &[Big], starts: &[Start; 2]) -> [Big; 2] {
    let wheel = Wheel::new(parameter, inputs);
    let left = wheel.seen(&inputs[7..10], &inputs[10], &starts[0]);
    let right = wheel.seen(&inputs[11..14], &inputs[10], &starts[1]);
    angle_differences(&left.view, &right.view)
}
