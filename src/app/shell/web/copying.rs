//! The copying of text in a page, and the message that appears once the browser confirms it; or the system's
//! sheet for sharing a link, on a phone.

use std::cell::Cell;
use std::rc::Rc;

use eframe::egui::Context;
use gamow_platform::web::{page, tasks};

use crate::app::state::notice::Notice;

/// The browser's copying of a text, and the message for when it is done.
pub struct Copying {
    notice: Notice,
    is_copied: Rc<Cell<bool>>,
}

impl Copying {
    /// Asks the browser to copy `text`, or to share it if it is a link and there is a sheet for that. Where
    /// it refuses, the page shows the text, selected.
    pub fn begin(ctx: &Context, text: String, is_link: bool, notice: Notice) -> Self {
        let is_copied = Rc::new(Cell::new(false));
        let (copied, ctx) = (Rc::clone(&is_copied), ctx.clone());
        tasks::spawn(async move {
            if is_link && page::shares_links() && page::share(&text).await {
                return;
            }
            if page::copy_text(&text).await {
                copied.set(true);
                ctx.request_repaint();
            } else {
                page::offer_text(&text);
            }
        });
        Self { notice, is_copied }
    }

    /// Takes the message once the text is copied.
    pub fn take_done(copying: &mut Option<Self>) -> Option<Notice> {
        copying.take_if(|copying| copying.is_copied.get()).map(|copying| copying.notice)
    }
}
