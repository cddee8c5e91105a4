//! The commands that need no window, one file each, and what they share: the columns they write
//! (`columns`), the CSV they read and write (`csv_in`, `csv_out`), files written whole (`output`) and when a point passes
//! (`passage`).

pub mod accuracy;
pub mod columns;
mod csv_in;
mod csv_out;
pub mod curve;
pub mod eval;
pub mod fit;
pub mod image_in;
pub mod measure;
pub mod output;
pub mod paper;
mod passage;
mod plot;
pub mod rectify;
pub mod render;
