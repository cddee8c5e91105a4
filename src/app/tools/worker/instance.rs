//! Work of one kind in another instance of the program, beside the page's thread.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::rc::{Rc, Weak};

use eframe::egui::Context;
use gamow_platform::web::instances::{Asked, Heard, Instance, answer, fail, listen};
use gamow_platform::web::page;

use super::page::Worker;
use super::steps::{Message, StepOutcome, Wanted, Work};

/// Work of one kind in an instance of its own, which is started for the first job; the label of a job comes
/// back with its result.
pub struct BackgroundWork<W: Work, L>(Rc<WorkExchange<W, L>>);

struct WorkExchange<W: Work, L> {
    ctx: Context,
    tools: W::Tools,
    place: RefCell<Workplace<W>>,
    labels: RefCell<VecDeque<(u64, L)>>,
    results: RefCell<VecDeque<(u64, W::Result)>>,
    newest: Cell<u64>,
    received: Cell<u64>,
    stopped: Cell<u64>,
}

/// A job with its number.
type Numbered<W> = (u64, <W as Work>::Base, <W as Work>::Job);

/// The place where the work is done.
enum Workplace<W: Work> {
    /// None yet: the first job has an instance started.
    Open,
    /// An instance that does not listen yet, and the newest job.
    Starting(Instance, Option<Numbered<W>>),
    /// An instance, and what jobs had in common when it was last sent.
    Apart(Instance, Option<W::Base>),
}

impl<W: Work, L: 'static> BackgroundWork<W, L> {
    /// Nothing is started yet. Each result is announced by a repaint. The place of the work makes tools of
    /// its own; these `tools` get its notes.
    pub fn new(ctx: &Context, tools: W::Tools) -> Self {
        Self(Rc::new(WorkExchange {
            ctx: ctx.clone(),
            tools,
            place: RefCell::new(Workplace::Open),
            labels: RefCell::default(),
            results: RefCell::default(),
            newest: Cell::new(0),
            received: Cell::new(0),
            stopped: Cell::new(0),
        }))
    }

    /// Does the job next, instead of what still waits.
    pub fn request(&self, label: L, base: W::Base, job: W::Job) {
        let shared = &self.0;
        let number = shared.newest.get() + 1;
        shared.newest.set(number);
        shared.labels.borrow_mut().push_back((number, label));
        let mut place = shared.place.borrow_mut();
        if let Workplace::Open = *place {
            *place = WorkExchange::begun(shared);
        }
        place.send((number, base, job));
    }

    /// Gives up what is running or waiting.
    pub fn stop(&self) {
        let shared = &self.0;
        shared.stopped.set(shared.newest.get());
        shared.labels.borrow_mut().clear();
        match &mut *shared.place.borrow_mut() {
            Workplace::Open => {}
            Workplace::Starting(_, waiting) => *waiting = None,
            Workplace::Apart(instance, _) => instance.stop(shared.newest.get()),
        }
    }

    /// Gives up what is running or waiting, even within a step: the instance ends, and the next job starts
    /// another.
    pub fn end(&self) {
        if self.is_pending() {
            self.stop();
            self.0.place.replace(Workplace::Open);
        }
    }

    /// Returns the newest result since the last call, with the label of its job.
    pub fn result(&self) -> Option<(L, W::Result)> {
        let shared = &self.0;
        let (number, result) = shared.results.borrow_mut().drain(..).last()?;
        shared.received.set(number);
        let mut labels = shared.labels.borrow_mut();
        while labels.front().is_some_and(|(first, _)| *first < number) {
            labels.pop_front();
        }
        let (_, label) = labels.pop_front_if(|(first, _)| *first == number)?;
        Some((label, result))
    }

    /// Whether the newest job's result has yet to be received.
    pub fn is_pending(&self) -> bool {
        self.0.newest.get() > self.0.received.get().max(self.0.stopped.get())
    }
}

impl<W: Work, L: 'static> WorkExchange<W, L> {
    /// Starts an instance; where the browser refuses, the page says so in place of the window.
    fn begun(shared: &Rc<Self>) -> Workplace<W> {
        let shared = Rc::downgrade(shared);
        let hear = move |heard| {
            if let Some(shared) = Weak::upgrade(&shared) {
                shared.hear(heard);
            }
        };
        let Some(instance) = Instance::start(W::NAME, hear) else {
            log::error!("the browser starts no worker for {}", W::NAME);
            page::show_defect();
            return Workplace::Open;
        };
        Workplace::Starting(instance, None)
    }

    /// Takes in a message of the instance.
    fn hear(&self, heard: Heard) {
        if let Heard::Note(note) = &heard {
            return W::take_note(&self.tools, note);
        }
        let place = std::mem::replace(&mut *self.place.borrow_mut(), Workplace::Open);
        let (mut place, waiting) = match (heard, place) {
            (Heard::Ready, Workplace::Starting(instance, waiting)) => {
                (Workplace::Apart(instance, None), waiting)
            }
            (Heard::Failed(problem), place) => {
                log::error!("{problem}");
                page::show_defect();
                (place, None)
            }
            (Heard::Result(number, bytes), place) => {
                match postcard::from_bytes(&bytes) {
                    Ok(result) => self.results.borrow_mut().push_back((number, result)),
                    Err(error) => log::error!("the result of {}: {error}", W::NAME),
                }
                (place, None)
            }
            (Heard::Ready | Heard::Note(_), place) => (place, None),
        };
        if let Some(waiting) = waiting {
            place.send(waiting);
        }
        self.place.replace(place);
        self.ctx.request_repaint();
    }
}

impl<W: Work> Workplace<W> {
    /// Has the job done next.
    fn send(&mut self, (number, base, job): Numbered<W>) {
        match self {
            Self::Open => {}
            Self::Starting(_, waiting) => *waiting = Some((number, base, job)),
            Self::Apart(instance, sent) => {
                let is_known = sent.as_ref() == Some(&base);
                let common = (!is_known).then(|| encoded(&base));
                if !instance.request(number, common.as_deref(), &encoded(&job)) {
                    log::error!("a job of {} could not be sent", W::NAME);
                }
                *sent = Some(base);
            }
        }
    }
}

/// Does the work of this kind in this instance, for the page.
pub fn serve<W: Work>() {
    let begin = |(number, base, job)| (number, W::begin(base, job));
    let mut tools = W::Tools::default();
    let step = move |(number, work): &mut (u64, W), wanted: &Wanted| {
        let StepOutcome::Last(result) = work.step(&mut tools, wanted) else { return StepOutcome::More };
        result.iter().for_each(|result| answer(*number, &encoded(result)));
        StepOutcome::Last(None)
    };
    let worker = Worker::new(begin, step);
    let mut known = None;
    listen(move |asked| match asked {
        Asked::Stop => worker.stop(),
        Asked::Job(number, base, job) => {
            let base = base.map_or(Ok(known.take()), |base| postcard::from_bytes(&base).map(Some));
            match (base, postcard::from_bytes(&job)) {
                (Ok(Some(base)), Ok(job)) => {
                    known = Some(W::Base::clone(&base));
                    worker.request((number, base, job));
                }
                _ => fail(&format!("a job of {} cannot be read", W::NAME)),
            }
        }
    });
}

/// The bytes of a message.
fn encoded(message: &impl Message) -> Vec<u8> {
    postcard::to_stdvec(message).expect("messages are numbers, texts and lists whose lengths are known")
}
