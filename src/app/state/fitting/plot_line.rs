//! Points of a plot, which another instance of the program can send.

use std::ops::Deref;

use egui_plot::PlotPoint;
use serde::{Deserialize, Serialize};

/// Points of a plot, in their order.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct PlotLine(Vec<PlotPoint>);

impl Deref for PlotLine {
    type Target = [PlotPoint];

    fn deref(&self) -> &[PlotPoint] {
        &self.0
    }
}

impl FromIterator<PlotPoint> for PlotLine {
    fn from_iter<I: IntoIterator<Item = PlotPoint>>(points: I) -> Self {
        Self(points.into_iter().collect())
    }
}

impl From<Vec<[f64; 2]>> for PlotLine {
    fn from(points: Vec<[f64; 2]>) -> Self {
        points.into_iter().map(PlotPoint::from).collect()
    }
}

impl From<PlotLine> for Vec<[f64; 2]> {
    fn from(points: PlotLine) -> Self {
        points.iter().map(|point| [point.x, point.y]).collect()
    }
}
