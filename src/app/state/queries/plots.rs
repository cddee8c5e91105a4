//! The plots against T: the quantities, the ranges of T, and the keys of the curves.

use relativity_core::Model;

use crate::app::state::State;
use crate::app::state::plots::curves::CurvesKey;
use crate::app::state::plots::look::{Pin, quantities};
use crate::app::state::points::Point;
use crate::plot::{MOST_TICKS, widened};
use crate::quantity::Quantity;
use crate::settings::PlotTab;

impl State {
    /// The quantities that are plotted: only the first for an audience, and among few controls.
    #[must_use]
    pub fn plotted_quantities(&self) -> &'static [Quantity] {
        let all = quantities(&self.document.settings.plots);
        let shows_all = !self.session.stage.is_presented() && !self.document.settings.window.simple;
        match (shows_all, all) {
            (true, all) => all,
            (false, [first, ..]) => std::slice::from_ref(first),
            (false, []) if self.document.settings.plots.plot == PlotTab::Light => &[],
            (false, []) => &[Quantity::DeltaPhi],
        }
    }

    /// First and last T of the plot of `quantity`: those of the scrubber, widened to have round ticks, or of
    /// the part that is looked at.
    #[must_use]
    pub fn plotted_times(&self, quantity: Quantity) -> [f64; 2] {
        self.scratch.plotting.zoom(quantity).map_or_else(|| self.whole_times(), |zoom| zoom.times)
    }

    /// Returns the first and last T of a plot that shows everything.
    #[must_use]
    pub fn whole_times(&self) -> [f64; 2] {
        let unit = self.measures().time;
        let shown = self.time_range().map(|time| unit.shown(time));
        widened(false, shown, MOST_TICKS).map(|time| unit.in_scene(time))
    }

    /// Returns the key of the curves of `point` in the plot of `quantity`.
    #[must_use]
    pub fn plotted_key(&self, point: &Point, quantity: Quantity) -> CurvesKey {
        let point = self.seen_point(point);
        let published = self.document.settings.plots.published && !matches!(point.model, Model::Published(_));
        CurvesKey { point, quantity, range: self.plotted_times(quantity), published }
    }

    /// Returns the key of a pinned curve, which keeps its model whatever the views show now.
    #[must_use]
    pub fn pinned_key(&self, pin: &Pin, quantity: Quantity) -> CurvesKey {
        CurvesKey { point: pin.seen.clone(), quantity, range: self.plotted_times(quantity), published: false }
    }

    /// Returns the keys of all curves that are plotted, each once.
    #[must_use]
    pub fn plotted_keys(&self) -> Vec<CurvesKey> {
        let mut keys: Vec<CurvesKey> = Vec::new();
        for &quantity in self.plotted_quantities() {
            let points = self.document.points.all().iter().map(|point| self.plotted_key(point, quantity));
            let pins = self.scratch.plotting.pins.iter().map(|pin| self.pinned_key(pin, quantity));
            for key in points.chain(pins) {
                if !keys.contains(&key) {
                    keys.push(key);
                }
            }
        }
        keys
    }
}
