//! The plots against T: another part of them, cursors and pins.

use crate::app::state::State;
use crate::app::state::plots::look::{Pin, PlotCommand};
use crate::app::tools::clock;

impl State {
    /// Performs a command of the plots.
    pub(super) fn perform_plots(&mut self, command: PlotCommand) {
        let (point, now) = (*self.document.points.selected(), self.document.time);
        let pin = Pin { point, seen: self.seen_point(&point) };
        let plotting = &mut self.scratch.plotting;
        match command {
            PlotCommand::Look(quantity, ranges) => plotting.look(quantity, ranges),
            PlotCommand::Whole => plotting.zooms.clear(),
            PlotCommand::Cursor(time) => plotting.put_cursor(clock::bounded(time.unwrap_or(now))),
            PlotCommand::Pin => plotting.pin(pin),
            PlotCommand::Unpin => plotting.pins.clear(),
        }
    }
}
