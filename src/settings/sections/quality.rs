//! The section of quality: the renderer, and the trade of speed for accuracy.

use clap::Args;
use serde::Serialize;

use crate::flags::choices::RendererChoice;
use crate::flags::{Goal, OnOff, switch};

/// The choice of a renderer: the trade of speed for accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Quality")]
pub struct QualitySettings {
    /// Renderer of the views.
    #[arg(long, value_enum)]
    pub renderer: RendererChoice,
    /// Goal of the automatic renderer.
    #[command(flatten)]
    #[serde(flatten)]
    pub goal: Goal,
    /// Whether the views of the window get smoother while nothing changes: the reference draws them again,
    /// with more and more rays per pixel.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub refine: OnOff,
}

impl Default for QualitySettings {
    fn default() -> Self {
        Self { renderer: RendererChoice::Auto, goal: Goal::default(), refine: true }
    }
}
