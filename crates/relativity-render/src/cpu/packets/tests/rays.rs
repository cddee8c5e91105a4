//! Rays, against those of the reference.

use glam::DVec3;

use super::{Random, cases};
use crate::Projection;

/// Relative error in f32 of each quantity; of the moment relative to the distance of the group's middle. For
/// pixels that are further from the frame's pole than the focal length is long, as many times as much.
const PART: f64 = 1e-6;
/// In conformal pictures of a tilted head `n_x` is a sum of parts of order 1, which f32 rounds by so much;
/// the contracted geometry stretches it by gamma.
const ROUNDING: f64 = 6e-8;

#[test]
fn rest_rays_are_those_of_the_reference() {
    let mut random = Random(1);
    let mut most = 0.0f64;
    for (context, case) in cases() {
        let pixels = case.pixels(&mut random, 1.5);
        for (lane, found) in case.found_best(&pixels).into_iter().enumerate() {
            let truth = case.group_view.rest_ray(case.line_of_sight(pixels[0][lane], pixels[1][lane]));
            let centre = case.middle() - truth.origin;
            let off = [
                found.direction.distance(truth.direction),
                (found.doppler / truth.doppler_factor - 1.0).abs(),
                (found.ground_per_rest / truth.ground_per_rest - 1.0).abs(),
                found.moment.distance(centre.cross(truth.direction)) / centre.length(),
                (found.to_centre - centre.dot(truth.direction)).abs() / centre.length(),
            ];
            let [pole_u, pole_v, ..] = case.frame.pole.map(f64::from);
            let [u, v] = [0, 1].map(|axis| f64::from(pixels[axis][lane]));
            let from_pole = (u - pole_u).hypot(v - pole_v) / case.view.camera.focal_length_px();
            let off = off.map(|off| off / from_pole.max(1.0));
            let worst = off.into_iter().fold(0.0, f64::max);
            most = most.max(worst);
            let tilted = match case.view.camera.projection {
                Projection::Mercator { right, .. } if right != DVec3::X => ROUNDING * case.view.speed.gamma(),
                _ => 0.0,
            };
            assert!(worst < PART.max(tilted), "{context}: {off:?}");
        }
    }
    println!("at most {most:e}");
}
