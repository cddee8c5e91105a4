//! Gamow: the window and the headless commands over `relativity-core` and `relativity-render`.

pub mod accuracy;
pub mod app;
pub mod cli;
pub mod headless;
pub mod scene;
