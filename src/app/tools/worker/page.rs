//! Work that would stop the window, done on the page's one thread between two frames: of several jobs the newest.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::clock::Instant;
use gamow_platform::web::tasks;

use super::steps::{StepOutcome, Wanted};

/// Time for the steps of a job between two frames.
const SLICE: Duration = Duration::from_millis(12);

/// A worker that does its jobs in steps between the frames of the page; dropping it ends them.
pub struct Worker<J, R> {
    shared: Rc<WorkerState<J, R>>,
    received: Cell<u64>,
}

struct WorkerState<J, R> {
    waiting: RefCell<Option<(u64, J)>>,
    results: RefCell<VecDeque<(u64, R)>>,
    newest: Arc<AtomicU64>,
    stopped: Arc<AtomicU64>,
    run: RefCell<Box<dyn FnMut(J) -> StepByStep<R>>>,
    is_running: Cell<bool>,
    ctx: Context,
}

/// A job that was begun: its next step.
type StepByStep<R> = Box<dyn FnMut(&Wanted) -> StepOutcome<R>>;

impl<J: 'static, R: 'static> Worker<J, R> {
    /// Does each job by `work` in one step.
    pub fn new(ctx: Context, mut work: impl FnMut(J, &Wanted) -> Option<R> + 'static) -> Self {
        let work = Rc::new(RefCell::new(move |job, wanted: &Wanted| work(job, wanted)));
        Self::running(ctx, move |job| {
            let (work, mut job) = (Rc::clone(&work), Some(job));
            Box::new(move |wanted| {
                StepOutcome::Last(job.take().and_then(|job| (work.borrow_mut())(job, wanted)))
            })
        })
    }

    /// Begins jobs by `begin` and does them in steps, between which the page draws frames and takes events.
    pub fn in_steps<S: 'static>(
        ctx: Context,
        mut begin: impl FnMut(J) -> S + 'static,
        step: impl FnMut(&mut S, &Wanted) -> StepOutcome<R> + 'static,
    ) -> Self {
        let step = Rc::new(RefCell::new(step));
        Self::running(ctx, move |job| {
            let (step, mut begun) = (Rc::clone(&step), begin(job));
            Box::new(move |wanted| (step.borrow_mut())(&mut begun, wanted))
        })
    }

    fn running(ctx: Context, run: impl FnMut(J) -> StepByStep<R> + 'static) -> Self {
        let shared = WorkerState {
            waiting: RefCell::new(None),
            results: RefCell::default(),
            newest: Arc::default(),
            stopped: Arc::default(),
            run: RefCell::new(Box::new(run)),
            is_running: Cell::new(false),
            ctx,
        };
        Self { shared: Rc::new(shared), received: Cell::new(0) }
    }

    /// Does `job` next, instead of what still waits.
    pub fn request(&self, job: J) {
        let number = self.shared.newest.fetch_add(1, Ordering::Relaxed) + 1;
        self.shared.waiting.replace(Some((number, job)));
        if !self.shared.is_running.replace(true) {
            tasks::spawn(Rc::clone(&self.shared).work_off());
        }
    }

    /// Gives up what is running or waiting.
    pub fn stop(&self) {
        self.shared.stopped.store(self.shared.newest.load(Ordering::Relaxed), Ordering::Relaxed);
    }

    /// Returns the newest result since the last call.
    pub fn result(&self) -> Option<R> {
        let (number, result) = self.shared.results.borrow_mut().drain(..).last()?;
        self.received.set(number);
        Some(result)
    }

    /// Whether the newest job's result has yet to be received.
    pub fn is_pending(&self) -> bool {
        let stopped = self.shared.stopped.load(Ordering::Relaxed);
        self.shared.newest.load(Ordering::Relaxed) > self.received.get().max(stopped)
    }
}

impl<J, R> WorkerState<J, R> {
    /// Does what waits, until nothing does.
    async fn work_off(self: Rc<Self>) {
        loop {
            tasks::pause().await;
            let waiting = self.waiting.take();
            let Some((number, job)) = waiting else { break };
            let wanted = Wanted::new(number, Arc::clone(&self.newest), Arc::clone(&self.stopped));
            if wanted.holds() {
                let begun = (self.run.borrow_mut())(job);
                self.do_job(begun, number, &wanted).await;
            }
        }
        self.is_running.set(false);
    }

    async fn do_job(&self, mut step: StepByStep<R>, number: u64, wanted: &Wanted) {
        let mut slice = Instant::now();
        while wanted.holds() {
            if let StepOutcome::Last(result) = step(wanted) {
                if let Some(result) = result {
                    self.results.borrow_mut().push_back((number, result));
                    self.ctx.request_repaint();
                }
                return;
            }
            if slice.elapsed() >= SLICE {
                tasks::pause().await;
                slice = Instant::now();
            }
        }
    }
}

impl<J, R> Drop for Worker<J, R> {
    fn drop(&mut self) {
        self.shared.stopped.store(u64::MAX, Ordering::Relaxed);
        self.shared.waiting.take();
    }
}
