//! Further instances of the program beside the page's: dedicated workers, each with a thread and a memory of
//! its own.
//!
//! Messages are arrays. To an instance: the number of a job and the bytes of its two parts, of which the
//! first is left out where it is that of the job before; the number alone has it stop. From an instance:
//! nothing in it once it listens; the number of a job and the bytes of its result; bytes alone, a note on a
//! job; a text alone when it has failed.

use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{DedicatedWorkerGlobalScope, Event, MessageEvent, Worker, WorkerOptions, WorkerType};

/// The script that starts an instance.
const SCRIPT: &str = "./gamow-worker.js";

/// A message from an instance.
pub enum Heard {
    /// The instance is ready for jobs.
    Ready,
    /// The result of the job of this number.
    Result(u64, Vec<u8>),
    /// A note on the job under way.
    Note(Vec<u8>),
    /// The instance cannot go on, and why.
    Failed(String),
}

/// An instance, which ends when this is dropped.
pub struct Instance {
    worker: Worker,
    _heard: Closure<dyn FnMut(MessageEvent)>,
    _failed: Closure<dyn FnMut(Event)>,
}

impl Instance {
    /// Starts an instance for work of this `kind`; `None` where the browser refuses. Messages from it come to
    /// `hear`.
    pub fn start(kind: &str, hear: impl FnMut(Heard) + Clone + 'static) -> Option<Self> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        options.set_name(kind);
        let worker = Worker::new_with_options(SCRIPT, &options).ok()?;
        let mut hear_failure = hear.clone();
        let failed = Closure::<dyn FnMut(Event)>::new(move |_| {
            hear_failure(Heard::Failed("a worker could not be started, or has ended".to_owned()));
        });
        let mut hear = hear;
        let heard = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
            let parts: Array = event.data().unchecked_into();
            hear(match (parts.length(), parts.get(0).as_string()) {
                (0, _) => Heard::Ready,
                (_, Some(problem)) => Heard::Failed(problem),
                (1, None) => Heard::Note(bytes(&parts.get(0)).unwrap_or_default()),
                _ => Heard::Result(number(&parts), bytes(&parts.get(1)).unwrap_or_default()),
            });
        });
        worker.set_onmessage(Some(heard.as_ref().unchecked_ref()));
        worker.set_onerror(Some(failed.as_ref().unchecked_ref()));
        worker.post_message(&wasm_bindgen::module()).ok()?;
        Some(Self { worker, _heard: heard, _failed: failed })
    }

    /// Sends the job of this number; whether the browser does.
    pub fn request(&self, number: u64, base: Option<&[u8]>, job: &[u8]) -> bool {
        let base = base.map_or(JsValue::UNDEFINED, |base| Uint8Array::from(base).into());
        let parts = Array::of3(&JsValue::from(number as f64), &base, &Uint8Array::from(job));
        self.worker.post_message(&parts).is_ok()
    }

    /// Has the instance give up what it has been sent.
    pub fn stop(&self, number: u64) {
        // An instance that has ended does nothing anyway.
        let _ = self.worker.post_message(&Array::of1(&JsValue::from(number as f64)));
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        // What it has said already is heard by nobody.
        self.worker.set_onmessage(None);
        self.worker.set_onerror(None);
        self.worker.terminate();
    }
}

/// A message to this instance.
pub enum Asked {
    /// A job: its number, and its two parts.
    Job(u64, Option<Vec<u8>>, Vec<u8>),
    /// Gives up what was sent.
    Stop,
}

/// The kind of work that this instance of the program was started for; `None` in the page itself.
#[must_use]
pub fn own_kind() -> Option<String> {
    scope().map(|scope| scope.name())
}

/// Calls `hear` for each message to this instance from now on, and reports to the page that it is ready.
pub fn listen(mut hear: impl FnMut(Asked) + 'static) {
    let Some(scope) = scope() else { return };
    let heard = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let parts: Array = event.data().unchecked_into();
        hear(match bytes(&parts.get(2)) {
            Some(job) => Asked::Job(number(&parts), bytes(&parts.get(1)), job),
            None => Asked::Stop,
        });
    });
    scope.set_onmessage(Some(heard.as_ref().unchecked_ref()));
    // It lasts as long as the instance.
    heard.forget();
    let _ = scope.post_message(&Array::new());
}

/// Sends the result of the job of this number to the page.
pub fn answer(number: u64, result: &[u8]) {
    let Some(scope) = scope() else { return };
    let result = Uint8Array::from(result);
    let parts = Array::of2(&JsValue::from(number as f64), &result);
    let _ = scope.post_message_with_transfer(&parts, &Array::of1(&result.buffer()));
}

/// Sends a note on the job under way to the page; the page itself sends none.
pub fn note(note: &[u8]) {
    if let Some(scope) = scope() {
        let _ = scope.post_message(&Array::of1(&Uint8Array::from(note)));
    }
}

/// Tells the page that this instance cannot go on.
pub fn fail(problem: &str) {
    if let Some(scope) = scope() {
        let _ = scope.post_message(&Array::of1(&JsValue::from(problem)));
    }
}

fn scope() -> Option<DedicatedWorkerGlobalScope> {
    js_sys::global().dyn_into().ok()
}

fn number(parts: &Array) -> u64 {
    parts.get(0).as_f64().unwrap_or_default() as u64
}

fn bytes(part: &JsValue) -> Option<Vec<u8>> {
    part.dyn_ref().map(Uint8Array::to_vec)
}
