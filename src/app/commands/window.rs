//! The window itself: what lies over it, and what of the screen it takes.

use crate::app::state::measuring::angle_ruler::AngleRuler;
use crate::app::state::overlay::Overlay;
use crate::app::state::stage::WindowPart;
use crate::app::state::{Scratch, Session, State};

/// A command about the window itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WindowCommand {
    /// Shows or hides an overlay.
    Toggle(Overlay),
    /// Takes the whole screen, or leaves it.
    ToggleFullScreen,
    /// Starts or ends the presentation to an audience.
    TogglePresenting,
    /// Shows the views and a lesson's words in a window for a projector, too, or no longer.
    ToggleProjector,
    /// Has the window as the screen of a stereoscope, or no longer.
    ToggleStereoscope,
    /// Has a part alone in the window, or all others again.
    ToggleMaximised(WindowPart),
    /// Closes the message.
    CloseNotice,
    /// Closes what is on top, else leaves what the window was made.
    Close,
}

impl State {
    /// Performs a command about the window itself.
    pub(super) fn perform_window(&mut self, command: WindowCommand) {
        let stage = &mut self.session.stage;
        match command {
            WindowCommand::Toggle(overlay) => self.toggle(overlay),
            WindowCommand::ToggleFullScreen => stage.full_screen = !stage.full_screen,
            WindowCommand::TogglePresenting => stage.toggle_presenting(),
            WindowCommand::ToggleProjector => stage.projector = !stage.projector,
            WindowCommand::ToggleStereoscope => stage.toggle_stereoscope(),
            WindowCommand::ToggleMaximised(part) => stage.toggle_maximised(part),
            WindowCommand::CloseNotice => self.scratch.notice = None,
            WindowCommand::Close => self.close(),
        }
    }

    fn toggle(&mut self, overlay: Overlay) {
        self.session.overlay = Some(overlay).filter(|_| self.session.overlay != Some(overlay));
    }

    fn close(&mut self) {
        let Scratch { notice, chooser, angle_ruler, .. } = &mut self.scratch;
        let Session { overlay, stage, .. } = &mut self.session;
        if *overlay == Some(Overlay::Palette) {
            *overlay = None;
        } else if chooser.is_some() {
            *chooser = None;
        } else if notice.is_some() {
            *notice = None;
        } else if let Some(shown) = *overlay {
            *overlay = shown.below();
        } else if *angle_ruler != AngleRuler::Off {
            *angle_ruler = AngleRuler::Off;
        } else {
            stage.leave();
        }
    }
}
