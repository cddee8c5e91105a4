//! The colour of light of one wavelength.

use eframe::egui::Color32;
use relativity_render::colour;

/// The colour of light of this wavelength, nm, over `behind`, which shows where eyes see nothing.
pub fn visible_colour(wavelength_nm: f64, behind: Color32) -> Color32 {
    let linear = colour::linear_srgb(wavelength_nm);
    let seen = linear.into_iter().fold(0.0, f64::max).min(1.0);
    let behind = behind.to_array();
    let [r, g, b] = [0, 1, 2].map(|i| {
        let behind = colour::srgb_decoded(f64::from(behind[i]) / 255.0);
        colour::srgb_level(behind * (1.0 - seen) + linear[i])
    });
    Color32::from_rgb(r, g, b)
}
