//! Rectangles of the toolkit as those in which labels are placed.

use eframe::egui::Rect;

use crate::plot::Area;

impl From<Rect> for Area {
    fn from(rect: Rect) -> Self {
        Self { min: rect.min.into(), max: rect.max.into() }
    }
}

impl From<Area> for Rect {
    fn from(area: Area) -> Self {
        Self { min: area.min.into(), max: area.max.into() }
    }
}
