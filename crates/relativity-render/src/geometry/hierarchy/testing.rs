//! Rays and boxes for tests.

use glam::DVec3;

use crate::geometry::ray::Ray;

/// From 0 to 1, all over.
fn spread(i: u32, root: f64) -> f64 {
    (f64::from(i) * root.sqrt()).fract()
}

/// Returns a place in a cube, another one for each number.
pub fn place(i: u32, size: f64) -> DVec3 {
    size * (DVec3::new(spread(i, 2.0), spread(i, 3.0), spread(i, 5.0)) * 2.0 - 1.0)
}

/// Fewer rays than are looked along at once, from cameras near and far.
pub fn looks(middle: DVec3) -> impl Iterator<Item = Vec<Ray>> {
    [(5.0, 0.05), (1e6, 1e-7), (1e12, 1e-13)].into_iter().map(move |(distance, gap)| {
        let ray = |i| {
            let towards = middle + place(i, 1.5) + DVec3::X * f64::from(i) * gap;
            let camera = middle + DVec3::new(0.3, -1.0, 0.2).normalize() * distance;
            Ray::new(camera, (towards - camera).normalize()).counted_from(middle)
        };
        (0..61).map(ray).collect()
    })
}

/// Returns the range in which `ray` is inside a box, if anywhere: between three pairs of planes, in f64.
pub fn inside(ray: &Ray, centre: DVec3, half: DVec3) -> Option<[f64; 2]> {
    let to = |corner: DVec3| (corner - ray.start) / ray.direction;
    let (low, high) = (to(centre - half), to(centre + half));
    let [from, until] = [low.min(high).max_element(), low.max(high).min_element()];
    (from <= until).then_some([from, until])
}
