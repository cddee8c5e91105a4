//! A sheet: one of the two charts, and the colours on both.

use eframe::egui::{Color32, Rect, Visuals};

use crate::app::panels::map::canvas;
use crate::app::theme;
use crate::eye::Eye;
use crate::map::{BodyPicture, Chart, MapProjection};

/// A chart of the face.
#[derive(Debug, Clone, Copy)]
pub(super) struct SpaceSheet {
    /// Projection of the chart.
    pub projection: MapProjection,
    /// Chart that places things.
    pub chart: Chart,
}

impl SpaceSheet {
    /// Returns the name of the chart for assistive technology.
    pub const fn name(&self) -> &'static str {
        match self.projection {
            MapProjection::Plan => "Map, from above",
            MapProjection::Side => "Map, from the side",
        }
    }

    /// The room the sheet is drawn in.
    pub fn room(&self) -> Rect {
        canvas::rect(&self.chart)
    }
}

/// The colour of a picture.
pub(super) fn colour(picture: BodyPicture, visuals: &Visuals) -> Color32 {
    match picture {
        BodyPicture::Measured => theme::measured_colour(visuals),
        BodyPicture::Seen(eye) => theme::eye_colour(Eye::BOTH[eye], visuals),
        BodyPicture::Stereo => theme::stereo_colour(visuals),
    }
}
