//! The cost of a model of a million triangles beside that of our own shapes: how long it takes to be
//! prepared, its memory, and the rays a second by the reference and by the packets; on a graphics device also
//! by the rays and by the mesh.
//!
//! `cargo bench -p relativity-render --bench models` prints them for a ball that rides past at beta = 0.9,
//! from far and from near. Memory is read where the system tells it.

#[path = "../tests/models/mod.rs"]
mod models;
#[path = "../tests/support/mod.rs"]
mod support;

use std::time::Instant;

use relativity_core::{Aperture, Speed};
use relativity_render::{
    Appearance, Body, Camera, Colour, EyeTarget, Gaze, Geometry, Gpu, Method, PreparedScene, Renderers,
    Shape, View,
};

use models::ball_model;

const ROUNDS: usize = 3;
const SIZE: [u32; 2] = [960, 720];
const MIDDLE: [f64; 3] = [0.0, 4.0, 0.5];

fn main() {
    let start = Instant::now();
    let before = memory_mb("VmRSS");
    let triangles = ball_model(MIDDLE, 0.6, 500).prepared().expect("a model");
    let prepared_s = start.elapsed().as_secs_f64();
    let count = triangles.count() as f64 / 1e6;
    let scene = PreparedScene::moving(&[Body::of_triangles(triangles)]);
    let left = memory_mb("VmRSS") - before;
    let most = memory_mb("VmHWM") - before;
    println!(
        "{count:.1} million triangles: made and prepared in {prepared_s:.2} s; {left:.0} MB, at most {most:.0}"
    );
    let exact = PreparedScene::moving(&[Body::white(Shape::Sphere { centre: MIDDLE, radius: 0.6 })]);
    for fov in [40.0, 15.0] {
        let view = view(f64::to_radians(fov));
        for (name, scene) in [("a million triangles", &scene), ("our ball", &exact)] {
            compare(name, scene, &view);
        }
    }
}

/// Prints the cost of a picture of `scene` by each renderer.
fn compare(name: &str, scene: &PreparedScene, view: &View) {
    let rays = f64::from(SIZE[0] * SIZE[1]) / 1e6;
    let covered = scene.hit_image(view).hits.iter().flatten().count() as f64 / rays / 1e4;
    println!("{name}, {covered:.0} % covered, {}x{}:", SIZE[0], SIZE[1]);
    let before = processor_s();
    let reference_s = fastest(|| drop(scene.hit_image(view)));
    let per_core = ROUNDS as f64 * rays / (processor_s() - before);
    println!("  reference: {:.2} million rays/s, {per_core:.2} a core", rays / reference_s);
    let mut renderers = Renderers::new(Gpu::headless().ok());
    let appearance = Appearance { colour: Colour::White, ..Appearance::default() };
    let packets_s = fastest(|| {
        renderers.picture(Method::Packets, scene, view, &appearance, 1).expect("it needs no device");
    });
    println!("  packets: {:.0} ms", 1e3 * packets_s);
    let Some(gpu) = renderers.gpu().cloned() else { return };
    let mut target = EyeTarget::new(&gpu, SIZE);
    for method in [Method::Rays, Method::Mesh] {
        let mut draw = || {
            renderers.draw(method, scene, view, &appearance, &mut target).expect("device works");
            gpu.wait().expect("device works");
        };
        draw();
        println!("  {method}: {:.0} ms on {}", 1e3 * fastest(draw), gpu.description());
    }
}

fn view(horizontal_fov: f64) -> View {
    let speed = Speed::from_beta(0.9).expect("below 1");
    let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, horizontal_fov, SIZE);
    let mut view = View { camera, speed, observation_time: 4.0, geometry: Geometry::Seen };
    let middle = view.apparent_position(MIDDLE).expect("inside the domain");
    view.camera.gaze = Gaze::along(middle.to_array());
    view
}

/// Seconds of the fastest of some runs.
fn fastest(mut work: impl FnMut()) -> f64 {
    let mut run = || {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..ROUNDS).map(|_| run()).fold(f64::INFINITY, f64::min)
}

/// Returns the processor time of this process in seconds, from Linux in hundredths; 0 elsewhere.
fn processor_s() -> f64 {
    let status = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields = status.rsplit(')').next().unwrap_or_default().split_whitespace();
    fields.skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / 100.0
}

/// Returns a line of this process' memory in Linux, MB; 0 elsewhere.
fn memory_mb(name: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(':'));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) / 1024.0
}
