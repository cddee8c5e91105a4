//! Movements of rays from pixel to pixel, against differences of the reference's rays; and depths.

use super::{Random, cases};

#[test]
fn movement_is_what_neighbouring_rays_differ_by() {
    let mut random = Random(2);
    for (context, case) in cases() {
        let pixels = case.pixels(&mut random, 1.5);
        for (lane, found) in case.found_best(&pixels).into_iter().enumerate() {
            let [u, v] = [0, 1].map(|axis| f64::from(pixels[axis][lane]));
            let direction =
                |u: f64, v: f64| case.group_view.rest_ray(case.view.camera.line_of_sight([u, v])).direction;
            let step = 1e-3;
            let differences = [
                (direction(u + step, v) - direction(u - step, v)) / (2.0 * step),
                (direction(u, v + step) - direction(u, v - step)) / (2.0 * step),
            ];
            let greatest = differences[0].length().max(differences[1].length());
            for (found_part, difference) in found.movement.into_iter().zip(differences) {
                let off = (found_part - difference.dot(found.across)).abs();
                assert!(off < 1e-5 * greatest, "{context}: {found_part} for {difference}");
            }
        }
    }
}
