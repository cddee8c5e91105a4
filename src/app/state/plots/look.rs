//! The user's look at the plots against T: parts they zoom into, two cursors, and curves that are pinned.

use crate::app::state::plots::curves::SeenPoint;
use crate::app::state::points::Point;
use crate::quantity::Quantity;
use crate::settings::{PlotSettings, PlotTab};

/// Greatest number of pinned curves: as many as there are dashes to distinguish them.
pub const MAX_PINS: usize = 4;

/// The state of the plots: the parts that are shown, cursors and pins.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plotting {
    /// The plots of which a part is shown, and that.
    pub zooms: Vec<(Quantity, Ranges)>,
    /// T of the cursors, of which there are none, one or two.
    pub cursors: Vec<f64>,
    /// The curves that are kept, the oldest first.
    pub pins: Vec<Pin>,
}

/// The part of a plot that is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ranges {
    /// First and last T.
    pub times: [f64; 2],
    /// Lowest and highest value, as plotted: logarithms of a quantity that is one.
    pub values: [f64; 2],
}

/// The curves of a point as it once moved and was seen, which stay while everything else changes.
#[derive(Debug, Clone, PartialEq)]
pub struct Pin {
    /// The point, with the number whose colour the pin has.
    pub point: Point,
    /// The point as it moved and was seen.
    pub seen: SeenPoint,
}

/// A command of the plots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlotCommand {
    /// Looks at a part of a plot, or at the whole.
    Look(Quantity, Option<Ranges>),
    /// Looks at the whole of every plot.
    Whole,
    /// Sets the first cursor at this T, or at the present one; then the second; then removes both.
    Cursor(Option<f64>),
    /// Keeps the curves of the selected point, in place of the oldest where there are [`MAX_PINS`].
    Pin,
    /// Removes all pins.
    Unpin,
}

impl Plotting {
    /// Returns the part of the plot of `quantity` that is shown; `None` for the whole.
    #[must_use]
    pub fn zoom(&self, quantity: Quantity) -> Option<Ranges> {
        self.zooms.iter().find_map(|&(of, ranges)| (of == quantity).then_some(ranges))
    }

    /// Looks at a part of the plot of `quantity`, or at the whole.
    pub fn look(&mut self, quantity: Quantity, ranges: Option<Ranges>) {
        self.zooms.retain(|(of, _)| *of != quantity);
        self.zooms.extend(ranges.map(|ranges| (quantity, ranges)));
    }

    /// Sets the first cursor at this T; then the second; then removes both.
    pub fn put_cursor(&mut self, time: f64) {
        if self.cursors.len() == 2 {
            self.cursors.clear();
        } else {
            self.cursors.push(time);
        }
    }

    /// Keeps these curves, in place of the oldest where there are [`MAX_PINS`].
    pub fn pin(&mut self, pin: Pin) {
        self.pins.retain(|kept| kept.seen != pin.seen);
        if self.pins.len() == MAX_PINS {
            self.pins.remove(0);
        }
        self.pins.push(pin);
    }
}

/// Returns the quantities that the shown tab plots against T.
#[must_use]
pub fn quantities(plots: &PlotSettings) -> &'static [Quantity] {
    match plots.plot {
        PlotTab::Disparity if plots.is_conformal() => &Quantity::CONFORMAL_DISPARITIES,
        PlotTab::Disparity => &Quantity::DISPARITIES,
        PlotTab::Angles => &Quantity::ANGLE_PLOTS,
        PlotTab::Doppler => &Quantity::DOPPLER_PLOT,
        PlotTab::Stereo => &Quantity::STEREO_PLOTS,
        PlotTab::Light | PlotTab::Fit | PlotTab::Accuracy => &[],
    }
}
