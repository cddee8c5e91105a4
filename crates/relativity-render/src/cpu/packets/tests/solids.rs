//! Meetings of rays with bodies that stand still, against the reference.

use glam::DVec3;

use super::{Case, Found, Random, cases};
use crate::geometry::intersect::Entry;
use crate::geometry::shape::Shape;

/// Error in f32, relative to the body's size.
const PART: f64 = 2e-6;

impl Case {
    fn entry(&self, found: &Found, aside: DVec3) -> Option<Entry> {
        self.scene.solid(0).entry(&self.ray(found, aside))
    }
}

#[test]
fn the_same_rays_hit_at_the_same_places() {
    let mut random = Random(3);
    let (mut hits, mut blended, mut grazes) = (0, 0, 0);
    let (mut most_off, mut most_clear) = (0.0f64, 0.0f64);
    for (context, case) in cases() {
        let solid = case.scene.solid(0);
        for _ in 0..12 {
            let pixels = case.pixels(&mut random, 1.2);
            for found in case.found_best(&pixels) {
                let entry = case.entry(&found, DVec3::ZERO);
                let part = found.clearance.abs() / case.size();
                if entry.is_some() != (found.clearance > 0.0) {
                    most_clear = most_clear.max(part);
                    assert!(part < PART, "{context}: {entry:?} but {found:?}");
                }
                let Some(entry) = entry.filter(|_| part > PART) else { continue };
                hits += 1;
                let place = case.middle() + found.place;
                let cosine = entry.normal.dot(found.direction).abs();
                if cosine < 0.02 {
                    grazes += 1;
                    continue;
                }
                let off = [
                    solid.form.answers().distance(place - solid.centre()).0.abs(),
                    place.distance(entry.position) * cosine,
                    (found.beyond - (entry.position - case.middle()).dot(found.direction)).abs() * cosine,
                ];
                let worst = off.into_iter().fold(0.0, f64::max) / case.size();
                most_off = most_off.max(worst);
                assert!(worst < PART, "{context}: {entry:?} but {found:?}");
                if found.normal.length() < 1.0 - 1e-5 {
                    assert!(matches!(case.body.shape, Shape::Box { .. } | Shape::Cylinder { .. }));
                    blended += 1;
                    continue;
                }
                let tilt = found.normal.distance(entry.normal) * cosine * found.half_width / case.size();
                assert!(tilt < PART, "{context}: {entry:?} but {found:?}");
            }
        }
    }
    println!(
        "{hits} hits, {grazes} grazes, {blended} at edges; {most_off:e} of the size off, wrong within {most_clear:e}"
    );
    assert!(hits > 10_000 && 20 * (blended + grazes) < hits);
}

/// A ray that is moved out of the body by its clearance, and a tenth more, leaves it; by a tenth less it does
/// not. So near outlines that these are nearly straight.
#[test]
fn clearance_is_how_far_rays_are_inside() {
    let mut random = Random(4);
    let mut checked = 0;
    for (context, case) in cases() {
        for _ in 0..40 {
            let pixels = case.pixels(&mut random, 1.2);
            for found in case.found_best(&pixels) {
                let part = found.clearance / found.half_width;
                let Some(entry) = case.entry(&found, DVec3::ZERO).filter(|_| 1e-4 < part && part < 0.005)
                else {
                    continue;
                };
                checked += 1;
                let margin = 0.1 * found.clearance + PART * case.size();
                let moved = |by: f64| case.entry(&found, found.outward * by);
                let nearly = moved(found.clearance - margin);
                assert!(nearly.is_some(), "{context}: {found:?}");
                // Out of this, a ray may meet what is behind: a graze is no longer than 0.1 radii before and
                // after.
                let beyond = moved(found.clearance + margin);
                let is_out =
                    beyond.is_none_or(|beyond| beyond.distance > entry.distance + 0.2 * found.half_width);
                assert!(is_out, "{context}: {beyond:?} after {entry:?}, {found:?}");
            }
        }
    }
    println!("{checked} checked");
    assert!(checked > 500);
}
