//! The margins of the start page.

/// The widest that what is on the page becomes, points.
const WIDEST: f32 = 1720.0;
/// Space that stays free at its sides, on a page wider than a phone's and on that of a phone, and the width
/// between these; points.
const SIDES: f32 = 32.0;
const SIDES_OF_A_PHONE: f32 = 16.0;
const WIDEST_PHONE: f32 = 540.0;

/// Returns the space that stays free at each side of a page of this `width`, points.
pub fn sides(width: f32) -> f32 {
    if width > WIDEST_PHONE { SIDES } else { SIDES_OF_A_PHONE }
}

/// Returns the width of what is on a page of this `width` with writing magnified by `scale`, points.
pub fn inner_width(width: f32, scale: f32) -> f32 {
    (width - 2.0 * sides(width)).min(scale * WIDEST).max(1.0)
}
