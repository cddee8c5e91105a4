//! Gestures of the mouse in a plot: a click or a drag goes to that T, a shift-click sets a cursor, the wheel
//! zooms about the pointer, a drag with the right button moves the plot, a double click has the whole of it
//! again.

use eframe::egui::{self, Event, Id, MouseWheelUnit, PointerButton, Ui};
use egui_plot::PlotResponse;
use relativity_core::math;

use super::axes::time_at_pointer;
use super::chart::TimePlot;
use crate::app::commands::{Command, PlaybackCommand};
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::State;
use crate::app::state::plots::look::{PlotCommand, Ranges};

/// Scrolling by this much is one step of the zoom; by a line of a wheel it is that too. Points.
const NOTCH: f32 = 40.0;
/// Least width that can be shown, as a part of the largest value there.
const NARROWEST: f64 = 1e-6;

/// Asks for what the mouse does in the plot of `chart`.
pub(super) fn read(
    ui: &Ui,
    state: &State,
    response: &PlotResponse<()>,
    chart: &TimePlot<'_>,
    commands: &mut Commands,
) {
    let quantity = chart.quantity;
    let look = |ranges| Command::Plots(PlotCommand::Look(quantity, ranges));
    let (mouse, modifiers) = (&response.response, ui.input(|input| input.modifiers));
    let shown = Ranges { times: chart.range, values: chart.value_range() };
    let is_moved = mouse.dragged_by(PointerButton::Secondary)
        || (mouse.dragged_by(PointerButton::Primary) && modifiers.command);
    if mouse.double_clicked() {
        if chart.zoomed.is_some() {
            commands.push(look(None));
        }
    } else if is_moved {
        let delta = mouse.drag_delta();
        let [x, y] = [0, 1].map(|axis| response.transform.dpos_dvalue()[axis]);
        let moved = |[from, to]: [f64; 2], by: f64| [from - by, to - by];
        let times = moved(shown.times, f64::from(delta.x) / x);
        let values = moved(shown.values, f64::from(delta.y) / y);
        if delta != egui::Vec2::ZERO {
            commands.push(look(Some(Ranges { times, values })));
        }
    } else if let Some(time) = time_at_pointer(response) {
        if modifiers.shift {
            mouse.on_click(commands, PlotCommand::Cursor(Some(time)));
        } else if !modifiers.command {
            commands.push(PlaybackCommand::GoTo(time).into());
        }
    }
    let Some(pointer) = mouse.hover_pos().filter(|_| mouse.contains_pointer()) else { return };
    let steps = steps(ui, mouse.id);
    if steps != 0 {
        let at = response.transform.value_from_position(pointer);
        commands.push(look(zoomed(chart, shown, state.whole_times(), [at.x, at.y], steps)));
    }
}

/// Steps of the zoom that the wheel has made: inwards above 0.
fn steps(ui: &Ui, id: Id) -> i32 {
    let scrolled: f32 = ui.input(|input| {
        let points = |event: &Event| match event {
            Event::MouseWheel { unit: MouseWheelUnit::Point, delta, .. } => delta.y,
            Event::MouseWheel { delta, .. } => delta.y.signum() * NOTCH * f32::from(u8::from(delta.y != 0.0)),
            // To spread two fingers by a third is a step, too.
            Event::Zoom(factor) => math::ln(f64::from(*factor)) as f32 * 3.0 * NOTCH,
            _ => 0.0,
        };
        input.events.iter().map(points).sum()
    });
    if scrolled == 0.0 {
        return 0;
    }
    ui.data_mut(|data| {
        let left: &mut f32 = data.get_temp_mut_or_default(id.with("scrolled"));
        *left += scrolled;
        let steps = (*left / NOTCH).trunc();
        *left -= steps * NOTCH;
        steps as i32
    })
}

/// Returns the part that is shown after this number of `steps` about a place; `None` where that is the whole
/// range of T.
fn zoomed(
    chart: &TimePlot<'_>,
    shown: Ranges,
    whole: [f64; 2],
    [x, y]: [f64; 2],
    steps: i32,
) -> Option<Ranges> {
    let (time_ruler, value_ruler, inwards) = (chart.time_ruler(0.0), chart.ruler(), steps > 0);
    let mut ranges = shown;
    for _ in 0..steps.unsigned_abs() {
        let times = time_ruler.zoomed(ranges.times, x, inwards);
        let values = value_ruler.zoomed(ranges.values, y, inwards);
        if inwards && (is_too_narrow(times) || is_too_narrow(values)) {
            break;
        }
        if !inwards && times[1] - times[0] >= whole[1] - whole[0] {
            return None;
        }
        ranges = Ranges { times, values };
    }
    Some(ranges)
}

fn is_too_narrow([from, to]: [f64; 2]) -> bool {
    to - from < NARROWEST * from.abs().max(to.abs())
}
