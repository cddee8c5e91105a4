//! What `gamow accuracy` has measured, as `--json` writes it.

use serde::Serialize;

use crate::accuracy::{Place, RoundsError, Spread};

/// The members, at whatever depth, that rest on the clock, and differ from run to run: times, ratios of times, and what is said
/// of them. All others are the same in every run on the same device.
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

/// All of it.
#[derive(Debug, Clone, Serialize)]
pub struct AccuracyReport {
    /// Under which circumstances.
    pub setting: Setting,
    /// The names of the members that differ from run to run.
    pub timed: [&'static str; TIMED.len()],
    /// What this machine could not measure, and why.
    pub missing: Vec<String>,
    /// Pictures: one entry per renderer, the reference first.
    pub renderers: Vec<RendererReport>,
    /// Single points: one entry per form and precision.
    pub formulas: Vec<FormulaReport>,
    /// The published binocular model against the exact one.
    pub published: PublishedReport,
    /// What each effect costs.
    pub effects: EffectsReport,
    /// What follows from these figures, a sentence each.
    pub advice: Vec<String>,
}

/// Circumstances of the measurement.
#[derive(Debug, Clone, Serialize)]
pub struct Setting {
    /// Program and version.
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
    /// Speed.
    pub beta: f64,
    /// The same as Lorentz factor.
    pub gamma: f64,
    /// Where the tracked point is seen.
    pub place: Place,
}

/// One renderer.
#[derive(Debug, Clone, Serialize)]
pub struct RendererReport {
    /// Its name.
    pub method: String,
    /// Whether it is what the others are held against; then its errors are 0 by definition.
    pub is_reference: bool,
    /// How far it promises to draw any point from where it is seen, pixels, if it does.
    pub bound_px: Option<f64>,
    /// Median over the views of the milliseconds per picture of one eye.
    pub frame_ms: f64,
    /// Of each figure the largest of all views.
    pub worst_view: PictureErrors,
    /// View by view.
    pub views: Vec<PictureRow>,
}

impl RendererReport {
    /// Whether it is a ray test in f32: it is neither the reference nor made of triangles.
    #[must_use]
    pub const fn is_rays(&self) -> bool {
        !self.is_reference && self.bound_px.is_none()
    }
}

/// A renderer in one view.
#[derive(Debug, Clone, Serialize)]
pub struct PictureRow {
    /// Which view.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Milliseconds per picture of one eye.
    pub frame_ms: f64,
    /// How far from the truth.
    #[serde(flatten)]
    pub errors: PictureErrors,
    /// With the reference: what rounds come to where bodies turn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rounds: Option<RoundsError>,
}

/// Errors of a picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PictureErrors {
    /// Displacement of outlines.
    #[serde(rename = "silhouettes_px")]
    pub outlines_px: Option<Spread>,
    /// Lines of sight.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Doppler factor.
    pub doppler_relative: Option<Spread>,
    /// Wrong pixels per covered pixel.
    pub wrong_share: f64,
    /// Wrong pixels away from any outline.
    pub wrong_pixels_off_outlines: usize,
}

/// One form of the formulas for a point.
#[derive(Debug, Clone, Serialize)]
pub struct FormulaReport {
    /// Form and precision.
    pub formula: String,
    /// Whether it is what the others are held against.
    pub is_reference: bool,
    /// Median over the views of the nanoseconds per point, one thread.
    pub point_ns: f64,
    /// Largest of all views.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Largest of all views.
    pub doppler_relative: Option<Spread>,
    /// View by view.
    pub views: Vec<FormulaRow>,
}

/// A formula in one view.
#[derive(Debug, Clone, Serialize)]
pub struct FormulaRow {
    /// Which view.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Nanoseconds per point.
    pub point_ns: f64,
    /// Angle between the lines of sight.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Doppler factor.
    pub doppler_relative: Option<Spread>,
}

/// The published binocular model.
#[derive(Debug, Clone, Serialize)]
pub struct PublishedReport {
    /// Median over the views of the nanoseconds per point.
    pub published_ns: f64,
    /// The same of the exact model.
    pub exact_ns: f64,
    /// View by view: the right eye's line of sight.
    pub views: Vec<PublishedRow>,
}

/// The published model in one view.
#[derive(Debug, Clone, Serialize)]
pub struct PublishedRow {
    /// Which view.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Angle between the lines of sight.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// The same in the picture.
    pub pixels: Option<Spread>,
}

/// What effects cost.
#[derive(Debug, Clone, Serialize)]
pub struct EffectsReport {
    /// Which renderer.
    pub method: String,
    /// Which view.
    #[serde(flatten)]
    pub view: Circumstances,
    /// Milliseconds per picture of one eye with everything on.
    pub all_on_ms: f64,
    /// By how much the same picture differed when it was timed again, relatively: less is noise.
    pub repeatability: f64,
    /// One entry per effect, and one with all off.
    pub without: Vec<EffectRow>,
}

/// A picture with an effect left out.
#[derive(Debug, Clone, Serialize)]
pub struct EffectRow {
    /// What is left out.
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
    Spread::of(numbers.collect()).map_or(0.0, |spread| spread.median)
}
