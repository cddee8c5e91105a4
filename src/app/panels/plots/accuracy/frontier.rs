//! The Accuracy tab's plot: error against cost of each way to draw the present views, both as powers of ten.

use eframe::egui::{self, Align2, Color32, Rect, TextStyle, Ui, Visuals};
use egui_plot::{HLine, LineStyle, PlotBounds, PlotPoint, PlotResponse, PlotUi, Points, VLine};
use relativity_core::math;
use relativity_render::Method;

use crate::app::panels::plots::axes::{Ruler, frame, still_plot};
use crate::app::views::examination::{Examination, ExaminedMethod};
use crate::app::widgets::theme;
use crate::flags::Goal;
use crate::plot::{Area, LabelPlaces, extent};
use crate::settings::QualitySettings;

/// Errors below this, arcseconds, are drawn as this: none is measured as 0 but by chance.
const LEAST_ERROR: f64 = 1e-12;
/// Distance from a mark up to which a click means it, points.
const REACH: f32 = 40.0;

/// A method in the plot.
struct MethodMark {
    method: Method,
    name: String,
    /// log10 of its milliseconds and of its error in arcseconds.
    place: [f64; 2],
    colour: Color32,
    radius: f32,
}

impl MethodMark {
    fn new(row: &ExaminedMethod<'_>, is_worth: bool, chosen: Method, visuals: &Visuals) -> Option<Self> {
        let figures = row.figures?.as_ref().ok()?;
        let error = figures.line_of_sight_arcseconds?.p99.max(LEAST_ERROR);
        let place = [figures.frame_ms, error].map(math::log10);
        let is_chosen = row.method == chosen;
        let colour = if is_chosen { theme::point_colour(1, visuals) } else { visuals.text_color() };
        let mark = Self {
            method: row.method,
            name: row.name().to_owned(),
            place,
            colour: if row.is_current && is_worth { colour } else { colour.gamma_multiply(0.4) },
            radius: if is_chosen { 5.5 } else { 4.0 },
        };
        place.iter().all(|value| value.is_finite()).then_some(mark)
    }

    fn draw(&self, plot: &mut PlotUi<'_>) {
        let points = Points::new(&self.name, vec![self.place]).color(self.colour).radius(self.radius);
        plot.points(points.allow_hover(false));
    }
}

/// The line of automatic quality's goal in the plot.
#[derive(Debug, Clone, Copy)]
struct GoalLine {
    goal: Goal,
    /// log10 of the milliseconds, or of the error in arcseconds.
    at: f64,
    colour: Color32,
}

impl GoalLine {
    /// Returns the line of `quality`, where it is automatic.
    fn new(quality: QualitySettings, examination: &Examination, visuals: &Visuals) -> Option<Self> {
        let value = match quality.goal {
            Goal::Error(px) => 3600.0 * (px / examination.px_per_radian()?).to_degrees(),
            Goal::Budget(ms) => ms,
        };
        let (goal, at) = (quality.goal, math::log10(value));
        let colour = theme::point_colour(1, visuals).gamma_multiply(0.7);
        (quality.method().is_none() && at.is_finite()).then_some(Self { goal, at, colour })
    }

    /// Along the axis, if it is in the plot.
    fn draw(self, plot: &mut PlotUi<'_>, bounds: PlotBounds) {
        let Self { goal, at, colour } = self;
        let style = LineStyle::dashed_loose();
        match goal {
            Goal::Error(_) if bounds.range_y().contains(&at) => {
                plot.hline(HLine::new("error bound", at).color(colour).style(style).allow_hover(false));
            }
            Goal::Budget(_) if bounds.range_x().contains(&at) => {
                plot.vline(VLine::new("budget", at).color(colour).style(style).allow_hover(false));
            }
            Goal::Error(_) | Goal::Budget(_) => {}
        }
    }
}

/// Names the marks, each beside its own where no other name or mark is, nor the names of the axes.
fn name_marks(ui: &Ui, response: &PlotResponse<()>, marks: &[MethodMark], axes: [Rect; 2]) {
    let frame = *response.transform.frame();
    let painter = ui.painter().with_clip_rect(frame);
    let small = TextStyle::Small.resolve(ui.style());
    let middle = |mark: &MethodMark| response.transform.position_from_point(&PlotPoint::from(mark.place));
    let mut labels = LabelPlaces::new(frame, 0.0);
    for name in axes {
        labels.keep_free(name);
    }
    for mark in marks {
        labels.keep_clear_of(middle(mark), mark.radius);
    }
    for mark in marks {
        let galley = painter.layout_no_wrap(mark.name.clone(), small.clone(), mark.colour);
        let near = Area::near(middle(mark), mark.radius, galley.size());
        if let Some(place) = labels.take(near).map(Rect::from) {
            painter.galley(place.min, galley, mark.colour);
        }
    }
}

/// Shows it in `size`; clicking a mark chooses that renderer.
pub fn show(
    ui: &mut Ui,
    size: egui::Vec2,
    examination: &Examination,
    chosen: Method,
    quality: &mut QualitySettings,
) {
    let mark = |row: ExaminedMethod<'_>| {
        let is_worth = examination.better_than(&row).is_none();
        MethodMark::new(&row, is_worth, chosen, ui.visuals())
    };
    let marks: Vec<MethodMark> = examination.rows().filter_map(mark).collect();
    let rulers = rulers(size);
    let line = GoalLine::new(*quality, examination, ui.visuals());
    let bounds = bounds(&marks, rulers);
    let [costs, errors] = rulers;
    let response = errors.beside(costs.below(still_plot(ui, "cost and error", size))).show(ui, |plot| {
        plot.set_plot_bounds(bounds);
        if let Some(line) = line {
            line.draw(plot, bounds);
        }
        for mark in &marks {
            mark.draw(plot);
        }
    });
    let names = annotate(ui, &response);
    name_marks(ui, &response, &marks, names);
    if let Some(mark) = clicked(&marks, &response) {
        *quality = quality.with_method(mark.method);
    }
}

/// Frames the plot, names its axes, and names it for assistive technology. Where the names of the axes stand.
fn annotate(ui: &Ui, response: &PlotResponse<()>) -> [Rect; 2] {
    frame(ui, response);
    let corners = response.transform.frame().shrink(5.0);
    let (small, weak) = (TextStyle::Small.resolve(ui.style()), ui.visuals().weak_text_color());
    let names = [
        (corners.left_top(), Align2::LEFT_TOP, "direction / ″ (99 %)"),
        (corners.right_bottom(), Align2::RIGHT_BOTTOM, "time / ms"),
    ];
    let names =
        names.map(|(corner, align, name)| ui.painter().text(corner, align, name, small.clone(), weak));
    let role = egui::accesskit::Role::GraphicsObject;
    response.response.widget_info(|| egui::WidgetInfo::labeled(role, true, "Plot of error against cost"));
    names
}

/// The mark that was clicked.
fn clicked<'a>(marks: &'a [MethodMark], response: &PlotResponse<()>) -> Option<&'a MethodMark> {
    let pointer = response.response.interact_pointer_pos().filter(|_| response.response.clicked())?;
    let distance = |mark: &MethodMark| {
        response.transform.position_from_point(&PlotPoint::from(mark.place)).distance(pointer)
    };
    let nearest = marks.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    (distance(nearest) < REACH).then_some(nearest)
}

/// Returns the rulers of the costs and of the errors.
fn rulers(size: egui::Vec2) -> [Ruler; 2] {
    [Ruler::of_powers_along(size.x), Ruler::of_powers(size.y)]
}

/// Returns the bounds of all marks with a margin for their names; never of no size.
fn bounds(marks: &[MethodMark], rulers: [Ruler; 2]) -> PlotBounds {
    let range = |axis: usize, margin: f64| {
        let range = extent(marks.iter().map(|mark| mark.place[axis]))
            .map_or([-1.0, 1.0], |[lowest, highest]| [lowest - margin.min(1.0), highest + margin]);
        rulers[axis].widened(range)
    };
    let ([left, right], [bottom, top]) = (range(0, 0.6), range(1, 2.5));
    PlotBounds::from_min_max([left, bottom], [right, top])
}
