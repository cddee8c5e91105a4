//! Notices when files change on disk.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::clock::Instant;
use gamow_platform::files;
use gamow_platform::threads::{self, JoinHandle};

use crate::app::tools::waker::{Waker, Woken};

/// Interval between two looks at the files.
const INTERVAL: Duration = Duration::from_secs(1);

/// Longest time to wait for the watching thread to end. On a disc that hangs it takes longer, and is left
/// behind.
const PATIENCE: Duration = Duration::from_millis(200);

/// A thread that looks at files about once a second, and ends with this. Only a change is announced by a
/// repaint.
#[derive(Debug)]
pub struct Watch {
    paths: Vec<PathBuf>,
    changed: Receiver<PathBuf>,
    /// The thread, and the sender that ends it when dropped.
    running: Option<(Sender<()>, JoinHandle<()>)>,
    _woken: Woken,
}

impl Watch {
    /// Watches `paths`.
    #[must_use]
    pub fn new(ctx: Context, paths: Vec<PathBuf>) -> Self {
        let (sender, changed) = channel();
        let (stop, stopped) = channel();
        let woken = Woken::new(ctx);
        let (watched, waker) = (stamped(&paths), woken.waker());
        let thread = threads::spawn(move || look(&waker, watched, &sender, &stopped));
        Self { paths, changed, running: Some((stop, thread)), _woken: woken }
    }

    /// Returns the paths that are watched.
    #[must_use]
    pub fn paths(&self) -> &[PathBuf] {
        &self.paths
    }

    /// Returns the files that have changed since the last call.
    #[must_use]
    pub fn changed(&self) -> Vec<PathBuf> {
        let mut changed: Vec<_> = self.changed.try_iter().collect();
        changed.sort();
        changed.dedup();
        changed
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        if let Some((stop, thread)) = self.running.take() {
            drop(stop);
            join_at_end(thread, &self.changed, PATIENCE);
        }
    }
}

/// Joins the `thread` that holds the other end of `changed`, if it ends within this `patience`; returns
/// whether it did.
fn join_at_end(thread: JoinHandle<()>, changed: &Receiver<PathBuf>, patience: Duration) -> bool {
    let start = Instant::now();
    loop {
        match changed.recv_timeout(patience.saturating_sub(start.elapsed())) {
            Ok(_) => {}
            Err(RecvTimeoutError::Timeout) => return false,
            // It is at its end. A panic of it was reported when it happened.
            Err(RecvTimeoutError::Disconnected) => return thread.join().is_ok(),
        }
    }
}

/// A file with its stamp, which changes with it.
type Stamped = (PathBuf, Option<files::Stamp>);

fn stamped(paths: &[PathBuf]) -> Vec<Stamped> {
    paths.iter().map(|path| (path.clone(), files::stamp(path))).collect()
}

fn look(waker: &Waker, mut watched: Vec<Stamped>, changed: &Sender<PathBuf>, stopped: &Receiver<()>) {
    while stopped.recv_timeout(INTERVAL) == Err(RecvTimeoutError::Timeout) {
        for (path, known) in &mut watched {
            // While an editor replaces it, it may be gone for a moment.
            let Some(now) = files::stamp(path) else { continue };
            if *known != Some(now) {
                *known = Some(now);
                if changed.send(path.clone()).is_err() {
                    return;
                }
                waker.wake();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_thread_of_a_watch_ends_with_it() {
        let mut watch = Watch::new(Context::default(), vec![PathBuf::from("Cargo.toml")]);
        let (stop, thread) = watch.running.take().expect("it runs");
        drop(stop);
        // Without a limit that a busy machine could reach.
        assert!(join_at_end(thread, &watch.changed, Duration::from_mins(1)));
    }

    #[test]
    fn a_disc_that_hangs_keeps_nobody() {
        let (sender, changed) = channel();
        let (release, released) = channel::<()>();
        let thread = threads::spawn(move || {
            let _ = released.recv();
            drop(sender);
        });
        assert!(!join_at_end(thread, &changed, Duration::from_millis(10)));
        drop(release);
    }
}
