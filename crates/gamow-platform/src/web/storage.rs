//! Texts that a browser keeps for a page from one visit to the next. It keeps them for an origin, whose pages
//! are told apart by their paths.

use std::io;

/// Returns the text called `name`; `None` if there is none, or if the browser keeps nothing for this page.
#[must_use]
pub fn read(name: &str) -> Option<String> {
    storage()?.get_item(&key(name)?).ok()?
}

/// Keeps `text` under `name`.
///
/// # Errors
/// A browser that keeps nothing for this page, or no more.
pub fn write(name: &str, text: &str) -> io::Result<()> {
    let refused = || io::Error::other("the browser keeps no data of this page");
    let key = key(name).ok_or_else(refused)?;
    storage().ok_or_else(refused)?.set_item(&key, text).map_err(|_| refused())
}

/// Returns the names of all texts.
#[must_use]
pub fn names() -> Vec<String> {
    let Some((storage, own)) = storage().zip(key("")) else { return Vec::new() };
    let count = storage.length().unwrap_or_default();
    let keys = (0..count).filter_map(|number| storage.key(number).ok()?);
    keys.filter_map(|key| key.strip_prefix(&own).map(str::to_owned)).collect()
}

/// Removes the text called `name`.
pub fn remove(name: &str) {
    if let Some((storage, key)) = storage().zip(key(name)) {
        let _ = storage.remove_item(&key);
    }
}

/// The key under which the text called `name` is kept: after the page's folder.
fn key(name: &str) -> Option<String> {
    let path = web_sys::window()?.location().pathname().ok()?;
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    Some(format!("{folder}/:{name}"))
}

fn storage() -> Option<web_sys::Storage> {
    web_sys::window()?.local_storage().ok()?
}
