//! Examination of the present views: the cost of each way to draw them, and its error, measured by a thread
//! of its own, one method after the other, while the Accuracy tab is shown and nothing moves.

use eframe::egui::{Context, TextureHandle, TextureOptions};
use relativity_render::{Appearance, Gpu, GpuError, Method, PreparedScene, Renderers, View};
use serde::{Deserialize, Serialize};

use crate::accuracy::{
    DifferenceFigures, Effort, ExpectedError, Spread, expected_error, method_name, total_error_px,
};
use crate::app::tools::debounce::Debounce;
use crate::app::tools::worker::{BackgroundWork, StepOutcome, Wanted, Work};
use crate::app::views::heat_map::HeatMap;
use crate::eye::Eye;

/// The present views, which are examined.
#[derive(Debug, Clone, PartialEq)]
pub struct ExaminedViews {
    /// Views of the eyes through their own light cones.
    pub views: Vec<(Eye, View)>,
    /// Appearance of their light.
    pub appearance: Appearance,
    /// Scene that is seen.
    pub scene: PreparedScene,
}

/// The cost of one method, and the error of its pictures: the worse of the eyes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// Milliseconds for the pictures of all eyes.
    pub frame_ms: f64,
    /// Displacement of outlines, pixels. `None` without outlines, and for the reference itself.
    pub outlines_px: Option<Spread>,
    /// Between where a point is drawn and where it is seen, arcseconds.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Relative error of the Doppler factor.
    pub doppler: Option<Spread>,
    /// Share of the covered pixels that show another body.
    pub wrong_share: f64,
    /// Total error, pixels: 99 % of the outlines that can be distinguished, and of the directions, are
    /// nearer.
    pub error_px: f64,
}

/// The error of each eye's picture, pixel by pixel.
type HeatMaps = Vec<(Eye, HeatMap)>;

/// The outcome of one method.
struct MethodOutcome {
    method: Method,
    /// Number of the sight in which the outcome was measured.
    sight: u64,
    figures: Result<Figures, String>,
    maps: HeatMaps,
}

/// The measuring of one method in the views of the eyes, one after the other.
pub struct MethodSteps {
    scene: PreparedScene,
    job: ExaminationJob,
    /// Errors in the views so far.
    found: Vec<ExpectedError>,
}

/// A job: the views, the appearance of their light, and the method to measure.
type ExaminationJob = (Vec<(Eye, View)>, Appearance, Method);

impl Work for MethodSteps {
    const NAME: &'static str = "accuracy";
    type Base = PreparedScene;
    type Job = ExaminationJob;
    type Result = (Result<Figures, String>, HeatMaps);
    type Tools = Renderers;

    fn begin(scene: PreparedScene, job: ExaminationJob) -> Self {
        Self { scene, job, found: Vec::new() }
    }

    fn step(&mut self, renderers: &mut Renderers, wanted: &Wanted) -> StepOutcome<Self::Result> {
        match self.next_view(renderers, &|| !wanted.holds()) {
            Ok(true) => StepOutcome::More,
            Ok(false) => StepOutcome::Last(wanted.holds().then(|| self.outcome())),
            Err(error) => StepOutcome::Last(Some((Err(error.to_string()), Vec::new()))),
        }
    }
}

impl MethodSteps {
    /// Measures the next view; whether there was one, and it was not cancelled.
    fn next_view(
        &mut self,
        renderers: &mut Renderers,
        is_cancelled: &dyn Fn() -> bool,
    ) -> Result<bool, GpuError> {
        let (views, appearance, method) = &self.job;
        let Some((_, view)) = views.get(self.found.len()) else { return Ok(false) };
        let effort = Effort::GLANCE;
        let error = expected_error(renderers, &self.scene, *method, view, appearance, effort, is_cancelled)?;
        Ok(error.map(|error| self.found.push(error)).is_some())
    }

    /// Returns the figures and the heat maps of the views that were measured.
    fn outcome(&self) -> (Result<Figures, String>, HeatMaps) {
        let (views, ..) = &self.job;
        let map = |((eye, view), error): (&(Eye, View), &ExpectedError)| {
            (*eye, HeatMap::new(&error.difference, view.camera.px_per_radian()))
        };
        let maps = views.iter().zip(&self.found).map(map).collect();
        let px_per_radian = views.iter().map(|(_, view)| view.camera.px_per_radian()).fold(0.0, f64::max);
        (Ok(Figures::from_errors(&self.found, px_per_radian)), maps)
    }
}

/// The figures of all methods, and what measures them.
pub struct Examination {
    /// Each job with its method, and the number of its sight.
    worker: BackgroundWork<MethodSteps, (Method, u64)>,
    has_gpu: bool,
    stillness: Debounce<ExaminedViews>,
    /// Sight that is examined; `None` while the tab is hidden.
    sight: Option<ExaminedViews>,
    /// Number of sights so far.
    number: u64,
    methods: Vec<Method>,
    /// Method that draws the views.
    pub chosen: Method,
    outcomes: Vec<MethodOutcome>,
    shown_maps: Option<ShownMaps>,
}

/// The heat maps that are on screen, and what they are of.
struct ShownMaps {
    method: Method,
    sight: u64,
    textures: Vec<(Eye, TextureHandle)>,
}

/// A method, and what is known about it.
#[derive(Debug, Clone, Copy)]
pub struct ExaminedMethod<'a> {
    /// Method of the row.
    pub method: Method,
    /// Figures, or the reason why there are none; `None` before the first.
    pub figures: Option<&'a Result<Figures, String>>,
    /// Whether they were measured in the present views.
    pub is_current: bool,
}

impl<'a> ExaminedMethod<'a> {
    /// Returns the figures, if they were measured in the present views.
    #[must_use]
    pub fn measured(&self) -> Option<&'a Figures> {
        self.figures.filter(|_| self.is_current)?.as_ref().ok()
    }

    /// Returns the name of the method.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        method_name(self.method)
    }
}

impl Examination {
    /// Nothing is known yet. Without a `gpu` only packets and the reference are measured.
    #[must_use]
    pub fn new(ctx: &Context, gpu: Option<Gpu>) -> Self {
        let has_gpu = gpu.is_some();
        Self {
            worker: BackgroundWork::new(ctx, Renderers::new(gpu)),
            has_gpu,
            stillness: Debounce::default(),
            sight: None,
            number: 0,
            methods: Vec::new(),
            chosen: Method::Reference,
            outcomes: Vec::new(),
            shown_maps: None,
        }
    }

    /// Examines `sight` by all methods, the `chosen` one first. What was begun for another sight is given up.
    pub fn update(&mut self, ctx: &Context, sight: &ExaminedViews, chosen: Method) {
        let chosen = sight.views.first().map_or(chosen, |(_, view)| chosen.of_view(view));
        self.methods = methods(self.has_gpu, chosen, sight);
        self.chosen = chosen;
        if self.sight.as_ref() != Some(sight) {
            self.worker.end();
            self.sight = Some(sight.clone());
            self.number += 1;
        }
        self.receive();
        if !self.stillness.is_still(ctx, sight) || self.worker.is_pending() {
            return;
        }
        let first = Some(chosen).filter(|chosen| self.methods.contains(chosen));
        let next = first.into_iter().chain(self.methods.iter().copied());
        if let Some(method) = next.into_iter().find(|&method| self.is_wanted(method)) {
            let ExaminedViews { views, appearance, scene } = sight.clone();
            self.worker.request((method, self.number), scene, (views, appearance, method));
        }
    }

    fn receive(&mut self) {
        let methods = &self.methods;
        self.outcomes.retain(|outcome| methods.contains(&outcome.method));
        let Some(((method, sight), (figures, maps))) = self.worker.result() else { return };
        let new = MethodOutcome { method, sight, figures, maps };
        if new.sight != self.number {
            return;
        }
        self.outcomes.retain(|outcome| outcome.method != new.method);
        self.outcomes.push(new);
    }

    fn outcome(&self, method: Method) -> Option<&MethodOutcome> {
        self.outcomes.iter().find(|outcome| outcome.method == method)
    }

    /// Whether `method` has yet to be measured in the present sight.
    fn is_wanted(&self, method: Method) -> bool {
        let is_seen = self.sight.as_ref().is_some_and(|sight| !sight.views.is_empty());
        is_seen && self.outcome(method).is_none_or(|outcome| outcome.sight != self.number)
    }

    /// Returns the pixels of a picture per radian; `None` while the tab is hidden.
    #[must_use]
    pub fn px_per_radian(&self) -> Option<f64> {
        let views = &self.sight.as_ref()?.views;
        views.iter().map(|(_, view)| view.camera.px_per_radian()).reduce(f64::max)
    }

    /// Gives up what is being measured, as nobody looks.
    pub fn rest(&mut self) {
        if self.sight.take().is_some() {
            self.worker.end();
        }
    }

    /// Whether there is more to measure.
    #[must_use]
    pub fn is_pending(&self) -> bool {
        self.methods.iter().any(|&method| self.is_wanted(method))
    }

    /// Whether there is nothing to see, and so nothing to measure.
    #[must_use]
    pub fn is_blind(&self) -> bool {
        self.sight.as_ref().is_none_or(|sight| sight.views.is_empty())
    }

    /// Returns the rows of all methods: rays, packets, the mesh where it draws the views, reference.
    pub fn rows(&self) -> impl Iterator<Item = ExaminedMethod<'_>> {
        self.methods.iter().map(|&method| {
            let outcome = self.outcome(method);
            let is_current = outcome.is_some_and(|outcome| outcome.sight == self.number);
            ExaminedMethod { method, figures: outcome.map(|outcome| &outcome.figures), is_current }
        })
    }

    /// The method that costs less than that of `row` and is no further off, or costs no more and is nearer;
    /// `None` of what is worth its time, and before that is known.
    #[must_use]
    pub fn better_than(&self, row: &ExaminedMethod<'_>) -> Option<Method> {
        let own = row.measured()?;
        let is_better = |other: &Figures| {
            other.frame_ms <= own.frame_ms
                && other.error_px <= own.error_px
                && (other.frame_ms < own.frame_ms || other.error_px < own.error_px)
        };
        self.rows().find_map(|other| is_better(other.measured()?).then_some(other.method))
    }

    /// Returns the error of the picture of `eye` by `method`, pixel by pixel, once it is known and while the
    /// tab is shown.
    pub fn heat_map(&mut self, ctx: &Context, eye: Eye, method: Method) -> Option<&TextureHandle> {
        self.sight.as_ref()?;
        let sight = self.number;
        if !self.shown_maps.as_ref().is_some_and(|maps| (maps.method, maps.sight) == (method, sight)) {
            let outcome = self.outcome(method).filter(|outcome| outcome.sight == sight)?;
            let texture = |(eye, map): &(Eye, HeatMap)| {
                (*eye, ctx.load_texture("heat map", map.image(), TextureOptions::NEAREST))
            };
            let textures = outcome.maps.iter().map(texture).collect();
            self.shown_maps = Some(ShownMaps { method, sight, textures });
        }
        let maps = self.shown_maps.as_ref()?;
        maps.textures.iter().find_map(|(of, texture)| (*of == eye).then_some(texture))
    }
}

/// Returns the methods that can be measured, without those that another one replaces.
fn methods(has_gpu: bool, chosen: Method, sight: &ExaminedViews) -> Vec<Method> {
    if !has_gpu {
        return vec![Method::Packets, Method::Reference];
    }
    let draws = |method: &Method| {
        let is_known = |(_, view): &(Eye, View)| method.of_view(view) == *method;
        sight.views.iter().all(is_known)
    };
    [Method::Rays, Method::Packets]
        .into_iter()
        .chain(Some(chosen).filter(|method| *method == Method::Mesh))
        .chain([Method::Reference])
        .filter(draws)
        .collect()
}

impl Figures {
    /// Returns the figures for the errors found in the eyes' views, in which a radian is this many pixels.
    fn from_errors(found: &[ExpectedError], px_per_radian: f64) -> Self {
        let worse = |spread: fn(&ExpectedError) -> Option<Spread>| {
            found.iter().filter_map(spread).reduce(Spread::worse)
        };
        let sum = |count: fn(&DifferenceFigures) -> usize| -> usize {
            found.iter().map(|error| count(&error.difference.figures)).sum()
        };
        let covered = sum(|figures| figures.covered_pixels).max(1);
        let outlines_px = worse(|error| error.outlines_px);
        let line_of_sight_arcseconds = worse(|error| error.difference.figures.line_of_sight_arcseconds);
        let [outlines, directions] =
            [outlines_px, line_of_sight_arcseconds].map(|spread| spread.map(|spread| spread.p99));
        Self {
            error_px: total_error_px(outlines, directions, px_per_radian),
            frame_ms: found.iter().map(|error| error.frame_ms).sum(),
            outlines_px,
            line_of_sight_arcseconds,
            doppler: worse(|error| error.difference.figures.doppler_relative),
            wrong_share: sum(|figures| figures.wrong_pixels) as f64 / covered as f64,
        }
    }
}
