//! A ruler for angles, laid into a view from one place to another: two directions in the frame of the eye,
//! which stay where the picture turns or has another projection, and the angle between them.

use glam::DVec3;
use relativity_core::math;
use relativity_render::Camera;

use crate::eye::Eye;
use crate::number_text;

/// Parts of the great circle between both ends that are drawn straight.
pub const PARTS: u16 = 48;

/// A ruler, as far as it is laid.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum AngleRuler {
    /// No ruler is shown.
    #[default]
    Off,
    /// The next drag in a view lays it.
    Armed,
    /// The ruler lies in a view.
    Laid(Laid),
}

/// A ruler in a view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Laid {
    /// Eye of the picture that the ruler is in.
    pub eye: Eye,
    /// Whether that is the second of two pictures of one eye.
    pub is_second: bool,
    /// Unit vectors from the eye.
    pub ends: [DVec3; 2],
    /// Largest error of the angle: half a pixel at each end, as the picture was when it was laid; radians.
    pub error: f64,
    /// Whether the ruler is still being laid.
    pub is_held: bool,
}

/// A drag that lays a ruler.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lay {
    /// Eye of the picture.
    pub eye: Eye,
    /// Whether the ruler lies in the second of two pictures of one eye.
    pub is_second: bool,
    /// First and last place of the drag, in pixels from the top left corner.
    pub ends: [[f64; 2]; 2],
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
}

/// A command about the ruler.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RulerCommand {
    /// Has the next drag lay one, or if there is one takes it away.
    Toggle,
    /// Lays the ruler between two places.
    Lay(Lay),
    /// Ends the drag that lays it: it stays, and drags look around again.
    Settle,
}

impl AngleRuler {
    /// Whether a drag lays the angle ruler.
    #[must_use]
    pub const fn takes_drags(&self) -> bool {
        matches!(self, Self::Armed | Self::Laid(Laid { is_held: true, .. }))
    }
}

impl Laid {
    /// The angle between both directions, radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        let [from, to] = self.ends;
        between(from, to)
    }

    /// The angle with its error: in degrees, below one in arcminutes.
    #[must_use]
    pub fn text(&self) -> String {
        let degrees = self.angle().to_degrees();
        let (factor, unit) = if degrees < 1.0 { (60.0, "′") } else { (1.0, "°") };
        let error = factor * self.error.to_degrees();
        // The error has one digit, two where the first is a 1.
        let decimals = (1.2 - math::log10(error)).floor().clamp(0.0, 6.0) as u8;
        let [angle, error] = [factor * degrees, error].map(|value| number_text::fixed(value, decimals));
        format!("{angle}{unit} ± {error}{unit}")
    }

    /// The direction after that `part` of the [`PARTS`] of the way between both ends.
    #[must_use]
    pub fn along(&self, part: u16) -> DVec3 {
        let [from, to] = self.ends;
        let (share, angle) = (f64::from(part) / f64::from(PARTS), between(from, to));
        let across = (to - from * from.dot(to)).normalize_or(from.any_orthonormal_vector());
        let (sine, cosine) = math::sin_cos(share * angle);
        from * cosine + across * sine
    }
}

/// The angle between unit vectors, accurate for small ones too.
fn between(from: DVec3, to: DVec3) -> f64 {
    math::atan2(from.cross(to).length(), from.dot(to))
}

/// The ruler that this drag lays in a picture of this `camera`; none of a drag that has no length.
#[must_use]
pub fn laid(camera: &Camera, Lay { eye, is_second, ends, .. }: Lay) -> Option<Laid> {
    let [[x0, y0], [x1, y1]] = ends;
    let length = math::hypot(x1 - x0, y1 - y0);
    let [x, y] = [0.5 * (x1 - x0) / length, 0.5 * (y1 - y0) / length];
    // How far a line of sight turns over half a pixel to each side, along the drag.
    let half_pixel = |[u, v]: [f64; 2]| {
        let [before, after] = [[u - x, v - y], [u + x, v + y]].map(|pixel| camera.line_of_sight(pixel));
        0.5 * between(before, after)
    };
    let laid = Laid {
        eye,
        is_second,
        ends: ends.map(|end| camera.line_of_sight(end)),
        error: half_pixel(ends[0]) + half_pixel(ends[1]),
        is_held: true,
    };
    (length > 0.0 && laid.angle().is_finite() && laid.error.is_finite()).then_some(laid)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ruler(ends: [DVec3; 2], error: f64) -> Laid {
        Laid { eye: Eye::Left, is_second: false, ends, error, is_held: false }
    }

    #[test]
    fn the_text_has_an_error_of_one_digit_or_two() {
        let laid = |angle: f64, error: f64| {
            ruler([DVec3::X, DVec3::new(angle.cos(), angle.sin(), 0.0)], error).text()
        };
        let degree = 1f64.to_radians();
        assert_eq!(laid(12.345 * degree, 0.06 * degree), "12.35° ± 0.06°");
        assert_eq!(laid(12.345 * degree, 0.12 * degree), "12.35° ± 0.12°");
        assert_eq!(laid(0.5 * degree, 0.05 * degree), "30′ ± 3′");
        assert_eq!(laid(179.0 * degree, 2.0 * degree), "179° ± 2°");
    }

    /// The way between both ends is a great circle, and ends where it should, also between opposite
    /// directions.
    #[test]
    fn the_way_is_a_great_circle() {
        for to in [DVec3::Y, DVec3::new(0.6, 0.0, 0.8), -DVec3::X, DVec3::X] {
            let laid = ruler([DVec3::X, to], 0.1);
            assert!(laid.along(0).distance(DVec3::X) < 1e-12 && laid.along(PARTS).distance(to) < 1e-12);
            for part in 0..=PARTS {
                let way = laid.along(part);
                let share = between(DVec3::X, to) * f64::from(part) / f64::from(PARTS);
                assert!((way.length() - 1.0).abs() < 1e-12 && (between(DVec3::X, way) - share).abs() < 1e-12);
            }
        }
    }
}
