//! The shaders' sources, put together from `shaders/`.

/// A shader's source: files of `shaders/`, one after another. Many have some in common, which the program
/// holds once.
pub type Source = &'static [&'static str];

/// The [`Source`] of these files.
macro_rules! source {
    ($($file:literal),+) => {
        &[$(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/shaders/", $file, ".wgsl"))),+]
    };
}
pub(crate) use source;

/// The shader of the last pass.
pub const BACKDROP: Source = source!("frame", "passage", "tables", "street", "srgb", "backdrop");
/// Composes two eyes' pictures.
pub const COMPOSE: Source = source!("srgb", "compose");
