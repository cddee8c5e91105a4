//! Errors of a graphics device: they are reported to whoever draws, and never end the program.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use wgpu::{DeviceLostReason, ErrorFilter};

use super::answers::PendingReadbacks;
use super::error::GpuError;

/// The errors of a device that nobody was waiting for, and its loss.
#[derive(Debug, Clone, Default)]
pub struct DeviceErrors(Arc<Mutex<Recorded>>);

#[derive(Debug, Default)]
struct Recorded {
    errors: u64,
    first: Option<String>,
    loss: Option<String>,
}

impl DeviceErrors {
    /// Collects the errors of `device` from now on, in place of ending the program; each error calls `wake`.
    pub fn collect(device: &wgpu::Device, wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        let collected = Self::default();
        let (recorded, wakes) = (collected.clone(), wake.clone());
        device.on_uncaptured_error(Arc::new(move |error| {
            recorded.note_error(&error);
            wakes();
        }));
        let recorded = collected.clone();
        device.set_device_lost_callback(move |reason, message| {
            recorded.note_loss(reason, &message);
            wake();
        });
        collected
    }

    /// Returns the number of errors so far.
    #[must_use]
    pub fn errors(&self) -> u64 {
        self.recorded().errors
    }

    /// The first of them.
    #[must_use]
    pub fn first(&self) -> Option<String> {
        self.recorded().first.clone()
    }

    /// Why the device is lost, if it is.
    #[must_use]
    pub fn loss(&self) -> Option<String> {
        self.recorded().loss.clone()
    }

    fn note_error(&self, error: &wgpu::Error) {
        let mut recorded = self.recorded();
        recorded.errors += 1;
        recorded.first.get_or_insert_with(|| in_one_line(&error.to_string()));
    }

    fn note_loss(&self, reason: DeviceLostReason, message: &str) {
        let message = in_one_line(message);
        let why = if message.is_empty() { format!("{reason:?}") } else { message };
        self.recorded().loss.get_or_insert(why);
    }

    fn recorded(&self) -> MutexGuard<'_, Recorded> {
        // A report is whole even if another thread ended while it made one.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Waits for what a device refuses of what this thread asks of it.
#[derive(Debug)]
pub struct ErrorScopes {
    /// The last that was opened is the first to be closed, or dropped.
    scopes: [wgpu::ErrorScopeGuard; 3],
    answers: PendingReadbacks,
}

impl ErrorScopes {
    pub(crate) fn open(device: &wgpu::Device, answers: PendingReadbacks) -> Self {
        let kinds = [ErrorFilter::Validation, ErrorFilter::OutOfMemory, ErrorFilter::Internal];
        let [validation, memory, internal] = kinds.map(|kind| device.push_error_scope(kind));
        Self { scopes: [internal, memory, validation], answers }
    }

    /// Ends the wait. A browser answers later: what it refuses here is an error where the next wait ends.
    ///
    /// # Errors
    ///
    /// The first that was refused.
    pub fn close(self) -> Result<(), GpuError> {
        let Self { scopes, answers } = self;
        let refused = answers.to(scopes.map(wgpu::ErrorScopeGuard::pop));
        match refused {
            None => Ok(()),
            Some(wgpu::Error::OutOfMemory { .. }) => Err(GpuError::OutOfMemory),
            Some(error) => Err(GpuError::Refused(in_one_line(&error.to_string()))),
        }
    }
}

fn in_one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}
