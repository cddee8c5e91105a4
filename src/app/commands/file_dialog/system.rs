//! A dialog of the system, in which a file is chosen.

use std::path::Path;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::Duration;

use eframe::egui::Context;
use gamow_platform::clock::Instant;
use gamow_platform::{files, threads};

use crate::app::commands::file_dialog::answer::DialogAnswer;
use crate::app::state::files::purpose::Purpose;
use crate::app::tools::waker::Woken;

/// A dialog of the system. A thread waits for it, as that may take as long as the user likes; so nothing
/// waits for the thread: an open dialog would keep the program from its end. The thread holds nothing of the
/// window's but a waker, which wakes nobody then.
pub struct Dialog {
    answer: Receiver<DialogAnswer>,
    _woken: Woken,
}

/// A dialog that is closed sooner than this was never there: nobody is so quick.
const QUICKEST: Duration = Duration::from_millis(300);

impl Dialog {
    /// Whether there is one for this `purpose`.
    pub const fn is_for(_: Purpose) -> bool {
        true
    }

    /// Opens the dialog for this `purpose`, beginning at this path.
    pub fn open(ctx: &Context, purpose: Purpose, at: &Path) -> Self {
        let folder = if files::is_folder(at) { Some(at) } else { at.parent() };
        let name = at.file_name().unwrap_or_default().to_string_lossy();
        let mut dialog = rfd::FileDialog::new().set_title(purpose.title());
        if let Some(folder) = folder {
            dialog = dialog.set_directory(folder);
        }
        if let Purpose::Save(product) = purpose {
            dialog = dialog.set_file_name(name).add_filter(product.name(), product.endings());
        }
        let (answered, answer) = channel();
        let woken = Woken::new(ctx.clone());
        let waker = woken.waker();
        threads::spawn(move || {
            let start = Instant::now();
            let path = match purpose {
                Purpose::Save(_) => dialog.save_file(),
                Purpose::Open | Purpose::OpenData => dialog.pick_file(),
            };
            let is_there = start.elapsed() >= QUICKEST;
            let none = if is_there { DialogAnswer::None } else { DialogAnswer::NoDialog };
            // Nobody may wait for it any more.
            let _ = answered.send(path.map_or(none, DialogAnswer::Path));
            waker.wake();
        });
        Self { answer, _woken: woken }
    }

    /// Returns the answer of the dialog, once there is one.
    pub fn answer(&self) -> Option<DialogAnswer> {
        match self.answer.try_recv() {
            Ok(answer) => Some(answer),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(DialogAnswer::NoDialog),
        }
    }
}
