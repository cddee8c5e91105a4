//! Messages about errors of the graphics device, each shown once.

use eframe::egui::Context;
use eframe::egui_wgpu::RenderState;
use relativity_render::{DeviceErrors, GpuError};

use crate::app::tools::waker::Woken;
use crate::caption::capitalised;

/// The errors that the device has reported, and the number of those that were shown.
#[derive(Debug, Default)]
pub struct GpuErrors {
    errors: DeviceErrors,
    is_reported: bool,
    /// The window that a fault wakes: the device, which it owns, must not own it in turn.
    _woken: Option<Woken>,
}

impl GpuErrors {
    /// Collects the errors of the window's device, if it has one, from now on; each is followed by a frame.
    pub fn new(ctx: &Context, render_state: Option<&RenderState>) -> Self {
        let Some(state) = render_state else { return Self::default() };
        let woken = Woken::new(ctx.clone());
        let waker = woken.waker();
        Self {
            errors: DeviceErrors::collect(&state.device, move || waker.wake()),
            is_reported: false,
            _woken: Some(woken),
        }
    }

    /// Why the device is lost, if it is: then the window cannot be drawn.
    pub fn loss(&self) -> Option<String> {
        self.errors.loss()
    }

    /// Takes the message for errors that have not been shown yet; `newly`, the device has refused to draw the
    /// views.
    pub fn take_new(&mut self, newly: Option<GpuError>) -> Option<String> {
        let text = if let Some(error) = newly {
            format!("{}. The views are drawn on the CPU from now on.", capitalised(&error.to_string()))
        } else {
            let error = self.errors.first().filter(|_| !self.is_reported)?;
            self.is_reported = true;
            format!("The graphics device reported an error, which was passed over: {error}")
        };
        log::warn!("{text}");
        Some(text)
    }
}
