//! Gamow: the window and the headless commands over `relativity-core` and `relativity-render`.
#![cfg_attr(
    not(test),
    warn(clippy::disallowed_methods, clippy::disallowed_types, clippy::print_stdout, clippy::print_stderr)
)]

pub mod accuracy;
pub mod app;
pub mod caption;
pub mod cli;
pub mod columns;
pub mod comfort;
pub mod commands;
pub mod estimate;
mod eye_colours;
pub mod files;
pub mod flags;
pub mod formula;
pub mod lesson;
pub mod map;
mod markup;
mod number_text;
pub mod platform;
mod plot;
pub mod scene;
pub mod settings;
pub mod studio;
mod time_range;
pub mod units;
