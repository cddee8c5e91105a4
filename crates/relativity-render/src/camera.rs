//! A pinhole camera at an aperture: lines of sight of pixels, and pixels of lines of sight.

use glam::DVec3;
use relativity_core::Aperture;
use relativity_core::math::{asin, atan2, hypot, sin_cos, tan};

/// Where a camera looks: the direction of its optical axis. Its horizon stays level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaze {
    /// Azimuth from +x towards +y, radians; pi/2 looks straight ahead along +y.
    pub azimuth: f64,
    /// Elevation from the x-y plane, radians, in (-pi/2, pi/2).
    pub elevation: f64,
}

/// Steepest elevation of a gaze that follows something: at the zenith itself no horizon is level.
pub const MAX_ELEVATION: f64 = 89.5 * std::f64::consts::PI / 180.0;

/// A pinhole camera at rest on the ground.
///
/// # Examples
///
/// ```
/// use relativity_core::Aperture;
/// use relativity_render::{Camera, Gaze};
///
/// let (gaze, horizontal_fov) = (Gaze::STRAIGHT_AHEAD, std::f64::consts::FRAC_PI_2);
/// let camera = Camera::new(Aperture::default(), gaze, horizontal_fov, [200, 100]);
/// let [u, v] = camera.pixel([1.0, 2.0, 0.0].into()).expect("in front of the camera");
/// assert!((u - 150.0).abs() < 1e-9 && (v - 50.0).abs() < 1e-9);
/// ```
///
/// Pixel coordinates run right and down from the image's top left corner; the centre of pixel (i, j)
/// lies at (i + 0.5, j + 0.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// The pinhole.
    pub aperture: Aperture,
    /// Optical axis.
    pub gaze: Gaze,
    /// Angle between the left and the right edge of the picture, radians, in (0, pi).
    pub horizontal_fov: f64,
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// From the middle between the two eyes, of which the aperture is one, to it.
    pub off_middle: DVec3,
    /// Where the picture plane lies.
    pub projection: Projection,
}

/// Where the picture plane of a camera lies, and how directions are mapped to it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Projection {
    /// Across the gaze, the horizon level.
    #[default]
    Gaze,
    /// Parallel to the baseline of two eyes, from which both pictures can be fused: the rows of the picture run along that,
    /// and its axis is what of the gaze is across it. The gaze is in the middle of the picture all the same, which is sheared
    /// for that, along its rows only: what both eyes see at one height above such a plane is in one row of both pictures.
    Parallel {
        /// Unit vector along the baseline, from the left eye to the right one.
        right: DVec3,
        /// By how many focal lengths the picture's content is moved to the right (this eye's image shift).
        shift: f64,
    },
    /// Half of the sky, 180 degrees square, by its longitude and latitude about the direction across the baseline that is
    /// nearest to the gaze, level. Drawn by the reference renderer alone.
    Vr180 {
        /// Unit vector along the baseline, from the left eye to the right one.
        right: DVec3,
    },
}

/// Unit vectors of a camera: right, up and forward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// To the right edge of the picture.
    pub right: DVec3,
    /// To its upper edge.
    pub up: DVec3,
    /// Along the optical axis, away from the camera.
    pub forward: DVec3,
}

impl Gaze {
    /// Along +y.
    pub const STRAIGHT_AHEAD: Self = Self { azimuth: std::f64::consts::FRAC_PI_2, elevation: 0.0 };

    /// The gaze that looks along `direction` (any length above 0).
    #[must_use]
    pub fn along([x, y, z]: [f64; 3]) -> Self {
        Self { azimuth: atan2(y, x), elevation: atan2(z, hypot(x, y)) }
    }

    /// The gaze of two parallel eyes towards something that appears in these two directions (any lengths): their
    /// bisector, so that it lies as far left of the middle in one picture as right in the other. `None` for opposite
    /// directions, and inside an aperture.
    #[must_use]
    pub fn towards(directions: [DVec3; 2]) -> Option<Self> {
        let [left, right] = directions.map(DVec3::try_normalize);
        let Self { azimuth, elevation } = Self::along((left? + right?).try_normalize()?.to_array());
        Some(Self { azimuth, elevation: elevation.clamp(-MAX_ELEVATION, MAX_ELEVATION) })
    }

    /// The camera's unit vectors.
    #[must_use]
    pub fn axes(&self) -> Axes {
        let (sin_azimuth, cos_azimuth) = sin_cos(self.azimuth);
        let (sin_elevation, cos_elevation) = sin_cos(self.elevation);
        let right = DVec3::new(sin_azimuth, -cos_azimuth, 0.0);
        let forward = DVec3::new(cos_elevation * cos_azimuth, cos_elevation * sin_azimuth, sin_elevation);
        Axes { right, up: right.cross(forward), forward }
    }
}

impl Camera {
    /// A camera with its picture plane across the gaze, one of two eyes on a line along x, the middle of which is at x = 0.
    #[must_use]
    pub fn new(aperture: Aperture, gaze: Gaze, horizontal_fov: f64, size: [u32; 2]) -> Self {
        let off_middle = DVec3::X * aperture.x;
        Self { aperture, gaze, horizontal_fov, size, off_middle, projection: Projection::Gaze }
    }

    /// Distance from the pinhole to the picture plane, in pixels.
    #[must_use]
    pub fn focal_length_px(&self) -> f64 {
        0.5 * f64::from(self.size[0]) / tan(0.5 * self.horizontal_fov)
    }

    /// Unit vector from the aperture through the point `[u, v]` of the picture, in pixels.
    #[must_use]
    pub fn line_of_sight(&self, pixel: [f64; 2]) -> DVec3 {
        LinesOfSight::new(self).through(pixel)
    }

    /// The gaze with which something along `direction` (any length above 0) appears at `pixel`, the horizon staying
    /// level; the nearest there is where that would tilt further than [`MAX_ELEVATION`].
    #[must_use]
    pub fn gaze_with(&self, direction: DVec3, [u, v]: [f64; 2]) -> Gaze {
        let [width, height] = self.size.map(f64::from);
        // Right, up and forward of that pixel's line of sight.
        let (right, up, forward) = (u - 0.5 * width, 0.5 * height - v, self.focal_length_px());
        let (steepness, reach) = (atan2(up, forward), hypot(up, forward));
        let Gaze { azimuth, elevation } = Gaze::along(direction.to_array());
        // The height of the line of sight above the horizon is reach sin(elevation of the gaze + steepness).
        let height = sin_cos(elevation).0 * hypot(reach, right) / reach;
        let tilt = asin(height.clamp(-1.0, 1.0)) - steepness;
        let elevation = tilt.clamp(-MAX_ELEVATION, MAX_ELEVATION);
        Gaze { azimuth: azimuth + atan2(right, reach * sin_cos(elevation + steepness).1), elevation }
    }

    /// Where in the picture (pixels) something along `direction` (any length above 0) appears; `None`
    /// behind the camera. May lie outside the picture.
    #[must_use]
    pub fn pixel(&self, direction: DVec3) -> Option<[f64; 2]> {
        let Axes { right, up, forward } = self.gaze.axes();
        let depth = direction.dot(forward);
        if depth <= 0.0 {
            return None;
        }
        let [width, height] = self.size.map(f64::from);
        let scale = self.focal_length_px() / depth;
        Some([0.5 * width + direction.dot(right) * scale, 0.5 * height - direction.dot(up) * scale])
    }

    /// Whether what lies along `direction` (any length above 0) is in the picture, its edges included.
    #[must_use]
    pub fn shows(&self, direction: DVec3) -> bool {
        let is_inside = |(place, side): (f64, u32)| (0.0..=f64::from(side)).contains(&place);
        self.pixel(direction).is_some_and(|pixel| pixel.into_iter().zip(self.size).all(is_inside))
    }
}

/// The lines of sight of one camera, for many pixels: its angles are turned into vectors once.
#[derive(Debug, Clone, Copy)]
pub struct LinesOfSight {
    to_top_left: DVec3,
    right: DVec3,
    up: DVec3,
}

impl LinesOfSight {
    /// Those of `camera`.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        let Axes { right, up, forward } = camera.gaze.axes();
        let [width, height] = camera.size.map(f64::from);
        let to_top_left = forward * camera.focal_length_px() - right * (0.5 * width) + up * (0.5 * height);
        Self { to_top_left, right, up }
    }

    /// Unit vector from the aperture through the point `[u, v]` of the picture, in pixels.
    #[must_use]
    pub fn through(&self, [u, v]: [f64; 2]) -> DVec3 {
        (self.to_top_left + self.right * u - self.up * v).normalize()
    }

    /// By how much that turns from there to the pixel on the right, and to the one below.
    pub(crate) fn turns(&self, [u, v]: [f64; 2]) -> [DVec3; 2] {
        let unnormalised = self.to_top_left + self.right * u - self.up * v;
        let length = unnormalised.length();
        let sight = unnormalised / length;
        [self.right, -self.up].map(|across| (across - sight * sight.dot(across)) / length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    fn camera() -> Camera {
        Camera::new(Aperture::default(), Gaze { azimuth: FRAC_PI_2, elevation: 0.0 }, FRAC_PI_2, [200, 100])
    }

    #[test]
    fn looking_ahead_has_x_on_the_right_and_z_up() {
        let camera = camera();
        let [u, v] = camera.pixel(DVec3::new(1.0, 1.0, 0.0)).expect("in front");
        assert!((u - 200.0).abs() < 1e-9 && (v - 50.0).abs() < 1e-9);
        let [u, v] = camera.pixel(DVec3::new(0.0, 1.0, 0.5)).expect("in front");
        assert!((u - 100.0).abs() < 1e-9 && v.abs() < 1e-9);
        assert!(camera.pixel(DVec3::NEG_Y).is_none());
    }

    #[test]
    fn a_gaze_holds_a_direction_at_a_pixel() {
        for azimuth in [-3.0, 0.1, 1.5] {
            for elevation in [-1.0, 0.0, 0.6] {
                let gaze = Gaze { azimuth, elevation };
                let from = Camera { gaze, ..camera() };
                for pixel in [[100.0, 50.0], [3.0, 90.0], [180.0, 20.0]] {
                    let direction = from.line_of_sight(pixel);
                    let to = Camera { horizontal_fov: 1.0, ..from };
                    let to = Camera { gaze: to.gaze_with(direction, pixel), ..to };
                    let [u, v] = to.pixel(direction).expect("in front");
                    assert!((u - pixel[0]).abs() < 1e-9 && (v - pixel[1]).abs() < 1e-9, "{gaze:?} {pixel:?}");
                }
            }
        }
    }

    #[test]
    fn pixel_and_line_of_sight_are_inverse() {
        let mut camera = camera();
        camera.gaze = Gaze { azimuth: 2.0, elevation: 0.7 };
        for pixel in [[0.5, 0.5], [13.0, 77.25], [199.5, 99.5]] {
            let [u, v] = camera.pixel(camera.line_of_sight(pixel)).expect("in front");
            assert!((u - pixel[0]).abs() < 1e-9 && (v - pixel[1]).abs() < 1e-9);
        }
    }
}
