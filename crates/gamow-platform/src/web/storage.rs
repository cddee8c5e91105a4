//! Texts that a browser keeps for a page from one visit to the next.

use std::io;

/// Returns the text called `name`; `None` if there is none, or if the browser keeps nothing for this page.
#[must_use]
pub fn read(name: &str) -> Option<String> {
    storage()?.get_item(name).ok()?
}

/// Keeps `text` under `name`.
///
/// # Errors
/// A browser that keeps nothing for this page, or no more.
pub fn write(name: &str, text: &str) -> io::Result<()> {
    let refused = || io::Error::other("the browser keeps no data of this page");
    storage().ok_or_else(refused)?.set_item(name, text).map_err(|_| refused())
}

/// Removes the text called `name`.
pub fn remove(name: &str) {
    if let Some(storage) = storage() {
        let _ = storage.remove_item(name);
    }
}

fn storage() -> Option<web_sys::Storage> {
    web_sys::window()?.local_storage().ok()?
}
