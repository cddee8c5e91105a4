//! The data of the plots.

use crate::app::state::fitting::Fitting;
use crate::app::state::plots::curves::QuantityCurves;
use crate::app::views::examination::Examination;

/// The data that can be plotted.
#[derive(Clone, Copy)]
pub struct Plotted<'a> {
    /// Curves for the state's `plotted_keys`.
    pub curves: &'a [QuantityCurves],
    /// The fit of the selected one.
    pub fitting: &'a Fitting,
    /// Examination of the views' cost and error.
    pub examination: Option<&'a Examination>,
}
