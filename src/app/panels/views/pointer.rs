//! The mouse and the keys in a view.

use eframe::egui::{self, CursorIcon, Event, EventFilter, Key, Response, Sense, Ui};
use relativity_core::math;

use crate::app::commands::riding::thumbs;
use crate::app::commands::{Command, GazeCommand, LOOK_STEP, PlaybackCommand, PointsCommand};
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::measuring::angle_ruler::{Lay, RulerCommand};
use crate::app::state::pointer::{Pick, Turn, Zoom};
use crate::app::views::panes::EyePane;

/// Zoom per point of scrolling.
const ZOOM_PER_SCROLL: f64 = 0.002;

/// Reads the mouse in `pane`, which assistive technology calls by this `name`.
pub fn interact(ui: &mut Ui, state: &State, pane: EyePane, name: &str, commands: &mut Commands) {
    let id = ui.scope_id().with(("view", pane.eye.index()));
    let response = ui.interact(pane.rect, id, Sense::click_and_drag()).on_hover_cursor(CursorIcon::Crosshair);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, name));
    let describe = |node: &mut egui::accesskit::Node| node.set_description(state.moment().sentence());
    ui.ctx().accesskit_node_builder(response.id, describe);
    if response.double_clicked() {
        commands.push(GazeCommand::WholeAgain.into());
    } else if response.triple_clicked() {
        // It is a double click that went on.
    } else if let (true, Some(place)) = (response.clicked(), response.interact_pointer_pos()) {
        let add = ui.input(|input| input.modifiers.shift);
        let EyePane { eye, is_second, size, .. } = pane;
        commands
            .push(PointsCommand::Pick(Pick { eye, is_second, pixel: pane.pixel(place), size, add }).into());
    }
    if response.has_focus() {
        keys(ui, &response, commands);
    }
    if state.scratch.angle_ruler.takes_drags() {
        measure(ui, &response, pane, commands);
    } else {
        turn(ui, &response, pane, commands);
    }
    // Two thumbs do not pinch while one pedals.
    if response.hovered() && thumbs::held(ui.ctx()).is_none() {
        let scroll = f64::from(ui.input(|input| input.smooth_scroll_delta().y));
        let pinch = f64::from(ui.input(egui::InputState::zoom_delta));
        let factor = math::exp(-scroll * ZOOM_PER_SCROLL) / pinch;
        if factor != 1.0 && factor.is_finite() {
            let place = response.hover_pos().unwrap_or(pane.rect.center());
            commands.push(
                GazeCommand::Zoom(Zoom {
                    eye: pane.eye,
                    is_second: pane.is_second,
                    pixel: pane.pixel(place),
                    size: pane.size,
                    factor,
                })
                .into(),
            );
        }
    }
}

/// Performs the keys of the view that has the keyboard focus.
fn keys(ui: &Ui, response: &Response, commands: &mut Commands) {
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    let pressed = |event: &Event| match event {
        Event::Key { key, pressed: true, modifiers, .. } => command_of(*key, modifiers.shift),
        _ => None,
    };
    commands.extend(ui.input(|input| input.events.iter().filter_map(pressed).collect::<Vec<_>>()));
}

fn command_of(key: Key, with_shift: bool) -> Option<Command> {
    match key {
        Key::ArrowLeft => Some(Command::Gaze(GazeCommand::Aside([-LOOK_STEP, 0.0]))),
        Key::ArrowRight => Some(Command::Gaze(GazeCommand::Aside([LOOK_STEP, 0.0]))),
        Key::ArrowUp => Some(Command::Gaze(GazeCommand::Aside([0.0, LOOK_STEP]))),
        Key::ArrowDown => Some(Command::Gaze(GazeCommand::Aside([0.0, -LOOK_STEP]))),
        Key::Enter => Some(Command::Points(PointsCommand::FollowNext(if with_shift { -1 } else { 1 }))),
        Key::Space => Some(Command::Playback(PlaybackCommand::Toggle)),
        _ => None,
    }
}

/// The scene follows the pointer: what is under it when a drag starts stays there. It follows the
/// thumb beside one that pedals, too.
fn turn(ui: &Ui, response: &Response, pane: EyePane, commands: &mut Commands) {
    let place = response.interact_pointer_pos().filter(|_| response.dragged());
    let dragged = place.map(|place| [place - response.drag_delta(), place]);
    let Some(ends) = dragged.or_else(|| thumbs::looked(ui.ctx(), pane.rect)) else { return };
    if ends[0] != ends[1] {
        let [from, to] = ends.map(|place| pane.pixel(place));
        let EyePane { eye, is_second, size, .. } = pane;
        commands.push(GazeCommand::Turn(Turn { eye, is_second, from, to, size }).into());
    }
}

/// A drag lays a ruler.
fn measure(ui: &Ui, response: &Response, pane: EyePane, commands: &mut Commands) {
    let from = ui.input(|input| input.pointer.press_origin());
    let to = response.interact_pointer_pos();
    if let Some((from, to)) = from.zip(to).filter(|_| response.dragged()) {
        let EyePane { eye, is_second, size, .. } = pane;
        let ends = [from, to].map(|place| pane.pixel(place));
        commands.push(RulerCommand::Lay(Lay { eye, is_second, ends, size }).into());
    }
    if response.drag_stopped() {
        commands.push(RulerCommand::Settle.into());
    }
}
