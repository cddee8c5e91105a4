//! Answers of a device on whether it has refused something: there at once, but in a browser only after the
//! page's present work.

use std::fmt;
use std::pin::Pin;
use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Context, Poll, Waker};

type Awaited = Pin<Box<dyn Future<Output = Option<wgpu::Error>> + Send>>;

/// The answers that a device still owes.
#[derive(Clone, Default)]
pub struct PendingReadbacks(Arc<Mutex<Vec<Awaited>>>);

impl fmt::Debug for PendingReadbacks {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Answers")
    }
}

impl PendingReadbacks {
    /// Returns the first refusal in answer `to` these questions and to earlier ones, as far as it is there.
    pub fn to(
        &self,
        questions: impl IntoIterator<Item = impl Future<Output = Option<wgpu::Error>> + Send + 'static>,
    ) -> Option<wgpu::Error> {
        let mut awaited = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        awaited.extend(questions.into_iter().map(|question| Box::pin(question) as Awaited));
        let mut refusal = None;
        awaited.retain_mut(|answer| match answer.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Pending => true,
            Poll::Ready(answer) => {
                refusal = refusal.take().or(answer);
                false
            }
        });
        refusal
    }
}
