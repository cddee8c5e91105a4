//! The window's icon: what the left eye sees and what the right eye sees, overlapping.

use eframe::egui::IconData;
use eframe::icon_data;

/// Two discs in the colours of the eyes, white where they overlap.
#[must_use]
pub fn icon() -> IconData {
    icon_data::from_png_bytes(include_bytes!("../../../assets/icon.png")).expect("it is a picture")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_icon_is_a_picture() {
        let icon = icon();
        assert_eq!((icon.width, icon.height, icon.rgba.len()), (256, 256, 4 * 256 * 256));
    }
}
