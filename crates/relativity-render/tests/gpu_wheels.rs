//! Wheels that roll, as the GPU draws them, against the f64 reference.

use std::f64::consts::FRAC_PI_2;
use std::iter;
use std::sync::LazyLock;

use glam::DVec3;
use relativity_core::{ObserverVelocity, Speed};
use relativity_render::{
    Geometry, Hit, HitImage, MaterialPoint, Method, PreparedScene, Projection, Renderers, View,
};

use crate::gpu_support::Test;
use crate::support::{documented, sweep};
use crate::wheels::spokes::wrong_pixels;
use crate::wheels::{From, SPIN, scene, view_of_wheel};

pub const TESTS: &[Test] = &[
    ("the_rays_and_packets_agree_with_the_reference", the_rays_and_packets_agree_with_the_reference),
    ("wheels_before_an_oblique_ride_agree_with_the_reference", wheels_before_an_oblique_ride_agree),
    ("rays_show_what_is_seen_within_the_stated_error", rays_show_what_is_seen_within_the_stated_error),
    ("every_number_is_finite_at_the_extremes", every_number_is_finite_at_the_extremes),
    ("bounds_never_clip", bounds_never_clip),
    ("the_mesh_keeps_its_bound", the_mesh_keeps_its_bound),
    ("the_mesh_shows_points_where_they_are_seen", the_mesh_shows_points_where_they_are_seen),
];

const BETAS: [f64; 5] = [0.0, 0.5, 0.93, 0.99, 0.9999];
const GEOMETRIES: [Geometry; 3] = [Geometry::Seen, Geometry::Contracted, Geometry::Rest];
const ASIDE: [f64; 2] = [-0.05, 0.3];

/// A flat picture, and a conformal one.
const PROJECTIONS: [Projection; 2] = [Projection::Gaze, Projection::Mercator { right: DVec3::X, shift: 0.0 }];

/// The widest half of a conformal picture of a wheel, in units of u: a wheel around the baseline is seen
/// infinitely far aside.
const WIDEST: f64 = 1.2;

/// `view` in this projection, the wheel as large in the picture.
fn projected(mut view: View, projection: Projection) -> View {
    view.camera.projection = projection;
    if projection.is_conformal() {
        let flat = (0.5 * view.camera.horizontal_fov).tan();
        let gaze = view.camera.gaze.axes().forward;
        // cosh u times as large as abreast.
        let half_width = (flat / gaze.y.hypot(gaze.z)).min(WIDEST);
        view.camera.horizontal_fov = 2.0 * half_width.sinh().atan();
    }
    view
}

/// The documented bounds of the rays for turning bodies.
struct Promise {
    wrong_percent: f64,
    outline_px: f64,
    doppler_error: f64,
}

static PROMISE: LazyLock<Promise> = LazyLock::new(|| Promise {
    wrong_percent: documented(RENDERERS, "the body differs at fewer than "),
    outline_px: documented(RENDERERS, "Outlines of what turns are within "),
    doppler_error: documented(RENDERERS, "and its D within "),
});
const RENDERERS: &str = include_str!("../src/renderers.rs");

/// The comparison of pictures with the reference's.
#[derive(Debug, Clone, Copy, Default)]
struct Compared {
    shown: usize,
    wrong: usize,
    most_off: f64,
    most_doppler: f64,
}

impl Compared {
    /// Compares the `image` of a view with the `truth`.
    fn add(&mut self, image: &HitImage, truth: &HitImage, scene: &PreparedScene, view: &View, context: &str) {
        for (i, (hit, true_hit)) in image.hits.iter().zip(&truth.hits).enumerate() {
            self.shown += usize::from(true_hit.is_some());
            if hit.map(|hit| hit.body) != true_hit.map(|hit| hit.body) {
                self.wrong += 1;
                let off = outline_distance(scene, view, pixel(image, i), *hit);
                match off.filter(|off| *off <= PROMISE.outline_px) {
                    Some(off) => self.most_off = self.most_off.max(off),
                    None => panic!("{context}: {:?} is {off:?} px off", pixel(image, i)),
                }
            } else if let (Some(hit), Some(true_hit)) = (hit, true_hit) {
                let doppler = (hit.doppler_factor / true_hit.doppler_factor - 1.0).abs();
                self.most_doppler = self.most_doppler.max(doppler / view.speed.gamma());
                let off = hit.material_position.distance(true_hit.material_position);
                assert!(off < 1e-3, "{context}: another point of the body, {off} away");
            }
        }
    }

    fn assert_as_promised(&self, context: &str) {
        println!("{context}: {self:?}");
        let most = 0.01 * PROMISE.wrong_percent * self.shown as f64;
        assert!(self.wrong as f64 <= most, "{context}: {} of {} are wrong", self.wrong, self.shown);
        assert!(
            self.most_doppler < PROMISE.doppler_error,
            "{context}: D is {:e} gamma off",
            self.most_doppler
        );
    }
}

/// From the side, before and behind, and in the wheel's plane, where rays run along spokes that overtake
/// them.
fn the_rays_and_packets_agree_with_the_reference(renderers: &mut Renderers) {
    let scene = scene();
    let cases = BETAS.into_iter().flat_map(|beta| GEOMETRIES.map(|geometry| (beta, geometry)));
    let cases = cases.flat_map(|case| PROJECTIONS.map(|projection| (case, projection)));
    let methods = [Method::Rays, Method::Packets];
    for ((beta, geometry), projection) in sweep(0, 6, cases) {
        let mut compared = [Compared::default(); 2];
        let context = format!("{geometry:?} beta {beta} {projection:?}");
        for (from, aside) in From::ALL.into_iter().flat_map(|from| ASIDE.map(|aside| (from, aside))) {
            let view = projected(view_of_wheel(from, beta, geometry, aside), projection);
            let truth = scene.hit_image(&view);
            for (compared, method) in compared.iter_mut().zip(methods) {
                let image = renderers.hits(method, &scene, &view).expect("device works");
                compared.add(&image, &truth, &scene, &view, &format!("{method}, {context} {from:?}"));
            }
        }
        for (compared, method) in compared.iter().zip(methods) {
            compared.assert_as_promised(&format!("{method}, {context}"));
        }
    }
}

/// The same before cameras that move across the wheel's way, aslant and downwards.
fn wheels_before_an_oblique_ride_agree(renderers: &mut Renderers) {
    let scene = scene();
    let rides = [(0.5, 0.6, FRAC_PI_2, 0.0), (0.93, 0.9, 2.3, 0.4), (0.99, 0.5, -0.7, -1.0)];
    for ((beta, own, azimuth, elevation), geometry) in rides
        .into_iter()
        .flat_map(|ride| [Geometry::Seen, Geometry::Contracted].map(|geometry| (ride, geometry)))
    {
        let own = Speed::from_beta(own).expect("a speed");
        let mut compared = Compared::default();
        for from in From::ALL {
            let mut view = view_of_wheel(from, beta, geometry, ASIDE[0]).with_size([160, 160]);
            view.camera.velocity = ObserverVelocity::new(own, azimuth, elevation);
            let framing = scene.framing(&[view]).expect("there is a wheel");
            view.camera.gaze = framing.gaze;
            view.camera.horizontal_fov = framing.horizontal_fov(view.camera.size);
            let truth = scene.hit_image(&view);
            for method in [Method::Rays, Method::Packets] {
                let image = renderers.hits(method, &scene, &view).expect("device works");
                compared.add(
                    &image,
                    &truth,
                    &scene,
                    &view,
                    &format!("{method}, {geometry:?} {beta} {from:?}"),
                );
            }
        }
        assert!(compared.shown > 2000);
        compared.assert_as_promised(&format!("{geometry:?} beta {beta}"));
    }
}

/// From everywhere, as `spokes.rs` has packets show it.
fn rays_show_what_is_seen_within_the_stated_error(renderers: &mut Renderers) {
    let (covered, wrong) = wrong_pixels(renderers, Method::Rays, PROMISE.outline_px, 0..24);
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(covered > 10_000, "{covered} pixels show something");
}

/// Long before and long after the wheel passes, and while it does, at the highest speeds.
fn every_number_is_finite_at_the_extremes(renderers: &mut Renderers) {
    let scene = scene();
    let methods = [Method::Rays, Method::Packets, Method::Mesh];
    let mut shown = [0; 4];
    for (gamma, observation_time) in
        [1e3, 1e12, 1e30].into_iter().flat_map(|gamma| [-1e12, -1.0, 3.3, 1e12].map(|time| (gamma, time)))
    {
        let speed = Speed::from_gamma(gamma).expect("in range");
        for projection in PROJECTIONS {
            let mut view = view_of_wheel(From::Side, 0.5, Geometry::Seen, 0.0);
            (view.speed, view.observation_time, view.camera.projection) =
                (speed, observation_time, projection);
            let Some(framing) = scene.framing(&[view]) else { continue };
            view.camera.gaze = framing.gaze;
            view.camera.horizontal_fov = framing.horizontal_fov(view.camera.size);
            let reference = iter::once(scene.hit_image(&view));
            let others = methods.map(|method| renderers.hits(method, &scene, &view).expect("device works"));
            for (shown, image) in shown.iter_mut().zip(reference.chain(others)) {
                for hit in image.hits.iter().flatten() {
                    *shown += 1;
                    assert!(all_numbers(hit).iter().all(|number| number.is_finite()), "{view:?}: {hit:?}");
                }
            }
        }
    }
    assert!(shown.iter().all(|&pixels| pixels > 1000), "{shown:?} pixels show something");
}

fn all_numbers(hit: &Hit) -> Vec<f64> {
    let vectors = [hit.rest_position, hit.rest_normal, hit.material_position];
    let numbers = [hit.distance, hit.emission_time, hit.proper_time, hit.turn, hit.doppler_factor];
    vectors.into_iter().flat_map(|vector| vector.to_array()).chain(numbers).collect()
}

/// Returns the distance from `place` at which the reference shows the body of `hit`, px, in steps; `None` if
/// it is not near.
fn outline_distance(scene: &PreparedScene, view: &View, [u, v]: [f64; 2], hit: Option<Hit>) -> Option<f64> {
    let body = hit.map(|hit| hit.body);
    [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.35].into_iter().find(|reach| {
        (0..24).any(|k| {
            let (sine, cosine) = (std::f64::consts::TAU * f64::from(k) / 24.0).sin_cos();
            let line = view.camera.line_of_sight([u + reach * cosine, v + reach * sine]);
            scene.first_hit(view, line).map(|hit| hit.body) == body
        })
    })
}

fn bounds_never_clip(renderers: &mut Renderers) {
    let mut unbounded = Renderers::brute_force(renderers.gpu().expect("a device").clone());
    let scene = scene();
    let motions = BETAS[1..].iter().flat_map(|&beta| GEOMETRIES.map(|geometry| (beta, geometry)));
    for (seed, (beta, geometry)) in (0..).zip(motions) {
        let cases = From::ALL.into_iter().flat_map(|from| PROJECTIONS.map(|projection| (from, projection)));
        for (from, projection) in sweep(seed, 8, cases) {
            let view =
                projected(view_of_wheel(from, beta, geometry, ASIDE[0]).with_size([96, 96]), projection);
            let [found, expected] = [&mut *renderers, &mut unbounded]
                .map(|renderers| renderers.hits(Method::Rays, &scene, &view).expect("device works"));
            let differing = found.hits.iter().zip(&expected.hits).filter(|(a, b)| a != b).count();
            assert_eq!(differing, 0, "{geometry:?} beta {beta} {from:?} {projection:?}");
        }
    }
}

/// Pixels show a body that the reference shows no farther off than the bound: all but 1 % of them in a view,
/// mostly in the wheel's plane, where f32 and triangles tell the order of crowded spokes.
fn the_mesh_keeps_its_bound(renderers: &mut Renderers) {
    let scene = scene();
    let geometries = [Geometry::Seen, Geometry::Contracted, Geometry::Rest, Geometry::OneCone];
    let motions = [0.5, 0.93, 0.99].into_iter().flat_map(|beta| geometries.map(|geometry| (beta, geometry)));
    for (seed, (beta, geometry)) in (0..).zip(motions) {
        let cases = From::ALL.into_iter().flat_map(|from| PROJECTIONS.map(|projection| (from, projection)));
        for (from, projection) in sweep(seed, 6, cases) {
            let view =
                projected(view_of_wheel(from, beta, geometry, ASIDE[0]), projection).with_size([140, 140]);
            let (truth, bound_px) = (scene.hit_image(&view), Method::MESH_ERROR_PX);
            let image = renderers.hits(Method::Mesh, &scene, &view).expect("device works");
            let bad = image.hits.iter().zip(&truth.hits).enumerate().filter(|(i, (hit, true_hit))| {
                let body = hit.map(|hit| hit.body);
                body != true_hit.map(|hit| hit.body)
                    && !bodies_around(&scene, &view, pixel(&image, *i), bound_px).any(|found| found == body)
            });
            let bad = bad.count();
            let shown = truth.hits.iter().flatten().count();
            if bad > 0 {
                println!(
                    "{geometry:?} beta {beta} {from:?} {projection:?}: {bad} of {shown} beyond {bound_px} px"
                );
            }
            assert!(
                bad as f64 <= (0.01 * shown as f64).max(1.0),
                "{geometry:?} beta {beta} {from:?} {projection:?}: {bad} of {shown} pixels are off by more than {bound_px} px"
            );
        }
    }
}

/// Returns the bodies that the reference shows up to `reach` from there, px.
fn bodies_around(
    scene: &PreparedScene,
    view: &View,
    [u, v]: [f64; 2],
    reach: f64,
) -> impl Iterator<Item = Option<usize>> {
    (1..=6).flat_map(move |ring| {
        (0..24).map(move |k| {
            let (sine, cosine) = (std::f64::consts::TAU * f64::from(k) / 24.0).sin_cos();
            let off = reach * f64::from(ring) / 6.0;
            let line = view.camera.line_of_sight([u + off * cosine, v + off * sine]);
            scene.first_hit(view, line).map(|hit| hit.body)
        })
    })
}

/// In every geometry, the published model and one light cone among them: the material point that a pixel
/// shows is seen no farther off than the bound, says the core.
fn the_mesh_shows_points_where_they_are_seen(renderers: &mut Renderers) {
    let scene = scene();
    let geometries =
        [Geometry::Seen, Geometry::Contracted, Geometry::Rest, Geometry::OneCone, Geometry::Published];
    let mut most = 0.0f64;
    let motions = BETAS[1..].iter().flat_map(|&beta| geometries.map(|geometry| (beta, geometry)));
    for (seed, (beta, geometry)) in (0..).zip(motions) {
        let cases = From::ALL.into_iter().flat_map(|from| PROJECTIONS.map(|projection| (from, projection)));
        let cases = cases.filter(|&(from, projection)| is_bounded(from, beta, geometry, projection));
        for (from, projection) in sweep(seed, 8, cases) {
            let view = projected(view_of_wheel(from, beta, geometry, ASIDE[0]), projection);
            let image = renderers.hits(Method::Mesh, &scene, &view).expect("device works");
            for (i, hit) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?))) {
                let point = MaterialPoint { rest: hit.material_position, spin: Some(SPIN) };
                let place = view.apparent_position(point).and_then(|place| view.camera.pixel(place));
                let [u, v] = place.expect("in front of the camera");
                let [x, y] = pixel(&image, i);
                let off = (u - x).hypot(v - y);
                let case = format!("{geometry:?} beta {beta} {from:?} {projection:?}");
                assert!(off <= Method::MESH_ERROR_PX, "{case}: {off} px off");
                most = most.max(off);
            }
        }
    }
    println!("at most {most} px");
}

/// Returns whether the bound is kept. In the wheel's plane the published model shows some points of a wheel
/// at such a distance from their neighbours, and the fastest wheel that recedes there is seen so near to
/// where it came from, that no division is fine enough (a ring that stands still there is not, either).
///
/// In a conformal picture, what is close to the line through the eyes, as spokes of a wheel around that are,
/// is bent there without a bound.
fn is_bounded(from: From, beta: f64, geometry: Geometry, projection: Projection) -> bool {
    if projection.is_conformal() && matches!(from, From::PlaneBefore | From::PlaneBehind) {
        return false;
    }
    match geometry {
        Geometry::Published => !from.is_in_plane() && beta < 0.999,
        _ => from != From::PlaneBehind || beta < 0.999,
    }
}

/// The pixel's centre.
fn pixel(image: &HitImage, i: usize) -> [f64; 2] {
    let width = image.size[0] as usize;
    [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5]
}
