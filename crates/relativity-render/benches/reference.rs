//! What the tree of boxes saves: the reference renderer against its own loop over all bodies.
//!
//! `cargo bench -p relativity-render --bench reference` prints, for 64, 640 and 6,400 bodies in a crowd that
//! rides past at beta = 0.9, the time per ray of both and their ratio, measured in turns in one run.

use std::hint::black_box;
use std::time::Instant;

use glam::DVec3;
use relativity_core::{Aperture, Speed};
use relativity_render::bvh::Bvh;
use relativity_render::camera::LinesOfSight;
use relativity_render::intersect::{Entry, Solid};
use relativity_render::{Body, Camera, Gaze, Geometry, ReferenceScene, Shape, View};

const ROUNDS: usize = 5;

fn main() {
    println!("bodies  covered  loop ns/ray  tree ns/ray  ratio  whole image ns/ray");
    for bodies in [64, 640, 6400] {
        compare(&crowd(bodies));
    }
}

fn compare(bodies: &[Body]) {
    let view = view();
    let solids: Vec<_> = bodies.iter().map(|body| Solid::new(&body.shape)).collect();
    let tree = Bvh::new(solids.iter().copied());
    let rays = rays(&view);
    let looped = || rays.iter().filter(|[origin, n]| nearest_by_loop(&solids, *origin, *n).is_some()).count();
    let treed = || rays.iter().filter(|[origin, n]| tree.nearest_entry(*origin, *n).is_some()).count();
    assert_eq!(looped(), treed());

    let scene = ReferenceScene::new(bodies);
    let image = || scene.hit_image(&view).hits.len();
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        times[0].push(nanoseconds(looped));
        times[1].push(nanoseconds(treed));
        times[2].push(nanoseconds(image));
    }
    let [looped_ns, treed_ns, image_ns] = times.map(|mut t| median(&mut t) / rays.len() as f64);
    let covered = 100.0 * treed() as f64 / rays.len() as f64;
    println!(
        "{:6}  {covered:5.1} %  {looped_ns:11.0}  {treed_ns:11.0}  {:5.1}  {image_ns:18.0}",
        bodies.len(),
        looped_ns / treed_ns
    );
}

fn nearest_by_loop(solids: &[Solid], origin: DVec3, direction: DVec3) -> Option<Entry> {
    let entries = solids.iter().filter_map(|solid| solid.entry(origin, direction));
    entries.min_by(|a, b| a.distance.total_cmp(&b.distance))
}

/// Spheres, tubes and rings spread over a block 12 long, 4 deep and 4 high, smaller the more there are.
fn crowd(count: u32) -> Vec<Body> {
    let size = f64::from(count).cbrt().recip();
    let spread = |i: u32, root: f64| (f64::from(i) * root.sqrt()).fract();
    let body = |i| {
        let place = DVec3::new(12.0 * spread(i, 2.0) - 6.0, 3.0 + 4.0 * spread(i, 3.0), 4.0 * spread(i, 5.0));
        let turned =
            DVec3::new(spread(i, 7.0) - 0.5, spread(i, 11.0) - 0.5, spread(i, 13.0) - 0.5).normalize();
        let center = place.to_array();
        let shape = match i % 3 {
            0 => Shape::Sphere { center, radius: 0.4 * size },
            1 => {
                Shape::Tube { from: center, to: (place + turned * 2.0 * size).to_array(), radius: 0.1 * size }
            }
            _ => Shape::Ring { center, axis: turned.to_array(), radius: 0.6 * size, tube_radius: 0.1 * size },
        };
        Body { shape, rest_wavelength_nm: 600.0 }
    };
    (0..count).map(body).collect()
}

fn view() -> View {
    let camera = Camera {
        aperture: Aperture::default(),
        gaze: Gaze::along([0.0, 4.0, 2.0]),
        horizontal_fov: 40f64.to_radians(),
        size: [192, 144],
    };
    let speed = Speed::from_beta(0.9).expect("below 1");
    View { camera, speed, observation_time: 4.0, geometry: Geometry::Seen }
}

/// Origin and direction in the rest frame, one ray per pixel.
fn rays(view: &View) -> Vec<[DVec3; 2]> {
    let lines_of_sight = LinesOfSight::new(&view.camera);
    let [width, height] = view.camera.size;
    let pixels = (0..height).flat_map(|v| (0..width).map(move |u| [f64::from(u) + 0.5, f64::from(v) + 0.5]));
    let rest = |pixel| view.rest_ray(lines_of_sight.through(pixel));
    pixels.map(rest).map(|ray| [ray.origin, ray.direction]).collect()
}

fn nanoseconds(work: impl Fn() -> usize) -> f64 {
    let start = Instant::now();
    black_box(work());
    start.elapsed().as_secs_f64() * 1e9
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
