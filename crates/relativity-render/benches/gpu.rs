//! The cost of rays, against a loop over all bodies per pixel, packets of rays on the CPU, and triangles.
//!
//! `cargo bench -p relativity-render --bench gpu` prints, for up to 100,000 bodies that ride past at beta =
//! 0.9, milliseconds per frame of two eyes of 480 x 540 pixels (median of rounds taken in turns) and ratios
//! to the rays'; then what it adds to compose the two pictures into one, and what pictures parallel to the
//! baseline and conformal ones cost beside those across the gaze. With `-- crowds` it prints the first alone,
//! with `-- projections` the last.

mod crowd;

use std::hint::black_box;
use std::time::Instant;

use glam::DVec3;
use relativity_core::{Aperture, Speed};
use relativity_render::picture::compose::Top;
use relativity_render::{
    Appearance, Body, Camera, Composed, Composer, Composition, EyeTarget, Gaze, Geometry, Gpu, GpuError,
    Method, PreparedScene, Projection, Renderers, View,
};

const ROUNDS: usize = 5;
const SIZE: [u32; 2] = [480, 540];
/// A brute-force frame of more bodies than this takes half a minute on a software GPU.
const MOST_FOR_BRUTE_FORCE: usize = 64;
/// And a mesh of more.
const MOST_FOR_MESH: usize = 6400;

fn main() -> Result<(), GpuError> {
    let gpu = Gpu::headless()?;
    println!("{}, 2 x {} x {}, ms per frame", gpu.description(), SIZE[0], SIZE[1]);
    if std::env::args().any(|argument| argument == "projections") {
        return compare_all_projections(&gpu);
    }
    println!("bodies  no bodies   rays  packets: no bodies   packets  brute force        mesh");
    for count in [0, 64, 640, 6400, 100_000] {
        compare(&gpu, &crowd(count))?;
    }
    if std::env::args().any(|argument| argument == "crowds") {
        return Ok(());
    }
    for composition in [
        Composition::Anaglyph,
        Composition::Dubois,
        Composition::Overlay([[0x56, 0xB4, 0xE9], [0xE6, 0x9F, 0x00]]),
        Composition::Rows { top: Top::First },
        Composition::HalfSideBySide,
        Composition::HalfOverUnder,
    ] {
        compose(&gpu, composition, &crowd(64))?;
    }
    compare_all_projections(&gpu)
}

fn compare_all_projections(gpu: &Gpu) -> Result<(), GpuError> {
    println!("bodies  across the gaze      parallel, the same picture      parallel, sheared      conformal");
    for (count, method) in [
        (0, Method::Rays),
        (64, Method::Rays),
        (640, Method::Rays),
        (0, Method::Packets),
        (64, Method::Packets),
        (640, Method::Packets),
        (64, Method::Mesh),
        (640, Method::Mesh),
        (64, Method::Reference),
    ] {
        compare_projections(gpu, &crowd(count), method)?;
    }
    Ok(())
}

/// Prints the times of the picture across the gaze, of the same as one parallel to its rows, of one that is
/// sheared, and of a conformal one with as many pixels per radian in its middle.
fn compare_projections(gpu: &Gpu, bodies: &[Body], method: Method) -> Result<(), GpuError> {
    let mut renderers = Renderers::new(Some(gpu.clone()));
    let scene = PreparedScene::moving(bodies);
    let appearance = Appearance { ground_z: Some(-2.5), ..Appearance::default() };
    let mut targets = [EyeTarget::new(gpu, SIZE), EyeTarget::new(gpu, SIZE)];
    let same = views()[0].camera.gaze.axes().right;
    let parallel = |right| Projection::Parallel { right, shift: 0.0 };
    let projections = [
        Projection::Gaze,
        parallel(same),
        parallel(DVec3::X),
        Projection::Mercator { right: DVec3::X, shift: 0.0 },
    ];
    let mut times = [const { Vec::new() }; 4];
    for round in 0..=4 * ROUNDS {
        for (projection, times) in projections.into_iter().zip(&mut times) {
            let start = Instant::now();
            for (view, target) in views().into_iter().zip(&mut targets) {
                let view = projected(view, projection);
                if method == Method::Reference {
                    black_box(renderers.picture(method, &scene, &view, &appearance, 1)?);
                } else {
                    renderers.draw(method, &scene, &view, &appearance, target)?;
                }
            }
            gpu.wait()?;
            if round > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
        }
    }
    let across = times[0].clone();
    let ratio = |times: &[f64]| {
        let ratios = times.iter().zip(&across).map(|(time, across)| time / across);
        format!("{:8.1} ({:5.3} x)", median(times.to_vec()), median(ratios.collect()))
    };
    println!(
        "{:6}  {method}  {}  {}  {}  {}",
        bodies.len(),
        ratio(&times[0]),
        ratio(&times[1]),
        ratio(&times[2]),
        ratio(&times[3])
    );
    Ok(())
}

/// `view` in this projection; a conformal one is as fine in its middle as a flat one.
fn projected(mut view: View, projection: Projection) -> View {
    let px_per_radian = view.camera.px_per_radian();
    view.camera.projection = projection;
    if projection.is_conformal() {
        let [x, y, z] = view.camera.gaze.axes().forward.to_array();
        let px_per_unit = px_per_radian * y.hypot(z) / x.hypot(y).hypot(z);
        view.camera.horizontal_fov = 2.0 * (0.5 * f64::from(SIZE[0]) / px_per_unit).sinh().atan();
    }
    view
}

/// Prints what a frame of two eyes costs with and without a composition of them.
fn compose(gpu: &Gpu, composition: Composition, bodies: &[Body]) -> Result<(), GpuError> {
    let (mut renderers, composer) = (Renderers::new(Some(gpu.clone())), Composer::new(gpu));
    let scene = PreparedScene::moving(bodies);
    let appearance = Appearance { ground_z: Some(-2.5), ..Appearance::default() };
    let mut targets = [EyeTarget::new(gpu, SIZE), EyeTarget::new(gpu, SIZE)];
    let composed = Composed::new(gpu, composition.size(SIZE));
    let mut times = [const { Vec::new() }; 2];
    for round in 0..=4 * ROUNDS {
        for (is_composed, times) in [false, true].into_iter().zip(&mut times) {
            let start = Instant::now();
            for (view, target) in views().iter().zip(&mut targets) {
                renderers.draw(Method::Rays, &scene, view, &appearance, target)?;
            }
            if is_composed {
                composer.compose(gpu, composition, targets.each_ref(), &composed);
            }
            gpu.wait()?;
            if round > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
        }
    }
    let [without, with] = times.map(median);
    println!("{composition:?}: with {with:.1}, without {without:.1} ms ({:.2} x)", with / without);
    Ok(())
}

fn compare(gpu: &Gpu, bodies: &[Body]) -> Result<(), GpuError> {
    let mut renderers = Renderers::new(Some(gpu.clone()));
    let mut brute = Renderers::brute_force(gpu.clone());
    let (scene, empty) = (PreparedScene::moving(bodies), PreparedScene::moving(&[]));
    let appearance = Appearance { ground_z: Some(-2.5), ..Appearance::default() };
    let mut targets = [EyeTarget::new(gpu, SIZE), EyeTarget::new(gpu, SIZE)];
    let mut times = [const { Vec::new() }; 6];
    for round in 0..=ROUNDS {
        let mut timed = |times: &mut Vec<f64>, renderers: &mut Renderers, method, scene| {
            let start = Instant::now();
            for (view, target) in views().iter().zip(&mut targets) {
                renderers.draw(method, scene, view, &appearance, target)?;
            }
            gpu.wait()?;
            // The first round makes pipelines.
            if round > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
            Ok::<_, GpuError>(())
        };
        timed(&mut times[0], &mut renderers, Method::Rays, &empty)?;
        timed(&mut times[1], &mut renderers, Method::Rays, &scene)?;
        timed(&mut times[4], &mut renderers, Method::Packets, &empty)?;
        timed(&mut times[5], &mut renderers, Method::Packets, &scene)?;
        if bodies.len() <= MOST_FOR_BRUTE_FORCE {
            timed(&mut times[2], &mut brute, Method::Rays, &scene)?;
        }
        if bodies.len() <= MOST_FOR_MESH {
            timed(&mut times[3], &mut renderers, Method::Mesh, &scene)?;
        }
    }
    let [none, rays, brute, mesh, no_packets, packets] = times.map(median);
    let ratio = |time: f64| {
        let text = if time.is_nan() { "-".to_owned() } else { format!("{time:.1} ({:5.2} x)", time / rays) };
        format!("{text:>18}")
    };
    println!(
        "{:6}  {none:9.1}  {rays:5.1}  {no_packets:18.1}  {}  {}  {}",
        bodies.len(),
        ratio(packets),
        ratio(brute),
        ratio(mesh)
    );
    Ok(())
}

/// NaN without times.
fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}

fn views() -> [View; 2] {
    Aperture::pair(0.1).map(|aperture| View {
        camera: Camera::new(aperture, Gaze { azimuth: 2.0, elevation: 0.0 }, 1.0, SIZE),
        speed: Speed::from_beta(0.9).expect("below 1"),
        observation_time: 6.0,
        geometry: Geometry::Seen,
    })
}

/// Balls, tubes and rings spread over a block 12 long, 4 deep and 4 high, smaller the more there are.
fn crowd(count: u32) -> Vec<Body> {
    let size = f64::from(count).cbrt().recip();
    let spread = |i: u32, root: f64| (f64::from(i) * root.sqrt()).fract();
    let centre = |i| [12.0 * spread(i, 2.0) - 6.0, 4.0 + 4.0 * spread(i, 3.0), 4.0 * spread(i, 5.0) - 2.0];
    (0..count).map(|i| crowd::body(i, centre(i), size)).collect()
}
