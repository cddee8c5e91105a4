//! What the window says of a graphics device that fails, once.

use std::sync::Arc;

use eframe::egui::Context;
use eframe::egui_wgpu::RenderState;
use relativity_render::{Faults, GpuError};

use crate::caption::capitalised;

/// What the device has reported, and how much of that was told.
#[derive(Debug, Default)]
pub struct Faulty {
    faults: Faults,
    is_told: bool,
    /// The window that a fault wakes. The device holds it weakly: egui's renderer is part of a window's context and owns
    /// the device, which could never be freed if it owned the context in turn.
    _woken: Option<Arc<Context>>,
}

impl Faulty {
    /// Of the window's device, if it has one, from now on; each fault is followed by a frame.
    pub fn of(ctx: &Context, render_state: Option<&RenderState>) -> Self {
        let Some(state) = render_state else { return Self::default() };
        let woken = Arc::new(ctx.clone());
        let ctx = Arc::downgrade(&woken);
        let wake = move || ctx.upgrade().iter().for_each(|ctx| ctx.request_repaint());
        Self { faults: Faults::of(&state.device, wake), is_told: false, _woken: Some(woken) }
    }

    /// Why the device is lost, if it is: then the window cannot be drawn.
    pub fn loss(&self) -> Option<String> {
        self.faults.loss()
    }

    /// What is to be said, once, of what the device could not do; it is `newly` known that it refuses to draw the views.
    pub fn newly_told(&mut self, newly: Option<GpuError>) -> Option<String> {
        let text = if let Some(error) = newly {
            format!("{}. The views are drawn on the CPU from now on.", capitalised(&error.to_string()))
        } else {
            let error = self.faults.first().filter(|_| !self.is_told)?;
            self.is_told = true;
            format!("The graphics device reported an error, which was passed over: {error}")
        };
        log::warn!("{text}");
        Some(text)
    }
}
