//! The parts of the window, one file each. Each reads the state and asks for commands; none calls
//! another.

mod axes;
pub mod bar;
pub mod controls;
pub mod corrected;
pub mod fit;
mod fit_plots;
mod fit_table;
pub mod help;
mod icons;
pub mod light;
pub mod plots;
pub mod readout;
pub mod speed;
pub mod timeline;
pub mod views;
mod widgets;

use super::command::Command;

/// What a panel asks for while it is shown.
pub type Asks = Vec<Command>;
