//! How the user looks at the plots against T: parts they zoom into, two cursors, and curves that are pinned.

use super::clock;
use super::curves::{CurvesKey, Quantity};
use super::points::Point;
use super::state::State;
use crate::plot::{MOST_TICKS, widened};
use crate::settings::PlotTab;

/// Most curves that can be pinned: as many as there are dashes to tell them apart.
pub const MAX_PINS: usize = 4;

/// What is looked at of the plots, and what is kept in them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plotting {
    zooms: Vec<(Quantity, Ranges)>,
    cursors: Vec<f64>,
    pins: Vec<Pin>,
}

/// The part of a plot that is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ranges {
    /// First and last T.
    pub times: [f64; 2],
    /// Lowest and highest value, as plotted: logarithms of a quantity that is one.
    pub values: [f64; 2],
}

/// The curves of a point as it once moved and was seen, which stay while everything else changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pin {
    /// The point, with the number whose colour it has.
    pub point: Point,
    /// What its curves depend on, but for the range of T.
    pub key: CurvesKey,
}

/// Something that is asked of the plots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlotCommand {
    /// Look at a part of a plot, or at the whole.
    Look(Quantity, Option<Ranges>),
    /// Look at the whole of every plot.
    Whole,
    /// Set the first cursor at this T, or at the present one; then the second; then remove both.
    Cursor(Option<f64>),
    /// Keep the curves of the selected point, in place of the oldest where there are [`MAX_PINS`].
    Pin,
    /// Keep none.
    Unpin,
}

impl Plotting {
    /// The part of the plot of `quantity` that is looked at; `None` of the whole.
    #[must_use]
    pub fn zoom(&self, quantity: Quantity) -> Option<Ranges> {
        self.zooms.iter().find_map(|&(of, ranges)| (of == quantity).then_some(ranges))
    }

    /// T of the cursors, of which there are none, one or two.
    #[must_use]
    pub fn cursors(&self) -> &[f64] {
        &self.cursors
    }

    /// The curves that are kept, the oldest first.
    #[must_use]
    pub fn pins(&self) -> &[Pin] {
        &self.pins
    }

    /// Whether any plot shows a part only.
    #[must_use]
    pub const fn is_zoomed(&self) -> bool {
        !self.zooms.is_empty()
    }
}

/// What the plots of a tab show; nothing of those that do not plot against T.
#[must_use]
pub const fn quantities(tab: PlotTab) -> &'static [Quantity] {
    match tab {
        PlotTab::Disparity => &[Quantity::DeltaPhi, Quantity::DeltaTheta],
        PlotTab::Angles => &[Quantity::Phi, Quantity::Theta],
        PlotTab::Doppler => &[Quantity::LogDoppler],
        PlotTab::Stereo => &[Quantity::LogGain, Quantity::LogDistance],
        PlotTab::Fit | PlotTab::Accuracy => &[],
    }
}

impl State {
    /// Does what was asked of the plots.
    pub fn apply_to_plots(&mut self, command: PlotCommand) {
        let pin = Pin {
            point: *self.session.points.selected(),
            key: self.curve_key(self.session.points.selected()),
        };
        let now = self.session.time;
        let Plotting { zooms, cursors, pins } = &mut self.session.plotting;
        match command {
            PlotCommand::Look(quantity, ranges) => {
                zooms.retain(|(of, _)| *of != quantity);
                zooms.extend(ranges.map(|ranges| (quantity, ranges)));
            }
            PlotCommand::Whole => zooms.clear(),
            PlotCommand::Cursor(_) if cursors.len() == 2 => cursors.clear(),
            PlotCommand::Cursor(time) => cursors.push(clock::bounded(time.unwrap_or(now))),
            PlotCommand::Pin => {
                pins.retain(|kept| !is_same(kept, &pin));
                if pins.len() == MAX_PINS {
                    pins.remove(0);
                }
                pins.push(pin);
            }
            PlotCommand::Unpin => pins.clear(),
        }
    }

    /// What is plotted, the one plot for an audience included.
    #[must_use]
    pub fn plotted_quantities(&self) -> &'static [Quantity] {
        let all = quantities(self.settings.plots.plot);
        match (self.session.stage.is_presented(), all) {
            (false, all) => all,
            (true, [first, ..]) => std::slice::from_ref(first),
            (true, []) => &[Quantity::DeltaPhi],
        }
    }

    /// First and last T of the plot of `quantity`: those of the scrubber, widened to have round ticks, or of the part that is
    /// looked at.
    #[must_use]
    pub fn plotted_times(&self, quantity: Quantity) -> [f64; 2] {
        self.session.plotting.zoom(quantity).map_or_else(|| self.whole_times(), |zoom| zoom.times)
    }

    /// First and last T of a plot of which no part only is looked at.
    #[must_use]
    pub fn whole_times(&self) -> [f64; 2] {
        let unit = self.measures().time;
        let shown = self.time_range().map(|time| unit.shown(time));
        widened(false, shown, MOST_TICKS).map(|time| unit.in_scene(time))
    }

    /// What the curves of `point` in the plot of `quantity` depend on.
    #[must_use]
    pub fn plotted_key(&self, point: &Point, quantity: Quantity) -> CurvesKey {
        CurvesKey { range: self.plotted_times(quantity), ..self.curve_key(point) }
    }

    /// The same of a pinned one: where that is of the exact model, whatever the views show now.
    #[must_use]
    pub fn pinned_key(&self, pin: &Pin, quantity: Quantity) -> CurvesKey {
        let stereo = self.settings.plots.plot == PlotTab::Stereo;
        CurvesKey { range: self.plotted_times(quantity), published: false, stereo, ..pin.key }
    }

    /// What all curves that are plotted depend on, each once.
    #[must_use]
    pub fn plotted_keys(&self) -> Vec<CurvesKey> {
        let mut keys: Vec<CurvesKey> = Vec::new();
        for &quantity in self.plotted_quantities() {
            let points = self.session.points.all().iter().map(|point| self.plotted_key(point, quantity));
            let pins = self.session.plotting.pins.iter().map(|pin| self.pinned_key(pin, quantity));
            for key in points.chain(pins) {
                if !keys.contains(&key) {
                    keys.push(key);
                }
            }
        }
        keys
    }
}

/// Whether two pins have the same curves.
fn is_same(a: &Pin, b: &Pin) -> bool {
    let bare = |pin: &Pin| CurvesKey { range: [0.0; 2], published: false, stereo: false, ..pin.key };
    bare(a) == bare(b)
}
