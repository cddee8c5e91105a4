//! The Accuracy tab's plot: error against cost of each way to draw the present views, both as powers of ten.

use std::ops::RangeInclusive;

use eframe::egui::{self, Align2, Color32, RichText, TextStyle, Ui, Visuals};
use egui_plot::{GridInput, GridMark, PlotBounds, PlotPoint, PlotResponse, PlotUi, Points, Text};
use relativity_core::math;
use relativity_render::Method;

use crate::app::examination::{Examination, Row};
use crate::app::panels::plots::axes::{frame, still_plot};
use crate::app::theme;
use crate::figures;
use crate::plot::extent;
use crate::settings::Quality;

/// Errors below this, arcseconds, are drawn as this: none is measured as 0 but by chance.
const LEAST_ERROR: f64 = 1e-12;
/// How far from a mark a click still means it, points.
const REACH: f32 = 40.0;

/// A method in the plot.
struct Mark {
    method: Method,
    name: String,
    /// log10 of its milliseconds and of its error in arcseconds.
    place: [f64; 2],
    colour: Color32,
    radius: f32,
}

impl Mark {
    fn of(row: &Row<'_>, is_worth: bool, chosen: Method, visuals: &Visuals) -> Option<Self> {
        let figures = row.figures?.as_ref().ok()?;
        let error = figures.line_of_sight_arcseconds?.p99.max(LEAST_ERROR);
        let place = [figures.frame_ms, error].map(math::log10);
        let is_chosen = row.method == chosen;
        let colour = if is_chosen { theme::point_colour(1, visuals) } else { visuals.text_color() };
        let mark = Self {
            method: row.method,
            name: row.name(),
            place,
            colour: if row.is_current && is_worth { colour } else { colour.gamma_multiply(0.4) },
            radius: if is_chosen { 5.5 } else { 4.0 },
        };
        place.iter().all(|value| value.is_finite()).then_some(mark)
    }

    fn draw(&self, plot: &mut PlotUi<'_>, bounds: &PlotBounds) {
        let text = &self.name;
        let points = Points::new(text, vec![self.place]).color(self.colour).radius(self.radius);
        plot.points(points.allow_hover(false));
        let [x, y] = self.place;
        // On the side where there is more room.
        let is_left = 2.0 * x < bounds.min()[0] + bounds.max()[0];
        let anchor = if is_left { Align2::LEFT_BOTTOM } else { Align2::RIGHT_BOTTOM };
        let label = RichText::new(format!("  {text}  ")).small();
        let label = Text::new(text, PlotPoint::new(x, y), label);
        plot.text(label.anchor(anchor).color(self.colour).allow_hover(false));
    }
}

/// Shows it in `size`; clicking a mark chooses that renderer.
pub fn show(ui: &mut Ui, size: egui::Vec2, examination: &Examination, quality: &mut Quality) {
    let mark = |row: Row<'_>| {
        let is_worth = examination.better_than(&row).is_none();
        Mark::of(&row, is_worth, quality.method(), ui.visuals())
    };
    let marks: Vec<Mark> = examination.rows().filter_map(mark).collect();
    let bounds = bounds(&marks);
    let response = still_plot(ui, "cost and error", size)
        .x_grid_spacer(|input| decades(&input, 1.0))
        .y_grid_spacer(|input| decades(&input, 2.0))
        .x_axis_formatter(|mark, _: &RangeInclusive<f64>| figures::power_of_ten(mark.value))
        .y_axis_formatter(|mark, _| figures::power_of_ten(mark.value))
        .show(ui, |plot| {
            plot.set_plot_bounds(bounds);
            for mark in &marks {
                mark.draw(plot, &bounds);
            }
        });
    annotate(ui, &response);
    if let Some(mark) = clicked(&marks, &response) {
        *quality = quality.with_method(mark.method);
    }
}

/// Frames the plot, names its axes, and names it for assistive technology.
fn annotate(ui: &Ui, response: &PlotResponse<()>) {
    frame(ui, response);
    let corners = response.transform.frame().shrink(5.0);
    let (small, weak) = (TextStyle::Small.resolve(ui.style()), ui.visuals().weak_text_color());
    ui.painter().text(corners.left_top(), Align2::LEFT_TOP, "direction / ″ (99 %)", small.clone(), weak);
    ui.painter().text(corners.right_bottom(), Align2::RIGHT_BOTTOM, "ms", small, weak);
    let role = egui::accesskit::Role::GraphicsObject;
    response.response.widget_info(|| egui::WidgetInfo::labeled(role, true, "Plot of error against cost"));
}

/// The mark that was clicked.
fn clicked<'a>(marks: &'a [Mark], response: &PlotResponse<()>) -> Option<&'a Mark> {
    let pointer = response.response.interact_pointer_pos().filter(|_| response.response.clicked())?;
    let distance =
        |mark: &Mark| response.transform.position_from_point(&PlotPoint::from(mark.place)).distance(pointer);
    let nearest = marks.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(nearest) < REACH).then_some(nearest)
}

/// All marks with a margin for their names; never of no size.
fn bounds(marks: &[Mark]) -> PlotBounds {
    let range = |axis: usize, margin: f64| {
        extent(marks.iter().map(|mark| mark.place[axis]))
            .map_or([-1.0, 1.0], |[lowest, highest]| [lowest - margin.min(1.0), highest + margin])
    };
    let ([left, right], [bottom, top]) = (range(0, 0.6), range(1, 2.5));
    PlotBounds::from_min_max([left, bottom], [right, top])
}

/// Grid lines at every so many powers of ten.
fn decades(input: &GridInput, step_size: f64) -> Vec<GridMark> {
    let (from, to) = input.bounds;
    let [first, last] = [(from / step_size).ceil(), (to / step_size).floor()].map(|mark| mark as i32);
    (first..=last).map(|mark| GridMark { value: f64::from(mark) * step_size, step_size }).collect()
}
