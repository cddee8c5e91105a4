//! The platform: everything that the system provides, each thing in one module, which decides what a platform lacks: the clock, files,
//! locks, threads, interrupts, being ended, limits, what names of files mean, the environment, the standard streams, a terminal, and how much memory a file may ask for.

pub mod clock;
pub mod closed;
pub mod environment;
pub mod files;
pub mod interrupt;
pub mod last_word;
pub mod limits;
pub mod locks;
pub mod messages;
pub mod names;
pub mod progress;
pub mod sizes;
pub mod threads;
