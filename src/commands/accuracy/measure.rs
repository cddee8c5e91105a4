//! The measurement itself: every method in every view.

use anyhow::Context as _;
use gamow_platform::{progress, threads};
use relativity_core::Speed;
use relativity_render::{Appearance, Gpu, Method, PreparedScene, Renderers, View};

use super::report::{
    AccuracyReport, Circumstances, FormulaReport, FormulaRow, MeasuredSetup, PictureErrors, PictureRow,
    PublishedReport, PublishedRow, RendererReport, TIMED, median,
};
use super::{advice, effects};
use crate::accuracy::{
    ConeFormula, Effort, ExpectedError, LARGEST_PX, RESOLUTION_PX, Spread, TrackedPlace, expected_error,
    formula_error, methods, published_error, view_at,
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
/// Only for formulas in f64.
const EXTREME_GAMMAS: [f64; 2] = [1e5, 1e7];
const QUICK_EFFORT: Effort = Effort { outline_places: 12, rounds: 1 };

/// Measures everything for `scene`, called `scene_name`.
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
    let mut measurement = Measurement {
        renderers: Renderers::new(gpu),
        scene: scene.prepared(),
        appearance: Appearance { ground_z: scene.ground_z, ..Appearance::default() },
        views: views(scene, size, quick)?,
        tracked: scene.tracked,
        effort: if quick { QUICK_EFFORT } else { Effort::REPORT },
    };
    let setting = MeasuredSetup {
        program: SOFTWARE,
        optimised: !cfg!(debug_assertions),
        threads: threads::count(),
        device: measurement.renderers.gpu().map(Gpu::description),
        scene: scene_name.to_owned(),
        bodies: scene.bodies.len(),
        size_px: size,
        fov_degrees: FOV_DEGREES,
        separation: SEPARATION,
        outline_resolution_px: RESOLUTION_PX,
        outline_limit_px: LARGEST_PX,
    };
    let mut report = AccuracyReport {
        setting,
        timed: TIMED,
        missing,
        renderers: measurement.pictures()?,
        formulas: measurement.formulas()?,
        published: measurement.published()?,
        effects: measurement.effects()?,
        advice: Vec::new(),
    };
    report.advice = advice::advice(&report);
    Ok(report)
}

/// Measures the views, and reports each.
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

struct Measurement {
    renderers: Renderers,
    scene: PreparedScene,
    appearance: Appearance,
    views: Vec<(Circumstances, View)>,
    tracked: [f64; 3],
    effort: Effort,
}

impl Measurement {
    fn pictures(&mut self) -> anyhow::Result<Vec<RendererReport>> {
        let methods = methods(&self.renderers);
        let progress = progress::bar((methods.len() * self.views.len()) as u64, "views");
        let mut reports = Vec::new();
        for method in methods {
            let mut rows = Vec::new();
            for (circumstances, view) in &self.views {
                let (renderers, appearance, effort) = (&mut self.renderers, &self.appearance, self.effort);
                let found =
                    expected_error(renderers, &self.scene, method, view, appearance, effort, &|| false)?;
                let found = found.context("nothing cancels this")?;
                rows.push(picture_row(*circumstances, found));
                progress.inc(1);
            }
            reports.push(renderer_report(method, rows));
        }
        progress.finish_and_clear();
        Ok(reports)
    }

    fn formulas(&self) -> anyhow::Result<Vec<FormulaReport>> {
        ConeFormula::ALL.into_iter().map(|formula| self.formula(formula)).collect()
    }

    fn formula(&self, formula: ConeFormula) -> anyhow::Result<FormulaReport> {
        let default = self.views.iter().map(|(circumstances, view)| (*circumstances, view.speed));
        let mut cases: Vec<_> = default.collect();
        for gamma in EXTREME_GAMMAS {
            let speed = Speed::from_gamma(gamma)?;
            cases.extend(TrackedPlace::ALL.map(|place| (circumstances(&speed, place), speed)));
        }
        cases.retain(|(_, speed)| speed.gamma() <= formula.max_gamma());
        let row = |(view, speed): (Circumstances, Speed)| {
            let error = formula_error(formula, &speed, view.place, self.tracked, -0.5 * SEPARATION)?;
            Ok(FormulaRow {
                view,
                point_ns: error.point_ns,
                line_of_sight_arcseconds: error.line_of_sight_arcseconds,
                doppler_relative: error.doppler_relative,
            })
        };
        let views = cases.into_iter().map(row).collect::<anyhow::Result<Vec<_>>>()?;
        Ok(FormulaReport {
            formula: formula.to_string(),
            is_reference: formula == ConeFormula::StableF64,
            point_ns: median(views.iter().map(|row| row.point_ns)),
            line_of_sight_arcseconds: worst(views.iter().map(|row| row.line_of_sight_arcseconds)),
            doppler_relative: worst(views.iter().map(|row| row.doppler_relative)),
            views,
        })
    }

    fn published(&self) -> anyhow::Result<PublishedReport> {
        let error = |(_, view): &(Circumstances, View)| published_error(&self.scene, view, SEPARATION);
        let errors = self.views.iter().map(error).collect::<Result<Vec<_>, _>>()?;
        let row =
            |((view, _), error): (&(Circumstances, View), &crate::accuracy::PublishedError)| PublishedRow {
                view: *view,
                line_of_sight_arcseconds: error.line_of_sight_arcseconds,
                pixels: error.pixels,
            };
        Ok(PublishedReport {
            published_ns: median(errors.iter().map(|error| error.published_ns)),
            exact_ns: median(errors.iter().map(|error| error.exact_ns)),
            views: self.views.iter().zip(&errors).map(row).collect(),
        })
    }

    /// Abreast at the paper's speed.
    fn effects(&mut self) -> anyhow::Result<super::report::EffectsReport> {
        let is_paper =
            |(view, _): &&(Circumstances, View)| view.beta == 0.9 && view.place == TrackedPlace::Abreast;
        let (circumstances, view) = *self.views.iter().find(is_paper).context("0.9 is always measured")?;
        let (renderers, rounds) = (&mut self.renderers, self.effort.rounds);
        effects::report(renderers, &self.scene, circumstances, &view, &self.appearance, rounds)
    }
}

fn picture_row(view: Circumstances, found: ExpectedError) -> PictureRow {
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
        rounds: found.rounds,
    }
}

/// The worst of some spreads, figure by figure.
fn worst(spreads: impl Iterator<Item = Option<Spread>>) -> Option<Spread> {
    spreads.flatten().reduce(Spread::worse)
}

fn renderer_report(method: Method, views: Vec<PictureRow>) -> RendererReport {
    let spread = |of: fn(&PictureErrors) -> Option<_>| worst(views.iter().map(|row| of(&row.errors)));
    let largest = |of: fn(&PictureErrors) -> f64| views.iter().map(|row| of(&row.errors)).fold(0.0, f64::max);
    let off_outlines = views.iter().map(|row| row.errors.wrong_pixels_off_outlines).max();
    RendererReport {
        method: method.to_string(),
        is_reference: method == Method::Reference,
        frame_ms: median(views.iter().map(|row| row.frame_ms)),
        worst_view: PictureErrors {
            outlines_px: spread(|errors| errors.outlines_px),
            line_of_sight_arcseconds: spread(|errors| errors.line_of_sight_arcseconds),
            doppler_relative: spread(|errors| errors.doppler_relative),
            wrong_share: largest(|errors| errors.wrong_share),
            wrong_pixels_off_outlines: off_outlines.unwrap_or(0),
        },
        views,
    }
}
