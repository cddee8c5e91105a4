//! Files in and out: CSV, PNG and EXR, and files written whole or not at all.

pub mod csv_in;
pub mod csv_out;
pub mod exr_file;
pub mod image_in;
pub mod png_file;
pub mod whole;
