//! What the keys do: one table, from which they act and from which the help is written.

use eframe::egui::{Context, Event, Key, Modifiers};
use relativity_render::Geometry;

use super::command::Command;

/// Keys that do one thing, or a pair that does opposite things.
pub struct Shortcut {
    /// As shown in the help.
    pub keys: &'static str,
    /// As shown in the help.
    pub action: &'static str,
    /// Each key and what it asks for.
    commands: &'static [Binding],
}

/// A key, and what it asks for with the modifiers held.
type Binding = (Key, fn(Modifiers) -> Command);

/// All of them.
pub const SHORTCUTS: [Shortcut; 19] = [
    Shortcut { keys: "Space", action: "play, pause", commands: &[(Key::Space, |_| Command::TogglePlaying)] },
    Shortcut {
        keys: "← →",
        action: "step in time (with shift, ten steps)",
        commands: &[
            (Key::ArrowLeft, |modifiers| Command::Step(-stride(modifiers))),
            (Key::ArrowRight, |modifiers| Command::Step(stride(modifiers))),
        ],
    },
    Shortcut {
        keys: "Home  End",
        action: "to the start, to the end",
        commands: &[(Key::Home, |_| Command::TimeInRange(0.0)), (Key::End, |_| Command::TimeInRange(1.0))],
    },
    Shortcut {
        keys: "↑ ↓",
        action: "faster, slower (with shift, ten steps)",
        commands: &[
            (Key::ArrowUp, |modifiers| Command::NudgeSpeed(stride(modifiers))),
            (Key::ArrowDown, |modifiers| Command::NudgeSpeed(-stride(modifiers))),
        ],
    },
    Shortcut {
        keys: "1",
        action: "as seen",
        commands: &[(Key::Num1, |_| Command::Geometry(Geometry::Seen))],
    },
    Shortcut {
        keys: "2",
        action: "contracted only",
        commands: &[(Key::Num2, |_| Command::Geometry(Geometry::Contracted))],
    },
    Shortcut {
        keys: "3",
        action: "at rest",
        commands: &[(Key::Num3, |_| Command::Geometry(Geometry::Rest))],
    },
    Shortcut {
        keys: "4",
        action: "one light cone for both eyes",
        commands: &[(Key::Num4, |_| Command::Geometry(Geometry::OneCone))],
    },
    Shortcut {
        keys: "F",
        action: "frame: the whole scene in the views",
        commands: &[(Key::F, |_| Command::Frame)],
    },
    Shortcut {
        keys: "L",
        action: "next layout of the two pictures (with shift, the one before)",
        commands: &[(Key::L, |modifiers| Command::NextLayout(if modifiers.shift { -1 } else { 1 }))],
    },
    Shortcut { keys: "X", action: "swap the eyes", commands: &[(Key::X, |_| Command::SwapEyes)] },
    Shortcut { keys: "M", action: "show or hide the map", commands: &[(Key::M, |_| Command::ToggleMap)] },
    Shortcut {
        keys: "G",
        action: "draw the map in the ground's or the bicycle's frame",
        commands: &[(Key::G, |_| Command::ToggleFrame)],
    },
    Shortcut {
        keys: "F11",
        action: "the whole screen",
        commands: &[(Key::F11, |_| Command::ToggleFullScreen)],
    },
    Shortcut {
        keys: "P",
        action: "present: large writing, and no controls",
        commands: &[(Key::P, |_| Command::TogglePresenting)],
    },
    Shortcut {
        keys: "W",
        action: "the views in a window of their own, for a projector",
        commands: &[(Key::W, |_| Command::ToggleProjector)],
    },
    Shortcut {
        keys: "PageUp  PageDown",
        action: "the preset before, the next one",
        commands: &[(Key::PageUp, |_| Command::ShowNext(-1)), (Key::PageDown, |_| Command::ShowNext(1))],
    },
    Shortcut {
        keys: "?  F1",
        action: "this help",
        commands: &[(Key::Questionmark, |_| Command::ToggleHelp), (Key::F1, |_| Command::ToggleHelp)],
    },
    Shortcut { keys: "Esc", action: "close, leave", commands: &[(Key::Escape, |_| Command::Close)] },
];

fn stride(modifiers: Modifiers) -> i32 {
    if modifiers.shift { 10 } else { 1 }
}

/// What the keys pressed since the last frame ask for; nothing while a widget has the keyboard.
pub fn asked(ctx: &Context) -> Vec<Command> {
    if ctx.egui_wants_keyboard_input() {
        return Vec::new();
    }
    ctx.input(|input| input.events.iter().filter_map(command).collect())
}

fn command(event: &Event) -> Option<Command> {
    let Event::Key { key, pressed: true, modifiers, .. } = event else { return None };
    if modifiers.command || modifiers.alt {
        return None;
    }
    let all = SHORTCUTS.iter().flat_map(|shortcut| shortcut.commands);
    all.filter(|(bound, _)| bound == key).map(|(_, command)| command(*modifiers)).next()
}
