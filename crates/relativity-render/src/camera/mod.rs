//! A pinhole camera at an aperture: lines of sight of pixels, and pixels of lines of sight.

pub(crate) mod axes;
mod gaze;
mod gaze_at_pixel;
pub mod lines_of_sight;
pub mod mercator;
pub(crate) mod outline;

use glam::{DVec2, DVec3};
use relativity_core::math::{asinh, atan, atan2, hypot, sinh, tan};
use relativity_core::{Aperture, Observer, ObserverVelocity};
use std::f64::consts::{FRAC_PI_2, PI};

pub use axes::{Axes, MAX_ELEVATION};
use axes::{level_across, position};
use gaze::aside;
pub(crate) use gaze::held;
pub use gaze::{Gaze, MAX_SLANT};
use lines_of_sight::{DirectionMap, LinesOfSight};
use mercator::{MOST_SHIFTED, Mercator};

/// A pinhole camera at rest on the ground. Its [`Projection`] gives the place of the picture plane: across
/// the gaze, unless two eyes' pictures are to be fused.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, ObserverVelocity};
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Camera {
    /// Place of the pinhole on the ground.
    pub aperture: Aperture,
    /// Velocity on the ground, in any direction. Lines of sight, distances and the picture are in the frame
    /// of what moves so, its axes those of the ground boosted along the velocity.
    pub velocity: ObserverVelocity,
    /// Way on the street, as measured in that frame, over which wheels that ride along have rolled: the
    /// integral of the velocity over proper time. Units of length.
    pub rolled: f64,
    /// Direction of the optical axis.
    pub gaze: Gaze,
    /// Angle between the left and the right edge of the picture if its middle is on its axis (abreast, in a
    /// conformal one), radians, in (0, pi): what sets the focal length, so that it stays as the gaze moves.
    pub horizontal_fov: f64,
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// From the middle between the two eyes, of which the aperture is one, to it.
    pub off_middle: DVec3,
    /// Place of the picture plane.
    pub projection: Projection,
}

/// The place of a camera's picture plane, and the map of directions to it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Projection {
    /// Across the gaze, the horizon level.
    #[default]
    Gaze,
    /// Parallel to the baseline of two eyes, so that both pictures can be fused: its rows run along the
    /// baseline, and its axis is what of the gaze is across that. The picture is sheared along its rows to
    /// have the gaze in the middle all the same. Whatever is in one row of one picture is in that of the
    /// other, if both eyes have this gaze.
    ///
    /// A gaze that slants further than [`MAX_SLANT`] turns the pictures of both eyes, which stay parallel to
    /// each other, about their columns by as much as it does so. What is there is far away, and in nearly one
    /// row of both.
    ///
    /// The picture is never upside down: its rows run against `right` where that takes it, as for a gaze
    /// behind the head.
    Parallel {
        /// Unit vector along the baseline, from the left eye to the right one.
        right: DVec3,
        /// By how many focal lengths the picture's content is moved to the right, this eye's image shift.
        /// What is at depth s before the eyes has one place in both pictures where that is (`off_middle` .
        /// `right`)/s.
        shift: f64,
    },
    /// Conformal: Mercator's projection with its poles at the ends of the baseline. Rows are planes through
    /// the baseline, so whatever is in one row of one picture is in that of the other; small shapes are true,
    /// wherever they are seen; and motion along the baseline slides the picture by its rapidity, with all
    /// shapes as at rest.
    ///
    /// As [`Self::Parallel`], the picture is never upside down. A gaze along the baseline is held 1e-12
    /// radians off it.
    Mercator {
        /// Unit vector along the baseline, from the left eye to the right one.
        right: DVec3,
        /// This eye's image shift: the u by which the picture's content is moved to the right.
        shift: f64,
    },
    /// Half of the sky: 180 by 180 degrees of longitude and latitude, about the level direction across the
    /// baseline that is nearest to the gaze. Drawn by the reference renderer alone.
    Vr180 {
        /// Unit vector along the baseline, from the left eye to the right one.
        right: DVec3,
    },
}

impl Projection {
    /// Whether pictures are conformal.
    #[must_use]
    pub const fn is_conformal(&self) -> bool {
        matches!(self, Self::Mercator { .. })
    }
}

impl Camera {
    /// A camera with its picture plane across the gaze, one of two eyes on a line along x, the middle of
    /// which is at x = 0.
    #[must_use]
    pub fn new(aperture: Aperture, gaze: Gaze, horizontal_fov: f64, size: [u32; 2]) -> Self {
        let off_middle = DVec3::X * aperture.x;
        let projection = Projection::Gaze;
        Self {
            aperture,
            velocity: ObserverVelocity::REST,
            rolled: 0.0,
            gaze,
            horizontal_fov,
            size,
            off_middle,
            projection,
        }
    }

    /// The event of the middle between the eyes, on the ground, when the pinhole is at its place there at T =
    /// `time`: for the observer both are at one time.
    pub(crate) fn event_of_middle(&self, time: f64) -> (DVec3, f64) {
        let (DVec3 { x, y, z }, eye) = (self.off_middle, self.aperture);
        let middle = Observer { velocity: self.velocity, ..Observer::at_rest(0.0) };
        let (offset, later) = middle.event_of(Aperture { x, y, z });
        (position(eye) - position(offset), time - later)
    }

    /// Distance from the pinhole to the picture plane, in pixels: how many of them a radian about the
    /// picture's axis has, or a unit of u in a conformal picture.
    #[must_use]
    pub fn focal_length_px(&self) -> f64 {
        0.5 * f64::from(self.size[0]) / self.half_width()
    }

    /// Returns the number of pixels that a radian along the middle row of the picture has.
    #[must_use]
    pub fn px_per_radian(&self) -> f64 {
        let stretch = self.through_middle().length();
        self.focal_length_px() * if self.projection.is_conformal() { stretch } else { stretch * stretch }
    }

    /// Half the width of the picture, focal lengths.
    pub(crate) fn half_width(&self) -> f64 {
        match self.projection {
            Projection::Gaze | Projection::Parallel { .. } => tan(0.5 * self.horizontal_fov),
            Projection::Mercator { .. } => asinh(tan(0.5 * self.horizontal_fov)),
            Projection::Vr180 { .. } => FRAC_PI_2,
        }
    }

    /// Towards the middle of the picture: its part along the axis is 1.
    pub(crate) fn through_middle(&self) -> DVec3 {
        let axes = self.axes();
        let middle = self.middle(&axes);
        let aside = if self.projection.is_conformal() { sinh(middle) } else { middle };
        axes.forward + axes.right * aside
    }

    /// The axes of the picture: along its rows, up its columns, and across it.
    #[must_use]
    pub fn axes(&self) -> Axes {
        match self.projection {
            Projection::Gaze => self.gaze.axes(),
            Projection::Parallel { right, .. } => Axes::beside(right, self.gaze.axes().forward),
            Projection::Mercator { right, .. } => Axes::across(right, self.gaze.axes().forward),
            Projection::Vr180 { right } => {
                let ahead = Gaze { elevation: 0.0, ..self.gaze }.axes().forward;
                let level = level_across(right).map(|level| level * 1f64.copysign(level.dot(ahead)));
                Axes::across(right, level.unwrap_or(ahead))
            }
        }
    }

    /// Returns the coordinates of `direction` (any length above 0) in the picture, focal lengths to the right
    /// of the picture's axis and up, the same for all image shifts: tangents, or (u, v) in a conformal
    /// picture. `None` where it is in no picture: behind a flat one, along the baseline of a conformal one.
    #[must_use]
    pub fn coordinates(&self, direction: DVec3) -> Option<[f64; 2]> {
        if let Some(mercator) = self.mercator() {
            return mercator.coordinates(direction).map(Into::into);
        }
        let Axes { right, up, forward } = self.axes();
        let depth = direction.dot(forward);
        (depth > 0.0).then(|| [direction.dot(right) / depth, direction.dot(up) / depth])
    }

    /// Returns the gauge, which gives the place of anything in a flat picture.
    pub(crate) fn gauge(&self) -> Gauge {
        let axes = self.axes();
        let Axes { right, up, forward } = axes;
        let middle = self.middle(&axes);
        Gauge { right: right - forward * middle, up, forward, middle }
    }

    /// Returns the map of the sky, if the picture is conformal.
    #[must_use]
    pub fn mercator(&self) -> Option<Mercator> {
        if !self.projection.is_conformal() {
            return None;
        }
        let (axes, px_per_unit) = (self.axes(), self.focal_length_px());
        let [width, height] = self.size.map(f64::from);
        let origin = DVec2::new(0.5 * width - self.middle(&axes) * px_per_unit, 0.5 * height);
        Some(Mercator { axes, px_per_unit, origin })
    }

    /// Returns the place of the picture's middle to the right of its axis: a tangent, or u in a conformal
    /// picture.
    fn middle(&self, axes: &Axes) -> f64 {
        match self.projection {
            Projection::Mercator { shift, .. } => {
                (aside(axes, self.gaze.axes().forward) - shift).clamp(-MOST_SHIFTED, MOST_SHIFTED)
            }
            Projection::Parallel { shift, .. } => axes.shear_towards(self.gaze.axes().forward) - shift,
            Projection::Gaze | Projection::Vr180 { .. } => 0.0,
        }
    }

    /// Returns the lines of sight of its pixels: for many of them, since its angles are turned into vectors
    /// once.
    #[must_use]
    pub fn lines_of_sight(&self) -> LinesOfSight {
        let axes = self.axes();
        let Axes { right, up, forward } = axes;
        let focal_length_px = self.focal_length_px();
        let size = self.size.map(f64::from);
        let map = if let Projection::Vr180 { .. } = self.projection {
            DirectionMap::Round { size }
        } else if let Some(mercator) = self.mercator() {
            DirectionMap::Mercator(mercator)
        } else {
            let to_left = 0.5 * size[0] - self.middle(&axes) * focal_length_px;
            DirectionMap::Flat {
                to_top_left: forward * focal_length_px - right * to_left + up * (0.5 * size[1]),
            }
        };
        LinesOfSight { axes, focal_length_px, map }
    }

    /// Unit vector from the aperture through the point `[u, v]` of the picture, in pixels.
    #[must_use]
    pub fn line_of_sight(&self, pixel: [f64; 2]) -> DVec3 {
        self.lines_of_sight().through(pixel)
    }

    /// Returns the place in the picture (pixels) where something along `direction` (any length above 0)
    /// appears; `None` behind the camera, and along the baseline of a conformal picture. The place may lie
    /// outside the picture.
    #[must_use]
    pub fn pixel(&self, direction: DVec3) -> Option<[f64; 2]> {
        if let Some(mercator) = self.mercator() {
            return mercator.coordinates(direction).map(|coordinates| mercator.place_of(coordinates));
        }
        let [width, height] = self.size.map(f64::from);
        if let Projection::Vr180 { .. } = self.projection {
            let Axes { right, up, forward } = self.axes();
            let (aside, depth) = (direction.dot(right), direction.dot(forward));
            let (longitude, latitude) = (atan2(aside, depth), atan2(direction.dot(up), hypot(aside, depth)));
            return Some([width * (0.5 + longitude / PI), height * (0.5 - latitude / PI)]);
        }
        let Gauge { right, up, forward, .. } = self.gauge();
        let depth = direction.dot(forward);
        if depth <= 0.0 {
            return None;
        }
        let scale = self.focal_length_px() / depth;
        Some([0.5 * width + direction.dot(right) * scale, 0.5 * height - direction.dot(up) * scale])
    }

    /// Returns a camera whose small picture of this `size` shows the surroundings of `pixel` in this one,
    /// magnified by `factor`.
    #[must_use]
    pub fn magnified(&self, pixel: [f64; 2], size: [u32; 2], factor: f64) -> Self {
        let sight = self.line_of_sight(pixel);
        let half_width = 0.5 * f64::from(size[0]) / (self.focal_length_px() * factor);
        let (projection, half_tangent) = match self.projection {
            // However far it slants.
            Projection::Parallel { right, .. } => {
                let axes = Axes::beside(right, sight);
                let shift = axes.shear_towards(sight) - sight.dot(axes.right) / sight.dot(axes.forward);
                (Projection::Parallel { right, shift }, half_width)
            }
            Projection::Mercator { right, .. } => {
                (Projection::Mercator { right, shift: 0.0 }, sinh(half_width))
            }
            Projection::Gaze | Projection::Vr180 { .. } => (Projection::Gaze, half_width),
        };
        let gaze = Gaze::along(sight.to_array());
        Self { gaze, horizontal_fov: 2.0 * atan(half_tangent), size, projection, ..*self }
    }

    /// Returns the greatest difference in shape or size to a picture of the other kind, at the corners: how
    /// many times as long as wide a flat picture shows a small disc there, or how many times as large as in
    /// its middle a conformal one shows it. 1 for half of the sky, which is looked at all around.
    #[must_use]
    pub fn stretch(&self) -> f64 {
        let axes = self.axes();
        let [width, height] = self.size.map(f64::from);
        let scale = |place: [f64; 2]| {
            let sight = self.line_of_sight(place);
            match self.projection {
                Projection::Gaze | Projection::Parallel { .. } => 1.0 / sight.dot(axes.forward),
                Projection::Mercator { .. } => 1.0 / sight.reject_from_normalized(axes.right).length(),
                Projection::Vr180 { .. } => 1.0,
            }
        };
        let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]].map(scale);
        let largest = corners.into_iter().fold(1.0, f64::max);
        if self.projection.is_conformal() { largest / scale([0.5 * width, 0.5 * height]) } else { largest }
    }

    /// Whether what lies along `direction` (any length above 0) is in the picture, its edges included.
    #[must_use]
    pub fn shows(&self, direction: DVec3) -> bool {
        let is_inside = |(place, side): (f64, u32)| (0.0..=f64::from(side)).contains(&place);
        self.pixel(direction).is_some_and(|pixel| pixel.into_iter().zip(self.size).all(is_inside))
    }
}

/// The axes that give the place of anything in a flat picture: its products with `right` and `up`, over that
/// with `forward`, count focal lengths from the middle of the picture. Where that is not on the picture's
/// axis, `right` is not across `forward`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Gauge {
    pub right: DVec3,
    pub up: DVec3,
    pub forward: DVec3,
    /// The tangent to the right of the axis at which the middle of the picture is.
    pub middle: f64,
}

impl Gauge {
    /// Returns the gauge for places that are `turned` into other axes, or reflected.
    pub fn turned(&self, turned: impl Fn(DVec3) -> DVec3) -> Self {
        let Self { right, up, forward, middle } = *self;
        Self { right: turned(right), up: turned(up), forward: turned(forward), middle }
    }
}

#[cfg(test)]
mod tests;
