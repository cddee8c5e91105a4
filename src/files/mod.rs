//! Files in and out: CSV, PNG, GIF, MP4, EXR and HTML, JPEG in, tables as JSON out, what is wrong with TOML,
//! what files say of how they were made, and files written whole or not at all.

pub mod csv_in;
pub mod csv_out;
pub mod exr;
pub mod gif;
pub mod html;
pub mod jpeg;
pub mod mp4;
pub mod png;
pub mod provenance;
pub mod syntax;
pub mod table_out;
pub(crate) mod utf16;
mod watched;
pub mod whole;
