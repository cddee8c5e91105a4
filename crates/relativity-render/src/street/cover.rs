//! Coverage of a pixel by painted bands and lines: the share of it that they cover.

/// Share of a pixel, `pixel` wide there, that what lies between two places covers.
pub fn band_cover(coordinate: f64, [from, to]: [f64; 2], pixel: f64) -> f64 {
    let half = (0.5 * pixel).max(1e-6);
    let covered = (coordinate + half).min(to) - (coordinate - half).max(from);
    (covered / (2.0 * half)).clamp(0.0, 1.0)
}

/// Share of a pixel that pieces of this `length` cover, which begin at 0 and at every multiple of `period`.
pub fn repeated_cover(coordinate: f64, length: f64, period: f64, pixel: f64) -> f64 {
    let half = (0.5 * pixel).max(1e-6);
    let [from, to] = [coordinate - half, coordinate + half];
    let [before_from, before_to] = [from, to].map(|end| (end / period).floor());
    let within = |end: f64, before: f64| (end - before * period).min(length);
    let covered = (before_to - before_from) * length + (within(to, before_to) - within(from, before_from));
    covered / (2.0 * half)
}

/// Share of a pixel that a line covers whose middle lies `off_line` from its own; one thinner than the pixel
/// is faded rather than broken up.
pub fn line_cover(off_line: f64, half_width: f64, pixel: f64) -> f64 {
    let half = half_width.max(0.5 * pixel);
    ((half - off_line) / pixel.max(1e-6) + 0.5).clamp(0.0, 1.0) * (half_width / half)
}
