//! A cost model: the time of one eye's picture by each renderer, from its pixels and what they show.
//!
//! `cargo bench -p relativity-render --bench cost` times pictures of three sizes, of crowds of up to 64,000
//! bodies and of models of up to a million triangles, and fits
//!
//! ```text
//! ms = a + p P + b B + n N + t T
//! ```
//!
//! with P the megapixels of the picture, B those that show bodies, N thousands of bodies, and T the
//! megapixels that show triangles, times log2 of how many triangles there are. It prints the coefficients,
//! none below 0, how far the times are from them, and both for each picture. The reference looks once per
//! pixel.

mod crowd;
#[path = "../tests/models/mod.rs"]
mod models;
#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;
use std::time::Instant;

use glam::DVec3;
use models::ball_model;
use relativity_core::{Aperture, Speed};
use relativity_render::{
    Appearance, Body, Camera, EyeTarget, Gaze, Geometry, Gpu, GpuError, Method, PreparedScene, Renderers,
    View,
};
use support::{centred, spread};

const ROUNDS: usize = 5;
const SIZES: [[u32; 2]; 3] = [[240, 180], [480, 360], [960, 720]];
const CROWDS: [u32; 5] = [0, 64, 640, 6400, 64_000];
/// Rings of the models, each with four times as many triangles.
const MODELS: [u32; 3] = [10, 100, 500];
const MIDDLE: [f64; 3] = [0.0, 5.0, 0.0];
const TERMS: usize = 5;

/// The cost of a picture.
struct Cost {
    name: String,
    /// The factors of the coefficients.
    terms: [f64; TERMS],
    /// The median time, ms.
    ms: f64,
}

fn main() -> Result<(), GpuError> {
    let gpu = Gpu::headless()?;
    println!("{}, {} threads", gpu.description(), rayon::current_num_threads());
    let crowds = CROWDS.map(|count| (format!("{count} bodies"), PreparedScene::moving(&crowd(count)), 0));
    let models = MODELS.map(|rings| {
        let triangles = ball_model(MIDDLE, 1.5, rings).prepared().expect("a model");
        let count = triangles.count();
        (format!("{count} triangles"), PreparedScene::moving(&[Body::of_triangles(triangles)]), count)
    });
    let scenes: Vec<_> = crowds.into_iter().chain(models).collect();
    for method in [Method::Rays, Method::Packets, Method::Reference] {
        let mut renderers = Renderers::new(Some(gpu.clone()));
        let mut costs = Vec::new();
        for (name, scene, triangles) in &scenes {
            for size in SIZES {
                let name = format!("{name}, {}x{}", size[0], size[1]);
                costs.push(cost(&gpu, &mut renderers, method, name, scene, *triangles, size)?);
            }
        }
        report(method, &costs);
    }
    Ok(())
}

fn cost(
    gpu: &Gpu,
    renderers: &mut Renderers,
    method: Method,
    name: String,
    scene: &PreparedScene,
    triangles: usize,
    size: [u32; 2],
) -> Result<Cost, GpuError> {
    let speed = Speed::from_beta(0.6).expect("below 1");
    let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.0, size);
    let mut view = View { camera, speed, observation_time: 5.0, geometry: Geometry::Seen };
    view.camera.gaze = Gaze::along(view.apparent_position(MIDDLE).expect("inside the domain").to_array());
    let appearance = Appearance { ground_z: Some(-2.5), ..Appearance::default() };
    let mut target = EyeTarget::new(gpu, size);
    let mut times = Vec::new();
    for round in 0..=ROUNDS {
        let start = Instant::now();
        if method == Method::Reference {
            black_box(renderers.picture(method, scene, &view, &appearance, 1)?);
        } else {
            renderers.draw(method, scene, &view, &appearance, &mut target)?;
            gpu.wait()?;
        }
        // The first round makes pipelines.
        if round > 0 {
            times.push(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    times.sort_by(f64::total_cmp);
    let megapixels = f64::from(size[0] * size[1]) / 1e6;
    let hits = renderers.hits(Method::Packets, scene, &view)?.hits;
    let shown = hits.iter().flatten().count() as f64 / 1e6;
    let terms = if triangles == 0 {
        [1.0, megapixels, shown, scene.bodies().len() as f64 / 1e3, 0.0]
    } else {
        [1.0, megapixels, 0.0, 0.0, shown * (triangles as f64).log2()]
    };
    Ok(Cost { name, terms, ms: times[ROUNDS / 2] })
}

/// Prints the model of these costs, and how far they are from it.
fn report(method: Method, costs: &[Cost]) {
    let model = fitted(costs);
    let modelled =
        |cost: &Cost| cost.terms.iter().zip(model).map(|(term, factor)| term * factor).sum::<f64>();
    let mut off: Vec<_> = costs.iter().map(|cost| (cost.ms / modelled(cost)).ln().abs().exp()).collect();
    off.sort_by(f64::total_cmp);
    let [a, p, b, n, t] = model;
    println!("{method}: {a:.2} + {p:.1} P + {b:.1} B + {n:.3} N + {t:.2} T ms");
    println!("  off by a factor of {:.2} (median), {:.2} (at most)", off[off.len() / 2], off[off.len() - 1]);
    for cost in costs {
        println!("  {:32} {:9.2} ms, modelled {:9.2}", cost.name, cost.ms, modelled(cost));
    }
}

/// The coefficients, none of them below 0, of least squares of relative errors: terms that would count less
/// than nothing are left out.
fn fitted(costs: &[Cost]) -> [f64; TERMS] {
    let mut used: Vec<usize> = (0..TERMS).collect();
    loop {
        let factors = least_squares(costs, &used);
        let Some(worst) =
            (0..used.len()).filter(|&i| factors[i] < 0.0).min_by(|&i, &j| factors[i].total_cmp(&factors[j]))
        else {
            let mut all = [0.0; TERMS];
            for (&term, factor) in used.iter().zip(factors) {
                all[term] = factor;
            }
            return all;
        };
        used.remove(worst);
    }
}

/// Solves the normal equations of these terms by elimination.
fn least_squares(costs: &[Cost], used: &[usize]) -> Vec<f64> {
    let count = used.len();
    let mut rows = vec![vec![0.0; count + 1]; count];
    for Cost { terms, ms, .. } in costs {
        for (row, &i) in rows.iter_mut().zip(used) {
            for (entry, &j) in row.iter_mut().zip(used) {
                *entry += terms[i] * terms[j] / (ms * ms);
            }
            row[count] += terms[i] / ms;
        }
    }
    for i in 0..count {
        let pivot = rows[i].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(j, _)| *j != i) {
            let factor = row[i] / pivot[i];
            for (entry, own) in row.iter_mut().zip(&pivot) {
                *entry -= factor * own;
            }
        }
    }
    (0..count).map(|i| rows[i][count] / rows[i][i]).collect()
}

/// Bodies of three kinds strewn around the middle, smaller the more there are, so that they cover about as
/// much.
fn crowd(count: u32) -> Vec<Body> {
    let size = 0.8 * f64::from(count.max(1)).sqrt().recip();
    let centre = |i| (DVec3::from(MIDDLE) + 1.5 * centred(spread(i))).to_array();
    (0..count).map(|i| crowd::body(i, centre(i), size)).collect()
}
