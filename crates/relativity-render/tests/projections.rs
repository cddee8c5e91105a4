//! Places in pictures of each projection, against formulas of their own.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DQuat, DVec3};
use relativity_core::{Aperture, SourcePoint, Speed, sighting};
use relativity_render::camera::{MAX_SLANT, Projection};
use relativity_render::{
    Appearance, Body, Camera, Colour, Gaze, Geometry, Method, PreparedScene, Renderers, Shape, Undrawn, View,
};

use crate::support::spread;

/// Numbers from 0 to 1, three times seven of them for each `i`, by the generator of Steele, Lea and Flood
/// (`SplitMix64`).
fn random(i: u32) -> [[f64; 7]; 3] {
    let number = |k: usize| {
        let state = (u64::from(i) * 21 + k as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / 2f64.powi(53)
    };
    std::array::from_fn(|row| std::array::from_fn(|k| number(7 * row + k)))
}

/// `share` of the way from `low` to `high`.
fn between(low: f64, high: f64, share: f64) -> f64 {
    low + (high - low) * share
}

/// A random camera of an eye at `off_middle` from the middle, its picture parallel to `right`.
fn camera(i: u32, off_middle: DVec3, right: DVec3, shift: f64) -> Camera {
    let [[azimuth, elevation, fov, width, height, ..], ..] = random(i);
    let gaze = Gaze { azimuth: between(0.0, PI, azimuth), elevation: between(-1.3, 1.3, elevation) };
    let size = [between(200.0, 3840.0, width) as u32, between(200.0, 2160.0, height) as u32];
    let aperture = Aperture { x: off_middle.x, y: off_middle.y, z: off_middle.z };
    let camera = Camera::new(aperture, gaze, between(0.05, 2.6, fov), size);
    Camera { off_middle, projection: Projection::Parallel { right, shift }, ..camera }
}

/// Returns the angle of a gaze to the plane across `baseline`.
fn slant(gaze: Gaze, baseline: DVec3) -> f64 {
    FRAC_PI_2
        - gaze.axes().forward.angle_between(baseline).min(PI - gaze.axes().forward.angle_between(baseline))
}

/// Both eyes see a point in the same row of their pictures, at any speed and time, wherever it is and
/// wherever they look but along the line between them.
#[test]
fn a_straight_pair_has_no_vertical_parallax() {
    let (mut worst, mut shown) = (0.0f64, 0);
    for i in 0..40_000 {
        let [_, [beta, time, d, x, y, z, _], [left_shift, right_shift, ..]] = random(i);
        let beta = 1.0 - 10f64.powf(between(0.0, -4.0, beta));
        let speed = Speed::from_beta(beta).expect("below 1");
        let place = [between(-20.0, 20.0, x), between(-8.0, 8.0, y), between(-8.0, 8.0, z)];
        let point = SourcePoint::from_rest(place, &speed);
        let (d, time) = (between(0.0, 1.0, d), between(-20.0, 20.0, time));
        let shifts = [left_shift, right_shift].map(|shift| between(-0.2, 0.2, shift));
        let eyes: [_; 2] = std::array::from_fn(|eye| {
            let x = [-0.5 * d, 0.5 * d][eye];
            let camera = camera(i, DVec3::X * x, DVec3::X, shifts[eye]);
            let seen = sighting(&speed, point, Aperture { x, y: 0.0, z: 0.0 }, time).expect("in the domain");
            (camera, seen.position)
        });
        if slant(eyes[0].0.gaze, DVec3::X) > MAX_SLANT {
            continue;
        }
        let [Some(left), Some(right)] = eyes.map(|(camera, seen)| camera.pixel(seen.into())) else {
            continue;
        };
        for ((camera, seen), [u, v]) in eyes.into_iter().zip([left, right]) {
            let expected = expected(&camera, seen);
            let off = (u - expected[0]).abs().max((v - expected[1]).abs());
            assert!(off < 1e-9 * (1.0 + u.abs() + v.abs()), "{camera:?}: {u}, {v} for {expected:?}");
        }
        // Far out of a picture its numbers have fewer digits.
        if left[1].abs().max(right[1].abs()) < 1e5 {
            worst = worst.max((left[1] - right[1]).abs());
            shown += 1;
        }
    }
    assert!(shown > 10_000, "{shown}");
    assert!(worst < 0.01, "{worst} px");
    println!("{worst:e} px at most, of {shown} pairs");
}

/// The place of what is seen at (X, y, z) by tangents alone: X and the height above the plane through x and
/// the gaze, over how far it is along what of the gaze is in the y-z plane.
fn expected(camera: &Camera, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let Projection::Parallel { shift, .. } = camera.projection else { panic!("it is parallel") };
    let Gaze { azimuth, elevation } = camera.gaze;
    let gaze = [elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()];
    let [across_y, across_z] = [gaze[1], gaze[2]].map(|part| part / gaze[1].hypot(gaze[2]));
    let slant = gaze[0] / gaze[1].hypot(gaze[2]);
    let depth = y * across_y + z * across_z;
    let rise = z * across_y - y * across_z;
    let [width, height] = camera.size.map(f64::from);
    let focal_length = 0.5 * width / (0.5 * camera.horizontal_fov).tan();
    [0.5 * width + focal_length * (x / depth - slant + shift), 0.5 * height - focal_length * rise / depth]
}

/// A gaze further aside turns both pictures along, steadily, so that it stays in their middle. What is there
/// is in nearly one row: heights are seen from distances that differ by what the turn makes of the baseline,
/// and are far larger than that.
#[test]
fn far_aside_pictures_turn_with_the_gaze() {
    let d = 0.2;
    for i in 0..2000 {
        let [[side, by, elevation, ..], [x, z, distance, ..], _] = random(i);
        let turn = between(0.0, 14.9, by).to_radians();
        let slanted = (MAX_SLANT + turn).copysign(side - 0.5);
        let tilt = between(-1.0, 1.0, elevation);
        let towards = DVec3::new(slanted.sin(), slanted.cos() * tilt.cos(), slanted.cos() * tilt.sin());
        let gaze = Gaze::along(towards.to_array());
        let cameras = [-0.5 * d, 0.5 * d].map(|x| {
            let camera = Camera::new(Aperture { x, y: 0.0, z: 0.0 }, gaze, 1.2, [640, 480]);
            Camera { projection: Projection::Parallel { right: DVec3::X, shift: 0.0 }, ..camera }
        });
        let [u, v] = cameras[0].pixel(towards).expect("in front");
        assert!((u - 320.0).abs() < 1e-7 && (v - 240.0).abs() < 1e-7, "{gaze:?}: {u}, {v}");
        let axes = cameras[0].axes();
        assert!((axes.right.angle_between(DVec3::X) - turn).abs() < 1e-7, "{gaze:?}: {axes:?}");
        // Something in the picture.
        let sight = cameras[0].line_of_sight([640.0 * x, 480.0 * z]) * between(3.0, 50.0, distance);
        let [left, right] = [sight, sight - DVec3::X * d];
        let rows = [cameras[0].pixel(left), cameras[1].pixel(right)].map(|place| place.expect("in front")[1]);
        let nearer = d * turn.sin() / left.dot(axes.forward).min(right.dot(axes.forward));
        assert!((rows[0] - rows[1]).abs() <= 240.0 * nearer + 1e-9, "{rows:?}: {gaze:?}, {sight}");
    }
}

/// A point at depth s has one place in both pictures where the shifts are -+ d/(2 s); without shifts a
/// distant one has.
#[test]
fn the_image_shift_brings_a_depth_onto_the_screen() {
    let (d, s) = (0.3, 4.0);
    for shifted in [false, true] {
        for (x, depth) in [(-1.3, s), (0.0, s), (2.2, s), (-3.0, 1e9)] {
            let places = [-0.5 * d, 0.5 * d].map(|eye| {
                let shift = if shifted { eye / s } else { 0.0 };
                let projection = Projection::Parallel { right: DVec3::X, shift };
                let gaze = Gaze { azimuth: 1.2, elevation: 0.0 };
                let camera = Camera::new(Aperture { x: eye, y: 0.0, z: 0.0 }, gaze, 1.0, [640, 480]);
                let camera = Camera { projection, ..camera };
                camera.pixel(DVec3::new(x - eye, depth, 1.0)).expect("in front")
            });
            let apart = places[0][0] - places[1][0];
            let focal_length = 320.0 / 0.5f64.tan();
            let shift = if shifted { d / s } else { 0.0 };
            let expected = focal_length * (d / depth - shift);
            assert!((apart - expected).abs() < 1e-9, "{apart} px for {expected}");
        }
    }
}

fn projections() -> impl Iterator<Item = Projection> {
    let baselines =
        [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.48, -0.8, 0.36)];
    let of = |right| [Projection::Parallel { right, shift: 0.07 }, Projection::Vr180 { right }];
    [Projection::Gaze].into_iter().chain(baselines.into_iter().flat_map(of))
}

#[test]
fn pixel_and_line_of_sight_are_inverse() {
    for projection in projections() {
        for i in 0..200 {
            let [[.., azimuth, elevation], [u, v, ..], _] = random(i);
            let gaze = Gaze { azimuth: between(-PI, PI, azimuth), elevation: between(-1.5, 1.5, elevation) };
            let camera = Camera { gaze, projection, ..camera(i, DVec3::ZERO, DVec3::X, 0.0) };
            let [width, height] = camera.size.map(f64::from);
            let place = [u * width, v * height];
            let line_of_sight = camera.line_of_sight(place);
            assert!((line_of_sight.length() - 1.0).abs() < 1e-14);
            let [u, v] = camera.pixel(line_of_sight).expect("in front");
            assert!(
                (u - place[0]).abs() < 1e-7 && (v - place[1]).abs() < 1e-7,
                "{camera:?}: {u}, {v} for {place:?}"
            );
            assert!(camera.shows(line_of_sight));
        }
    }
}

/// Whether a picture of `camera` is parallel to the baseline, and not as steep as a picture can be.
fn is_plain(camera: &Camera) -> bool {
    let Projection::Parallel { right, .. } = camera.projection else { return true };
    slant(camera.gaze, right) <= MAX_SLANT && camera.axes().up.z > 0.02
}

#[test]
fn a_gaze_is_in_the_middle_and_holds_a_direction_at_a_pixel() {
    for projection in projections().filter(|projection| !matches!(projection, Projection::Vr180 { .. })) {
        let shift = if let Projection::Parallel { shift, .. } = projection { shift } else { 0.0 };
        for (azimuth, elevation) in
            [(1.2, 0.0), (1.9, 0.6), (2.1, -0.5), (0.1, 0.05), (3.0, -0.1), (0.05, -0.2)]
        {
            let gaze = Gaze { azimuth, elevation };
            let from = Camera { projection, ..Camera::new(Aperture::default(), gaze, 0.8, [640, 480]) };
            let [u, v] = from.pixel(gaze.axes().forward).expect("in front");
            let middle = 320.0 + shift * from.focal_length_px();
            assert!((u - middle).abs() < 1e-9 && (v - 240.0).abs() < 1e-9, "{from:?}: {u}, {v}");
            for pixel in [[320.0, 240.0], [3.0, 400.0], [600.0, 20.0]] {
                let direction = from.line_of_sight(pixel);
                let to = Camera { horizontal_fov: 1.0, ..from };
                let to = Camera { gaze: to.gaze_with(direction, pixel), ..to };
                let [u, v] = to.pixel(direction).expect("in front");
                // In turned pictures, and in the steepest, not every place can be reached.
                let is_held = (u - pixel[0]).abs() < 1e-8 && (v - pixel[1]).abs() < 1e-8;
                let is_bounded = !is_plain(&from) || !is_plain(&to);
                assert!(is_held || is_bounded, "{projection:?} {gaze:?} {pixel:?}: {u}, {v}");
            }
        }
    }
}

/// Rows and columns at right angles, the picture upright, and its axis as near to the gaze as it can be.
#[test]
fn no_picture_is_upside_down() {
    for projection in projections() {
        for i in 0..300 {
            let [[azimuth, elevation, ..], ..] = random(i);
            let gaze = Gaze { azimuth: between(-PI, PI, azimuth), elevation: between(-1.5, 1.5, elevation) };
            let camera = Camera { projection, ..Camera::new(Aperture::default(), gaze, 0.8, [640, 480]) };
            let axes = camera.axes();
            assert!(axes.up.z > -1e-9, "{camera:?}: {axes:?}");
            assert!((axes.right.cross(axes.forward) - axes.up).length() < 1e-12, "{axes:?}");
            if let Projection::Parallel { right, .. } = projection {
                let turned = (slant(gaze, right) - MAX_SLANT).max(0.0);
                let right = right * 1f64.copysign(axes.right.dot(right));
                assert!((axes.right.angle_between(right) - turned).abs() < 1e-6, "{axes:?}");
                assert!(axes.forward.dot(gaze.axes().forward) > 0.0);
            }
        }
    }
}

/// Also along the baseline itself, and where no baseline is given.
#[test]
fn no_gaze_gives_a_picture_that_is_none() {
    for right in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_Z, DVec3::ZERO] {
        for direction in
            [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::Z, DVec3::NEG_Z, DVec3::new(1.0, 1e-12, 0.0)]
        {
            for projection in [Projection::Parallel { right, shift: 0.0 }, Projection::Vr180 { right }] {
                let gaze = Gaze::along(direction.to_array());
                let camera = Camera { projection, ..Camera::new(Aperture::default(), gaze, 0.8, [640, 480]) };
                for pixel in [[0.0, 0.0], [320.0, 240.0], [640.0, 480.0]] {
                    assert!(camera.line_of_sight(pixel).is_finite(), "{camera:?}");
                    let gaze = camera.gaze_with(direction, pixel);
                    assert!(gaze.azimuth.is_finite() && gaze.elevation.is_finite(), "{camera:?}: {gaze:?}");
                }
            }
        }
    }
}

fn bodies() -> Vec<Body> {
    let shapes = (0..40).map(|i| {
        let [x, y, z, radius] = spread(i);
        let centre = [between(-6.0, 6.0, x), between(0.5, 6.0, y), between(-4.0, 4.0, z)];
        Shape::Sphere { centre, radius: between(0.05, 0.6, radius) }
    });
    shapes.map(|shape| Body::new(shape, 600.0)).collect()
}

fn view(camera: Camera) -> View {
    let speed = Speed::from_beta(0.9).expect("below 1");
    View { camera, speed, observation_time: 2.0, geometry: Geometry::Seen }
}

/// Across the baseline a picture is the same either way, pixel for pixel.
#[test]
fn straight_ahead_a_parallel_picture_is_that_across_the_gaze() {
    let scene = PreparedScene::moving(&bodies());
    let appearance = Appearance { ground_z: Some(-1.0), ..Appearance::default() };
    for elevation in [0.0, 0.4] {
        let gaze = Gaze { elevation, ..Gaze::STRAIGHT_AHEAD };
        let across = Camera::new(Aperture::default(), gaze, 1.0, [160, 120]);
        let right = gaze.axes().right;
        let parallel = Camera { projection: Projection::Parallel { right, shift: 0.0 }, ..across };
        let [across, parallel] =
            [across, parallel].map(|camera| scene.picture(&view(camera), &appearance, 1));
        assert_eq!(across, parallel);
    }
}

/// Sheared by its shift, a picture is one row of pixels of the same plane further.
#[test]
fn a_shift_by_pixels_moves_the_picture_by_as_many() {
    let scene = PreparedScene::moving(&bodies());
    // In false colours there is no hatch, whose lines stay where they are in the picture.
    let appearance = Appearance { ground_z: Some(-1.0), colour: Colour::False, ..Appearance::default() };
    let picture = |pixels: f64| {
        let camera = Camera::new(Aperture::default(), Gaze { azimuth: 1.1, elevation: 0.1 }, 1.0, [160, 120]);
        let shift = pixels / camera.focal_length_px();
        let camera = Camera { projection: Projection::Parallel { right: DVec3::X, shift }, ..camera };
        scene.picture(&view(camera), &appearance, 1).rgba
    };
    let [unmoved, moved] = [picture(0.0), picture(10.0)];
    let mut different = 0;
    for (row, moved) in unmoved.chunks(160).zip(moved.chunks(160)) {
        different += row[..150].iter().zip(&moved[10..]).filter(|(a, b)| a != b).count();
    }
    // Rounding decides at outlines.
    assert!(different < 5, "{different}");
}

/// Each degree of longitude and latitude has as many pixels, from the left to the right and from the zenith
/// to the nadir.
#[test]
fn half_of_the_sky_is_told_by_longitude_and_latitude() {
    let gaze = Gaze { azimuth: 1.9, elevation: 0.7 };
    let camera = Camera::new(Aperture::default(), gaze, 0.3, [720, 720]);
    let camera = Camera { projection: Projection::Vr180 { right: DVec3::X }, ..camera };
    for (longitude, latitude) in
        [(0.0f64, 0.0f64), (30.0, 0.0), (-90.0, 0.0), (0.0, 90.0), (45.0, -60.0), (89.0, 80.0)]
    {
        let place = [360.0 + 4.0 * longitude, 360.0 - 4.0 * latitude];
        let (longitude, latitude) = (longitude.to_radians(), latitude.to_radians());
        let expected =
            DVec3::new(latitude.cos() * longitude.sin(), latitude.cos() * longitude.cos(), latitude.sin());
        assert!(camera.line_of_sight(place).distance(expected) < 1e-14, "{place:?}");
    }
    // Behind the head, the other half.
    let behind = Camera { gaze: Gaze { azimuth: -FRAC_PI_2, elevation: 0.0 }, ..camera };
    assert!(behind.line_of_sight([360.0, 360.0]).distance(DVec3::NEG_Y) < 1e-14);
    assert!(behind.line_of_sight([360.0, 0.0]).distance(DVec3::Z) < 1e-14);
}

/// Tiles keep every body that any of their pixels shows.
#[test]
fn tiles_of_no_projection_lose_a_body() {
    let scene = PreparedScene::moving(&bodies());
    for projection in projections() {
        for (azimuth, elevation, fov) in [(1.4, 0.2, 1.0), (0.5, -0.3, 2.0), (2.9, 0.9, 3.1)] {
            let camera = Camera::new(Aperture::default(), Gaze { azimuth, elevation }, fov, [96, 72]);
            let view = view(Camera { projection, ..camera });
            let image = scene.hit_image(&view);
            let mut covered = 0;
            for (i, hit) in image.hits.iter().enumerate() {
                let place = [(i % 96) as f64 + 0.5, (i / 96) as f64 + 0.5];
                let alone = scene.first_hit(&view, view.camera.line_of_sight(place));
                assert_eq!(hit.map(|hit| hit.body), alone.map(|hit| hit.body), "{projection:?} at {place:?}");
                covered += usize::from(hit.is_some());
            }
            assert!(covered > 0 || !matches!(projection, Projection::Vr180 { .. }), "{projection:?}");
        }
    }
}

#[test]
fn half_of_the_sky_is_drawn_by_the_reference_alone() {
    let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.0, [16, 16]);
    let seen = view(Camera { projection: Projection::Vr180 { right: DVec3::X }, ..camera });
    for method in [Method::Reference, Method::Rays, Method::Mesh] {
        assert_eq!(method.of_view(&seen), Method::Reference);
        assert_eq!(method.on_gpu(&seen), Method::Reference);
    }
    let mut renderers = Renderers::new(None);
    let scene = PreparedScene::moving(&bodies());
    assert!(renderers.picture(Method::Rays, &scene, &seen, &Appearance::default(), 1).is_ok());
    let published = View { geometry: Geometry::Published, ..seen };
    assert_eq!(published.drawn(), Err(Undrawn::HalfOfSkyPublished));
    let refused = renderers.hits(Method::Reference, &scene, &published).expect_err("nothing draws it");
    assert!(refused.to_string().contains("published model"), "{refused}");
}

/// The distance between the pixels of a ground decides what is drawn of its grid; a step to the next is what
/// `pixel` finds.
#[test]
fn a_magnified_part_shows_what_is_about_its_pixel() {
    for projection in projections() {
        let gaze = Gaze { azimuth: 1.0, elevation: 0.3 };
        let whole = Camera { projection, ..Camera::new(Aperture::default(), gaze, 1.4, [640, 480]) };
        for pixel in [[320.0, 240.0], [600.0, 30.0], [10.0, 300.0]] {
            let part = whole.magnified(pixel, [100, 100], 1000.0);
            let middle = part.line_of_sight([50.0, 50.0]);
            assert!(middle.distance(whole.line_of_sight(pixel)) < 1e-14, "{projection:?}");
        }
    }
    let right = DQuat::from_rotation_y(-0.7) * DVec3::X;
    let camera = Camera::new(Aperture::default(), Gaze { azimuth: 1.0, elevation: 0.3 }, 1.4, [640, 480]);
    let camera = Camera { projection: Projection::Parallel { right, shift: 0.1 }, ..camera };
    let part = camera.magnified([600.0, 400.0], [100, 100], 1000.0);
    let [u, v] = camera.pixel(part.line_of_sight([60.0, 50.0])).expect("in front");
    assert!(u > 600.0 && (v - 400.0).abs() < 1e-9, "a row of it is along a row: {u}, {v}");
}
