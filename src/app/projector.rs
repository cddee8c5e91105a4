//! The projector's window: the views, while the controls stay on the lecturer's screen.

use eframe::egui::{Context, ViewportBuilder, ViewportCommand, ViewportId};

use super::command::Command;

/// What it is called among windows.
pub fn id() -> ViewportId {
    ViewportId::from_hash_of("projector")
}

/// How it opens: to be moved to the projector's screen, and made as large as that by F11.
pub fn window() -> ViewportBuilder {
    ViewportBuilder::default()
        .with_title("Gamow: views")
        .with_inner_size([1024.0, 520.0])
        .with_min_inner_size([240.0, 160.0])
}

/// Whether `command` is about this window alone, and then done: what it says of the whole screen is said of its own.
pub fn takes(ctx: &Context, command: &Command) -> bool {
    let is_full = ctx.input(|input| input.viewport().fullscreen).unwrap_or_default();
    let is_taken = match command {
        Command::ToggleFullScreen => true,
        Command::Close => is_full,
        _ => false,
    };
    if is_taken {
        ctx.send_viewport_cmd(ViewportCommand::Fullscreen(!is_full));
    }
    is_taken
}
