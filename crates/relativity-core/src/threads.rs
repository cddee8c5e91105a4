//! Threads: the one module through which this project computes on several.
//!
//! They are rayon's. Where a platform has none (`wasm32-unknown-unknown`), rayon falls back to a pool that consists
//! of the calling thread, so that the same code runs there, one task after the other. No result depends on the
//! number of threads.

pub use rayon::{current_num_threads, join, prelude};
