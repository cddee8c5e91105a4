//! Links that open the program with something: in a page its address, else one with a scheme of its own.

/// Returns the link with these `pairs` of a name and its value: `gamow:?beta=0.9`.
#[cfg(feature = "desktop")]
#[must_use]
pub fn link_to(pairs: &str) -> String {
    crate::settings::link_of_pairs(pairs)
}

/// Returns what is done with a link, in two words.
#[cfg(feature = "desktop")]
#[must_use]
pub const fn copying() -> &'static str {
    COPYING
}

/// Returns what is done with a link, in two words: a phone shares it.
#[cfg(not(feature = "desktop"))]
#[must_use]
pub fn copying() -> &'static str {
    if gamow_platform::web::page::shares_links() { "Share link" } else { COPYING }
}

const COPYING: &str = "Copy link";

/// Returns the address of this page with these `pairs` of a name and its value.
#[cfg(not(feature = "desktop"))]
#[must_use]
pub fn link_to(pairs: &str) -> String {
    format!("{}#{pairs}", gamow_platform::web::page::address())
}
