//! The gain from boxes within boxes and tiles: the reference renderer against its own loop over all bodies.
//!
//! `cargo bench -p relativity-render --bench reference` prints, for 64, 640 and 6,400 bodies in a crowd that
//! rides past at beta = 0.9, the time per image of both and their ratio, measured in turns in one run; then,
//! for up to a million tubes, how long these take to be prepared and how many rays a second it traces.

use std::hint::black_box;
use std::time::Instant;

use glam::DVec3;
use relativity_core::threads::prelude::*;
use relativity_core::{Aperture, Speed};
use relativity_render::{Body, Camera, Gaze, Geometry, PreparedScene, Shape, View};

const ROUNDS: usize = 3;

fn main() {
    println!("bodies  covered  loop ms  image ms  ratio");
    for bodies in [64, 640, 6400] {
        compare(&crowd(bodies));
    }
    for count in [6400, 100_000, 1_000_000] {
        scale(count);
    }
}

fn compare(bodies: &[Body]) {
    let view = view([480, 360]);
    let scene = PreparedScene::moving(bodies);
    let image = || scene.hit_image(&view).hits.iter().flatten().count();
    let looped = || loop_over_all(&scene, &view);
    assert_eq!(image(), looped());

    let mut times = [const { Vec::new() }; 2];
    for _ in 0..ROUNDS {
        times[0].push(milliseconds(looped));
        times[1].push(milliseconds(image));
    }
    let [looped_ms, image_ms] = times.map(|mut times| median(&mut times));
    let covered = 100.0 * image() as f64 / f64::from(view.camera.size[0] * view.camera.size[1]);
    let ratio = looped_ms / image_ms;
    println!("{:6}  {covered:5.1} %  {looped_ms:7.1}  {image_ms:8.1}  {ratio:5.1}", bodies.len());
}

/// Prints how long tubes, as many as that, take to be prepared, and how many rays a second the reference
/// traces among them; the thinner the more they are, so that they fill the same part of the picture.
fn scale(count: u32) {
    let bodies = tubes(count);
    let start = Instant::now();
    let scene = PreparedScene::moving(&bodies);
    let prepared_ms = start.elapsed().as_secs_f64() * 1e3;
    println!("{count} tubes: prepared in {prepared_ms:.0} ms");
    for size in [[480, 360], [1920, 1080]] {
        let view = view(size);
        let image = || scene.hit_image(&view).hits.iter().flatten().count();
        let mut times: Vec<_> = (0..ROUNDS).map(|_| milliseconds(image)).collect();
        let image_ms = median(&mut times);
        let rays = f64::from(size[0] * size[1]);
        let covered = 100.0 * image() as f64 / rays;
        let per_second = rays / image_ms / 1e3;
        println!("  {} x {}, {covered:.0} % covered: {per_second:.2} million rays/s", size[0], size[1]);
    }
}

/// Tubes spread over the same block as the crowd.
fn tubes(count: u32) -> Vec<Body> {
    let size = f64::from(count).sqrt().recip();
    let spread = |i: u32, root: f64| (f64::from(i) * root.sqrt()).fract();
    let body = |i| {
        let place = DVec3::new(12.0 * spread(i, 2.0) - 6.0, 3.0 + 4.0 * spread(i, 3.0), 4.0 * spread(i, 5.0));
        let turned =
            DVec3::new(spread(i, 7.0) - 0.5, spread(i, 11.0) - 0.5, spread(i, 13.0) - 0.5).normalize();
        let (from, to) = (place - turned * 4.0 * size, place + turned * 4.0 * size);
        Body::new(Shape::Tube { from: from.to_array(), to: to.to_array(), radius: 2.0 * size }, 600.0)
    };
    (0..count).map(body).collect()
}

/// Pixels that show a body, every ray tested against every body, on as many threads as the renderer uses.
fn loop_over_all(scene: &PreparedScene, view: &View) -> usize {
    let lines_of_sight = view.camera.lines_of_sight();
    let [width, height] = view.camera.size;
    let hits_of_row = |v: u32| {
        let centres = (0..width).map(|u| [f64::from(u) + 0.5, f64::from(v) + 0.5]);
        centres.filter(|&centre| scene.first_hit(view, lines_of_sight.through(centre)).is_some()).count()
    };
    (0..height).into_par_iter().map(hits_of_row).sum()
}

/// Spheres, tubes and rings spread over a block 12 long, 4 deep and 4 high, smaller the more there are.
fn crowd(count: u32) -> Vec<Body> {
    let size = f64::from(count).cbrt().recip();
    let spread = |i: u32, root: f64| (f64::from(i) * root.sqrt()).fract();
    let body = |i| {
        let place = DVec3::new(12.0 * spread(i, 2.0) - 6.0, 3.0 + 4.0 * spread(i, 3.0), 4.0 * spread(i, 5.0));
        let turned =
            DVec3::new(spread(i, 7.0) - 0.5, spread(i, 11.0) - 0.5, spread(i, 13.0) - 0.5).normalize();
        let centre = place.to_array();
        let shape = match i % 3 {
            0 => Shape::Sphere { centre, radius: 0.4 * size },
            1 => {
                Shape::Tube { from: centre, to: (place + turned * 2.0 * size).to_array(), radius: 0.1 * size }
            }
            _ => Shape::Ring { centre, axis: turned.to_array(), radius: 0.6 * size, tube_radius: 0.1 * size },
        };
        Body::new(shape, 600.0)
    };
    (0..count).map(body).collect()
}

fn view(size: [u32; 2]) -> View {
    let camera = Camera::new(Aperture::default(), Gaze::along([0.0, 4.0, 2.0]), 40f64.to_radians(), size);
    let speed = Speed::from_beta(0.9).expect("below 1");
    View { camera, speed, observation_time: 4.0, geometry: Geometry::Seen }
}

fn milliseconds(work: impl Fn() -> usize) -> f64 {
    let start = Instant::now();
    black_box(work());
    start.elapsed().as_secs_f64() * 1e3
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
