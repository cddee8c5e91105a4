//! The section of quality: the renderer, and the trade of speed for accuracy.

use std::ops::RangeInclusive;

use clap::Args;
use relativity_render::Method;
use serde::Serialize;

use crate::flags::choices::RendererChoice;
use crate::flags::{Goal, OnOff, switch, within};

/// Finest and coarsest bound of the mesh renderer, pixels.
pub const BOUND_PX: RangeInclusive<f64> = 0.01..=100.0;

/// The choice of a renderer: the trade of speed for accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Quality")]
pub struct QualitySettings {
    /// Renderer of the views.
    #[arg(long, value_enum)]
    pub renderer: RendererChoice,
    /// Greatest distance, pixels, at which the mesh renderer, where it is chosen, may draw a point from where it is seen. Coarser is faster.
    #[arg(long, value_name = "PX", value_parser = within(BOUND_PX))]
    pub bound_px: f64,
    /// Goal of the automatic renderer.
    #[command(flatten)]
    #[serde(flatten)]
    pub goal: Goal,
    /// Whether the views of the window get smoother while nothing changes: the reference draws them again, with more and more rays per pixel.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub refine: OnOff,
}

impl Default for QualitySettings {
    fn default() -> Self {
        let bound_px = Method::DEFAULT_BOUND_PX;
        Self { renderer: RendererChoice::Auto, bound_px, goal: Goal::default(), refine: true }
    }
}
