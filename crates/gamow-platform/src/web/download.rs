//! Files that leave a page, as downloads, and files that are chosen in a dialog of the browser.

use std::cell::RefCell;
use std::io;
use std::rc::Rc;

use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, HtmlInputElement, Url};

use super::tasks;

/// Time after which a browser has surely read what it downloads, milliseconds.
const READ_MS: i32 = 60_000;

/// Hands `bytes` to the browser as a download called `name`, of this media type.
///
/// # Errors
/// A browser that refuses it.
pub fn deliver(name: &str, kind: &str, bytes: &[u8]) -> io::Result<()> {
    try_deliver(name, kind, bytes).map_err(|_| io::Error::other("the browser refused the download"))
}

fn try_deliver(name: &str, kind: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or(JsValue::NULL)?;
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    let blob = Blob::new_with_u8_array_sequence_and_options(&Array::of1(&Uint8Array::from(bytes)), &options)?;
    let address = Url::create_object_url_with_blob(&blob)?;
    let anchor: HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    anchor.set_href(&address);
    anchor.set_download(name);
    anchor.click();
    tasks::spawn(async move {
        tasks::sleep(READ_MS).await;
        let _ = Url::revoke_object_url(&address);
    });
    Ok(())
}

/// Asks for a file in a dialog of the browser; `chosen` gets its name and its bytes, or nothing if none was
/// chosen.
pub fn choose(chosen: impl FnOnce(Option<(String, Vec<u8>)>) + 'static) {
    let chosen = Rc::new(RefCell::new(Some(chosen)));
    let input = web_sys::window().and_then(|window| window.document());
    let input = input.and_then(|document| document.create_element("input").ok());
    let Some(input) = input.map(|element| element.unchecked_into::<HtmlInputElement>()) else { return };
    input.set_type("file");
    for event in ["change", "cancel"] {
        let (input_then, chosen) = (input.clone(), Rc::clone(&chosen));
        let closure = Closure::<dyn FnMut()>::new(move || {
            let file = input_then.files().and_then(|files| files.get(0));
            let Some(chosen) = chosen.borrow_mut().take() else { return };
            tasks::spawn(async move {
                let Some(file) = file else { return chosen(None) };
                let bytes = JsFuture::from(file.array_buffer()).await;
                chosen(bytes.ok().map(|bytes| (file.name(), Uint8Array::new(&bytes).to_vec())));
            });
        });
        let _ = input.add_event_listener_with_callback(event, closure.as_ref().unchecked_ref());
        // The browser calls it later, once at most.
        closure.forget();
    }
    input.click();
}
