//! A dialog of the browser, in which a file is chosen to be opened.

use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use eframe::egui::Context;
use gamow_platform::files;
use gamow_platform::web::download;

use crate::app::commands::file_dialog::answer::DialogAnswer;
use crate::app::state::files::purpose::Purpose;

/// A dialog of the browser.
pub struct Dialog(Rc<RefCell<Option<DialogAnswer>>>);

impl Dialog {
    /// Whether there is one for this `purpose`: to save, the browser asks by itself.
    pub const fn is_for(purpose: Purpose) -> bool {
        !matches!(purpose, Purpose::Save(_))
    }

    /// Opens the dialog. Files are saved as downloads, for which the browser may ask.
    pub fn open(ctx: &Context, _: Purpose, _: &Path) -> Self {
        let answer = Rc::new(RefCell::new(None));
        let (answered, ctx) = (Rc::clone(&answer), ctx.clone());
        download::choose(move |chosen| {
            let path = chosen.map(|(name, bytes)| {
                let path = PathBuf::from(name);
                files::take_in(&path, bytes);
                path
            });
            answered.replace(Some(path.map_or(DialogAnswer::None, DialogAnswer::Path)));
            ctx.request_repaint();
        });
        Self(answer)
    }

    /// Returns the answer of the dialog, once there is one.
    pub fn answer(&self) -> Option<DialogAnswer> {
        self.0.take()
    }
}
