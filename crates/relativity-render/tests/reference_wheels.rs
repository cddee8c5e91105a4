//! Bodies that turn about an axle, drawn by the reference: against marching along the line of sight on the
//! ground, which shares nothing with it, and against known properties of a rolling wheel.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use relativity_core::{Aperture, Speed, Turning};
use relativity_render::{
    Body, Camera, Gaze, Geometry, Group, Hit, MaterialPoint, Motion, PreparedScene, Shape, Spin, Velocity,
    View,
};

use crate::support::{centred, signed_distance, spread};

const GEOMETRIES: [Geometry; 4] = [Geometry::Seen, Geometry::Contracted, Geometry::Rest, Geometry::OneCone];
const BETAS: [f64; 7] = [0.1, 0.5, -0.7, 0.9, 0.93, 0.99, 0.999];

/// A body that turns, how it moves, and a line of sight that passes near it.
struct Case {
    body: Body,
    spin: Spin,
    beta: f64,
    view: View,
    line_of_sight: DVec3,
}

impl Case {
    /// Every shape about a wheel of radius 0.5 or so at about (0, 3, 2), at every speed, in every geometry.
    fn new(i: u32) -> Self {
        let [a, b, c, d, e, f, g, h, k, l, m, n] = spread(i);
        let beta = BETAS[i as usize % BETAS.len()];
        let geometry = GEOMETRIES[(i as usize / BETAS.len()) % GEOMETRIES.len()];
        let hub = DVec3::new(a - 0.5, 2.0 + 2.0 * b, 1.5 * c - 0.5);
        let radius = 0.3 + 0.3 * d;
        let spin = Spin {
            hub: hub.to_array(),
            radius,
            turning: if e < 0.7 { Turning::Rolling } else { Turning::RimSpeed(2.0 * k - 1.0) },
        };
        let thin = radius * 0.1 * 10f64.powf(-2.0 * f);
        let place = |rho: f64, angle: f64, y: f64| {
            let (sine, cosine) = (TAU * angle).sin_cos();
            hub + DVec3::new(radius * rho * cosine, y, radius * rho * sine)
        };
        let shape = match i % 8 {
            0 => Shape::Sphere { centre: place(0.9 * g, h, 0.05).into(), radius: thin },
            1 => Shape::Box {
                centre: place(0.7 * g, h, 0.0).into(),
                half: [0.2 * radius, 0.1 * radius * k, thin],
                turn: DQuat::from_rotation_arc(DVec3::X, centred([g, h, k]).normalize()).to_array(),
            },
            2 => Shape::Cylinder {
                from: place(0.3, h, -0.1).into(),
                to: place(0.9, k, 0.1).into(),
                radius: thin,
            },
            3 => Shape::Ring {
                centre: place(0.5 * g, h, 0.0).into(),
                axis: centred([g, h, k]).normalize().into(),
                radius: 0.4 * radius,
                tube_radius: (2.0 * thin).min(0.3 * radius),
            },
            _ => Shape::Tube {
                from: place(0.1, h, 0.05 * (k - 0.5)).into(),
                to: place(0.97, h + 0.2 * (k - 0.5), 0.0).into(),
                radius: thin,
            },
        };
        let off_middle =
            if geometry == Geometry::OneCone { DVec3::X * (0.1 * (l - 0.5)) } else { DVec3::ZERO };
        let aperture = Aperture { x: off_middle.x, y: 0.0, z: 0.0 };
        let camera = Camera { off_middle, ..Camera::new(aperture, Gaze::STRAIGHT_AHEAD, 1.0, [640, 480]) };
        let is_forward = beta > 0.0;
        let speed = Speed::from_beta(beta.abs()).expect("below 1");
        let geometry =
            if is_forward { geometry } else { [Geometry::Seen, Geometry::Contracted][i as usize % 2] };
        // Seen, or measured, within four units of the camera.
        let along = 8.0 * l - 4.0;
        let passes = (along - hub.x / speed.gamma()) / beta;
        let delay = if geometry == Geometry::Contracted { 0.0 } else { DVec3 { x: along, ..hub }.length() };
        let view = View { camera, speed, observation_time: passes + delay, geometry };
        let body = Body::new(shape, 600.0).turning(spin);
        let case = Self { body, spin, beta, view, line_of_sight: DVec3::Y };
        // Towards a place on or near it.
        let near = shape.ends().map_or_else(
            || DVec3::from(shape.ball_around().0),
            |[from, to]| DVec3::from(from).lerp(to.into(), m),
        );
        let size = match i % 8 {
            1 => 0.2 * radius,
            3 => 0.5 * radius,
            _ => thin,
        };
        let near = near + centred([n, m, f]) * 1.5 * size;
        let aim = case.group_view().apparent_position(MaterialPoint { rest: near, spin: Some(spin) });
        let line_of_sight = aim.expect("inside the domain").normalize();
        Self { line_of_sight, ..case }
    }

    fn motion(&self) -> Motion {
        if self.beta > 0.0 {
            Motion::Scene
        } else {
            Motion::Own(Velocity::from_beta(self.beta).expect("a speed"))
        }
    }

    fn group_view(&self) -> relativity_render::GroupView {
        self.view.of_group(self.motion())
    }

    fn hit(&self) -> Option<Hit> {
        let bodies = [self.body.clone()];
        let scene = PreparedScene::new([Group { motion: self.motion(), bodies: &bodies }]);
        scene.first_hit(&self.view, self.line_of_sight)
    }

    /// The event at this `distance` along the line of sight in the rest frame: time, place.
    fn event(&self, distance: f64) -> (f64, DVec3) {
        let View { camera, observation_time, geometry, speed } = self.view;
        let aperture = DVec3::new(camera.aperture.x, camera.aperture.y, camera.aperture.z);
        let gamma = speed.gamma();
        let rest = |t: f64, p: DVec3| {
            (gamma * (t - self.beta * p.x), DVec3 { x: gamma * (p.x - self.beta * t), ..p })
        };
        let away = self.line_of_sight * distance;
        match geometry {
            Geometry::Seen | Geometry::Published => rest(observation_time - distance, aperture + away),
            Geometry::Contracted => rest(observation_time, aperture + away),
            Geometry::Rest => {
                let (t, p) = rest(observation_time, aperture);
                (t - distance, p + away)
            }
            Geometry::OneCone => {
                let from_middle = camera.off_middle + away;
                rest(observation_time - from_middle.length(), aperture - camera.off_middle + from_middle)
            }
        }
    }

    fn omega(&self) -> f64 {
        self.spin.turning.rim_speed(self.beta) / self.spin.radius
    }

    /// Returns the distance of the event at this `distance` from the body's surface.
    fn outside(&self, distance: f64) -> f64 {
        let (time, place) = self.event(distance);
        let (sine, cosine) = (self.omega() * time).sin_cos();
        // The angle from +x towards +z falls by omega t': back by that.
        let hub = DVec3::from(self.spin.hub);
        let DVec3 { x, y, z } = place - hub;
        let at_first = hub + DVec3::new(x * cosine - z * sine, y, x * sine + z * cosine);
        signed_distance(&self.body.shape, at_first)
    }

    /// By marching in small steps: the first distance at which the line of sight is inside, and the least
    /// distance outside of all.
    fn marched(&self) -> (Option<f64>, f64) {
        const STEPS: u32 = 4000;
        // Where the line of sight is nearest to the hub, and as far to both sides as the wheel reaches.
        let hub = DVec3::from(self.spin.hub);
        let from_hub = |distance: f64| self.event(distance).1.distance(hub);
        let [mut low, mut high] = [0.0, 1e3];
        while high - low > 1e-3 {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if from_hub(a) < from_hub(b) { high = b } else { low = a }
        }
        let rest_per_ground = self.event(low + 1e-3).1.distance(self.event(low).1) / 1e-3;
        let reach = 1e-3 + 1.3 * self.spin.radius / rest_per_ground;
        let [from, to] = [(low - reach).max(0.0), low + reach];
        let at = |i: u32| from + (to - from) * f64::from(i) / f64::from(STEPS);
        let values: Vec<_> = (0..=STEPS).map(|i| self.outside(at(i))).collect();
        assert!(values[0] > 0.0, "the camera is outside");
        let mut least = values[0];
        for i in 1..STEPS {
            let [before, here, after] = [i - 1, i, i + 1].map(|i| values[i as usize]);
            least = least.min(here);
            if here < 0.0 {
                return (Some(self.entry(at(i - 1), at(i))), least);
            }
            if here > before || here > after {
                continue;
            }
            // A least value near here, by golden section.
            let deepest = self.deepest(at(i - 1), at(i + 1));
            let value = self.outside(deepest);
            least = least.min(value);
            if value < 0.0 {
                return (Some(self.entry(at(i - 1), deepest)), least);
            }
        }
        (None, least)
    }

    fn deepest(&self, mut low: f64, mut high: f64) -> f64 {
        let golden = (5f64.sqrt() - 1.0) / 2.0;
        for _ in 0..60 {
            let [a, b] = [high - golden * (high - low), low + golden * (high - low)];
            let [at_a, at_b] = [self.outside(a), self.outside(b)];
            if at_a < 0.0 {
                return a;
            }
            if at_a < at_b {
                high = b;
            } else {
                low = a;
            }
        }
        0.5 * (low + high)
    }

    /// Returns where the line enters between a place `outside` and one `inside`.
    fn entry(&self, mut outside: f64, mut inside: f64) -> f64 {
        for _ in 0..80 {
            let middle = 0.5 * (outside + inside);
            if self.outside(middle) > 0.0 {
                outside = middle;
            } else {
                inside = middle;
            }
        }
        inside
    }
}

/// A wheel with dished spokes, a valve, and a box, a ball and a ring that turn with it.
fn wheel(hub: DVec3, radius: f64) -> Vec<Body> {
    let spin = Spin { hub: hub.to_array(), radius, turning: Turning::Rolling };
    let place = |rho: f64, angle: f64, y: f64| {
        let (sine, cosine) = angle.sin_cos();
        (hub + radius * DVec3::new(rho * cosine, y, rho * sine)).to_array()
    };
    let spoke = |i: i32| {
        let angle = TAU * f64::from(i) / 24.0;
        let side = if i % 2 == 0 { 0.1 } else { -0.1 };
        Shape::Tube {
            from: place(0.06, angle + 8.0 * side, side),
            to: place(0.93, angle, 0.0),
            radius: 0.006 * radius,
        }
    };
    let axis = [0.0, 1.0, 0.0];
    let turn = DQuat::from_rotation_x(0.4).to_array();
    let others = [
        Shape::Ring { centre: hub.to_array(), axis, radius: 0.96 * radius, tube_radius: 0.04 * radius },
        Shape::Tube { from: place(0.0, 0.0, -0.1), to: place(0.0, 0.0, 0.1), radius: 0.06 * radius },
        Shape::Tube { from: place(0.92, 0.1, 0.0), to: place(0.8, 0.1, 0.0), radius: 0.01 * radius },
        Shape::Box {
            centre: place(0.6, 1.0, 0.05),
            half: [0.05 * radius, 0.02 * radius, 0.04 * radius],
            turn,
        },
        Shape::Sphere { centre: place(0.5, 3.0, 0.0), radius: 0.05 * radius },
        Shape::Ring { centre: place(0.5, 4.0, 0.0), axis, radius: 0.2 * radius, tube_radius: 0.02 * radius },
    ];
    let shapes = (0..24).map(spoke).chain(others);
    shapes.map(|shape| Body::new(shape, 600.0).turning(spin)).collect()
}

#[test]
fn a_picture_shows_what_single_rays_meet() {
    let hub = DVec3::new(0.0, 3.0, 0.8);
    let scene = PreparedScene::moving(&wheel(hub, 0.5));
    for (i, beta) in [0.3, 0.9, 0.99].into_iter().enumerate() {
        for geometry in GEOMETRIES {
            let speed = Speed::from_beta(beta).expect("below 1");
            let off_middle = if geometry == Geometry::OneCone { DVec3::X * 0.05 } else { DVec3::ZERO };
            let aperture = Aperture { x: off_middle.x, y: 0.0, z: 0.0 };
            let camera = Camera { off_middle, ..Camera::new(aperture, Gaze::STRAIGHT_AHEAD, 1.0, [72, 56]) };
            let observation_time = [2.0, 3.5, 5.0][i];
            let mut view = View { camera, speed, observation_time, geometry };
            let middle = view.apparent_position(hub).expect("inside the domain");
            view.camera.gaze = Gaze::along(middle.to_array());
            view.camera.horizontal_fov = 1.4 / middle.length().max(1.0);
            let image = scene.hit_image(&view);
            let mut bodies = [0; 30];
            for (number, hit) in (0..).zip(&image.hits) {
                let pixel = [f64::from(number % 72) + 0.5, f64::from(number / 72) + 0.5];
                let alone = scene.first_hit(&view, view.camera.line_of_sight(pixel));
                assert_eq!(*hit, alone, "{geometry:?} at beta = {beta}, pixel {pixel:?}");
                if let Some(hit) = hit {
                    bodies[hit.body] += 1;
                }
            }
            let spokes = bodies[..24].iter().filter(|&&count| count > 0).count();
            assert!(spokes > 8 && bodies[24] > 40, "{geometry:?} at beta = {beta}: {bodies:?}");
        }
    }
}

#[test]
fn the_first_entry_into_what_turns_is_found_to_1e_12_in_every_geometry() {
    let (mut hits, mut misses, mut grazes) = (0, 0, 0);
    let mut worst = [0.0; 3];
    for i in 0..5600 {
        let case = Case::new(i);
        let (marched, least) = case.marched();
        let say = || format!("case {i}: {:?} {:?} beta {}", case.view.geometry, case.body.shape, case.beta);
        if least.abs() < 1e-11 {
            grazes += 1;
            continue;
        }
        let hit = case.hit();
        let Some(distance) = marched else {
            assert!(hit.is_none(), "{} is hit at {hit:?}, but {least:e} away", say());
            misses += 1;
            continue;
        };
        let Some(hit) = hit else { panic!("{} is missed, by {least:e}, at {distance}", say()) };
        hits += 1;
        // On the surface, and nowhere inside before.
        worst[0] = f64::max(worst[0], case.outside(hit.distance).abs());
        assert!(case.outside(hit.distance).abs() < 1e-12, "{}: {:e}", say(), case.outside(hit.distance));
        let slope = (case.outside(distance + 1e-7) - case.outside(distance - 1e-7)).abs() / 2e-7;
        let off = (hit.distance - distance).abs() * slope.min(1.0);
        worst[1] = f64::max(worst[1], off);
        assert!(off < 1e-10, "{}: {} instead of {distance}", say(), hit.distance);
        // The same point of the body.
        let on_body = signed_distance(&case.body.shape, hit.material_position).abs();
        worst[2] = f64::max(worst[2], on_body);
        assert!(on_body < 1e-12, "{}: {on_body:e} off the surface", say());
        let (time, place) = case.event(hit.distance);
        assert!(
            (hit.proper_time - time).abs() < 1e-11 && place.distance(hit.rest_position) < 1e-11,
            "{}",
            say()
        );
        // Picking leads back.
        let point = MaterialPoint { rest: hit.material_position, spin: Some(case.spin) };
        let seen = case.group_view().apparent_position(point).expect("inside the domain").normalize();
        let angle = seen.cross(case.line_of_sight).length();
        assert!(angle < 1e-9, "{}: picked {angle:e} away", say());
    }
    println!("{hits} hits, {misses} misses, {grazes} undecided; off {worst:?}");
    assert!(hits > 2000 && misses > 500 && grazes < 50);
}
