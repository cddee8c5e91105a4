//! Being interrupted (Ctrl-C), or told to end.

use std::sync::Once;

/// Exit status after an interrupt, as shells have it.
const INTERRUPTED: i32 = 130;

/// Ends the program when it is interrupted, after `before`; what that gives is held until the end. Only the first call has
/// an effect; where interrupts cannot be caught, they end the program as ever.
pub fn end_after<T>(before: impl Fn() -> T + Send + 'static) {
    static HANDLER: Once = Once::new();
    HANDLER.call_once(|| {
        let end = move || {
            let _held = before();
            std::process::exit(INTERRUPTED);
        };
        drop(ctrlc::set_handler(end));
    });
}
