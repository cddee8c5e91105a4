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

/// Returns the names of all texts.
#[must_use]
pub fn names() -> Vec<String> {
    let Some(storage) = storage() else { return Vec::new() };
    let count = storage.length().unwrap_or_default();
    (0..count).filter_map(|number| storage.key(number).ok()?).collect()
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
