//! The jobs of an instance beside the page, done in steps between which it takes messages: of several jobs
//! the newest.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use gamow_platform::clock::Instant;
use gamow_platform::web::tasks;

use super::steps::{StepOutcome, Wanted};

/// Time for the steps of a job between two looks at messages.
const SLICE: Duration = Duration::from_millis(12);

/// A worker that does its jobs in steps.
pub struct Worker<J>(Rc<WorkerState<J>>);

struct WorkerState<J> {
    waiting: RefCell<Option<(u64, J)>>,
    newest: Arc<AtomicU64>,
    stopped: Arc<AtomicU64>,
    run: RefCell<Box<dyn FnMut(J) -> StepByStep>>,
    is_running: Cell<bool>,
}

/// A job that was begun: its next step.
type StepByStep = Box<dyn FnMut(&Wanted) -> StepOutcome<()>>;

impl<J: 'static> Worker<J> {
    /// Begins jobs by `begin` and does them in steps, between which the instance takes messages.
    pub fn new<S: 'static>(
        mut begin: impl FnMut(J) -> S + 'static,
        step: impl FnMut(&mut S, &Wanted) -> StepOutcome<()> + 'static,
    ) -> Self {
        let step = Rc::new(RefCell::new(step));
        let run = move |job| -> StepByStep {
            let (step, mut begun) = (Rc::clone(&step), begin(job));
            Box::new(move |wanted| (step.borrow_mut())(&mut begun, wanted))
        };
        Self(Rc::new(WorkerState {
            waiting: RefCell::new(None),
            newest: Arc::default(),
            stopped: Arc::default(),
            run: RefCell::new(Box::new(run)),
            is_running: Cell::new(false),
        }))
    }

    /// Does `job` next, instead of what still waits.
    pub fn request(&self, job: J) {
        let number = self.0.newest.fetch_add(1, Ordering::Relaxed) + 1;
        self.0.waiting.replace(Some((number, job)));
        if !self.0.is_running.replace(true) {
            tasks::spawn(Rc::clone(&self.0).work_off());
        }
    }

    /// Gives up what is running or waiting.
    pub fn stop(&self) {
        self.0.stopped.store(self.0.newest.load(Ordering::Relaxed), Ordering::Relaxed);
    }
}

impl<J> WorkerState<J> {
    /// Does what waits, until nothing does.
    async fn work_off(self: Rc<Self>) {
        loop {
            tasks::pause().await;
            let waiting = self.waiting.take();
            let Some((number, job)) = waiting else { break };
            let wanted = Wanted::new(number, Arc::clone(&self.newest), Arc::clone(&self.stopped));
            if wanted.holds() {
                let begun = (self.run.borrow_mut())(job);
                Self::do_job(begun, &wanted).await;
            }
        }
        self.is_running.set(false);
    }

    async fn do_job(mut step: StepByStep, wanted: &Wanted) {
        let mut slice = Instant::now();
        while wanted.holds() && matches!(step(wanted), StepOutcome::More) {
            if slice.elapsed() >= SLICE {
                tasks::pause().await;
                slice = Instant::now();
            }
        }
    }
}
