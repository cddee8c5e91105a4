//! What a user does with the mouse, the keyboard and an aid for accessibility: frames with these events.

use eframe::egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, TouchPhase, Vec2,
};
use egui_kittest::Harness;
use gamow::app::shell::App;

pub type Window = Harness<'static, App>;

/// A frame with all of these `events`.
pub fn frame(window: &mut Window, events: impl IntoIterator<Item = Event>) {
    window.input_mut().events.extend(events);
    window.step();
}

/// Holds these keys from now on.
fn hold(window: &mut Window, modifiers: Modifiers) {
    window.input_mut().events.push(Event::ModifiersChanged(modifiers));
}

pub fn press(window: &mut Window, key: Key, modifiers: Modifiers) {
    hold(window, modifiers);
    let event = |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
    frame(window, [event(true), event(false), Event::ModifiersChanged(Modifiers::NONE)]);
}

pub fn write(window: &mut Window, text: &str) {
    frame(window, [Event::Text(text.to_owned())]);
}

fn button(pos: Pos2, button: PointerButton, pressed: bool, modifiers: Modifiers) -> Event {
    Event::PointerButton { pos, button, pressed, modifiers }
}

pub fn click(window: &mut Window, place: Pos2, with: PointerButton, modifiers: Modifiers, times: usize) {
    hold(window, modifiers);
    for _ in 0..times {
        frame(window, [Event::PointerMoved(place), button(place, with, true, modifiers)]);
        frame(window, [button(place, with, false, modifiers)]);
    }
    hold(window, Modifiers::NONE);
}

pub fn drag(window: &mut Window, places: &[Pos2], with: PointerButton, modifiers: Modifiers) {
    let [first, .., last] = places else { return };
    hold(window, modifiers);
    frame(window, [Event::PointerMoved(*first), button(*first, with, true, modifiers)]);
    for place in places {
        frame(window, [Event::PointerMoved(*place)]);
    }
    frame(window, [button(*last, with, false, modifiers)]);
    hold(window, Modifiers::NONE);
}

pub fn turn_wheel(window: &mut Window, place: Pos2, delta: Vec2, modifiers: Modifiers) {
    hold(window, modifiers);
    let (unit, source) = (MouseWheelUnit::Point, MouseWheelSource::Wheel);
    frame(
        window,
        [
            Event::PointerMoved(place),
            Event::MouseWheel { source, unit, delta, phase: TouchPhase::Move, modifiers },
        ],
    );
    hold(window, Modifiers::NONE);
}
