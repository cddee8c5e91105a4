//! Gazes, pixels and lines of sight of flat pictures.

use super::*;
use std::f64::consts::FRAC_PI_2;

fn camera() -> Camera {
    Camera::new(Aperture::default(), Gaze { azimuth: FRAC_PI_2, elevation: 0.0 }, FRAC_PI_2, [200, 100])
}

#[test]
fn a_pointer_far_outside_the_smallest_picture_gives_a_gaze() {
    // A view of one pixel, dragged by a pointer that is a window away: |u| is thousands.
    let camera = Camera { horizontal_fov: 0.7, size: [1, 1], ..camera() };
    let right = DVec3::X;
    let projections = [
        Projection::Gaze,
        Projection::Parallel { right, shift: 0.0 },
        Projection::Mercator { right, shift: 0.0 },
    ];
    for projection in projections {
        let camera = Camera { projection, ..camera };
        for from in [[4000.0, 3.0], [-4000.0, -400.0], [0.5, 4000.0]] {
            let sight = camera.line_of_sight(from);
            assert!((sight.length() - 1.0).abs() < 1e-12, "{projection:?} {from:?}: {sight}");
            let gaze = camera.gaze_with(sight, [-200.0, 10.0]);
            assert!(gaze.azimuth.is_finite() && gaze.elevation.is_finite(), "{projection:?}: {gaze:?}");
        }
    }
}

#[test]
fn looking_ahead_has_x_on_the_right_and_z_up() {
    let camera = camera();
    let [u, v] = camera.pixel(DVec3::new(1.0, 1.0, 0.0)).expect("in front");
    assert!((u - 200.0).abs() < 1e-9 && (v - 50.0).abs() < 1e-9);
    let [u, v] = camera.pixel(DVec3::new(0.0, 1.0, 0.5)).expect("in front");
    assert!((u - 100.0).abs() < 1e-9 && v.abs() < 1e-9);
    assert!(camera.pixel(DVec3::NEG_Y).is_none());
}

#[test]
fn a_gaze_holds_a_direction_at_a_pixel() {
    for azimuth in [-3.0, 0.1, 1.5] {
        for elevation in [-1.0, 0.0, 0.6] {
            let gaze = Gaze { azimuth, elevation };
            let from = Camera { gaze, ..camera() };
            for pixel in [[100.0, 50.0], [3.0, 90.0], [180.0, 20.0]] {
                let direction = from.line_of_sight(pixel);
                let to = Camera { horizontal_fov: 1.0, ..from };
                let to = Camera { gaze: to.gaze_with(direction, pixel), ..to };
                let [u, v] = to.pixel(direction).expect("in front");
                assert!((u - pixel[0]).abs() < 1e-9 && (v - pixel[1]).abs() < 1e-9, "{gaze:?} {pixel:?}");
            }
        }
    }
}

#[test]
fn pixel_and_line_of_sight_are_inverse() {
    let mut camera = camera();
    camera.gaze = Gaze { azimuth: 2.0, elevation: 0.7 };
    for pixel in [[0.5, 0.5], [13.0, 77.25], [199.5, 99.5]] {
        let [u, v] = camera.pixel(camera.line_of_sight(pixel)).expect("in front");
        assert!((u - pixel[0]).abs() < 1e-9 && (v - pixel[1]).abs() < 1e-9);
    }
}
