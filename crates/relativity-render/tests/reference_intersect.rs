//! Ray entries against sphere tracing along the signed distance, which shares no algebra with them.

use glam::{DQuat, DVec3};
use relativity_render::Shape;
use relativity_render::geometry::intersect::Solid;
use relativity_render::geometry::ray::Ray;

use crate::support::{centred, documented, signed_distance, spread, surface_point};

/// Shapes about 1 in size, thin and thick, anywhere in the cube [-1, 1]^3.
fn shape(i: u32) -> Shape {
    let [a, b, c, d, e, f, g, h] = spread(i);
    let centre = centred([a, b, c]);
    let thin = 10f64.powf(-3.0 * g);
    match i % 5 {
        0 => Shape::Sphere { centre: centre.into(), radius: thin },
        3 => Shape::Box {
            centre: centre.into(),
            half: [0.2 + a, 0.2 + h, (0.2 + d) * thin],
            turn: DQuat::from_rotation_arc(DVec3::X, centred([d, e, f]).normalize()).to_array(),
        },
        4 => Shape::Cylinder {
            from: centre.into(),
            to: (centre + (centred([d, e, f]) - centre) * if h < 0.5 { thin } else { 1.0 }).into(),
            radius: 0.5 * if h < 0.5 { 1.0 } else { thin },
        },
        1 => Shape::Tube { from: centre.into(), to: centred([d, e, f]).into(), radius: 0.5 * thin },
        _ => Shape::Ring {
            centre: centre.into(),
            axis: centred([d, e, f]).normalize().into(),
            radius: 0.2 + h,
            tube_radius: 0.19 * thin,
        },
    }
}

/// A ray that comes from `away` and passes within `depth` of the surface of `shape`, inside for depth > 0.
fn near_miss(shape: &Shape, i: u32, away: f64, depth: f64) -> [DVec3; 2] {
    let [a, b, c, d, e, f, g, h] = spread(i + 1_000_000);
    let (on_surface, normal) = surface_point(shape, [a, b]);
    let sideways = centred([c, d, e]).cross(normal).normalize();
    let direction = (sideways + normal * (0.1 * (f - 0.5) * g)).normalize();
    let target = on_surface - normal * depth * h;
    [target - direction * away, direction]
}

/// First place within `end` of the origin where the ray comes within `threshold` of `shape`.
fn marched(shape: &Shape, [origin, direction]: [DVec3; 2], end: f64, threshold: f64) -> Option<f64> {
    let mut t = 0.0;
    for _ in 0..200_000 {
        let distance = signed_distance(shape, origin + direction * t);
        if distance < threshold {
            return Some(t);
        }
        t += distance;
        if t > end {
            return None;
        }
    }
    panic!("sphere tracing did not end");
}

#[test]
fn an_entry_is_where_sphere_tracing_meets_the_body_first() {
    let mut hits = 0;
    for i in 0..6000 {
        let shape = shape(i);
        let [origin, direction] = near_miss(&shape, i, 5.0, 0.3);
        let entry = Solid::new(&shape).entry(&Ray::new(origin, direction));
        // A body fattened by 1e-9 is met a little earlier, one thinned by 1e-9 a little later.
        let fat = marched(&shape, [origin, direction], 12.0, 1e-9);
        let Some(entry) = entry else {
            let deepest = (0..=4000)
                .map(|k| signed_distance(&shape, origin + direction * (12.0 * f64::from(k) / 4000.0)));
            assert!(deepest.fold(f64::INFINITY, f64::min) > -1e-9, "{i}: missed {shape:?}");
            continue;
        };
        hits += 1;
        let fat = fat.expect("an entry into the body is one into the fattened body");
        assert!(fat <= entry.distance + 1e-9, "{i}: sphere tracing passed {shape:?}");
        let slope = -entry.normal.dot(direction);
        assert!(slope >= 0.0 && (entry.distance - fat) * slope < 2e-9 + 1e-3 * slope, "{i}: {shape:?}");
        if slope > 0.05 {
            assert!((entry.distance - fat) < 1e-7, "{i}: {} late", entry.distance - fat);
        }
    }
    assert!(hits > 2000, "only {hits} rays hit");
}

/// Largest distance of an entry from the surface and from the ray, in units of the body's size, over rays
/// that come from `away` and graze within `depth`.
fn worst_residual(away: f64, depth: f64) -> [f64; 2] {
    let mut worst = [0.0; 2];
    for i in 0..6000 {
        let shape = shape(i);
        let [origin, direction] = near_miss(&shape, i, away, depth);
        let Some(entry) = Solid::new(&shape).entry(&Ray::new(origin, direction)) else { continue };
        let off_surface = signed_distance(&shape, entry.position).abs();
        let off_ray = (entry.position - origin).cross(direction).length() / away;
        worst = [off_surface.max(worst[0]), off_ray.max(worst[1])];
    }
    worst
}

#[test]
fn entries_lie_on_the_surface_even_from_far_away_and_at_grazing_incidence() {
    let intersect = include_str!("../src/geometry/intersect.rs");
    let bound = documented(intersect, "the position lies on the surface within ");
    let furthest = documented(intersect, "for cameras up to ");
    for away in [5.0, 1e3, 1e6, furthest] {
        for depth in [0.3, 1e-3, 1e-6, 1e-9] {
            let [off_surface, off_ray] = worst_residual(away, depth);
            println!(
                "from {away:e}, grazing depth {depth:e}: off surface {off_surface:.1e}, off ray {off_ray:.1e} of the way"
            );
            assert!(off_surface < bound, "from {away:e}, depth {depth:e}: {off_surface:e} off the surface");
            assert!(off_ray < 4.0 * f64::EPSILON, "from {away:e}: {off_ray:e} off the ray");
        }
    }
}

#[test]
fn normals_point_along_the_gradient_of_the_signed_distance() {
    for i in 0..600 {
        let shape = shape(i);
        let [origin, direction] = near_miss(&shape, i, 5.0, 0.3);
        let Some(entry) = Solid::new(&shape).entry(&Ray::new(origin, direction)) else { continue };
        let h = 1e-6;
        let slope = |axis: DVec3| {
            let [ahead, back] = [h, -h].map(|h| signed_distance(&shape, entry.position + axis * h));
            (ahead - back) / (2.0 * h)
        };
        let gradient = DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
        assert!(gradient.distance(entry.normal) < 1e-5, "{i}: {shape:?}");
    }
}

#[test]
fn an_aperture_inside_a_body_does_not_see_its_inner_surface() {
    let inside = [
        (Shape::Sphere { centre: [0.0; 3], radius: 1.0 }, DVec3::ZERO),
        (Shape::Tube { from: [-1.0, 0.0, 0.0], to: [1.0, 0.0, 0.0], radius: 0.5 }, DVec3::X),
        (Shape::Box { centre: [0.0; 3], half: [1.0, 2.0, 3.0], turn: [0.0, 0.0, 0.0, 1.0] }, DVec3::Y),
        (Shape::Cylinder { from: [-1.0, 0.0, 0.0], to: [1.0, 0.0, 0.0], radius: 0.5 }, DVec3::ZERO),
    ];
    for (shape, origin) in inside {
        assert_eq!(Solid::new(&shape).entry(&Ray::new(origin, DVec3::X)), None);
    }
    // From inside a ring's tube the far side of the ring is seen, its own skin is not.
    let ring = Shape::Ring { centre: [0.0; 3], axis: [0.0, 0.0, 1.0], radius: 1.0, tube_radius: 0.25 };
    let entry = Solid::new(&ring).entry(&Ray::new(DVec3::X, DVec3::NEG_X)).expect("the far side");
    assert!((entry.distance - 1.75).abs() < 1e-12);
}

#[test]
fn rays_in_the_planes_of_faces_and_along_axes_are_told_from_those_beside() {
    let cube = Shape::Box { centre: [0.0; 3], half: [1.0; 3], turn: [0.0, 0.0, 0.0, 1.0] };
    let rod = Shape::Cylinder { from: [-1.0, 0.0, 0.0], to: [1.0, 0.0, 0.0], radius: 1.0 };
    for (shape, off) in [(cube, DVec3::Z), (cube, DVec3::new(0.0, 1.0, 1.0)), (rod, DVec3::Z)] {
        for scale in [0.0, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 2.0] {
            let ray = Ray::new(DVec3::NEG_X * 5.0 + off * scale, DVec3::X);
            let entry = Solid::new(&shape).entry(&ray);
            assert_eq!(entry.is_some(), scale <= 1.0, "{shape:?} at {scale}");
            assert!(entry.is_none_or(|entry| (entry.distance - 4.0).abs() < 1e-14));
        }
    }
}

#[test]
fn bodies_behind_the_aperture_are_not_seen() {
    for i in 0..60 {
        let shape = shape(i);
        let [origin, direction] = near_miss(&shape, i, 5.0, 0.3);
        assert_eq!(Solid::new(&shape).entry(&Ray::new(origin, -direction)), None);
    }
}
