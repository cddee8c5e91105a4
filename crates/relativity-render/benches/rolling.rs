//! The cost of rolling wheels: a street with the wheels of a bicycle, against wheels that only slide.
//!
//! `cargo bench -p relativity-render --bench rolling` prints, for several speeds and times, milliseconds per
//! frame of two eyes of 480 x 540 pixels (median of rounds taken in turns) and their ratio.

use std::f64::consts::TAU;
use std::time::Instant;

use glam::DVec3;
use relativity_core::{Aperture, Speed, Turning};
use relativity_render::{
    Appearance, Body, Camera, EyeTarget, Gaze, Geometry, Gpu, GpuError, MaterialPoint, Method, Pattern,
    PreparedScene, Renderers, Shape, Spin, View,
};

const ROUNDS: usize = 20;
const SIZE: [u32; 2] = [480, 540];

fn main() -> Result<(), GpuError> {
    let gpu = Gpu::headless()?;
    println!("{}, 2 x {} x {}, ms per frame", gpu.description(), SIZE[0], SIZE[1]);
    println!("  beta  time  sliding  rolling");
    for beta in [0.5, 0.9, 0.93, 0.99] {
        for time in [3.0, 4.5, 6.0] {
            compare(&gpu, beta, time)?;
        }
    }
    Ok(())
}

/// Prints the cost of a frame of wheels that slide or roll, seen from the near side of the street.
fn compare(gpu: &Gpu, beta: f64, time: f64) -> Result<(), GpuError> {
    let mut renderers = Renderers::new(Some(gpu.clone()));
    let rolling = wheels();
    let sliding: Vec<_> = rolling.iter().map(|body| Body { spin: None, ..body.clone() }).collect();
    let scenes = [sliding, rolling].map(|bodies| PreparedScene::moving(&bodies));
    let appearance = Appearance {
        ground_z: Some(-2.5),
        road: Some([2.0, 9.0]),
        fronts: Some(13.0),
        ..Appearance::default()
    };
    let mut targets = [EyeTarget::new(gpu, SIZE), EyeTarget::new(gpu, SIZE)];
    let views = Aperture::pair(0.1).map(|aperture| {
        let camera = Camera::new(aperture, Gaze::STRAIGHT_AHEAD, 1.0, SIZE);
        let speed = Speed::from_beta(beta).expect("below 1");
        let mut view = View { camera, speed, observation_time: time, geometry: Geometry::Seen };
        let hub = view.apparent_position(MaterialPoint::from(HUBS[0])).expect("inside the domain");
        view.camera.gaze = Gaze::along(hub.to_array());
        view
    });
    let mut times = [const { Vec::new() }; 2];
    for round in 0..=ROUNDS {
        for (scene, times) in scenes.iter().zip(&mut times) {
            let start = Instant::now();
            for (view, target) in views.iter().zip(&mut targets) {
                renderers.draw(Method::Rays, scene, view, &appearance, target)?;
            }
            gpu.wait()?;
            if round > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
        }
    }
    let [sliding, rolling] = times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    });
    println!("{beta:6}  {time:4}  {sliding:7.1}  {rolling:7.1} ({:4.2} x)", rolling / sliding);
    Ok(())
}

/// Places of a bicycle's axles.
const HUBS: [[f64; 3]; 2] = [[-0.525, 4.0, -1.975], [-2.105, 4.0, -1.975]];

/// The wheels of a bicycle as they roll: of each tyre, rim, hub, valve and 14 crossed spokes.
fn wheels() -> Vec<Body> {
    HUBS.into_iter().flat_map(wheel).collect()
}

fn wheel(hub: [f64; 3]) -> impl Iterator<Item = Body> {
    const SPOKES: u32 = 14;
    let ring = |radius, tube_radius| Shape::Ring { centre: hub, axis: [0.0, 1.0, 0.0], radius, tube_radius };
    let place = move |off_axle: f64, angle: f64, y: f64| {
        let (sine, cosine) = angle.sin_cos();
        (DVec3::from(hub) + DVec3::new(off_axle * cosine, y, off_axle * sine)).to_array()
    };
    let tube = move |from, to, radius| Shape::Tube { from, to, radius };
    let spoke = move |i: u32| {
        let side = f64::from(i % 2) * 2.0 - 1.0;
        let angle = TAU * f64::from(i) / f64::from(SPOKES);
        let behind = if i % 4 < 2 { 1.3 } else { -1.3 };
        tube(place(0.042, angle + behind, 0.052 * side), place(0.447, angle, 0.0), 0.007)
    };
    let parts = [
        ring(0.447, 0.012),
        tube(place(0.0, 0.0, -0.075), place(0.0, 0.0, 0.075), 0.024),
        tube(place(0.447, 0.2, 0.0), place(0.37, 0.2, 0.0), 0.007),
    ];
    let spin = Spin { hub, radius: 0.525, turning: Turning::Rolling };
    let pattern = Pattern::Stripes { step: TAU * 0.493 / 31.0 };
    let tyre = Body { pattern, ..Body::new(ring(0.493, 0.032), 650.0) };
    let others = parts.into_iter().chain((0..SPOKES).map(spoke)).map(|shape| Body::new(shape, 650.0));
    [tyre].into_iter().chain(others).map(move |body| body.turning(spin))
}
