//! The error of the published binocular model: the distance of its right eye's view from the exact one.

use std::hint::black_box;

use gamow_platform::clock::Instant;
use glam::{DVec2, DVec3};
use relativity_core::{Aperture, Disparity, Model, PairError, PublishedVariant, SourcePoint};
use relativity_render::{Hit, Motion, PreparedScene, View};

use super::difference::{ARCSECONDS, angle};
use super::spread::Spread;

/// Greatest number of points that are compared.
const POINTS: usize = 2000;

/// The published model's error in one view, and both models' costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PublishedError {
    /// Nanoseconds per point of the published model.
    pub published_ns: f64,
    /// Nanoseconds per point of the exact model.
    pub exact_ns: f64,
    /// Angle between the lines of sight of the right eye, arcseconds.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Distance of the two places in the right eye's picture, pixels.
    pub pixels: Option<Spread>,
}

/// Compares the models (Appendix A's for the published one) at points that the left eye sees in `left`, a view
/// from the paper's pair of apertures `separation` apart.
///
/// # Errors
///
/// Points outside the domain of the core.
pub fn published_error(
    scene: &PreparedScene,
    left: &View,
    separation: f64,
) -> Result<PublishedError, PairError> {
    let points = visible_points(scene, left);
    let of = |model: Model| {
        timed(&points, |&point| {
            model.disparity(&left.speed, point, Aperture::pair(separation), left.observation_time)
        })
    };
    let (exact, exact_ns) = of(Model::Exact)?;
    let (published, published_ns) = of(Model::Published(PublishedVariant::AppendixA))?;
    let sights = |both: &[Disparity]| -> Vec<DVec3> {
        both.iter().map(|disparity| disparity.secondary.position.into()).collect()
    };
    let pairs: Vec<_> = sights(&exact).into_iter().zip(sights(&published)).collect();
    let pixel = |direction| left.camera.pixel(direction).map(DVec2::from);
    let pixels = |&(exact, published): &(DVec3, DVec3)| Some((pixel(exact)? - pixel(published)?).length());
    Ok(PublishedError {
        published_ns,
        exact_ns,
        line_of_sight_arcseconds: Spread::from_errors(
            pairs.iter().map(|&(a, b)| ARCSECONDS * angle(a, b)).collect(),
        ),
        pixels: Spread::from_errors(pairs.iter().filter_map(pixels).collect()),
    })
}

/// The worldlines of points on what `view` shows of the bodies that move at the scene's speed, evenly chosen from its
/// pixels.
fn visible_points(scene: &PreparedScene, view: &View) -> Vec<SourcePoint> {
    let image = scene.hit_image(view);
    let moves = |hit: &&Hit| scene.motion_of(hit.body) == Motion::Scene;
    let hits: Vec<_> = image.hits.iter().flatten().filter(moves).collect();
    let stride = hits.len().div_ceil(POINTS).max(1);
    let point = |place: DVec3| SourcePoint::from_rest(place.to_array(), &view.speed);
    hits.iter().step_by(stride).map(|hit| point(hit.rest_position)).collect()
}

/// The model's disparities, and nanoseconds per point.
fn timed(
    points: &[SourcePoint],
    model: impl Fn(&SourcePoint) -> Result<Disparity, PairError>,
) -> Result<(Vec<Disparity>, f64), PairError> {
    let mut fastest = f64::INFINITY;
    let mut disparities = Vec::new();
    for _ in 0..3 {
        let start = Instant::now();
        disparities = black_box(points.iter().map(&model).collect::<Result<_, _>>()?);
        fastest = fastest.min(start.elapsed().as_secs_f64() * 1e9 / points.len().max(1) as f64);
    }
    Ok((disparities, fastest))
}
