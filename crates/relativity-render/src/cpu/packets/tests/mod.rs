//! Visibility by packets, against the f64 reference.

mod bits;
mod movement;
mod rays;
mod solids;
mod turning;

use std::array;
use std::f64::consts::TAU;

use fearless_simd::Level;
use glam::{DQuat, DVec3};
use relativity_core::{Aperture, Speed, Turning};

use super::body::{PacketBody, PacketGroup};
use super::ray::{line_of_sight, movement as movement_of, rest_ray};
use super::shape::middle;
use super::wheel::spin::PacketSpin;
use super::wheel::turning::TurningBody;
use crate::frame::uniform::FrameUniform;
use crate::simd::lanes::{F, LANES, Simd, SimdFrom, V2, V3};
use crate::simd::registers::on_registers;
use crate::{
    Appearance, Body, Camera, Gaze, Geometry, Group, GroupView, MaterialPoint, Motion, PreparedScene,
    Projection, Shape, Spin, Velocity, View,
};

/// Evenly spread numbers, the same in each run (`SplitMix64`).
struct Random(u64);

impl Random {
    /// Returns a number in [-1, 1).
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        (bits ^ bits >> 31) as f64 / 2f64.powi(63) - 1.0
    }

    /// In a ball of radius 1.
    fn in_ball(&mut self) -> DVec3 {
        loop {
            let place = DVec3::new(self.next(), self.next(), self.next());
            if place.length_squared() < 1.0 {
                return place;
            }
        }
    }
}

/// A case: one body in one view.
struct Case {
    body: Body,
    scene: PreparedScene,
    view: View,
    group_view: GroupView,
    frame: FrameUniform,
}

/// The motion of a group, and its view.
#[derive(Debug, Clone, Copy)]
struct Passing {
    beta: f64,
    is_backward: bool,
    geometry: Geometry,
    projection: Projection,
}

/// The result of packets in one pixel.
#[derive(Debug, Clone, Copy)]
struct Found {
    direction: DVec3,
    ground_per_rest: f64,
    doppler: f64,
    moment: DVec3,
    to_centre: f64,
    clearance: f64,
    half_width: f64,
    outward: DVec3,
    beyond: f64,
    /// From the middle of the group.
    place: DVec3,
    normal: DVec3,
    /// Along the unit vector `across`, which is perpendicular to the ray.
    movement: [f64; 2],
    across: DVec3,
    own_doppler: f64,
    from_hub: DVec3,
    /// Turn of the body when the hit is shown.
    turn: DQuat,
    there: DVec3,
}

impl Passing {
    /// Speeds, both ways, and geometries.
    fn all() -> impl Iterator<Item = Self> {
        let seen = [0.0, 0.5, 0.9, 0.9999].into_iter().flat_map(|beta| {
            [
                (Geometry::Seen, false),
                (Geometry::Seen, true),
                (Geometry::Contracted, false),
                (Geometry::Contracted, true),
            ]
            .map(|(geometry, is_backward)| Self {
                beta,
                is_backward,
                geometry,
                projection: Projection::Gaze,
            })
        });
        let ridden = [0.5, 0.9999].map(|beta| Self {
            beta,
            is_backward: false,
            geometry: Geometry::Rest,
            projection: Projection::Gaze,
        });
        seen.chain(ridden)
    }

    /// Returns every passage in flat pictures, and in conformal ones of a straight and of a tilted head.
    fn in_all_projections() -> impl Iterator<Item = Self> {
        let tilted = DVec3::new(0.9, 0.1, 0.42).normalize();
        let conformal = [DVec3::X, tilted].map(|right| Projection::Mercator { right, shift: 0.05 });
        let projections = [Projection::Gaze, conformal[0], conformal[1]];
        Self::all().flat_map(move |passing| projections.map(|projection| Self { projection, ..passing }))
    }

    fn motion(&self) -> Motion {
        match (self.is_backward, self.speed()) {
            (false, _) => Motion::Scene,
            (true, speed) => Motion::Own(Velocity { speed, is_backward: true }),
        }
    }

    fn speed(&self) -> Speed {
        Speed::from_beta(self.beta).expect("below 1")
    }

    /// A view whose event is at `event` in the rest frame.
    fn view_from(&self, event: DVec3) -> View {
        let speed = self.speed();
        let x = if self.beta > 0.0 { 0.05 } else { event.x };
        let aperture = Aperture { x, y: event.y, z: event.z };
        let forward = (x - event.x / speed.gamma()) / self.beta.max(1e-3);
        let observation_time = if self.is_backward { -forward } else { forward };
        let camera = Camera::new(aperture, Gaze::STRAIGHT_AHEAD, 1.0, [1000, 800]);
        let camera = Camera { projection: self.projection, ..camera };
        View { camera, speed, observation_time, geometry: self.geometry }
    }
}

impl Case {
    /// From the place `event` in the rest frame; another body beside it moves the middle of its group away.
    fn new(body: Body, event: DVec3, passing: Passing) -> Self {
        let aside = Shape::Sphere { centre: [1.5, 4.0, -1.0], radius: 0.2 };
        let bodies = [body.clone(), Body::new(aside, 500.0)];
        let scene = PreparedScene::new([Group { motion: passing.motion(), bodies: &bodies }]);
        let mut view = passing.view_from(event);
        let middle = MaterialPoint { rest: scene.solid(0).centre(), spin: body.spin };
        let seen = scene.group_views(&view)[0].apparent_position(middle);
        view.camera.gaze = Gaze::along(seen.expect("inside the domain").to_array());
        let views = scene.group_views(&view);
        let frame = FrameUniform::of_groups(&scene, &views, &Appearance::default())[0];
        Self { body, view, group_view: views[0], frame, scene }
    }

    fn middle(&self) -> DVec3 {
        self.scene.groups()[0].extent.middle
    }

    /// Returns the reach of the body from its centre.
    fn size(&self) -> f64 {
        self.scene.solid(0).bounding_radius()
    }

    /// Pixels that show places in and near the body.
    fn pixels(&self, random: &mut Random, spread: f64) -> [[f32; LANES]; 2] {
        let pixels: [_; LANES] = array::from_fn(|_| {
            loop {
                let place = self.scene.solid(0).centre() + random.in_ball() * (spread * self.size());
                let spin = self.body.spin;
                if spin.is_some_and(|spin| spin.off_axle(place).length() > spin.radius) {
                    continue;
                }
                let seen = self.group_view.apparent_position(MaterialPoint { rest: place, spin });
                if let Some([u, v]) = seen.and_then(|seen| self.view.camera.pixel(seen)) {
                    break [u as f32, v as f32];
                }
            }
        });
        [0, 1].map(|axis| pixels.map(|pixel| pixel[axis]))
    }

    fn line_of_sight(&self, u: f32, v: f32) -> DVec3 {
        self.view.camera.line_of_sight([u.into(), v.into()])
    }

    /// Returns what the pixels show of the body.
    fn found(&self, level: Level, pixels: &[[f32; LANES]; 2]) -> [Found; LANES] {
        on_registers!(level, simd => found(simd, self, pixels)).expect("wide registers")
    }

    /// Returns what the best registers find.
    fn found_best(&self, pixels: &[[f32; LANES]; 2]) -> [Found; LANES] {
        self.found(Level::new(), pixels)
    }

    /// The ray that was found, in f64, in the rest frame, moved by `aside`.
    fn ray(&self, found: &Found, aside: DVec3) -> crate::geometry::ray::Ray {
        let direction = found.direction.normalize();
        let start = self.middle() - direction.cross(found.moment) + aside;
        crate::geometry::ray::Ray { start, direction, from_camera: found.to_centre }
    }
}

#[inline(always)]
fn found<S: Simd>(simd: S, case: &Case, [u, v]: &[[f32; LANES]; 2]) -> [Found; LANES] {
    let prepared = &case.scene.bodies()[0];
    let (kind, turns) = (prepared.kind, case.group_view.turns(prepared));
    let shown = case.group_view.shown(prepared, case.middle());
    let group = PacketGroup { frame: &case.frame, geometry: case.group_view.geometry };
    let body = PacketBody::new(simd, &shown.placement);
    let spin = PacketSpin::new(simd, &shown);
    let sight = line_of_sight(simd, &case.frame, F::simd_from(simd, *u), F::simd_from(simd, *v));
    let ray = rest_ray(simd, &group, sight);
    let turning = TurningBody { kind, turns, group, body, spin };
    let met = turning.surface_when_shown(simd, &ray, None);
    let across = ray.direction.cross(V3::all(simd, [0.3, -0.5, 0.8]));
    let across = across / across.length();
    let moved: V2<S> = movement_of(&group, &ray, across);
    let own_doppler = turning.doppler(met.place, met.normal, &ray);
    let from_hub = turning.place_of_hit(met.place);
    let stands = turning.standing(simd, met.place);
    let place = middle(kind, &body) + met.place;
    array::from_fn(|lane| {
        let number = |x: F<S>| f64::from(x[lane]);
        let vector = |v: V3<S>| DVec3::from(v.lane(lane).map(f64::from));
        let turn = stands.body.turn;
        Found {
            direction: vector(ray.direction),
            ground_per_rest: number(ray.ground_per_rest),
            doppler: number(ray.doppler),
            moment: vector(ray.moment),
            to_centre: number(ray.to_centre),
            clearance: number(met.clearance),
            half_width: number(met.half_width),
            outward: vector(met.outward),
            beyond: number(met.beyond),
            place: vector(place),
            normal: vector(met.normal),
            movement: [number(moved.x), number(moved.y)],
            across: vector(across),
            own_doppler: number(own_doppler),
            from_hub: vector(from_hub),
            turn: DQuat::from_vec4(vector(turn.v).extend(number(turn.w))),
            there: vector(stands.place),
        }
    })
}

const CENTRE: DVec3 = DVec3::new(-0.3, 3.0, 0.1);

/// A ball, and bodies of each kind, slender and stout.
fn shapes() -> Vec<Shape> {
    let centre = CENTRE.to_array();
    let end = |x: f64, y: f64, z: f64| (CENTRE + DVec3::new(x, y, z)).to_array();
    let axis = DVec3::new(0.3, -0.5, 0.8).normalize().to_array();
    let turn = DQuat::from_axis_angle(DVec3::new(0.2, 0.9, -0.4).normalize(), 1.1).to_array();
    vec![
        Shape::Sphere { centre, radius: 0.5 },
        Shape::Tube { from: end(-0.4, 0.1, 0.2), to: end(0.4, -0.1, -0.2), radius: 0.1 },
        Shape::Tube { from: end(-0.1, 0.0, 0.5), to: end(0.1, 0.0, -0.5), radius: 0.01 },
        Shape::Ring { centre, axis, radius: 0.4, tube_radius: 0.15 },
        Shape::Ring { centre, axis: [0.0, 1.0, 0.0], radius: 0.5, tube_radius: 0.02 },
        Shape::Box { centre, half: [0.4, 0.2, 0.3], turn },
        Shape::Box { centre, half: [0.5, 0.02, 0.1], turn: DQuat::IDENTITY.to_array() },
        Shape::Cylinder { from: end(-0.2, 0.1, 0.3), to: end(0.2, -0.1, -0.3), radius: 0.3 },
        Shape::Cylinder { from: end(0.0, -0.02, 0.0), to: end(0.0, 0.02, 0.0), radius: 0.5 },
    ]
}

/// Places of cameras from a body, in its rest frame: aside, ahead of it and behind it.
const EVENTS: [DVec3; 4] = [
    DVec3::new(0.2, -3.0, 0.4),
    DVec3::new(2.5, -1.5, -0.6),
    DVec3::new(-2.0, -2.0, 0.9),
    DVec3::new(0.4, -0.7, 2.2),
];

/// Each shape in each view.
fn cases() -> impl Iterator<Item = (String, Case)> {
    let bodies = shapes().into_iter().map(|shape| Body::new(shape, 600.0)).collect();
    cases_of(bodies, Passing::in_all_projections().collect())
}

fn cases_of(bodies: Vec<Body>, passings: Vec<Passing>) -> impl Iterator<Item = (String, Case)> {
    bodies.into_iter().flat_map(move |body| {
        let body = body.clone();
        passings.clone().into_iter().flat_map(move |passing| {
            EVENTS.map(|from| {
                let context = format!("{:?}, {passing:?} from {from}", body.shape);
                (context, Case::new(body.clone(), CENTRE + from, passing))
            })
        })
    })
}

/// Wheels in flat pictures: how the way along a ray is searched does not ask where the ray comes from.
fn cases_of_wheels() -> impl Iterator<Item = (String, Case)> {
    cases_of(wheels(), Passing::all().collect())
}

/// Bodies of each kind that turn about an axle, and one that turns in its place.
fn wheels() -> Vec<Body> {
    let hub = CENTRE + DVec3::new(0.1, 0.05, -0.05);
    let place = |rho: f64, y: f64, turns: f64| {
        let (sine, cosine) = (TAU * turns).sin_cos();
        (hub + DVec3::new(rho * cosine, y, rho * sine)).to_array()
    };
    let turn = DQuat::from_axis_angle(DVec3::new(0.2, 0.9, -0.4).normalize(), 1.1).to_array();
    let axis = DVec3::new(0.3, -0.5, 0.8).normalize().to_array();
    let shapes = [
        Shape::Tube { from: place(0.05, 0.03, 0.1), to: place(0.45, 0.0, 0.2), radius: 0.01 },
        Shape::Tube { from: place(0.4, 0.0, 0.6), to: place(0.4, 0.0, 0.6), radius: 0.08 },
        Shape::Ring { centre: place(0.25, 0.0, 0.8), axis, radius: 0.15, tube_radius: 0.04 },
        Shape::Box { centre: place(0.2, 0.0, 0.4), half: [0.1, 0.05, 0.2], turn },
        Shape::Cylinder { from: place(0.3, -0.1, 0.9), to: place(0.2, 0.1, 0.9), radius: 0.12 },
        Shape::Ring { centre: hub.to_array(), axis: [0.0, 1.0, 0.0], radius: 0.48, tube_radius: 0.02 },
        Shape::Cylinder { from: place(0.0, -0.1, 0.0), to: place(0.0, 0.1, 0.0), radius: 0.3 },
    ];
    let spin = Spin { hub: hub.to_array(), radius: 0.5, turning: Turning::Rolling };
    shapes.map(|shape| Body::new(shape, 600.0).turning(spin)).to_vec()
}
