//! The moment in a sentence, below the views.

use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{self, Align2, FontId, Ui, text::LayoutJob};

use crate::app::state::State;
use crate::app::widgets::theme;
use crate::caption::beginnings;

/// Sizes of the writing, points: the first at which the sentence fits is taken, else the last, and as much of
/// its end is left out as has no room.
const SIZES: [f32; 2] = [theme::BODY_SIZE, theme::SMALL_SIZE];

/// Greatest magnification relative to other large writing.
const LARGEST: f32 = 1.5;

/// Writes it into all of the room there is.
pub fn show(ui: &mut Ui, state: &State) {
    let (rect, sentence) = (ui.max_rect(), state.moment().sentence());
    let colour = ui.visuals().strong_text_color();
    // A number is not parted from its unit, nor from what it is the value of.
    let tied = sentence.replace(" nm", "\u{a0}nm").replace(" = ", "\u{a0}=\u{a0}");
    let scale = theme::text_scale(ui.style());
    let laid_out = |size: f32| {
        let job = LayoutJob::simple(tied.clone(), FontId::proportional(size), colour, rect.width());
        ui.painter().layout_job(job)
    };
    // For an audience it is as large as it fits, down to the usual.
    let largest = if scale > 1.0 { LARGEST } else { 1.0 };
    let sizes =
        [largest, 1.0].into_iter().flat_map(|part| SIZES.map(|size| part * scale * size)).chain(SIZES);
    let fitting = sizes.map(laid_out).find(|galley| galley.size().y <= rect.height());
    let is_whole = fitting.is_some();
    let galley = fitting.unwrap_or_else(|| {
        let cut = |text: &String| {
            let font = FontId::proportional(theme::SMALL_SIZE);
            ui.painter().layout(text.clone(), font, colour, rect.width())
        };
        let shorter = beginnings(&tied);
        let fitting = shorter.iter().rev().map(cut).find(|galley| galley.size().y <= rect.height());
        fitting.unwrap_or_else(|| cut(&shorter[0]))
    });
    let place = Align2::LEFT_CENTER.anchor_size(rect.left_center(), galley.size());
    ui.painter().galley(place.min, galley, colour);
    let response = ui.interact(rect, ui.scope_id().with("sentence"), egui::Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Label, true, &sentence));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_live(live(state)));
    if !is_whole {
        response.on_hover_text(&sentence);
    }
}

/// Returns whether assistive technology reads out the sentence when it changes: while time runs it changes
/// faster than that.
pub const fn live(state: &State) -> Live {
    if state.scratch.playing { Live::Off } else { Live::Polite }
}
