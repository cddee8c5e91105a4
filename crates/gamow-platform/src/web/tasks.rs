//! Tasks that a page's thread does between two frames, or a worker's between two messages.

use js_sys::Promise;
use wasm_bindgen::JsCast as _;
use wasm_bindgen_futures::JsFuture;
use web_sys::WorkerGlobalScope;

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
        // Where there is no page, a worker waits. Neither refuses.
        let _ = match web_sys::window() {
            Some(window) => window.set_timeout_with_callback_and_timeout_and_arguments_0(&done, milliseconds),
            None => js_sys::global()
                .unchecked_into::<WorkerGlobalScope>()
                .set_timeout_with_callback_and_timeout_and_arguments_0(&done, milliseconds),
        };
    });
    // It is never rejected.
    let _ = JsFuture::from(promise).await;
}
