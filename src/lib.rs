//! Gamow: the window and the headless commands over `relativity-core` and `relativity-render`.
#![cfg_attr(
    not(test),
    warn(clippy::disallowed_methods, clippy::disallowed_types, clippy::print_stdout, clippy::print_stderr)
)]
#![cfg_attr(
    not(all(feature = "desktop", feature = "window")),
    expect(dead_code, reason = "some of it only the commands use, and some only the window")
)]
#![cfg_attr(not(feature = "window"), expect(unused_imports, reason = "some of it only the window uses"))]

#[cfg(all(not(feature = "desktop"), not(target_arch = "wasm32")))]
compile_error!(
    "without the feature `desktop` gamow is the library of a page, for the target wasm32-unknown-unknown"
);

pub mod accuracy;
#[cfg(feature = "window")]
pub mod app;
pub mod caption;
#[cfg(all(feature = "desktop", feature = "window"))]
pub mod cli;
pub mod columns;
pub mod comfort;
#[cfg(feature = "desktop")]
pub mod commands;
pub mod estimate;
pub mod eye;
mod eye_colours;
pub mod files;
pub mod flags;
pub mod formula;
pub mod lesson;
pub mod map;
mod markup;
mod number_text;
mod plot;
pub mod quantity;
pub mod scene;
pub mod settings;
pub mod similar;
pub mod studio;
mod time_range;
pub mod units;
