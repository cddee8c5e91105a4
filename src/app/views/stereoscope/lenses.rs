//! Places of the pictures behind the lenses of a stereoscope.

use eframe::egui::{Rect, pos2, vec2};
use relativity_core::math::{atan, tan};

/// Least width of a picture, points.
const LEAST_WIDTH: f32 = 2.0;

/// Returns the pictures of the left and the right eye in a screen's `area`: their middles are `apart`
/// (points) from each other, and none reaches over the middle of the screen or its edge. Where the screen is
/// too narrow for that, the middles are nearer to each other.
#[must_use]
pub fn pictures(area: Rect, apart: f32) -> [Rect; 2] {
    let half = (0.5 * apart).min(0.5 * area.width() - 0.5 * LEAST_WIDTH).max(0.5 * LEAST_WIDTH);
    let width = 2.0 * half.min(0.5 * area.width() - half).max(0.5 * LEAST_WIDTH);
    [-half, half].map(|aside| {
        Rect::from_center_size(pos2(area.center().x + aside, area.center().y), vec2(width, area.height()))
    })
}

/// Returns the angle that a picture of this `width` takes behind a lens at this distance from it, degrees;
/// both in one unit.
#[must_use]
pub fn field_of_view(width: f64, distance: f64) -> f64 {
    2.0 * atan(0.5 * width / distance).to_degrees()
}

/// Returns the angle of a point in the middle of a picture of this `width` and field of view (degrees),
/// radians.
#[must_use]
pub fn radians_per_point(width: f32, fov: f64) -> f64 {
    2.0 * tan(0.5 * fov.to_radians()) / f64::from(width)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middles_are_as_far_apart_as_the_lenses_and_each_picture_stays_in_its_half() {
        let area = Rect::from_min_size(pos2(10.0, 20.0), vec2(740.0, 360.0));
        for apart in [100.0, 320.0, 370.0, 420.0, 600.0] {
            let [left, right] = pictures(area, apart);
            assert!((right.center().x - left.center().x - apart).abs() < 1e-3, "{apart}");
            assert!((left.center().x + right.center().x - 2.0 * area.center().x).abs() < 1e-3);
            assert!(left.max.x <= area.center().x + 1e-3 && right.min.x >= area.center().x - 1e-3);
            assert!(area.expand(1e-3).contains_rect(left) && area.expand(1e-3).contains_rect(right));
            assert_eq!((left.height(), left.size()), (360.0, right.size()));
        }
        // The widest are those for lenses half the screen apart.
        let [left, right] = pictures(area, 370.0);
        assert!((left.width() - 370.0).abs() < 1e-3 && (right.max.x - area.max.x).abs() < 1e-3);
    }

    #[test]
    fn a_screen_that_is_too_narrow_has_narrow_pictures() {
        for (width, apart) in [(200.0, 300.0), (0.0, 300.0), (740.0, 0.0), (3.0, f32::MAX)] {
            let area = Rect::from_min_size(pos2(0.0, 0.0), vec2(width, 50.0));
            for picture in pictures(area, apart) {
                assert!(picture.width() >= 0.5 * LEAST_WIDTH && picture.center().x.is_finite());
            }
        }
    }

    #[test]
    fn a_picture_twice_as_wide_as_the_lens_is_far_takes_a_right_angle() {
        assert!((field_of_view(80.0, 40.0) - 90.0).abs() < 1e-12);
        assert!((radians_per_point(80.0, 90.0) - 1.0 / 40.0).abs() < 1e-12);
    }
}
