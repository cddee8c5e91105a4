//! The commands that need no window, one each. None imports another, and nothing in the window imports one.

pub mod accuracy;
pub mod completions;
pub mod curve;
pub mod eval;
pub mod fit;
pub mod lesson;
pub mod man;
pub mod measure;
pub mod paper;
pub mod rectify;
pub mod render;
