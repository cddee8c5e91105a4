//! The Accuracy tab's plot: error against cost of each way to draw the present views, both as powers of ten.

use std::ops::RangeInclusive;

use eframe::egui::{self, Align2, Color32, RichText, TextStyle, Ui};
use egui_plot::{GridInput, GridMark, Plot, PlotBounds, PlotPoint, PlotUi, Points, Text};

use super::accuracy::name;
use super::axes::frame;
use crate::accuracy::Method;
use crate::app::examination::{Examination, Figures};
use crate::app::settings::Quality;
use crate::app::{figures, theme};

/// Errors below this, arcseconds, are drawn as this: none is measured as 0 but by chance.
const LEAST_ERROR: f64 = 1e-12;
/// How far from a mark a click still means it, points.
const REACH: f32 = 40.0;

/// Where a method lies in the plot: log10 of its milliseconds and of its error in arcseconds.
fn place(figures: &Figures) -> Option<[f64; 2]> {
    let error = figures.line_of_sight_arcseconds?.p99.max(LEAST_ERROR);
    let place = [figures.frame_ms.log10(), error.log10()];
    place.iter().all(|value| value.is_finite()).then_some(place)
}

struct Mark {
    method: Method,
    place: [f64; 2],
    colour: Color32,
    radius: f32,
}

/// Shows it in `size`; clicking a mark chooses that renderer.
pub fn show(ui: &mut Ui, size: egui::Vec2, examination: &Examination, quality: &mut Quality) {
    let chosen = quality.method();
    let visuals = ui.visuals();
    let marks: Vec<Mark> = examination
        .rows()
        .filter_map(|row| {
            let place = place(row.figures?.as_ref().ok()?)?;
            let is_chosen = row.method == chosen;
            let radius = if is_chosen { 5.5 } else { 4.0 };
            let colour = if is_chosen { theme::point_colour(1, visuals) } else { visuals.text_color() };
            let colour = if row.is_current { colour } else { colour.gamma_multiply(0.4) };
            Some(Mark { method: row.method, place, colour, radius })
        })
        .collect();
    let bounds = bounds(&marks);
    let response = Plot::new("cost and error")
        .width(size.x)
        .height(size.y)
        .allow_zoom(false)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .allow_axis_zoom_drag(false)
        .y_axis_min_width(48.0)
        .grid_color(visuals.weak_text_color().gamma_multiply(0.25))
        .x_grid_spacer(|input| decades(&input, 1.0))
        .y_grid_spacer(|input| decades(&input, 2.0))
        .x_axis_formatter(|mark, _: &RangeInclusive<f64>| figures::power_of_ten(mark.value))
        .y_axis_formatter(|mark, _| figures::power_of_ten(mark.value))
        .show(ui, |plot| {
            plot.set_plot_bounds(bounds);
            for mark in &marks {
                draw(plot, mark, &bounds);
            }
        });
    frame(ui, &response);
    let corners = response.transform.frame().shrink(5.0);
    let (small, weak) = (TextStyle::Small.resolve(ui.style()), ui.visuals().weak_text_color());
    ui.painter().text(corners.left_top(), Align2::LEFT_TOP, "direction / ″ (99 %)", small.clone(), weak);
    ui.painter().text(corners.right_bottom(), Align2::RIGHT_BOTTOM, "ms", small, weak);
    let info = || {
        egui::WidgetInfo::labeled(egui::accesskit::Role::GraphicsObject, true, "Plot of error against cost")
    };
    response.response.widget_info(info);
    let clicked = response.response.interact_pointer_pos().filter(|_| response.response.clicked());
    let distance = |mark: &Mark, pointer: egui::Pos2| {
        response.transform.position_from_point(&PlotPoint::from(mark.place)).distance(pointer)
    };
    if let Some(pointer) = clicked {
        let nearest = marks.iter().min_by(|a, b| distance(a, pointer).total_cmp(&distance(b, pointer)));
        if let Some(mark) = nearest.filter(|mark| distance(mark, pointer) < REACH) {
            *quality = quality.with_method(mark.method);
        }
    }
}

/// All marks with a margin for their names; never of no size.
fn bounds(marks: &[Mark]) -> PlotBounds {
    let range = |axis: usize, margin: f64| {
        let values = marks.iter().map(|mark| mark.place[axis]);
        let lowest = values.clone().fold(f64::INFINITY, f64::min);
        let highest = values.fold(f64::NEG_INFINITY, f64::max);
        if lowest <= highest { [lowest - margin.min(1.0), highest + margin] } else { [-1.0, 1.0] }
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

fn draw(plot: &mut PlotUi<'_>, mark: &Mark, bounds: &PlotBounds) {
    let text = name(mark.method);
    let points = Points::new(text.clone(), vec![mark.place]).color(mark.colour).radius(mark.radius);
    plot.points(points.allow_hover(false));
    let [x, y] = mark.place;
    // On the side where there is more room.
    let anchor =
        if 2.0 * x < bounds.min()[0] + bounds.max()[0] { Align2::LEFT_BOTTOM } else { Align2::RIGHT_BOTTOM };
    let label = Text::new(text.clone(), PlotPoint::new(x, y), RichText::new(format!("  {text}  ")).small());
    plot.text(label.anchor(anchor).color(mark.colour).allow_hover(false));
}
