//! What the window does when its graphics device fails: it says so once, and closes where nothing can be drawn any more.

use eframe::egui::{Context, ViewportCommand};
use eframe::egui_wgpu::RenderState;
use relativity_render::Faults;

use super::App;
use super::eyes::EyePictures;
use super::notice::Notice;
use crate::caption::capitalised;

/// What the device has reported, and how much of that was told.
#[derive(Debug, Default)]
pub struct Faulty {
    faults: Faults,
    is_told: bool,
}

impl Faulty {
    /// Of the window's device, if it has one, from now on; each fault is followed by a frame.
    pub fn of(ctx: &Context, render_state: Option<&RenderState>) -> Self {
        let ctx = ctx.clone();
        let watch = |state: &RenderState| Faults::of(&state.device, move || ctx.request_repaint());
        Self { faults: render_state.map(watch).unwrap_or_default(), is_told: false }
    }
}

impl App {
    /// Why the device is lost, if it is: then the window cannot be drawn.
    #[must_use]
    pub fn loss(&self) -> Option<String> {
        self.faults.faults.loss()
    }

    /// Says once what the device could not do; closes the window that has lost it.
    pub(super) fn tell_faults(&mut self, ctx: &Context) {
        if self.loss().is_some() {
            ctx.send_viewport_cmd(ViewportCommand::Close);
            return;
        }
        let refused = [&mut self.eyes, &mut self.projected].into_iter().flatten();
        let text = if let Some(error) = refused.filter_map(EyePictures::newly_refused).last() {
            Some(format!("{}. The views are drawn on the CPU from now on.", capitalised(&error.to_string())))
        } else if !self.faults.is_told
            && let Some(error) = self.faults.faults.first()
        {
            self.faults.is_told = true;
            Some(format!("The graphics device reported an error, which was passed over: {error}"))
        } else {
            None
        };
        if let Some(text) = text {
            log::warn!("{text}");
            self.state.session.notice = Some(Notice::error(text));
            ctx.request_repaint();
        }
    }
}
