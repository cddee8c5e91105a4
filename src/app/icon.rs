//! The window's icon: what the left eye sees and what the right eye sees, overlapping.

use eframe::egui::IconData;
use relativity_core::math;

/// Width and height, pixels.
const SIDE: u32 = 64;
const LEFT: [f32; 3] = [86.0, 180.0, 233.0];
const RIGHT: [f32; 3] = [230.0, 159.0, 0.0];
const BOTH: [f32; 3] = [255.0, 255.0, 255.0];

/// Two discs in the colours of the eyes, white where they overlap.
#[must_use]
pub fn icon() -> IconData {
    let pixels = (0..SIDE * SIDE).map(|i| pixel((i % SIDE) as f32 + 0.5, (i / SIDE) as f32 + 0.5));
    IconData { rgba: pixels.flatten().collect(), width: SIDE, height: SIDE }
}

fn pixel(x: f32, y: f32) -> [u8; 4] {
    let cover = |centre: f32| (20.5 - math::hypot(x - centre, y - 32.0)).clamp(0.0, 1.0);
    let (left, right) = (cover(22.0), cover(42.0));
    let parts = [(LEFT, left * (1.0 - right)), (RIGHT, right * (1.0 - left)), (BOTH, left * right)];
    let alpha: f32 = parts.iter().map(|(_, part)| part).sum();
    let channel =
        |c: usize| parts.iter().map(|(colour, part)| colour[c] * part).sum::<f32>() / alpha.max(1e-3);
    [channel(0) as u8, channel(1) as u8, channel(2) as u8, (255.0 * alpha) as u8]
}
