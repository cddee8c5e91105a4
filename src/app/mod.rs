//! The window: two eyes' views of a scene that rides past, controls, a timeline, plots and a readout.
//!
//! Seven rows, each of which imports only from those below it:
//!
//! | | |
//! |---|---|
//! | `shell` | the application: opens the window and runs it from frame to frame |
//! | `panels` | the parts of the window: they read the state and push commands |
//! | `views` | what the panes of the eyes show, and where they lie |
//! | `commands` | the verbs: everything that a user can do to the state |
//! | `widgets` | what panels are made of, and the theme |
//! | `state` | the values: everything that the panels read |
//! | `tools` | clocks, workers, painting: they know nothing of the state |

pub mod commands;
mod panels;
pub mod shell;
pub mod state;
pub mod tools;
pub mod views;
mod widgets;
