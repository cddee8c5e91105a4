//! Notices when files change on disk.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::{files, threads};

use crate::app::waker::{Waker, Woken};

/// Interval between two looks at the files.
const INTERVAL: Duration = Duration::from_secs(1);

/// A thread that looks at files about once a second. It ends at once with this, unless a disc keeps it: nothing waits for it.
/// Only a change is announced by a repaint.
#[derive(Debug)]
pub struct Watch {
    paths: Vec<PathBuf>,
    changed: Receiver<PathBuf>,
    _stop: Sender<()>,
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
        threads::spawn(move || look(&waker, watched, &sender, &stopped));
        Self { paths, changed, _stop: stop, _woken: woken }
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
