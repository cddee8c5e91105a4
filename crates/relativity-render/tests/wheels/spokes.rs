//! Views of wheels from everywhere, and the pixels of their pictures that show what is seen nowhere near.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::Range;

use glam::DVec3;
use relativity_core::Speed;
use relativity_render::{Body, Geometry, Hit, HitImage, Method, PreparedScene, Renderers, Shape, View};

use super::{view_of_hub, wheel};
use crate::support::spread;

/// The ratio of the radii of stout and thin spokes.
const STOUT: f64 = 4.4;
/// By how much the distances of one place differ, as two methods have them.
const SAME_DISTANCE: f64 = 2e-3;
/// The distances from a pixel, px, at which its hit is looked for beyond the stated error.
const REACHES_PX: [f64; 8] = [0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0];

/// Wheels with thin spokes and with stout ones.
fn scenes() -> [PreparedScene; 2] {
    let stout = |body: Body| match body.shape {
        Shape::Tube { from, to, radius } if radius < 0.01 => {
            Body { shape: Shape::Tube { from, to, radius: STOUT * radius }, ..body }
        }
        _ => body,
    };
    let thin = wheel();
    let bodies: Vec<_> = thin.iter().cloned().map(stout).collect();
    [thin, bodies].map(|bodies| PreparedScene::moving(&bodies))
}

/// The view of this number: the hub is at any distance from 0.6 to 4 (the wheel's radius is 0.5), on any
/// side, in every other view within 17 degrees of the wheel's plane, and mostly nearer; gamma is from 1.02
/// to 1000.
fn view(number: u32) -> View {
    let [a, b, c, d] = spread(number + 1);
    let gamma = 1.0 + 10f64.powf(4.7 * a - 1.7);
    let even = 2.0 * b - 1.0;
    let from_plane = if number.is_multiple_of(2) { even * FRAC_PI_2 } else { 0.3 * even.powi(3) };
    let (y, across) = from_plane.sin_cos();
    let (z, x) = (TAU * c).sin_cos();
    let hub = DVec3::new(x * across, y, z * across) * (0.6 * (4.0f64 / 0.6).powf(d));
    let speed = Speed::from_gamma(gamma.min(1000.0)).expect("in range");
    let geometry = if number % 5 == 4 { Geometry::Contracted } else { Geometry::Seen };
    view_of_hub(hub, speed, geometry, -0.05)
}

/// A pixel that shows what is not seen within the stated error of it.
#[derive(Debug)]
#[expect(dead_code, reason = "a failed test prints it")]
pub struct WrongPixel {
    view: u32,
    gamma: f64,
    pixel: [f64; 2],
    /// Numbers of bodies and their distances.
    shown: Option<(usize, f64)>,
    truth: Option<(usize, f64)>,
    /// Between the ray and the wheel's plane, degrees.
    angle: f64,
    /// The distance from the pixel at which the reference shows it, px.
    off_px: f64,
}

/// Returns the number of pixels in these `views` that show a body, and the wrong ones: there `method` shows a
/// place that the reference shows nowhere within `stated_px`.
pub fn wrong_pixels(
    renderers: &mut Renderers,
    method: Method,
    stated_px: f64,
    views: Range<u32>,
) -> (usize, Vec<WrongPixel>) {
    let scenes = scenes();
    let (mut covered, mut wrong) = (0, Vec::new());
    for number in views {
        let (view, scene) = (view(number), &scenes[number as usize / 3 % 2]);
        let truth = scene.hit_image(&view);
        let image = renderers.hits(method, scene, &view).expect("it is drawn");
        covered += truth.hits.iter().flatten().count();
        for (i, (&shown, &truth)) in image.hits.iter().zip(&truth.hits).enumerate() {
            if is_same(shown, truth) {
                continue;
            }
            let pixel = centre(&image, i);
            let off_px = distance_px(scene, &view, pixel, shown, stated_px);
            if off_px > stated_px {
                let ray = scene.group_views(&view)[0].rest_ray(view.camera.line_of_sight(pixel));
                let [shown, truth] = [shown, truth].map(|hit| hit.map(|hit| (hit.body, hit.distance)));
                let angle = ray.direction.y.abs().asin().to_degrees();
                let gamma = view.speed.gamma();
                wrong.push(WrongPixel { view: number, gamma, pixel, shown, truth, angle, off_px });
            }
        }
    }
    (covered, wrong)
}

/// Whether both are one place of one body, or nothing.
fn is_same(a: Option<Hit>, b: Option<Hit>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => {
            a.body == b.body && (a.distance - b.distance).abs() < SAME_DISTANCE * b.distance
        }
        _ => false,
    }
}

/// Returns the distance, px, at which the reference shows `hit`: up to `stated_px`, or one of [`REACHES_PX`];
/// infinity beyond a pixel.
fn distance_px(
    scene: &PreparedScene,
    view: &View,
    [u, v]: [f64; 2],
    hit: Option<Hit>,
    stated_px: f64,
) -> f64 {
    let reaches = [0.25, 0.5, 1.0].map(|share| share * stated_px).into_iter().chain(REACHES_PX);
    let shows = |reach: f64| {
        (0..24).any(|k| {
            let (sine, cosine) = (TAU * f64::from(k) / 24.0).sin_cos();
            let line = view.camera.line_of_sight([u + reach * cosine, v + reach * sine]);
            is_same(hit, scene.first_hit(view, line))
        })
    };
    reaches.into_iter().find(|&reach| shows(reach)).unwrap_or(f64::INFINITY)
}

/// The middle of the `i`-th pixel.
fn centre(image: &HitImage, i: usize) -> [f64; 2] {
    let width = image.size[0] as usize;
    [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5]
}
