//! A wheel of a bicycle, and views of it.

pub mod spokes;

use std::f64::consts::TAU;

use glam::DVec3;
use relativity_core::{Aperture, Speed, Turning};
use relativity_render::{
    Body, Camera, Gaze, Geometry, Group, MaterialPoint, Motion, Pattern, PreparedScene, Shape, Spin, View,
};

/// The place of the axle, and the radius on which the wheel rolls.
pub const HUB: [f64; 3] = [-0.3, 3.0, 0.1];
pub const RADIUS: f64 = 0.5;
const SPOKES: u32 = 20;

/// The turning of the wheel.
pub const SPIN: Spin = Spin { hub: HUB, radius: RADIUS, turning: Turning::Rolling };

/// Tyre, rim and hub; a valve and crossed spokes to both sides of the hub.
pub fn wheel() -> Vec<Body> {
    let hub = DVec3::from(HUB);
    let ring = |radius, tube_radius| Shape::Ring { centre: HUB, axis: [0.0, 1.0, 0.0], radius, tube_radius };
    let place = |rho: f64, angle: f64, y: f64| {
        let (sine, cosine) = angle.sin_cos();
        (hub + DVec3::new(rho * cosine, y, rho * sine)).to_array()
    };
    let spoke = |i: u32| {
        let side = f64::from(i % 2) * 2.0 - 1.0;
        let angle = TAU * f64::from(i) / f64::from(SPOKES);
        let across = if i % 4 < 2 { 0.9 } else { -0.9 };
        Shape::Tube {
            from: place(0.03, angle + across, 0.035 * side),
            to: place(0.46, angle, 0.0),
            radius: 0.002,
        }
    };
    let valve = Shape::Tube { from: place(0.46, 0.3, 0.0), to: place(0.41, 0.3, 0.0), radius: 0.004 };
    let round = [
        ring(0.48, 0.02),
        ring(0.46, 0.008),
        Shape::Tube { from: place(0.0, 0.0, -0.05), to: place(0.0, 0.0, 0.05), radius: 0.02 },
    ];
    let pattern = Pattern::Stripes { step: TAU * 0.48 / 24.0 };
    let shapes = round.into_iter().chain([valve]).chain((0..SPOKES).map(spoke));
    let bodies = shapes.map(|shape| Body::new(shape, 600.0).turning(SPIN));
    bodies.enumerate().map(|(i, body)| if i == 0 { Body { pattern, ..body } } else { body }).collect()
}

/// The place of a camera, in the wheel's rest frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum From {
    /// Abreast of the wheel.
    Side,
    /// Ahead of the wheel and behind it, more aside than along.
    Before,
    Behind,
    /// Nearly in its plane.
    Flat,
    /// In its plane, as it comes and as it goes, and above.
    PlaneBefore,
    PlaneBehind,
    PlaneAbove,
}

impl From {
    pub const ALL: [Self; 7] = [
        Self::Side,
        Self::Before,
        Self::Behind,
        Self::Flat,
        Self::PlaneBefore,
        Self::PlaneBehind,
        Self::PlaneAbove,
    ];

    /// Whether the camera is in the wheel's plane, as good as.
    pub const fn is_in_plane(self) -> bool {
        matches!(self, Self::PlaneBefore | Self::PlaneBehind | Self::PlaneAbove)
    }

    /// The hub from the camera's event.
    const fn hub(self) -> DVec3 {
        match self {
            Self::Side => DVec3::new(0.2, 3.0, -0.4),
            Self::Before => DVec3::new(-1.5, 2.0, -0.5),
            Self::Behind => DVec3::new(1.8, 2.0, 0.3),
            Self::Flat => DVec3::new(2.5, 0.5, -0.3),
            Self::PlaneBefore => DVec3::new(-2.0, 0.0, 0.3),
            Self::PlaneBehind => DVec3::new(2.0, 0.0, 0.3),
            Self::PlaneAbove => DVec3::new(0.5, 0.01, -2.0),
        }
    }
}

/// A picture of the wheel, as wide as the picture, from there, `aside` from the middle between the eyes.
pub fn view_of_wheel(from: From, beta: f64, geometry: Geometry, aside: f64) -> View {
    let speed = Speed::from_beta(beta).expect("below 1");
    view_of_hub(from.hub(), speed, geometry, aside)
}

/// The same where the hub is at `hub` from the camera's event, in the rest frame.
pub fn view_of_hub(hub: DVec3, speed: Speed, geometry: Geometry, aside: f64) -> View {
    let beta = speed.beta();
    let event = DVec3::from(HUB) - hub;
    let x = if beta > 0.0 { aside } else { event.x };
    let aperture = Aperture { x, y: event.y, z: event.z };
    // The camera's event, or that of the middle between the eyes, is at gamma (x - beta T) in the rest frame.
    let receives = if geometry == Geometry::OneCone { 0.0 } else { x };
    let observation_time = (receives - event.x / speed.gamma()) / beta.max(1e-3);
    let camera = Camera::new(aperture, Gaze::STRAIGHT_AHEAD, 1.0, [280, 280]);
    let mut view = View { camera, speed, observation_time, geometry };
    let hub = seen(&view, DVec3::from(HUB));
    view.camera.gaze = Gaze::along(hub.to_array());
    // All of the rim is in the picture.
    let axis = hub.normalize();
    let widest = (0..64).map(|i| {
        let (sine, cosine) = (TAU * f64::from(i) / 64.0).sin_cos();
        let off_axle = DVec3::new(cosine, 0.0, sine) * RADIUS;
        seen(&view, DVec3::from(HUB) + off_axle).angle_between(axis)
    });
    let widest = widest.fold(0.0, f64::max).min(0.8);
    view.camera.horizontal_fov = 2.1 * widest;
    view
}

fn seen(view: &View, rest: DVec3) -> DVec3 {
    let point = MaterialPoint { rest, spin: Some(SPIN) };
    view.apparent_position(point).expect("inside the domain")
}

/// The wheel alone.
pub fn scene() -> PreparedScene {
    PreparedScene::new([Group { motion: Motion::Scene, bodies: &wheel() }])
}
