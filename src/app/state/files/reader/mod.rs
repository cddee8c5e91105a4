//! Files read for the window, so that no frame waits for a slow disc or a long file: each by a thread of its
//! own, in a page scenes by another instance of the program.

mod errand;
#[cfg(not(feature = "desktop"))]
mod page;
mod thread;

use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::clock::Instant;

pub use self::errand::{Contents, Errand, ReadFile, ReadyScene, Use};
#[cfg(not(feature = "desktop"))]
use self::page::Place;
#[cfg(not(feature = "desktop"))]
pub use self::page::SceneReading;
#[cfg(feature = "desktop")]
use self::thread::Place;
use crate::app::tools::waker::Woken;

/// A file that is read sooner than this is not announced.
const GRACE: Duration = Duration::from_millis(300);

/// The files that are being read.
pub struct Reader {
    woken: Woken,
    place: Place,
    begun: u64,
    underway: Vec<PendingRead>,
}

struct PendingRead {
    number: u64,
    path: PathBuf,
    purpose: Use,
    since: Instant,
}

impl Reader {
    /// Creates a reader that requests a repaint after each file it has read.
    #[must_use]
    pub fn new(ctx: Context) -> Self {
        let place = Place::new(&ctx);
        Self { woken: Woken::new(ctx), place, begun: 0, underway: Vec::new() }
    }

    /// Begins `errand`. A file that is opened takes the place of one that is still being read to be opened,
    /// and a change of a file that of an earlier one.
    pub fn begin(&mut self, errand: Errand) {
        let Errand { ref path, purpose, .. } = errand;
        self.begun += 1;
        let replaces = |other: &PendingRead| {
            let is_renewed = other.purpose == purpose && other.path == *path;
            is_renewed || purpose.opens() && other.purpose.opens()
        };
        self.underway.retain(|other| !replaces(other));
        let number = self.begun;
        self.underway.push(PendingRead { number, path: path.clone(), purpose, since: Instant::now() });
        self.place.begin(number, errand);
    }

    /// Takes the files read since the last call, except those no longer wanted.
    pub fn finished(&mut self) -> Vec<ReadFile> {
        let mut finished = Vec::new();
        for (number, file) in self.place.finished() {
            if let Some(place) = self.underway.iter().position(|underway| underway.number == number) {
                self.underway.remove(place);
                finished.push(file);
            }
        }
        finished
    }

    /// Gives up what is being read to be opened.
    pub fn stop(&mut self) {
        self.place.stop();
        self.underway.retain(|underway| !underway.purpose.opens());
    }

    /// Whether something is being read.
    #[must_use]
    pub const fn is_busy(&self) -> bool {
        !self.underway.is_empty()
    }

    /// The file that is taking long to be opened.
    #[must_use]
    pub fn awaited(&self) -> Option<&Path> {
        let opened = self.underway.iter().find(|underway| underway.purpose.opens())?;
        let rest = GRACE.saturating_sub(opened.since.elapsed());
        if rest.is_zero() {
            return Some(&opened.path);
        }
        self.woken.wake_after(rest);
        None
    }
}
