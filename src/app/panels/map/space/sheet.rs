//! A sheet: one of the two charts, what is drawn on it and with what, and the colours on both.

use eframe::egui::{Color32, Painter, Pos2, Rect, Ui, Visuals};
use glam::DVec3;

use crate::app::panels::map::canvas;
use crate::app::panels::map::labels::MapLabels;
use crate::app::state::State;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::map::{BodyPicture, Chart, MapInstant, MapProjection};

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

    /// Returns the point of the screen at which a place in space is drawn.
    pub fn on_screen(&self, place: DVec3) -> Pos2 {
        canvas::place(&self.chart, self.projection.flat(place))
    }
}

/// A sheet while it is drawn on.
pub(super) struct SheetPainter<'a> {
    pub ui: &'a Ui,
    /// Painter that keeps to the sheet's room.
    pub painter: &'a Painter,
    pub state: &'a State,
    /// Events that are drawn.
    pub instant: &'a MapInstant<'a>,
    pub sheet: SpaceSheet,
    /// Places of the labels that are written already.
    pub labels: MapLabels,
}

/// The colour of a picture.
pub(super) fn colour(picture: BodyPicture, visuals: &Visuals) -> Color32 {
    match picture {
        BodyPicture::Measured => theme::measured_colour(visuals),
        BodyPicture::Seen(eye) => theme::eye_colour(Eye::BOTH[eye], visuals),
        BodyPicture::Stereo => theme::stereo_colour(visuals),
    }
}
