//! The report of `gamow accuracy`, as `--json` writes it.

use serde::Serialize;

use crate::accuracy::{RoundsError, Spread, TrackedPlace};

/// Members, at whatever depth, that depend on the clock, and differ from run to run: times, ratios of times, and remarks
/// on them. All others are the same in every run on the same device.
pub const TIMED: [&str; 9] = [
    "frame_ms",
    "point_ns",
    "ray_ns",
    "exact_ns",
    "published_ns",
    "all_on_ms",
    "repeatability",
    "ratio",
    "advice",
];

/// The whole report.
#[derive(Debug, Clone, Serialize)]
pub struct AccuracyReport {
    /// Circumstances of the measurements.
    pub setting: MeasuredSetup,
    /// The names of the members that differ from run to run.
    pub timed: [&'static str; TIMED.len()],
    /// Measurements that this machine could not make, with the reasons.
    pub missing: Vec<String>,
    /// Pictures: one entry per renderer, the reference first.
    pub renderers: Vec<RendererReport>,
    /// Single points: one entry per form and precision.
    pub formulas: Vec<FormulaReport>,
    /// The published binocular model against the exact one.
    pub published: PublishedReport,
    /// Costs of effects.
    pub effects: EffectsReport,
    /// Conclusions from these figures, a sentence each.
    pub advice: Vec<String>,
}

/// Circumstances of the measurement.
#[derive(Debug, Clone, Serialize)]
pub struct MeasuredSetup {
    /// Name and version of the program.
    pub program: &'static str,
    /// Whether the program itself was compiled with optimisation; costs mean little without.
    pub optimised: bool,
    /// Threads of the reference renderer.
    pub threads: usize,
    /// Graphics device, if there is one.
    pub device: Option<String>,
    /// Name or path of the scene.
    pub scene: String,
    /// Number of its bodies.
    #[serde(rename = "objects")]
    pub bodies: usize,
    /// Width and height of one eye's picture, pixels.
    pub size_px: [u32; 2],
    /// Horizontal field of view, degrees.
    pub fov_degrees: f64,
    /// Distance of the apertures; pictures are the left one's.
    pub separation: f64,
    /// Displacements of outlines up to this, pixels, are reported as 0.
    #[serde(rename = "silhouette_resolution_px")]
    pub outline_resolution_px: f64,
    /// Displacements of outlines from this on, pixels, are reported as this.
    #[serde(rename = "silhouette_limit_px")]
    pub outline_limit_px: f64,
}

/// The view of a row.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Circumstances {
    /// Speed beta.
    pub beta: f64,
    /// Speed as Lorentz factor.
    pub gamma: f64,
    /// Place where the tracked point is seen.
    pub place: TrackedPlace,
}

/// The report on one renderer.
#[derive(Debug, Clone, Serialize)]
pub struct RendererReport {
    /// Name of the renderer.
    pub method: String,
    /// Whether this is the renderer that the others are compared with; then its errors are 0 by definition.
    pub is_reference: bool,
    /// Median over the views of the milliseconds per picture of one eye.
    pub frame_ms: f64,
    /// Largest of each figure in all views.
    pub worst_view: PictureErrors,
    /// Figures of each view.
    pub views: Vec<PictureRow>,
}

impl RendererReport {
    /// Whether the renderer tests rays in f32: it is not the reference.
    #[must_use]
    pub const fn is_rays(&self) -> bool {
        !self.is_reference
    }
}

/// A renderer in one view.
#[derive(Debug, Clone, Serialize)]
pub struct PictureRow {
    /// View that was measured.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Milliseconds per picture of one eye.
    pub frame_ms: f64,
    /// Errors against the truth.
    #[serde(flatten)]
    pub errors: PictureErrors,
    /// With the reference: what rounds come to where bodies turn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rounds: Option<RoundsError>,
}

/// Errors of a picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PictureErrors {
    /// Displacement of outlines, pixels.
    #[serde(rename = "silhouettes_px")]
    pub outlines_px: Option<Spread>,
    /// Error of lines of sight, arcseconds.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Relative error of the Doppler factor.
    pub doppler_relative: Option<Spread>,
    /// Wrong pixels per covered pixel.
    pub wrong_share: f64,
    /// Wrong pixels away from any outline.
    pub wrong_pixels_off_outlines: usize,
}

/// The report on one form of the formulas for a point.
#[derive(Debug, Clone, Serialize)]
pub struct FormulaReport {
    /// Name of the form, with its precision.
    pub formula: String,
    /// Whether this is the form that the others are compared with.
    pub is_reference: bool,
    /// Median over the views of the nanoseconds per point, one thread.
    pub point_ns: f64,
    /// Largest of all views.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Largest of all views.
    pub doppler_relative: Option<Spread>,
    /// Figures of each view.
    pub views: Vec<FormulaRow>,
}

/// A formula in one view.
#[derive(Debug, Clone, Serialize)]
pub struct FormulaRow {
    /// View that was measured.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Time per point, nanoseconds.
    pub point_ns: f64,
    /// Angle between the lines of sight.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Relative error of the Doppler factor.
    pub doppler_relative: Option<Spread>,
}

/// The published binocular model.
#[derive(Debug, Clone, Serialize)]
pub struct PublishedReport {
    /// Median over the views of the nanoseconds per point.
    pub published_ns: f64,
    /// Median of the nanoseconds per point of the exact model.
    pub exact_ns: f64,
    /// View by view: the right eye's line of sight.
    pub views: Vec<PublishedRow>,
}

/// The published model in one view.
#[derive(Debug, Clone, Serialize)]
pub struct PublishedRow {
    /// View that was measured.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Angle between the lines of sight.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Distance of the two places in the picture, pixels.
    pub pixels: Option<Spread>,
}

/// The costs of effects.
#[derive(Debug, Clone, Serialize)]
pub struct EffectsReport {
    /// Renderer that was measured.
    pub method: String,
    /// View that was measured.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Milliseconds per picture of one eye with everything on.
    pub all_on_ms: f64,
    /// Relative difference of the cost when the same picture was timed again: smaller differences are noise.
    pub repeatability: f64,
    /// Entries for each effect that is left out, and one for all.
    pub without: Vec<EffectRow>,
}

/// A picture with an effect left out.
#[derive(Debug, Clone, Serialize)]
pub struct EffectRow {
    /// Effect that is left out.
    pub effect: &'static str,
    /// Whether the picture still shows the bodies in the same places.
    pub same_geometry: bool,
    /// Milliseconds per picture of one eye.
    pub frame_ms: f64,
    /// Over that with everything on.
    pub ratio: f64,
}

/// The median of some numbers, 0 of none.
#[must_use]
pub fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    Spread::from_errors(numbers.collect()).map_or(0.0, |spread| spread.median)
}
