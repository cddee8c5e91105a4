//! The measurement itself: every method in every view.

use anyhow::Context as _;
use gamow_platform::{progress, threads};
use relativity_core::Speed;
use relativity_render::{Appearance, Gpu, Method, Renderers, View};

use super::report::{
    AccuracyReport, Circumstances, MeasuredSetup, PictureErrors, PictureRow, RendererReport, TIMED,
};
use crate::accuracy::{
    Effort, ExpectedError, LARGEST_PX, RESOLUTION_PX, Spread, TrackedPlace, expected_error, methods, view_at,
};
use crate::files::provenance::SOFTWARE;
use crate::scene::Scene;

/// Separation of the apertures: the paper's for its cyclist.
const SEPARATION: f64 = 0.1;
/// Field of view of `gamow render`.
const FOV_DEGREES: f64 = 60.0;
const BETAS: [f64; 7] = [0.0, 0.3, 0.6, 0.9, 0.99, 0.999, 0.9999];
const QUICK_BETAS: [f64; 3] = [0.0, 0.9, 0.9999];
/// Lorentz factors that beta does not express well.
const GAMMAS: [f64; 2] = [100.0, 1000.0];
const QUICK_EFFORT: Effort = Effort { outline_places: 12, rounds: 1 };

/// Measures rays, packets and the reference in every view of `scene`, called `scene_name`.
///
/// # Errors
///
/// A device that was lost; a scene outside the domain of the core.
pub fn report(
    scene: &Scene,
    scene_name: &str,
    size: [u32; 2],
    quick: bool,
) -> anyhow::Result<AccuracyReport> {
    let mut missing = Vec::new();
    let gpu = Gpu::headless().map_err(|error| missing.push(format!("rays: {error}"))).ok();
    let mut renderers = Renderers::new(gpu);
    let setting = MeasuredSetup {
        program: SOFTWARE,
        optimised: !cfg!(debug_assertions),
        threads: threads::count(),
        device: renderers.gpu().map(Gpu::description),
        scene: scene_name.to_owned(),
        bodies: scene.bodies.len(),
        size_px: size,
        fov_degrees: FOV_DEGREES,
        separation: SEPARATION,
        outline_resolution_px: RESOLUTION_PX,
        outline_limit_px: LARGEST_PX,
    };
    let effort = if quick { QUICK_EFFORT } else { Effort::REPORT };
    let renderers = pictures(&mut renderers, scene, &views(scene, size, quick)?, effort)?;
    Ok(AccuracyReport { setting, timed: TIMED, missing, renderers })
}

/// Returns the views that are measured, each with its circumstances.
pub(super) fn views(
    scene: &Scene,
    size: [u32; 2],
    quick: bool,
) -> anyhow::Result<Vec<(Circumstances, View)>> {
    let betas: &[f64] = if quick { &QUICK_BETAS } else { &BETAS };
    let gammas: &[f64] = if quick { &[] } else { &GAMMAS };
    let speeds = betas.iter().map(|&beta| Speed::from_beta(beta));
    let mut views = Vec::new();
    for speed in speeds.chain(gammas.iter().map(|&gamma| Speed::from_gamma(gamma))) {
        let speed = speed?;
        for &place in places(&speed) {
            let view = view_at(place, speed, scene.tracked, SEPARATION, FOV_DEGREES.to_radians(), size)?;
            views.push((circumstances(&speed, place), view));
        }
    }
    Ok(views)
}

/// At rest there is nothing to wait for.
fn places(speed: &Speed) -> &'static [TrackedPlace] {
    if speed.beta() == 0.0 { &[TrackedPlace::Abreast] } else { &TrackedPlace::ALL }
}

fn circumstances(speed: &Speed, place: TrackedPlace) -> Circumstances {
    Circumstances { beta: speed.beta(), gamma: speed.gamma(), place }
}

/// Measures each of the `renderers` in these views of `scene`.
fn pictures(
    renderers: &mut Renderers,
    scene: &Scene,
    views: &[(Circumstances, View)],
    effort: Effort,
) -> anyhow::Result<Vec<RendererReport>> {
    let prepared = scene.prepared();
    let appearance = Appearance { ground_z: scene.ground_z, ..Appearance::default() };
    let methods = methods(renderers);
    let progress = progress::bar((methods.len() * views.len()) as u64, "views");
    let mut reports = Vec::new();
    for method in methods {
        let mut rows = Vec::new();
        for (circumstances, view) in views {
            let found = expected_error(renderers, &prepared, method, view, &appearance, effort, &|| false)?;
            rows.push(picture_row(*circumstances, &found.context("nothing cancels this")?));
            progress.inc(1);
        }
        reports.push(renderer_report(method, rows));
    }
    progress.finish_and_clear();
    Ok(reports)
}

fn picture_row(view: Circumstances, found: &ExpectedError) -> PictureRow {
    let figures = &found.difference.figures;
    PictureRow {
        view,
        frame_ms: found.frame_ms,
        errors: PictureErrors {
            outlines_px: found.outlines_px,
            line_of_sight_arcseconds: figures.line_of_sight_arcseconds,
            doppler_relative: figures.doppler_relative,
            wrong_share: figures.wrong_share(),
            wrong_pixels_off_outlines: figures.wrong_pixels_off_outlines,
        },
    }
}

fn renderer_report(method: Method, views: Vec<PictureRow>) -> RendererReport {
    let errors = || views.iter().map(|row| &row.errors);
    let spread = |of: fn(&PictureErrors) -> Option<Spread>| errors().filter_map(of).reduce(Spread::worse);
    let costs = Spread::from_errors(views.iter().map(|row| row.frame_ms).collect());
    let off_outlines = errors().map(|errors| errors.wrong_pixels_off_outlines).max();
    RendererReport {
        method: method.to_string(),
        is_reference: method == Method::Reference,
        frame_ms: costs.map_or(0.0, |spread| spread.median),
        worst_view: PictureErrors {
            outlines_px: spread(|errors| errors.outlines_px),
            line_of_sight_arcseconds: spread(|errors| errors.line_of_sight_arcseconds),
            doppler_relative: spread(|errors| errors.doppler_relative),
            wrong_share: errors().map(|errors| errors.wrong_share).fold(0.0, f64::max),
            wrong_pixels_off_outlines: off_outlines.unwrap_or(0),
        },
        views,
    }
}
