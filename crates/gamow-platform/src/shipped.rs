//! Files that come with the program: within it, or beside the page that it is in, which fetches one when it
//! is first asked for, so that nobody waits for them before the first picture.

#[cfg(target_arch = "wasm32")]
use crate::web::page;

/// A file that comes with the program; [`shipped_file!`](crate::shipped_file) makes one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShippedFile {
    /// Path of the file below the folder of the program's sources, which is its path below that of the page.
    pub place: &'static str,
    /// Bytes of a file that is within the program; a file beside a page has none here.
    #[doc(hidden)]
    pub within: &'static [u8],
}

impl ShippedFile {
    /// Returns the bytes of the file; `None` while they come, and for ever if they cannot. `then` is called
    /// once those have come that were not there.
    #[cfg(not(target_arch = "wasm32"))]
    #[must_use]
    pub fn bytes(&self, _then: impl FnOnce() + 'static) -> Option<&'static [u8]> {
        Some(self.within)
    }

    /// Returns the bytes of the file; `None` while they come, and for ever if they cannot. `then` is called
    /// once those have come that were not there.
    #[cfg(target_arch = "wasm32")]
    #[must_use]
    pub fn bytes(&self, then: impl FnOnce() + 'static) -> Option<&'static [u8]> {
        page::fetched(self.place, then)
    }
}

/// The [`ShippedFile`](crate::shipped::ShippedFile) at a place below the folder of the calling crate, which
/// is that of the sources. It is within the program, but for that in a page.
#[macro_export]
macro_rules! shipped_file {
    ($($place:expr),+) => {{
        #[cfg(not(target_arch = "wasm32"))]
        const WITHIN: &[u8] = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/", $($place),+));
        #[cfg(target_arch = "wasm32")]
        const WITHIN: &[u8] = &[];
        $crate::shipped::ShippedFile { place: concat!($($place),+), within: WITHIN }
    }};
}
