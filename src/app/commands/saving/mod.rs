//! Saving and copying. Whatever takes time is made in the background.

mod copied;
mod progress;
pub(in crate::app) mod work;

use std::io::Write as _;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::clock::Instant;
use gamow_platform::files;

pub use self::progress::Progress;
use self::progress::{Reporter, lock};
pub use self::work::SavingStep;
use self::work::{SaveJob, SaveOutcome};
use crate::app::state::State;
use crate::app::state::files::purpose::Product;
use crate::app::tools::worker::BackgroundWork;
use crate::files::whole::write_whole;
use crate::lesson::Animated;
use crate::studio::film::{FRAMES_PER_SECOND, Written, frame_count};

impl State {
    /// Returns the range of T of a film, and the number of its frames: T runs through its range once, as fast
    /// as in playback; in ten seconds through the passage just shown, which is that of a lesson's reveal.
    #[must_use]
    pub fn film(&self, product: Product) -> ([f64; 2], u32) {
        let range = self.time_range();
        if product == Product::TenSeconds {
            return (self.revealed_passage().unwrap_or(range), TEN_SECONDS * u32::from(FRAMES_PER_SECOND));
        }
        (range, frame_count(range, self.document.settings.playback.rate))
    }

    /// Returns from which T to which the reveal of the present step of a lesson ran; `None` before it, and
    /// where something else changed.
    fn revealed_passage(&self) -> Option<[f64; 2]> {
        let course = self.course().filter(|course| course.is_revealed())?;
        let Animated::Time(to) = course.step()?.reveal.as_ref()?.animation?.to else { return None };
        let before = course.lesson().settings(course.place().step, false, &self.lesson_base()).ok()?;
        before.time.map(|from| [from.min(to), from.max(to)]).filter(|[from, to]| from < to)
    }
}

/// Seconds of the film of a passage.
const TEN_SECONDS: u32 = 10;

/// Greatest number of frames of a film.
pub const MOST_FRAMES: u32 = 5000;

/// Time within which something is made without an announcement.
const GRACE: Duration = Duration::from_millis(300);

/// The saver, with what works for it.
#[derive(Default)]
pub struct Saver {
    worker: Option<BackgroundWork<SavingStep, ()>>,
    written: Arc<Mutex<Written>>,
    underway: Option<PendingSave>,
}

struct PendingSave {
    name: String,
    frames: u32,
    since: Instant,
}

impl Saver {
    /// Begins a `job`, which makes `frames` pictures of the product called `name`.
    pub(in crate::app) fn begin(&mut self, ctx: &Context, job: SaveJob, name: String, frames: u32) {
        *lock(&self.written) = Written::default();
        self.underway = Some(PendingSave { name, frames, since: Instant::now() });
        let worker = || BackgroundWork::new(ctx, Reporter::new(ctx, &self.written));
        self.worker.get_or_insert_with(worker).request((), files::given(), job);
    }

    /// Takes the finished product, once.
    pub(in crate::app) fn made(&mut self) -> Option<SaveOutcome> {
        let ((), (made, files)) = self.worker.as_ref()?.result()?;
        let failure = files.iter().find_map(|(path, bytes)| {
            let error = write_whole(path, |file| Ok(file.write_all(bytes)?)).err()?;
            Some(SaveOutcome::Nothing(path.clone(), format!("{error:#}")))
        });
        self.underway = None;
        Some(failure.unwrap_or(made))
    }

    /// Gives up what is being made; whether there was anything.
    pub(in crate::app) fn stop(&mut self) -> bool {
        self.worker.iter().for_each(BackgroundWork::end);
        self.underway.take().is_some()
    }

    /// Whether something is being made.
    #[must_use]
    pub const fn is_busy(&self) -> bool {
        self.underway.is_some()
    }

    /// Returns the progress, if it takes long enough to be shown.
    #[must_use]
    pub fn progress(&self, ctx: &Context) -> Option<Progress<'_>> {
        let underway = self.underway.as_ref()?;
        let rest = GRACE.saturating_sub(underway.since.elapsed());
        if !rest.is_zero() {
            ctx.request_repaint_after(rest);
            return None;
        }
        let (name, frames) = (&underway.name, underway.frames);
        Some(Progress { name, written: *lock(&self.written), frames })
    }
}
