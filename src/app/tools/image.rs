//! Pictures as the window's toolkit takes them.

use eframe::egui::ColorImage;

/// Returns the image of this width and height, pixels, with these pixels, row by row from the top left: red,
/// green, blue (sRGB-encoded) and opacity.
pub fn of_pixels(size: [u32; 2], rgba: &[[u8; 4]]) -> ColorImage {
    ColorImage::from_rgba_unmultiplied(size.map(|side| side as usize), rgba.as_flattened())
}
