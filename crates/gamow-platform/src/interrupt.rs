//! Interrupts (Ctrl-C), and requests to end: handled in a program that says so, and left to the host of a
//! library, such as Python.

use std::any::Any;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Once, OnceLock};

/// Exit status after an interrupt, the same as in shells.
const INTERRUPTED: i32 = 130;

/// Effect of an interrupt: it ends the program; or the first one is noted, and the next ends it.
const ENDS: u8 = 0;
const IS_NOTED: u8 = 1;
const WAS_NOTED: u8 = 2;
static STATE: AtomicU8 = AtomicU8::new(ENDS);

/// Whether this process is a program of ours, whose interrupts are handled here.
static IS_OURS: AtomicBool = AtomicBool::new(false);

/// Says that this process is a program of ours. Without it no handler is ever installed.
pub fn handle() {
    IS_OURS.store(true, Ordering::SeqCst);
}

type Before = Box<dyn Fn() -> Box<dyn Any> + Send + Sync>;
static BEFORE: OnceLock<Before> = OnceLock::new();

/// Ends the program when it is interrupted, after `before`; what that gives is held until the end. Only the
/// first call has an effect; where interrupts cannot be caught, or are left to a host, they do as ever.
pub fn end_after<T: 'static>(before: impl Fn() -> T + Send + Sync + 'static) {
    BEFORE.get_or_init(|| Box::new(move || Box::new(before())));
    catch();
}

fn catch() {
    static HANDLER: Once = Once::new();
    if !IS_OURS.load(Ordering::SeqCst) {
        return;
    }
    HANDLER.call_once(|| {
        let end = || {
            let noted = STATE.compare_exchange(IS_NOTED, WAS_NOTED, Ordering::SeqCst, Ordering::SeqCst);
            if noted.is_err() {
                let _held = BEFORE.get().map(|before| before());
                std::process::exit(INTERRUPTED);
            }
        };
        drop(ctrlc::set_handler(end));
    });
}

/// While it is there, the first interrupt is noted, so that work can be ended with what is known. The second
/// ends the program.
#[derive(Debug)]
pub struct Noted(());

impl Noted {
    /// Begins to note them.
    #[must_use]
    pub fn new() -> Self {
        STATE.store(IS_NOTED, Ordering::SeqCst);
        catch();
        Self(())
    }

    /// Whether there was one.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        STATE.load(Ordering::SeqCst) == WAS_NOTED
    }
}

impl Default for Noted {
    fn default() -> Self {
        Self::new()
    }
}

impl Drop for Noted {
    fn drop(&mut self) {
        STATE.store(ENDS, Ordering::SeqCst);
    }
}
