//! The platform: everything that the system provides, each thing in one module, which decides what a platform
//! lacks: the clock, files, locks, threads, interrupts, being ended, limits, what names of files mean, the
//! environment, the standard streams, a terminal, how much memory a file may ask for, what its user asks of
//! all programs, files that come with the program, and messages to another instance of the program.
//!
//! With the feature `desktop` it is an operating system's, without it a browser's; both have the same names.
#![cfg_attr(
    not(test),
    warn(clippy::disallowed_methods, clippy::disallowed_types, clippy::print_stdout, clippy::print_stderr)
)]

#[cfg(all(not(feature = "desktop"), not(target_arch = "wasm32")))]
compile_error!(
    "without the feature `desktop` the platform is a browser, for the target wasm32-unknown-unknown"
);

pub mod clock;
#[cfg(feature = "desktop")]
pub mod closed;
pub mod environment;
pub mod files;
#[cfg(feature = "desktop")]
pub mod interrupt;
#[cfg(feature = "desktop")]
pub mod last_word;
#[cfg(feature = "desktop")]
pub mod limits;
#[cfg(feature = "desktop")]
pub mod locks;
pub mod messages;
pub mod names;
#[cfg(feature = "desktop")]
pub mod progress;
pub mod shared;
pub mod shipped;
pub mod sizes;
#[cfg(feature = "desktop")]
pub mod threads;
#[cfg(not(feature = "desktop"))]
pub mod web;
pub mod wishes;

#[cfg(not(feature = "desktop"))]
pub use web::{instances::note, locks, threads};

/// Sends a note on the job under way to another instance of the program; a desktop has one.
#[cfg(feature = "desktop")]
pub const fn note(_: &[u8]) {}
