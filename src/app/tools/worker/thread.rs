//! A thread of its own for work that would stop the window: of several jobs it does the newest.

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};

use eframe::egui::Context;
use gamow_platform::threads::{self, JoinHandle};

use super::steps::{StepOutcome, Wanted, Work};

/// The thread; it waits without using the processor, and ends with this.
pub struct Worker<J, R> {
    jobs: Sender<(u64, J)>,
    results: Receiver<(u64, R)>,
    received: Cell<u64>,
    newest: Arc<AtomicU64>,
    stopped: Arc<AtomicU64>,
    thread: Option<JoinHandle<()>>,
}

impl<J: Send + 'static, R: Send + 'static> Worker<J, R> {
    /// A thread that does jobs by `work`, which ends early with `None` when it is no longer wanted. Each
    /// result is announced by a repaint.
    pub fn new(ctx: Context, mut work: impl FnMut(J, &Wanted) -> Option<R> + Send + 'static) -> Self {
        let (jobs, todo) = channel::<(u64, J)>();
        let (done, results) = channel();
        let (newest, stopped) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicU64::new(0)));
        let (newest_asked, stopped_by) = (newest.clone(), stopped.clone());
        let thread = threads::spawn(move || {
            while let Ok(first) = todo.recv() {
                let (number, job) = todo.try_iter().last().unwrap_or(first);
                let (newest, stopped) = (newest_asked.clone(), stopped_by.clone());
                let wanted = Wanted::new(number, newest, stopped);
                let Some(result) = wanted.holds().then(|| work(job, &wanted)).flatten() else { continue };
                if done.send((number, result)).is_err() {
                    return;
                }
                ctx.request_repaint();
            }
        });
        Self { jobs, results, received: Cell::new(0), newest, stopped, thread: Some(thread) }
    }

    /// A thread that begins jobs by `begin` and does them in steps, until one is the last or the job is no
    /// longer wanted.
    pub fn in_steps<S>(
        ctx: Context,
        mut begin: impl FnMut(J) -> S + Send + 'static,
        mut step: impl FnMut(&mut S, &Wanted) -> StepOutcome<R> + Send + 'static,
    ) -> Self {
        Self::new(ctx, move |job, wanted| {
            let mut begun = begin(job);
            while wanted.holds() {
                if let StepOutcome::Last(result) = step(&mut begun, wanted) {
                    return result;
                }
            }
            None
        })
    }

    /// Does `job` next, instead of what still waits.
    pub fn request(&self, job: J) {
        let number = self.newest.fetch_add(1, Ordering::Relaxed) + 1;
        // The thread outlives this sender unless its work panicked; then there is nothing to wait for.
        let _ = self.jobs.send((number, job));
    }

    /// Gives up what is running or waiting.
    pub fn stop(&self) {
        self.stopped.store(self.newest.load(Ordering::Relaxed), Ordering::Relaxed);
    }

    /// Returns the newest result since the last call.
    pub fn result(&self) -> Option<R> {
        let (number, result) = self.results.try_iter().last()?;
        self.received.set(number);
        Some(result)
    }

    /// Whether the newest job's result has yet to be received. It will come: only a newer job or
    /// [`Self::stop`] ends a job without one.
    pub fn is_pending(&self) -> bool {
        let stopped = self.stopped.load(Ordering::Relaxed);
        self.newest.load(Ordering::Relaxed) > self.received.get().max(stopped)
    }
}

impl<J, R> Drop for Worker<J, R> {
    /// Gives up everything, and waits until the thread has ended: it may hold what must not outlive the
    /// window, such as the graphics device.
    fn drop(&mut self) {
        self.stopped.store(u64::MAX, Ordering::Relaxed);
        // Without a sender the thread has nothing left to wait for.
        self.jobs = channel().0;
        // An error means that its work panicked, which has been reported.
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

/// A job of work with its label.
type Labelled<W, L> = (L, <W as Work>::Base, <W as Work>::Job);

/// Work of one kind in a thread of its own; the label of a job comes back with its result.
pub struct BackgroundWork<W: Work, L>(Worker<Labelled<W, L>, (L, W::Result)>);

impl<W: Work<Tools: Send>, L: Clone + Send + 'static> BackgroundWork<W, L> {
    /// Starts the thread, which works with the `tools`. Each result is announced by a repaint.
    pub fn new(ctx: &Context, mut tools: W::Tools) -> Self {
        let begin = |(label, base, job)| (label, W::begin(base, job));
        let step = move |(label, work): &mut (L, W), wanted: &Wanted| {
            let label = label.clone();
            work.step(&mut tools, wanted).map(|result| (label, result))
        };
        Self(Worker::in_steps(ctx.clone(), begin, step))
    }

    /// Does the job next, instead of what still waits.
    pub fn request(&self, label: L, base: W::Base, job: W::Job) {
        self.0.request((label, base, job));
    }

    /// Gives up what is running or waiting.
    pub fn stop(&self) {
        self.0.stop();
    }

    /// Gives up what is running or waiting as soon as it can: where another instance of the program works,
    /// even within a step.
    pub fn end(&self) {
        self.stop();
    }

    /// Returns the newest result since the last call, with the label of its job.
    pub fn result(&self) -> Option<(L, W::Result)> {
        self.0.result()
    }

    /// Whether the newest job's result has yet to be received, as [`Worker::is_pending`].
    pub fn is_pending(&self) -> bool {
        self.0.is_pending()
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use gamow_platform::clock::Instant;

    use super::*;

    fn eventually<T>(mut value: impl FnMut() -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            if let Some(value) = value() {
                return value;
            }
            assert!(start.elapsed() < Duration::from_secs(20), "nothing came");
            threads::sleep(Duration::from_millis(1));
        }
    }

    #[test]
    fn the_newest_of_waiting_jobs_is_done() {
        let (go, gate) = channel::<()>();
        let worker = Worker::new(Context::default(), move |job: u32, _: &Wanted| {
            gate.recv().ok()?;
            Some(job)
        });
        assert!(!worker.is_pending());
        worker.request(1);
        // Once the first has begun, the others wait together.
        go.send(()).expect("the thread lives");
        assert!(worker.is_pending());
        assert_eq!(eventually(|| worker.result()), 1);
        assert!(!worker.is_pending());
        worker.request(2);
        worker.request(3);
        worker.request(4);
        for _ in 0..3 {
            go.send(()).expect("the thread lives");
        }
        let last = eventually(|| worker.result().filter(|&job| job == 4));
        assert_eq!(last, 4);
    }

    #[test]
    fn an_older_result_leaves_the_newest_pending() {
        let (begin, begun) = channel();
        let (go, gate) = channel::<()>();
        let worker = Worker::new(Context::default(), move |job: u32, _: &Wanted| {
            begin.send(()).ok()?;
            gate.recv().ok()?;
            Some(job)
        });
        worker.request(1);
        begun.recv().expect("the thread lives");
        worker.request(2);
        for (job, is_pending) in [(1, true), (2, false)] {
            go.send(()).expect("the thread lives");
            assert_eq!(eventually(|| worker.result()), job);
            assert_eq!(worker.is_pending(), is_pending);
        }
    }

    #[test]
    fn stopped_and_outdated_jobs_end() {
        let endless = |job: u32, wanted: &Wanted| {
            while job == 0 && wanted.holds() {
                threads::sleep(Duration::from_millis(1));
            }
            wanted.holds().then_some(job)
        };
        let worker = Worker::new(Context::default(), endless);
        worker.request(0);
        worker.request(7);
        assert_eq!(eventually(|| worker.result()), 7);
        worker.request(0);
        worker.stop();
        worker.request(8);
        assert_eq!(eventually(|| worker.result()), 8);
    }
}
