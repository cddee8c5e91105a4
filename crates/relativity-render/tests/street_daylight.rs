//! Pictures by the street's daylight, beside those by daylight that rides along.

use relativity_core::{Aperture, Speed};
use relativity_render::colour::srgb_encoded;
use relativity_render::colour::sunlit::{colour, log2_level, on_screen};
use relativity_render::light::tone::toned;
use relativity_render::{
    Appearance, Body, Camera, Colour, Gaze, Geometry, Group, Motion, Paint, Picture, PreparedScene, Shading,
    Shape, Velocity, View,
};

const SIZE: [u32; 2] = [64, 48];

fn appearance(colour: Colour) -> Appearance {
    let (shading, exposure_ev) = (Shading::Emission, -2.0);
    Appearance { colour, exposure_ev, shading, sky: false, ..Appearance::default() }
}

fn view(beta: f64, time: f64, azimuth: f64) -> View {
    let gaze = Gaze { azimuth, elevation: 0.0 };
    View {
        camera: Camera::new(Aperture::default(), gaze, 0.9, SIZE),
        speed: Speed::from_beta(beta).expect("a speed"),
        observation_time: time,
        geometry: Geometry::Seen,
    }
}

fn dice() -> Vec<Body> {
    let die = |x: f64, nm: f64| {
        Body::new(Shape::Box { centre: [x, 3.0, 0.0], half: [0.5; 3], turn: [0.1, 0.2, 0.3, 0.9] }, nm)
    };
    vec![die(-1.2, 620.0), die(0.3, 480.0)]
}

/// Both pictures of `scene`: daylight that rides along, and the street's.
fn both(scene: &PreparedScene, view: &View) -> [Picture; 2] {
    [Colour::White, Colour::StreetDaylight].map(|colour| scene.picture(view, &appearance(colour), 1))
}

/// The colour in the middle of the picture.
fn middle(picture: &Picture) -> [f64; 3] {
    let [width, height] = SIZE.map(|side| side as usize);
    let [red, green, blue, _] = picture.rgba[height / 2 * width + width / 2];
    [red, green, blue].map(f64::from)
}

#[test]
fn at_rest_both_pictures_are_the_same() {
    let scene = PreparedScene::moving(&dice());
    let [own, street] = both(&scene, &view(0.0, 0.0, 1.7));
    assert!(own.rgba == street.rgba && own.rgba.iter().any(|pixel| *pixel != own.rgba[0]));
}

#[test]
fn what_rests_on_the_street_is_the_same_beside_what_moves() {
    let far = [Body::new(Shape::Sphere { centre: [0.0, 60.0, 40.0], radius: 1.0 }, 600.0)];
    let passing = Group { motion: Motion::Scene, bodies: &far };
    let scene = PreparedScene::new([passing, Group { motion: Motion::Own(Velocity::REST), bodies: &dice() }]);
    let [own, street] = both(&scene, &view(0.9, 0.0, 1.7));
    assert!(own.rgba == street.rgba && own.rgba.iter().any(|pixel| *pixel != own.rgba[0]));
}

/// A face across the motion, seen from ahead and from behind.
#[test]
fn the_front_is_lit_blue_and_bright_and_the_rear_red_and_dim() {
    let shape = Shape::Box { centre: [0.0; 3], half: [0.5, 2.0, 2.0], turn: [0.0, 0.0, 0.0, 1.0] };
    let mut body = Body::new(shape, 600.0);
    body.emission = relativity_render::Emission::WHITE;
    let scene = PreparedScene::moving(&[body]);
    let [own, street] = both(&scene, &view(0.3, -20.0, std::f64::consts::PI)).map(|picture| middle(&picture));
    assert!(street[2] > own[2] && street[2] / street[0] >= own[2] / own[0], "front {own:?} {street:?}");
    let [own, street] = both(&scene, &view(0.3, 20.0, 0.0)).map(|picture| middle(&picture));
    assert!(street[0] < own[0] && street[2] / street[0] < own[2] / own[0], "rear {own:?} {street:?}");
}

/// The lamp rides along where nothing shifts wavelengths, and where the camera rides along.
#[test]
fn without_a_doppler_effect_daylight_rides_along() {
    let scene = PreparedScene::moving(&dice());
    for geometry in [Geometry::Contracted, Geometry::Rest] {
        let [own, street] = both(&scene, &View { geometry, ..view(0.9, 0.0, 1.7) });
        assert!(own.rgba == street.rgba, "{geometry:?}");
    }
    let shown = |colour| {
        let appearance = Appearance { doppler_shift: false, ..appearance(colour) };
        scene.picture(&view(0.9, 1.0, 1.7), &appearance, 1).rgba
    };
    assert!(shown(Colour::White) == shown(Colour::StreetDaylight));
}

/// A rider receives the light of resting bodies as everybody does, shifted by the rider's own motion alone.
#[test]
fn to_a_rider_what_rests_is_lit_as_by_a_lamp_of_its_own() {
    let scene = PreparedScene::new([Group { motion: Motion::Own(Velocity::REST), bodies: &dice() }]);
    let at_rest = view(0.0, 0.0, 1.7);
    let camera = Camera { velocity: Velocity::from_beta(0.6).expect("a speed").into(), ..at_rest.camera };
    let [own, street] = both(&scene, &View { camera, ..at_rest });
    assert!(own.rgba == street.rgba && own.rgba.iter().any(|pixel| *pixel != own.rgba[0]));
}

/// A white face that rides along with the eyes and looks ahead reflects the mean of shifted daylight over the
/// half of the sky before it, weighted by the cosine, in the face's own frame.
#[test]
fn a_face_that_rides_along_reflects_the_crowded_sky_ahead() {
    const STEPS: u32 = 20_000;
    for (beta, looks_ahead) in [(0.5, true), (0.8, true), (0.5, false)] {
        let x = if looks_ahead { -3.0 } else { 3.0 };
        let face = Shape::Box { centre: [x, 0.0, 0.0], half: [0.5, 2.0, 2.0], turn: [0.0, 0.0, 0.0, 1.0] };
        let mut body = Body::new(face, 600.0);
        body.emission = relativity_render::Emission::WHITE;
        let scene = PreparedScene::new([Group { motion: Motion::WithEyes, bodies: &[body] }]);
        let azimuth = if looks_ahead { std::f64::consts::PI } else { 0.0 };
        let at_rest = view(0.0, 0.0, azimuth);
        let camera =
            Camera { velocity: Velocity::from_beta(beta).expect("a speed").into(), ..at_rest.camera };
        let appearance = Appearance { invisible: false, ..appearance(Colour::StreetDaylight) };
        let seen = middle(&scene.picture(&View { camera, ..at_rest }, &appearance, 1));

        let gamma = 1.0 / (1.0 - beta * beta).sqrt();
        let mut sum = [0.0; 3];
        for step in 0..STEPS {
            let cosine = (f64::from(step) + 0.5) / f64::from(STEPS);
            let towards = if looks_ahead { cosine } else { -cosine };
            let doppler = 1.0 / (gamma * (1.0 - beta * towards));
            let light = colour(Paint::WHITE, doppler.log2());
            let weight = 2.0 * cosine / f64::from(STEPS) * log2_level(doppler.log2()).exp2();
            sum = std::array::from_fn(|i| sum[i] + weight * light[i]);
        }
        let shown = toned(on_screen(sum).map(|part| part * appearance.exposure_ev.exp2()));
        let expected = shown.map(|part| 255.0 * srgb_encoded(part));
        for (seen, expected) in seen.into_iter().zip(expected) {
            assert!((seen - expected).abs() < 3.0, "at {beta}, ahead {looks_ahead}: {seen} for {expected}");
        }
    }
}
