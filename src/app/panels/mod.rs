//! The parts of the window, one file each. Each reads the state and asks for commands; none calls
//! another.

pub mod accuracy;
mod accuracy_table;
mod axes;
pub mod bar;
pub mod controls;
pub mod corrected;
pub mod fit;
mod fit_plots;
mod fit_table;
mod frontier;
pub mod help;
mod icons;
pub mod light;
pub mod plots;
pub mod readout;
pub mod speed;
mod split;
pub mod timeline;
pub mod views;
mod widgets;

use super::command::Command;

/// What a panel asks for while it is shown.
pub type Asks = Vec<Command>;
