//! The button above views that are hard to fuse, which brings the eyes together.

use eframe::egui::{Align, Rect, Ui};

use super::{Commands, OnClick as _};
use crate::app::commands::SettingsCommand;
use crate::app::state::State;
use crate::app::widgets::strip_button;
use crate::comfort::ComfortVerdict;

/// Shows at the right of the title strip `strip` that the views are hard to fuse, in a layout that is made to
/// be fused; a click brings the eyes together.
pub fn offer(ui: &mut Ui, state: &State, strip: Rect, commands: &mut Commands) {
    let settings = &state.document.settings;
    if !settings.picture.layout.is_fused() || settings.is_comparing() {
        return;
    }
    let Some(comfort) = state.comfort(settings.motion.d) else { return };
    let verdict = comfort.verdict();
    if verdict == ComfortVerdict::Comfortable {
        return;
    }
    let text = format!("{} to fuse: narrow d", verdict.word());
    let tip = format!(
        "Brings the eyes together until these views are comfortable to fuse. Measured disparities shrink with d.\n\
         Now: {}.",
        comfort.words()
    );
    strip_button(ui, strip, Align::Max, &text).on_hover_text(tip).on_click(commands, SettingsCommand::Narrow);
}
