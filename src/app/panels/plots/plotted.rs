//! The data of the plots.

use crate::app::curves::Curves;
use crate::app::examination::Examination;
use crate::app::fitting::Fitting;

/// The data that can be plotted.
#[derive(Clone, Copy)]
pub struct Plotted<'a> {
    /// Curves for the state's `plotted_keys`.
    pub curves: &'a [Curves],
    /// The fit of the selected one.
    pub fitting: &'a Fitting,
    /// Examination of the views' cost and error.
    pub examination: Option<&'a Examination>,
}
