//! The commands that need no window, one file each.

pub mod eval;
