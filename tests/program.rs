//! The tests of the whole program, but those of its window, which are in `ui`.

mod accuracy;
mod cli;
mod conformal;
mod documents;
mod framing;
mod layers;
mod lessons;
mod light;
mod notices;
mod render;
mod scenes;
mod state;
#[path = "../crates/relativity-render/tests/support/mod.rs"]
mod support;
