//! The window for screen readers: the toolkit's accessibility tree in the page, and what is done to it there.
//!
//! It is always on, so that nobody has to find a switch without seeing it. The tree is made at most ten times
//! a second, and only in frames that are drawn anyway: see [`INTERVAL`].

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use eframe::egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId};
use eframe::egui::{Context, Event, FullOutput, Plugin, RawInput, Ui};
use gamow_platform::clock::Instant;
use gamow_platform::web::elements::{self, Deed};

use crate::app::tools::mirror::{Change, Mirror};

/// Least time between two trees: speech is slower, and time that runs would change the page in every frame.
const INTERVAL: Duration = Duration::from_millis(100);

/// Keeps the page's elements like the window, and has the window do what is done to them.
#[derive(Default)]
pub struct Accessibility {
    mirror: Mirror,
    requests: Arc<Mutex<Vec<ActionRequest>>>,
    /// The frame of the last tree, and when that was made.
    last: Option<(u64, Instant)>,
    /// Time until the next tree, if this frame makes none.
    rest: Option<Duration>,
    /// Whether something has been done to an element in this frame.
    is_asked: bool,
}

impl Accessibility {
    /// Begins in the window of `ctx`.
    pub fn begin(ctx: &Context) {
        let accessibility = Self::default();
        let (requests, woken) = (Arc::clone(&accessibility.requests), ctx.clone());
        elements::listen(move |id, deed| {
            locked(&requests).push(request(id, deed));
            woken.request_repaint();
        });
        elements::set_focus(None);
        ctx.add_plugin(accessibility);
    }

    /// Returns the time until a tree may be made, if it may not be in this frame.
    fn rest(&mut self, frame: u64) -> Option<Duration> {
        // A frame may have several passes, of which the last one counts.
        let rest =
            self.last.filter(|(last, _)| *last != frame).map(|(_, at)| INTERVAL.saturating_sub(at.elapsed()));
        rest.filter(|rest| !rest.is_zero())
    }
}

impl Plugin for Accessibility {
    fn debug_name(&self) -> &'static str {
        "Accessibility"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        // The focus of an element is the window's: else a slider would leave the arrow keys to others.
        input.focused |= elements::have_focus();
        let requests = std::mem::take(&mut *locked(&self.requests));
        for request in &requests {
            if request.action == Action::SetValue {
                self.mirror.touch(request.target_node);
            }
        }
        self.is_asked = !requests.is_empty();
        input.events.extend(requests.into_iter().map(Event::AccessKitActionRequest));
        let frame = ctx.cumulative_frame_nr();
        self.rest = self.rest(frame).filter(|_| !self.is_asked);
        if self.rest.is_some() {
            ctx.disable_accesskit();
        } else {
            ctx.enable_accesskit();
            if self.last.is_none_or(|(last, _)| last != frame) {
                self.last = Some((frame, Instant::now()));
            }
        }
    }

    fn on_end_pass(&mut self, ui: &mut Ui) {
        if self.is_asked {
            // A widget keeps the arrow keys for itself from its second frame with the focus on.
            ui.ctx().request_repaint();
        } else if let Some(rest) = self.rest {
            ui.ctx().request_repaint_after(rest);
        }
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let Some(update) = output.platform_output.accesskit_update.take() else { return };
        for change in self.mirror.update(update, f64::from(ctx.zoom_factor())) {
            make(change);
        }
    }
}

fn locked(requests: &Mutex<Vec<ActionRequest>>) -> MutexGuard<'_, Vec<ActionRequest>> {
    requests.lock().unwrap_or_else(PoisonError::into_inner)
}

fn request(id: u64, deed: Deed) -> ActionRequest {
    let (action, data) = match deed {
        Deed::Click => (Action::Click, None),
        Deed::Focus => (Action::Focus, None),
        Deed::Number(number) => (Action::SetValue, Some(ActionData::NumericValue(number))),
        Deed::Text(text) => (Action::SetValue, Some(ActionData::Value(text.into()))),
    };
    ActionRequest { action, target_tree: TreeId::ROOT, target_node: NodeId(id), data }
}

fn make(change: Change) {
    match change {
        Change::Create(id, tag) => elements::create(id.0, tag),
        Change::Attribute(id, name, value) => elements::set_attribute(id.0, name, value.as_deref()),
        Change::Text(id, text) => elements::set_text(id.0, &text),
        Change::Value(id, value) => elements::set_value(id.0, &value),
        Change::Children(parent, children) => {
            let children: Vec<u64> = children.iter().map(|id| id.0).collect();
            elements::set_children(parent.map(|id| id.0), &children);
        }
        Change::Delete(id) => elements::remove(id.0),
        Change::Focus(id) => elements::set_focus(id.map(|id| id.0)),
    }
}
