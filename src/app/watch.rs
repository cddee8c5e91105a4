//! Notices when files change on disk.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Weak};
use std::time::Duration;

use eframe::egui::Context;

use crate::platform::{files, threads};

/// How often they are looked at.
const INTERVAL: Duration = Duration::from_secs(1);

/// A thread that looks at files about once a second; it ends with this. Only a change is announced by a repaint.
#[derive(Debug)]
pub struct Watch {
    paths: Vec<PathBuf>,
    changed: Receiver<PathBuf>,
    _alive: Arc<()>,
}

impl Watch {
    /// One that looks at `paths`.
    #[must_use]
    pub fn new(ctx: Context, paths: Vec<PathBuf>) -> Self {
        let (sender, changed) = channel();
        let alive = Arc::new(());
        let (watched, is_wanted) = (stamped(&paths), Arc::downgrade(&alive));
        threads::spawn(move || look(&ctx, watched, &sender, &is_wanted));
        Self { paths, changed, _alive: alive }
    }

    /// What it looks at.
    #[must_use]
    pub fn paths(&self) -> &[PathBuf] {
        &self.paths
    }

    /// The files that have changed since this was last asked.
    #[must_use]
    pub fn changed(&self) -> Vec<PathBuf> {
        let mut changed: Vec<_> = self.changed.try_iter().collect();
        changed.sort();
        changed.dedup();
        changed
    }
}

/// A file with what tells that it has changed.
type Stamped = (PathBuf, Option<files::Stamp>);

fn stamped(paths: &[PathBuf]) -> Vec<Stamped> {
    paths.iter().map(|path| (path.clone(), files::stamp(path))).collect()
}

fn look(ctx: &Context, mut watched: Vec<Stamped>, changed: &Sender<PathBuf>, is_wanted: &Weak<()>) {
    loop {
        threads::sleep(INTERVAL);
        if is_wanted.strong_count() == 0 {
            return;
        }
        for (path, known) in &mut watched {
            // While an editor replaces it, it may be gone for a moment.
            let Some(now) = files::stamp(path) else { continue };
            if *known != Some(now) {
                *known = Some(now);
                if changed.send(path.clone()).is_err() {
                    return;
                }
                ctx.request_repaint();
            }
        }
    }
}
