//! The shaders' sources, put together from `shaders/`.

/// Files of `shaders/`, one after another.
macro_rules! source {
    ($($file:literal),+) => {
        concat!($(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/shaders/", $file, ".wgsl"))),+)
    };
}
pub(crate) use source;

/// The shader of the last pass.
pub const BACKDROP: &str = source!("frame", "passage", "tables", "street", "srgb", "backdrop");
/// Composes two eyes' pictures.
pub const COMPOSE: &str = source!("srgb", "compose");
