//! The borders between the parts of the window: a drag makes one part larger and the other smaller, a double
//! click has it as usual again. And the titles of parts: a double click has one alone in the window.

use eframe::egui::accesskit::Role;
use eframe::egui::{self, CursorIcon, Sense, Stroke, Ui, Vec2, vec2};

use super::{Commands, on_change};
use crate::app::commands::{SettingsCommand, WindowCommand};
use crate::app::state::State;
use crate::app::state::stage::WindowPart;
use crate::app::views::window_layout::border::Border;
use crate::flags::Share;

/// Size of the dots that show where a border can be grabbed, and from one to the next.
const DOT_RADIUS: f32 = 1.1;
const DOT_STEP: f32 = 5.0;

const TIP: &str = "Drag to resize.   Double-click to reset.";

/// Shows `border`, and reads drags of it.
pub fn show(ui: &Ui, state: &State, border: Border, commands: &mut Commands) {
    let Border { split, rect, .. } = border;
    let response = ui.interact(rect, ui.scope_id().with(split.name()), Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Splitter, true, split.name()));
    let cursor = if split.is_upright() { CursorIcon::ResizeHorizontal } else { CursorIcon::ResizeVertical };
    let is_held = response.hovered() || response.dragged();
    paint(ui, border, is_held);
    let window = state.document.settings.window;
    let dragged = response.interact_pointer_pos().filter(|_| response.dragged());
    let share = if response.double_clicked() {
        Some(Share(None))
    } else {
        dragged.map(|place| border.share_at(place))
    };
    response.on_hover_cursor(cursor).on_hover_text(TIP);
    let changed = share.map_or(window, |share| split.with(window, share));
    on_change(commands, &window, changed, SettingsCommand::Window);
}

/// Maximises `part` after a double click on its title, which is all that is in `ui`.
pub fn title(ui: &Ui, part: WindowPart, commands: &mut Commands) {
    let name = match part {
        WindowPart::Pane(number) => format!("Title of view {}", number + 1),
        WindowPart::Map => "Title of the map".to_owned(),
        WindowPart::Plots => "Title of the plots".to_owned(),
    };
    let response = ui.interact(ui.max_rect(), ui.scope_id().with(part), Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::TitleBar, true, &name));
    if response.double_clicked() {
        commands.push(WindowCommand::ToggleMaximised(part).into());
    }
    response.on_hover_text("Double-click to show this part alone, or all parts again.");
}

/// Three dots, and all along it a line while it is held.
fn paint(ui: &Ui, Border { split, rect, .. }: Border, is_held: bool) {
    let visuals = ui.visuals();
    let along = if split.is_upright() { Vec2::Y } else { Vec2::X };
    let colour =
        if is_held { visuals.strong_text_color() } else { visuals.widgets.noninteractive.fg_stroke.color };
    if is_held {
        let half = 0.5 * rect.size() * vec2(along.x, along.y);
        let ends = [rect.center() - half, rect.center() + half];
        ui.painter().line_segment(ends, Stroke::new(1.0, visuals.widgets.hovered.bg_stroke.color));
    }
    for step in [-1.0, 0.0, 1.0] {
        ui.painter().circle_filled(rect.center() + step * DOT_STEP * along, DOT_RADIUS, colour);
    }
}
