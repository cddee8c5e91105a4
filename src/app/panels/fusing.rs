//! How hard the two views are to fuse, in words, and the button above the views that brings the eyes together.

use eframe::egui::{Align, Rect, Ui};

use super::Asks;
use crate::app::command::Command;
use crate::app::state::State;
use crate::app::widgets::strip_button;
use crate::comfort::{Comfort, Verdict};
use crate::figures;

/// Returns the verdict on a pair of views, and the angles behind it.
pub fn verdict(comfort: Comfort) -> String {
    let across = figures::fixed(comfort.range.to_degrees(), 2);
    let down = figures::fixed(60.0 * comfort.vertical.to_degrees(), 0);
    format!("{}: {across}° across, {down}′ up", word(comfort.verdict()))
}

const fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Comfortable => "comfortable",
        Verdict::Tiring => "tiring",
        Verdict::TooMuch => "too much",
    }
}

/// Shows at the right of the title strip `strip` that the views are hard to fuse, in a layout that is made to be fused;
/// a click brings the eyes together.
pub fn offer(ui: &mut Ui, state: &State, strip: Rect, asks: &mut Asks) {
    let settings = &state.settings;
    if !settings.picture.layout.is_fused() || settings.is_comparing() {
        return;
    }
    let Some(comfort) = state.comfort(settings.motion.d) else { return };
    let verdict = comfort.verdict();
    if verdict == Verdict::Comfortable {
        return;
    }
    let text = format!("{} to fuse: narrow d", word(verdict));
    let tip = format!(
        "Brings the eyes together until these views are comfortable to fuse. Measured disparities shrink with d.\n\
         Now: {}.",
        self::verdict(comfort)
    );
    if strip_button(ui, strip, Align::Max, &text).on_hover_text(tip).clicked() {
        asks.push(Command::Narrow);
    }
}
