//! Background work: jobs in steps, each for as long as it is wanted.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use gamow_platform::clock::Instant;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Time after which a job is given up for a newer one. A shorter one is finished, so that
/// the view follows while a control is dragged.
const PATIENCE: Duration = Duration::from_millis(250);

/// Whether a job is still wanted.
pub struct Wanted {
    number: u64,
    started: Instant,
    newest: Arc<AtomicU64>,
    stopped: Arc<AtomicU64>,
}

impl Wanted {
    /// Returns the job of this `number`, wanted until the numbers of the `newest` and of the last that was
    /// `stopped` say otherwise.
    pub fn new(number: u64, newest: Arc<AtomicU64>, stopped: Arc<AtomicU64>) -> Self {
        Self { number, started: Instant::now(), newest, stopped }
    }

    /// False once the job was stopped, or takes long while a newer one waits.
    #[must_use]
    pub fn holds(&self) -> bool {
        let is_newest = self.number == self.newest.load(Ordering::Relaxed);
        let goes_on = self.number > self.stopped.load(Ordering::Relaxed);
        goes_on && (is_newest || self.started.elapsed() <= PATIENCE)
    }
}

/// The outcome of a step of a job.
pub enum StepOutcome<R> {
    /// There are further steps.
    More,
    /// The last step, with the result, or without if it was stopped.
    Last(Option<R>),
}

impl<R> StepOutcome<R> {
    /// Has `make` turn the result into another.
    pub fn map<T>(self, make: impl FnOnce(R) -> T) -> StepOutcome<T> {
        match self {
            Self::More => StepOutcome::More,
            Self::Last(result) => StepOutcome::Last(result.map(make)),
        }
    }
}

/// A value that can be sent to another instance of the program.
pub trait Message: Serialize + DeserializeOwned + Send + 'static {}

impl<T: Serialize + DeserializeOwned + Send + 'static> Message for T {}

/// Work of one kind, whose jobs and results are values alone: another thread can do it, or another instance
/// of the program.
pub trait Work: Sized + 'static {
    /// Name of the kind.
    const NAME: &'static str;
    /// The part that many jobs have in common, and that is large.
    type Base: Message + Clone + PartialEq;
    /// The rest of a job.
    type Job: Message;
    /// The result of a job.
    type Result: Message;
    /// Tools for all jobs, such as the graphics device; another instance of the program makes its own.
    type Tools: Default + 'static;

    /// Prepares the first step of a job.
    fn begin(base: Self::Base, job: Self::Job) -> Self;

    /// Takes in a note about a job from the instance that does it; the `tools` are those of the asking
    /// instance.
    fn take_note(_tools: &Self::Tools, _note: &[u8]) {}

    /// Does the next step.
    fn step(&mut self, tools: &mut Self::Tools, wanted: &Wanted) -> StepOutcome<Self::Result>;
}

/// Returns the value as another instance of the program reads it.
#[cfg(test)]
pub fn sent<T: Message>(value: &T) -> T {
    let bytes = postcard::to_stdvec(value).expect("it can be written");
    postcard::from_bytes(&bytes).expect("what is written can be read")
}
