//! Turns of the eyes where their pictures are shown one after the other.

use std::time::Duration;

use eframe::egui::Context;

use crate::files::png::FRAME_SECONDS;

/// Returns the place in the layout of the eye whose turn it is: 0 or 1. The next frame that is requested is
/// that in which the other's begins, so that nothing is drawn in between.
pub fn turn(ctx: &Context) -> usize {
    let [numerator, denominator] = FRAME_SECONDS.map(f64::from);
    let turns = ctx.input(|input| input.time) * denominator / numerator;
    let left = (1.0 - turns.rem_euclid(1.0)) * numerator / denominator;
    // A little later, so that the time is beyond it then.
    ctx.request_repaint_after(Duration::from_secs_f64(left + 0.001));
    turns.rem_euclid(2.0) as usize
}
