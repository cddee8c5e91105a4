//! What the plots are made of.

use crate::app::curves::Curves;
use crate::app::examination::Examination;
use crate::app::fitting::Fitting;

/// What there is to plot.
#[derive(Clone, Copy)]
pub struct Plotted<'a> {
    /// Those that the state's `plotted_keys` asks for.
    pub curves: &'a [Curves],
    /// The fit of the selected one.
    pub fitting: &'a Fitting,
    /// What the views cost, and how far they are off.
    pub examination: Option<&'a Examination>,
}
