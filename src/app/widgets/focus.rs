//! Keyboard focus: the keys that the focused widget takes, and a ring that shows it.

use eframe::egui::{Context, Event, Id, Key, KeyboardShortcut, Memory, Modifiers, Response, StrokeKind};

use crate::app::widgets::theme;

/// The letter that a number can contain: 1e-3.
const LETTER_OF_NUMBERS: Key = Key::E;

/// Notes that `response` is of a field in which words are typed; any other field is for a number.
pub fn note_words(response: &Response) {
    if response.has_focus() {
        response.ctx.data_mut(|data| data.insert_temp(words_id(), response.id));
    }
}

fn words_id() -> Id {
    Id::unique("field of words")
}

/// Whether `keys` are a letter that the focused field cannot contain, since a number is typed in it.
fn is_foreign(ctx: &Context, keys: KeyboardShortcut) -> bool {
    let takes_words = ctx.data(|data| data.get_temp(words_id())) == ctx.memory(Memory::focused);
    let KeyboardShortcut { modifiers, logical_key: key } = keys;
    let is_letter = (Key::A..=Key::Z).contains(&key) && key != LETTER_OF_NUMBERS;
    is_letter && !takes_words && matches!(modifiers, Modifiers::NONE | Modifiers::SHIFT)
}

/// Leaves the focused field for a number where `keys` are a letter that it cannot contain: the letter is a
/// command, and not typed.
pub fn leave_for(ctx: &Context, keys: KeyboardShortcut) {
    if !ctx.text_edit_focused() || !is_foreign(ctx, keys) {
        return;
    }
    if let Some(focused) = ctx.memory(Memory::focused) {
        ctx.memory_mut(|memory| memory.surrender_focus(focused));
    }
    let name = keys.logical_key.name();
    let is_it = |event: &Event| matches!(event, Event::Text(text) if text.eq_ignore_ascii_case(name));
    ctx.input_mut(|input| input.events.retain(|event| !is_it(event)));
}

/// Whether what is focused takes the `keys` for itself: a field all that can be typed in it and what edits
/// it, but not the keys that go on and back, any other widget what presses and moves it.
pub fn takes(ctx: &Context, keys: KeyboardShortcut) -> bool {
    let KeyboardShortcut { modifiers, logical_key: key } = keys;
    if ctx.text_edit_focused() {
        let edits = matches!(key, Key::A | Key::C | Key::V | Key::X | Key::Y | Key::Z);
        let is_function = key.name().starts_with('F') && key.name().len() > 1;
        let is_apart = is_function || matches!(key, Key::PageUp | Key::PageDown);
        return if modifiers.command { edits } else { !is_apart && !is_foreign(ctx, keys) };
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
