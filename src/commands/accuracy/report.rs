//! The report of `gamow accuracy`, as `--json` writes it.

use serde::Serialize;

use crate::accuracy::{Spread, TrackedPlace};

/// Members, at whatever depth, that depend on the clock, and differ from run to run. All others are the same
/// in every run on the same device.
pub const TIMED: [&str; 1] = ["frame_ms"];

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
