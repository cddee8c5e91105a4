//! The last word: a message where a system library ends the program, as that of X11 does: it calls `exit`
//! where its display is gone.
//!
//! The system's C library then drops what the calling thread alone has, and with that the last word. One that
//! does not (musl) leaves it unsaid.

use std::cell::Cell;
use std::marker::PhantomData;

/// The last action, and the exit status that it gives.
type LastAction = Box<dyn FnOnce() -> u8>;

thread_local!(static LAST: Last = const { Last(Cell::new(None)) });

/// The word of a thread.
struct Last(Cell<Option<LastAction>>);

impl Drop for Last {
    fn drop(&mut self) {
        if let Some(word) = self.0.take() {
            std::process::exit(word().into());
        }
    }
}

/// While it is there, its word is what is done last if something else ends the program from this thread.
#[derive(Debug)]
pub struct LastWord(PhantomData<*const ()>);

impl LastWord {
    /// Has `word` done then; the program ends with the status that it gives.
    #[must_use]
    pub fn new(word: impl FnOnce() -> u8 + 'static) -> Self {
        LAST.with(|last| last.0.set(Some(Box::new(word))));
        Self(PhantomData)
    }
}

impl Drop for LastWord {
    fn drop(&mut self) {
        LAST.with(|last| last.0.take());
    }
}
