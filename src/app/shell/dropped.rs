//! A file that is dropped onto the window.

use std::path::PathBuf;

use eframe::egui::Context;

/// Takes the path of a file that was dropped.
#[cfg(feature = "desktop")]
pub fn take(ctx: &Context) -> Option<PathBuf> {
    ctx.input(|input| input.raw.dropped_files.first().map(|file| file.path().to_owned()))
}

/// Takes the path of a file that was dropped, once the browser has read it.
#[cfg(not(feature = "desktop"))]
pub fn take(ctx: &Context) -> Option<PathBuf> {
    use eframe::egui::Id;

    use gamow_platform::files;
    use gamow_platform::web::tasks;

    let read = Id::unique("dropped file");
    if let Some(file) = ctx.input(|input| input.raw.dropped_files.first().cloned()) {
        let ctx = ctx.clone();
        tasks::spawn(async move {
            if let Ok(bytes) = file.bytes_async().await {
                files::take_in(file.path(), bytes);
                ctx.data_mut(|data| data.insert_temp(read, file.path().to_owned()));
                ctx.request_repaint();
            }
        });
    }
    ctx.data_mut(|data| data.remove_temp(read))
}
