//! Whether the window has the whole screen: what is wished for, and what the system has made of it.

use eframe::egui::{Context, ViewportCommand};

/// The full screen: the last request to the system, and whether it was fulfilled.
#[derive(Debug, Clone, Copy, Default)]
pub struct FullScreen {
    asked: Option<bool>,
    is_done: bool,
}

impl FullScreen {
    /// Asks the system for what is `wished`; what it is now: another than wished where the system itself has
    /// changed it, such as by a key of the desktop's.
    pub fn update(&mut self, ctx: &Context, wished: bool) -> bool {
        let actual = ctx.input(|input| input.viewport().fullscreen);
        if self.asked != Some(wished) {
            if actual.unwrap_or_default() != wished {
                ctx.send_viewport_cmd(ViewportCommand::Fullscreen(wished));
            }
            *self = Self { asked: Some(wished), is_done: false };
            return wished;
        }
        let Some(actual) = actual else { return wished };
        self.is_done |= actual == wished;
        if !self.is_done {
            return wished;
        }
        self.asked = Some(actual);
        actual
    }
}
