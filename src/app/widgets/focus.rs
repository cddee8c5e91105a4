//! Keyboard focus: the keys that the focused widget takes, and a ring that shows it.

use eframe::egui::{Context, Key, KeyboardShortcut, Memory, StrokeKind};

use crate::app::widgets::theme;

/// Whether what is focused takes the `keys` for itself: a field all that can be typed and what edits it, but
/// not the keys that go on and back, any other widget what presses and moves it.
pub fn takes(ctx: &Context, keys: KeyboardShortcut) -> bool {
    let KeyboardShortcut { modifiers, logical_key: key } = keys;
    if ctx.text_edit_focused() {
        let edits = matches!(key, Key::A | Key::C | Key::V | Key::X | Key::Y | Key::Z);
        let is_function = key.name().starts_with('F') && key.name().len() > 1;
        let is_apart = is_function || matches!(key, Key::PageUp | Key::PageDown);
        return if modifiers.command { edits } else { !is_apart };
    }
    let moves = matches!(
        key,
        Key::Space
            | Key::Enter
            | Key::ArrowLeft
            | Key::ArrowRight
            | Key::ArrowUp
            | Key::ArrowDown
            | Key::Home
            | Key::End
    );
    ctx.egui_wants_keyboard_input() && moves
}

/// Draws a ring around what is focused.
pub fn paint(ctx: &Context) {
    let Some(focused) = ctx.memory(Memory::focused) else { return };
    let Some(response) = ctx.read_response(focused) else { return };
    let painter = ctx.layer_painter(response.layer_id).with_clip_rect(response.interact_rect.expand(3.0));
    let stroke = theme::focus_stroke(&ctx.global_style().visuals);
    painter.rect_stroke(response.interact_rect.expand(1.0), 4.0, stroke, StrokeKind::Middle);
}
