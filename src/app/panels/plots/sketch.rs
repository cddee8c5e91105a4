//! The plot that a curve is drawn into before it is seen; then both stand in it.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Button, Color32, Id, Label, PointerButton, RichText, Sense, TextStyle, Ui, Vec2, WidgetInfo,
};
use egui_plot::{Line, PlotBounds, PlotPoints, PlotResponse, Points, VLine};

use super::axes::{Ruler, Y_AXIS_WIDTH, annotate, axis_label, label_places, plot_over_time};
use super::chart::RIGHT_DASHES;
use super::drawn::style;
use super::legend::{self, LegendEntry};
use crate::app::panels::{Commands, OnClick as _, on_change};
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::queries::drawn_curve::Sketched;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::lesson::{Answer, CurveAnswer, difference, sketch};
use crate::plot::Dash;
use crate::quantity::Quantity;

/// Invitation in an empty plot.
const INVITATION: &str = "Draw the curve that you expect: press and drag.";
/// Width of the lines, and their dashes and names.
const WIDTH: f32 = 2.0;
const DRAWN: (Dash, &str) = (RIGHT_DASHES, "your curve");
const TRUE: (Dash, &str) = (Dash::Solid, "true curve");

/// Shows the plot to draw in.
pub(super) fn show(ui: &mut Ui, state: &State, sketched: Sketched<'_>, commands: &mut Commands) {
    let quantity = sketched.curve.quantity;
    ui.spacing_mut().item_spacing.y = 2.0;
    // Before an audience the words of the lesson tell it.
    if !sketched.is_asked && !state.session.stage.is_presented() {
        ui.horizontal_wrapped(|ui| {
            switch(ui, state, commands);
            let off =
                sketched.is_revealed.then(|| difference(&sketched.curve, sketched.points, &state.sight()));
            if let Some(text) = off.flatten() {
                ui.add(Label::new(text).extend());
            }
        });
    }
    ui.horizontal_wrapped(|ui| {
        ui.add_space(Y_AXIS_WIDTH);
        let ruler = Ruler::of_height(ui.available_height());
        let heading = ruler.axis(sketched.curve.range).label(&axis_label(quantity, &state.measures()));
        let of = state.name_of(state.document.points.selected());
        ui.label(RichText::new(heading).strong());
        ui.label(RichText::new(format!("of the {of}{}", whose(quantity))).weak());
        if sketched.is_asked {
            // It is always there: the plot stays where it is while something is drawn.
            let clear = ui.add_enabled(!sketched.points.is_empty(), Button::new("Clear"));
            clear.on_hover_text("Clears the curve.").on_click(commands, LessonCommand::Draft(None));
        }
    });
    plot(ui, state, sketched, commands);
}

/// The small switch between the curve and the usual plots.
pub(super) fn switch(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let now = !state.shows_sketch();
    let mut plots = now;
    ui.selectable_value(&mut plots, false, "Your curve").on_hover_text("Your curve and the true one.");
    ui.selectable_value(&mut plots, true, "All plots").on_hover_text("The whole of every plot.");
    on_change(commands, &now, plots, LessonCommand::ShowPlots);
}

/// Returns the eyes of a quantity: disparities belong to both.
const fn whose(quantity: Quantity) -> &'static str {
    if quantity.is_disparity() { "" } else { ", left eye" }
}

fn plot(ui: &mut Ui, state: &State, sketched: Sketched<'_>, commands: &mut Commands) {
    let CurveAnswer { quantity, range: values } = sketched.curve;
    let (times, time_unit) = (state.whole_times(), state.measures().time);
    let size = ui.available_size().max(Vec2::splat(20.0));
    let (settings, track) = (&state.document.settings, state.document.points.selected().track);
    let truth = if sketched.is_revealed { sketched.curve.over(settings, &track, times) } else { Vec::new() };
    let drawn = sketch::pieces(sketched.points, times);
    let [drawn_colour, true_colour] = colours(ui, state, quantity);
    let plot = plot_over_time(ui, "sketch", time_unit, size).sense(Sense::drag());
    let now = state.document.time;
    let response = Ruler::of_height(size.y).beside(plot).show(ui, |plot| {
        plot.set_plot_bounds(PlotBounds::from_min_max([times[0], values[0]], [times[1], values[1]]));
        let now_line = VLine::new("T", now).width(1.0).allow_hover(false);
        plot.vline(now_line.color(theme::now_colour(&plot.ctx().global_style().visuals)));
        let dash = if sketched.is_revealed { DRAWN.0 } else { Dash::Solid };
        let lines = truth.iter().map(|piece| (piece, TRUE.0, TRUE.1, true_colour));
        for (piece, dash, name, colour) in
            lines.chain(drawn.iter().map(|piece| (piece, dash, DRAWN.1, drawn_colour)))
        {
            let line = Line::new(name, PlotPoints::from(piece.clone())).allow_hover(false).allow_band(false);
            plot.line(line.color(colour).width(WIDTH).style(style(dash)));
        }
        let value = sketched.is_revealed.then(|| sketched.curve.at(settings, &track, now));
        if let Some(value) = value.flatten() {
            let dot = Points::new("now", vec![[now, value]]).color(true_colour).radius(4.0);
            plot.points(dot.allow_hover(false));
        }
    });
    let mut labels = label_places(&response, now);
    for piece in truth.iter().chain(&drawn) {
        labels.avoid(piece.iter().map(|point| response.transform.position_from_point(&(*point).into())), 1.0);
    }
    annotate(ui, &response, (state.clock(), time_unit), None, &mut labels);
    let is_there = [(&truth, TRUE, true_colour), (&drawn, DRAWN, drawn_colour)];
    let is_there = is_there.into_iter().filter(|(pieces, ..)| sketched.is_revealed && !pieces.is_empty());
    let row =
        |(_, (dash, name), colour): (_, (Dash, &str), _)| LegendEntry::of_line(dash, WIDTH, name, colour);
    legend::show_rows(ui, &response, "the sketch", is_there.map(row).collect(), &mut labels);
    describe(ui, &response, state, sketched);
    if sketched.is_asked {
        read(ui, &response, sketched, [times, values], commands);
    }
}

/// The colour of what is drawn, and that of what it should be, which other plots have too.
fn colours(ui: &Ui, state: &State, quantity: Quantity) -> [Color32; 2] {
    let visuals = ui.visuals();
    let truth = if quantity.is_disparity() {
        theme::point_colour(state.document.points.selected().number, visuals)
    } else {
        theme::eye_colour(Eye::Left, visuals)
    };
    [visuals.text_color(), truth]
}

/// Names the plot for assistive technology, with the invitation if it is empty.
fn describe(ui: &Ui, response: &PlotResponse<()>, state: &State, sketched: Sketched<'_>) {
    let sign = sketched.curve.quantity.row().symbol;
    let point = state.name_of(state.document.points.selected());
    let name = if sketched.is_revealed {
        format!("Plot of {sign} of {point} against T, and of what was drawn")
    } else {
        format!("Plot to draw {sign} of {point} against T into")
    };
    response.response.widget_info(|| WidgetInfo::labeled(Role::GraphicsObject, true, &name));
    if sketched.is_asked && sketched.points.is_empty() {
        let frame = *response.transform.frame();
        let (font, colour) = (TextStyle::Body.resolve(ui.style()), ui.visuals().weak_text_color());
        let galley = ui.painter().layout(INVITATION.to_owned(), font, colour, frame.width());
        let place = Align2::CENTER_CENTER.align_size_within_rect(galley.size(), frame);
        ui.painter().galley(place.min, galley, colour);
        let shown = ui.interact(place, Id::unique(("invitation to draw", ui.layer_id())), Sense::empty());
        shown.widget_info(|| WidgetInfo::labeled(Role::Label, true, INVITATION));
    }
}

/// Asks for what the mouse draws: a straight stroke from where it was to where it is.
fn read(
    ui: &Ui,
    response: &PlotResponse<()>,
    sketched: Sketched<'_>,
    area: [[f64; 2]; 2],
    commands: &mut Commands,
) {
    let mouse = &response.response;
    let is_drawing =
        mouse.dragged_by(PointerButton::Primary) || mouse.drag_stopped_by(PointerButton::Primary);
    let Some(to) = mouse.interact_pointer_pos().filter(|_| is_drawing) else { return };
    let pressed = ui.input(|input| input.pointer.press_origin()).filter(|_| mouse.drag_started());
    let from = pressed.unwrap_or_else(|| to - ui.input(|input| input.pointer.delta()));
    let stroke = [from, to].map(|place| {
        let value = response.transform.value_from_position(place);
        [value.x, value.y]
    });
    let points = sketch::drawn(sketched.points, area, stroke);
    if points != sketched.points {
        commands.push(LessonCommand::Draft(Some(Answer::Curve(points))).into());
    }
}
