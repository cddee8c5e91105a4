//! The projector's window: the views, while the controls stay on the lecturer's screen.

use eframe::egui::{ViewportBuilder, ViewportId};

/// What it is called among windows.
pub fn id() -> ViewportId {
    ViewportId::from_hash_of("projector")
}

/// How it opens: to be moved to the projector's screen, and made as large as that by the desktop's means.
pub fn window() -> ViewportBuilder {
    ViewportBuilder::default()
        .with_title("Gamow: views")
        .with_inner_size([1024.0, 520.0])
        .with_min_inner_size([240.0, 160.0])
}
