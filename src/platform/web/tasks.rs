//! Tasks that the page's thread does between two frames.

use js_sys::Promise;
use wasm_bindgen_futures::JsFuture;

/// Runs `task` on the page's thread, after what runs there now.
pub fn spawn(task: impl Future<Output = ()> + 'static) {
    wasm_bindgen_futures::spawn_local(task);
}

/// Lets the page draw a frame and take events before the task goes on.
pub async fn pause() {
    sleep(0).await;
}

/// Has the task go on after this time.
pub async fn sleep(milliseconds: i32) {
    let promise = Promise::new(&mut |done, _| {
        if let Some(window) = web_sys::window() {
            // Without a window nobody waits.
            let _ = window.set_timeout_with_callback_and_timeout_and_arguments_0(&done, milliseconds);
        }
    });
    // It is never rejected.
    let _ = JsFuture::from(promise).await;
}
