//! Waits until something has stayed the same for a while, so that slow work does not start during a drag.

use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::clock::Instant;

/// Time without a change after which something counts as still by default.
const REST: Duration = Duration::from_millis(150);

/// When something last changed.
#[derive(Debug)]
pub struct Debounce<K> {
    rest: Duration,
    last: Option<(K, Instant)>,
}

impl<K> Default for Debounce<K> {
    fn default() -> Self {
        Self::after(REST)
    }
}

impl<K> Debounce<K> {
    /// Counts something as still after this time without a change.
    pub const fn after(rest: Duration) -> Self {
        Self { rest, last: None }
    }
}

impl<K: Clone + PartialEq> Debounce<K> {
    /// Returns whether `key` is unchanged, and has been for a while. If not, a frame is requested in which
    /// it may be.
    pub fn is_still(&mut self, ctx: &Context, key: &K) -> bool {
        let since = match &self.last {
            Some((last, since)) if last == key => *since,
            _ => self.last.insert((key.clone(), Instant::now())).1,
        };
        let rest = self.rest.saturating_sub(since.elapsed());
        if !rest.is_zero() {
            ctx.request_repaint_after(rest);
        }
        rest.is_zero()
    }
}
