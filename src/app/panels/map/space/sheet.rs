//! A sheet: one of the two charts, and the colours on both.

use eframe::egui::{Color32, Rect, Visuals};

use crate::app::panels::map::canvas;
use crate::app::theme;
use crate::eye::Eye;
use crate::map::{Chart, Picture, Projection};

/// A chart of the face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sheet {
    /// Projection of the chart.
    pub projection: Projection,
    /// Chart that places things.
    pub chart: Chart,
}

impl Sheet {
    /// Returns the name of the chart for assistive technology.
    pub const fn name(&self) -> &'static str {
        match self.projection {
            Projection::Plan => "Map, from above",
            Projection::Side => "Map, from the side",
        }
    }

    /// The room the sheet is drawn in.
    pub fn room(&self) -> Rect {
        canvas::rect(&self.chart)
    }
}

/// The colour of a picture.
pub(super) fn colour(picture: Picture, visuals: &Visuals) -> Color32 {
    match picture {
        Picture::Measured => theme::measured_colour(visuals),
        Picture::Seen(eye) => theme::eye_colour(Eye::BOTH[eye], visuals),
        Picture::Stereo => theme::stereo_colour(visuals),
    }
}
