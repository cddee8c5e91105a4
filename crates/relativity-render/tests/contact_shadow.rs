//! Contact shadows lie where wheels are seen to touch the road, worked out here with nothing but the core's
//! sightings.

use glam::{DVec2, DVec3};
use relativity_core::{Aperture, PublishedVariant, SourcePoint, Speed, published_disparity, sighting};
use relativity_render::{
    Appearance, Body, Camera, Gaze, Geometry, Group, Motion, Picture, PreparedScene, Shape, Velocity, View,
};

const SIZE: [u32; 2] = [240, 180];
const GROUND: f64 = -2.0;
/// The place at rest where the wheel touches the road.
const CONTACT: [f64; 3] = [-0.4, 4.0, GROUND];
const RADIUS: f64 = 0.5;
/// A wheel so thin that it hides next to nothing of the road.
const TUBE: f64 = 0.002;
const D: f64 = 0.4;
const FIELD: f64 = 0.25;
/// The darkest level of 8 bits is a spot about 0.04 long; its middle is known this well.
const SPOT: f64 = 0.02;

fn appearance() -> Appearance {
    Appearance {
        ground_z: Some(GROUND),
        road: Some([-90.0, 90.0]),
        light: true,
        sky: false,
        ..Appearance::default()
    }
}

/// A wheel that touches the road, raised by `height`.
fn scene(velocity: Velocity, height: f64) -> PreparedScene {
    let [x, y, z] = CONTACT;
    let centre = [x, y, z + RADIUS + height];
    let ring = Shape::Ring { centre, axis: [0.0, 1.0, 0.0], radius: RADIUS - TUBE, tube_radius: TUBE };
    let motion = if velocity.is_backward { Motion::Own(velocity) } else { Motion::Scene };
    PreparedScene::new([Group { motion, bodies: &[Body::new(ring, 600.0)] }])
}

/// The place from the eye at this x where it sees the contact, by the formulas of each geometry.
fn seen_contact(speed: &Speed, geometry: Geometry, time: f64, eye: f64) -> DVec3 {
    let [x, y, z] = CONTACT;
    let (gamma, beta) = (speed.gamma(), speed.beta());
    let point = SourcePoint::from_rest(CONTACT, speed);
    let from = |x: f64| {
        let seen = sighting(speed, point, Aperture { x, y: 0.0, z: 0.0 }, time).expect("in the domain");
        DVec3::from(seen.position)
    };
    match geometry {
        Geometry::Seen => from(eye),
        Geometry::OneCone => from(0.0) - DVec3::X * eye,
        Geometry::Contracted => DVec3::new(x / gamma + beta * time - eye, y, z),
        Geometry::Rest => DVec3::new(x - gamma * (eye - beta * time), y, z),
        // Which measures both eyes' angles from the left one.
        Geometry::Published => {
            let both = published_disparity(speed, point, -2.0 * eye, time, PublishedVariant::AppendixA);
            both.expect("in the domain").secondary.position.into()
        }
    }
}

fn view(velocity: Velocity, geometry: Geometry, time: f64, eye: f64, contact: DVec3) -> View {
    let gaze = Gaze::along(contact.to_array());
    let mut camera = Camera::new(Aperture { x: eye, y: 0.0, z: 0.0 }, gaze, FIELD, SIZE);
    camera.off_middle = DVec3::X * eye;
    View { camera, speed: velocity.speed, observation_time: time, geometry }
}

fn light([red, green, blue, _]: [u8; 4]) -> u32 {
    u32::from(red) + u32::from(green) + u32::from(blue)
}

/// The middle of the pixels of the road that are darkest, px; and their light, as a share of the brightest's.
fn darkest(picture: &Picture, is_road: impl Fn(usize) -> bool) -> (DVec2, f64) {
    let width = SIZE[0] as usize;
    let lights = picture.rgba.iter().map(|rgba| light(*rgba)).enumerate().filter(|(i, _)| is_road(*i));
    let road: Vec<_> = lights.collect();
    let least = road.iter().map(|(_, light)| *light).min().expect("there is a road");
    let most = road.iter().map(|(_, light)| *light).max().expect("there is a road");
    let places: Vec<_> = road.iter().filter(|(_, light)| *light == least).map(|(i, _)| *i).collect();
    let place = |i: &usize| DVec2::new((i % width) as f64, (i / width) as f64) + 0.5;
    let sum = places.iter().map(place).sum::<DVec2>();
    (sum / places.len() as f64, f64::from(least) / f64::from(most))
}

/// For both eyes: where the wheel touches, one event is seen of the wheel and of the road.
#[test]
fn the_road_is_darkest_where_the_wheel_touches_it() {
    let velocities = [0.0, 0.5, 0.9, -0.7].map(|beta| Velocity::from_beta(beta).expect("below 1"));
    let mut looked_at = 0;
    for velocity in velocities {
        let geometries = [Geometry::Seen, Geometry::OneCone, Geometry::Contracted, Geometry::Rest];
        let both = geometries.into_iter().flat_map(|geometry| [(geometry, -D / 2.0), (geometry, D / 2.0)]);
        for (geometry, eye) in both.chain([(Geometry::Published, -D / 2.0)]) {
            if velocity.is_backward && geometry != Geometry::Seen {
                continue;
            }
            let time = 4.0;
            let contact = if velocity.is_backward {
                let mirrored = Aperture { x: -eye, y: 0.0, z: 0.0 };
                let [x, y, z] = CONTACT;
                let point = SourcePoint::from_rest([-x, y, z], &velocity.speed);
                let seen = sighting(&velocity.speed, point, mirrored, time).expect("in the domain");
                DVec3::from(seen.position) * DVec3::new(-1.0, 1.0, 1.0)
            } else {
                seen_contact(&velocity.speed, geometry, time, eye)
            };
            let view = view(velocity, geometry, time, eye, contact);
            let scene = scene(velocity, 0.0);
            let hits = scene.hit_image(&view).hits;
            let shadowed = scene.picture(&view, &appearance(), 1);
            let (found, share) = darkest(&shadowed, |i| hits[i].is_none());
            let expected = DVec2::from(view.camera.pixel(contact).expect("in front"));
            let off = found.distance(expected);
            let px_per_unit = view.camera.focal_length_px() / contact.length();
            assert!(off < SPOT * px_per_unit, "{geometry:?} {velocity:?} {eye}: {found} for {expected}");
            assert!(share < 0.6, "{geometry:?} {velocity:?} {eye}: {share}");
            looked_at += 1;
        }
    }
    assert_eq!(looked_at, 29);
}

#[test]
fn a_raised_wheel_and_a_grid_have_no_shadow() {
    let velocity = Velocity::from_beta(0.9).expect("below 1");
    let contact = seen_contact(&velocity.speed, Geometry::Seen, 4.0, 0.1);
    let view = view(velocity, Geometry::Seen, 4.0, 0.1, contact);
    for (height, road) in [(0.1, appearance().road), (0.0, None)] {
        let appearance = Appearance { road, ..appearance() };
        let scene = scene(velocity, height);
        let (hits, drawn) = (scene.hit_image(&view).hits, scene.picture(&view, &appearance, 1).rgba);
        let plain = PreparedScene::new([]).picture(&view, &appearance, 1).rgba;
        let mut road = (0..plain.len()).filter(|i| hits[*i].is_none());
        assert!(road.all(|i| drawn[i] == plain[i]), "{height} {road:?}");
    }
}
