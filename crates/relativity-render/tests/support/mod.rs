//! Helpers that several tests share: spread numbers, the figures of the documentation, and each shape by its
//! definition.

#![allow(dead_code, reason = "each program that includes this module uses its own part")]
#![allow(clippy::allow_attributes, reason = "an expectation would fail in the programs that use every part")]

use std::f64::consts::TAU;

use glam::{DMat3, DQuat, DVec3};
use relativity_render::Shape;

/// The figure that follows `before` in the comments of `source`: what is written is what tests hold it to.
#[must_use]
pub fn documented(source: &str, before: &str) -> f64 {
    let comments = source.lines().filter_map(|line| line.trim_start().strip_prefix("//"));
    let words = comments.flat_map(|line| line.trim_start_matches(['/', '!']).split_whitespace());
    let text = words.collect::<Vec<_>>().join(" ");
    let (_, after) = text.split_once(before).expect("the documentation says so");
    let end = after.find(|c: char| !c.is_ascii_digit() && !".e-".contains(c)).unwrap_or(after.len());
    after[..end].trim_end_matches('.').parse().expect("a number")
}

/// The `i`-th of a sequence that fills the unit cube of `N` dimensions evenly (Kronecker sequence of
/// square roots of primes).
#[must_use]
pub fn spread<const N: usize>(i: u32) -> [f64; N] {
    const PRIMES: [f64; 12] = [2., 3., 5., 7., 11., 13., 17., 19., 23., 29., 31., 37.];
    std::array::from_fn(|k| (f64::from(i) * PRIMES[k].sqrt()).fract())
}

/// The cases of a sweep that are tried: all with `GAMOW_SWEEPS=full`, as `.ci/nightly` has it, else of each
/// `share` neighbours one, drawn by the sequence of [`spread`] from `seed` on: of sweeps within another each
/// has a seed of its own.
pub fn sweep<T>(seed: u32, share: usize, cases: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    let is_full = std::env::var_os("GAMOW_SWEEPS").is_some_and(|value| value == "full");
    let share = if is_full { 1 } else { share };
    let is_tried = move |i: usize| {
        let [drawn] = spread(997 * seed + (i / share) as u32 + 1);
        i % share == (drawn * share as f64) as usize
    };
    cases.into_iter().enumerate().filter(move |(i, _)| is_tried(*i)).map(|(_, case)| case)
}

/// A point in the cube [-1, 1]^3.
#[must_use]
pub fn centred(u: [f64; 3]) -> DVec3 {
    2.0 * DVec3::from(u) - 1.0
}

/// Signed distance of `p` from the surface of `shape`, negative inside.
#[must_use]
pub fn signed_distance(shape: &Shape, p: DVec3) -> f64 {
    match *shape {
        Shape::Sphere { centre, radius } => p.distance(centre.into()) - radius,
        Shape::Tube { from, to, radius } => {
            let (from, to) = (DVec3::from(from), DVec3::from(to));
            let share = (p - from).dot(to - from) / from.distance_squared(to);
            p.distance(from.lerp(to, share.clamp(0.0, 1.0))) - radius
        }
        Shape::Ring { centre, axis, radius, tube_radius } => {
            let (p, axis) = (p - DVec3::from(centre), DVec3::from(axis));
            (p.cross(axis).length() - radius).hypot(p.dot(axis)) - tube_radius
        }
        Shape::Box { centre, half, turn } => {
            let own = DQuat::from_array(turn).conjugate() * (p - DVec3::from(centre));
            let out = own.abs() - DVec3::from(half);
            out.max(DVec3::ZERO).length() + out.max_element().min(0.0)
        }
        Shape::Cylinder { from, to, radius } => {
            let (from, to) = (DVec3::from(from), DVec3::from(to));
            let (axis, p) = ((to - from).normalize(), p - 0.5 * (from + to));
            let [off, along] = [p.cross(axis).length() - radius, p.dot(axis).abs() - 0.5 * from.distance(to)];
            off.max(0.0).hypot(along.max(0.0)) + off.max(along).min(0.0)
        }
    }
}

/// Returns a point on the surface of `shape` and the unit normal there; both coordinates go from 0 to 1.
#[must_use]
pub fn surface_point(shape: &Shape, [u, v]: [f64; 2]) -> (DVec3, DVec3) {
    let turn = |axis: DVec3, share: f64| {
        let (first, second) = axis.normalize().any_orthonormal_pair();
        let angle = TAU * share;
        first * angle.cos() + second * angle.sin()
    };
    let (skeleton, normal, radius) = match *shape {
        Shape::Sphere { centre, radius } => {
            let z = 2.0 * v - 1.0;
            (centre.into(), turn(DVec3::Z, u) * (1.0 - z * z).sqrt() + DVec3::Z * z, radius)
        }
        Shape::Tube { from, to, radius } => {
            let (from, to) = (DVec3::from(from), DVec3::from(to));
            (from.lerp(to, v), turn(to - from, u), radius)
        }
        Shape::Ring { centre, axis, radius, tube_radius } => {
            let outwards = turn(axis.into(), u);
            let angle = TAU * v;
            let normal = outwards * angle.cos() + DVec3::from(axis) * angle.sin();
            (DVec3::from(centre) + outwards * radius, normal, tube_radius)
        }
        Shape::Box { centre, half, turn } => {
            let axes = DMat3::from_quat(DQuat::from_array(turn));
            let face = (6.0 * u) as usize;
            let side = if face.is_multiple_of(2) { 1.0 } else { -1.0 };
            let mut place = DVec3::new(2.0 * v - 1.0, 12.0 * u.fract() % 2.0 - 1.0, 1.0 - 2.0 * v);
            place[face / 2] = 0.0;
            let normal = axes.col(face / 2) * side;
            (DVec3::from(centre) + axes * (place * DVec3::from(half)), normal, half[face / 2])
        }
        Shape::Cylinder { from, to, radius } => {
            let (from, to) = (DVec3::from(from), DVec3::from(to));
            let axis = (to - from).normalize();
            if u < 0.3 {
                (from + turn(axis, v) * (radius * u / 0.3), -axis, 0.0)
            } else {
                (from.lerp(to, v), turn(axis, u), radius)
            }
        }
    };
    (skeleton + normal * radius, normal)
}

/// Returns `shape` in a mirror across x.
#[must_use]
pub fn mirrored(shape: &Shape) -> Shape {
    let place = |[x, y, z]: [f64; 3]| [-x, y, z];
    match *shape {
        Shape::Sphere { centre, radius } => Shape::Sphere { centre: place(centre), radius },
        Shape::Tube { from, to, radius } => Shape::Tube { from: place(from), to: place(to), radius },
        Shape::Ring { centre, axis, radius, tube_radius } => {
            Shape::Ring { centre: place(centre), axis: place(axis), radius, tube_radius }
        }
        // A mirror turns the other way about axes along it.
        Shape::Box { centre, half, turn: [x, y, z, w] } => {
            Shape::Box { centre: place(centre), half, turn: [x, -y, -z, w] }
        }
        Shape::Cylinder { from, to, radius } => Shape::Cylinder { from: place(from), to: place(to), radius },
    }
}
