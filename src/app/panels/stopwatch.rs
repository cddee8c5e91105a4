//! The stopwatch in the corner of a view.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Button, Color32, CornerRadius, Frame, Label, Margin, Rect, RichText, Sense, TextStyle, Ui, UiBuilder,
    Visuals, WidgetInfo, pos2, vec2,
};

use super::{Commands, OnClick as _};
use crate::app::commands::Command;
use crate::app::commands::actions::with_keys;
use crate::app::state::State;
use crate::app::state::measuring::stopwatch::{Stopwatch, StopwatchCommand, TIP};
use crate::app::views::panes::EyePane;
use crate::app::widgets::theme;
use crate::number_text;

/// Room around its words, and its width, points.
const MARGIN: f32 = 6.0;
const WIDTH: f32 = 200.0;
/// Room above it for a line of the view's own.
const ABOVE: f32 = 26.0;
/// Narrower views than this have none.
const NARROWEST_VIEW: f32 = WIDTH + 4.0 * MARGIN;

/// Shows it in the corner of `pane`.
pub fn show(ui: &mut Ui, state: &State, pane: EyePane, commands: &mut Commands) {
    let scale = theme::text_scale(ui.style());
    let width = scale * WIDTH;
    if state.scratch.stopwatch == Stopwatch::Hidden || pane.rect.width() < scale * NARROWEST_VIEW {
        return;
    }
    let corner = pos2(pane.rect.max.x - width - MARGIN, pane.rect.min.y + scale * ABOVE + MARGIN);
    let room = Rect::from_min_max(corner, pane.rect.max - vec2(MARGIN, MARGIN));
    // It takes the mouse from the view below it.
    let id = ui.scope_id().with("stopwatch");
    let before = ui.ctx().data(|data| data.get_temp::<Rect>(id));
    if let Some(rect) = before {
        ui.interact(rect, id, Sense::click_and_drag());
    }
    ui.scope_builder(UiBuilder::new().max_rect(room), |ui| {
        *ui.visuals_mut() = Visuals::dark();
        let frame = Frame::new()
            .fill(Color32::from_black_alpha(205))
            .corner_radius(CornerRadius::same(4))
            .inner_margin(Margin::same(MARGIN as i8));
        let shown = frame.show(ui, |ui| {
            ui.set_width(width - 2.0 * MARGIN);
            contents(ui, state, commands);
        });
        ui.ctx().data_mut(|data| data.insert_temp(id, shown.response.rect));
    });
}

fn contents(ui: &mut Ui, state: &State, commands: &mut Commands) {
    ui.spacing_mut().item_spacing.y = 2.0;
    ui.horizontal(|ui| {
        let is_running = matches!(state.scratch.stopwatch, Stopwatch::Running(_));
        let press = if is_running { "Stop" } else { "Start" };
        let tip =
            with_keys(TIP, &[StopwatchCommand::Press, StopwatchCommand::Toggle].map(Command::Stopwatch));
        for (name, command) in [
            (press, StopwatchCommand::Press),
            ("Clear", StopwatchCommand::Reset),
            ("Close stopwatch", StopwatchCommand::Toggle),
        ] {
            let shown = if command == StopwatchCommand::Toggle { "×" } else { name };
            let response = ui.add(Button::new(RichText::new(shown).small())).on_hover_text(&tip);
            response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
            response.on_click(commands, command);
        }
    });
    for text in lines(state) {
        let style = TextStyle::Body.resolve(ui.style());
        let shown = RichText::new(&text).font(style).color(Color32::WHITE);
        let line = ui.add(Label::new(shown).selectable(false));
        line.widget_info(|| WidgetInfo::labeled(Role::Label, true, format!("Stopwatch: {text}")));
    }
}

/// Returns the lines of its readout.
fn lines(state: &State) -> Vec<String> {
    let unit = state.measures().time;
    let told = |[value, error]: [f64; 2]| {
        let error = if error == 0.0 { "0".to_owned() } else { unit.number(error, 3) };
        format!("{} ± {error}{}", unit.number(value, 3), unit.suffix())
    };
    let elapsed = state.elapsed();
    let time = elapsed.map_or_else(|| number_text::NONE.to_owned(), |elapsed| told(elapsed.time));
    let clock = elapsed.and_then(|elapsed| elapsed.clock).map(|clock| {
        let name = state.name_of(state.document.points.selected());
        format!("clock of {name}: {}", told(clock))
    });
    let rate = elapsed.and_then(|elapsed| elapsed.mean_rate());
    let rate = rate.map(|rate| {
        let eye = state.timed_eye().name().to_lowercase();
        format!("{eye}’s mean D = {}", number_text::fixed(rate, 3))
    });
    [format!("T: {time}")].into_iter().chain(clock).chain(rate).collect()
}
