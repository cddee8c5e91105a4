//! Charts of round shapes, and how dark a pattern is there: the same way as `shaders/pattern.wgsl`. All in
//! the body's own axes.

use std::f32::consts::{FRAC_PI_2, PI};

use super::coverage::{PixelShifts, line, wave};
use crate::scene::pattern::{LINE_REACH, Ruling};
use crate::simd::lanes::{F, Simd, SimdFloat as _, V2, V3, all, select};

/// A place on a round shape, in the shape's own coordinates.
#[derive(Debug, Clone, Copy)]
pub struct SurfacePlaces<S: Simd> {
    /// Arc along the axis, and its gradient.
    pub along: F<S>,
    pub along_gradient: V3<S>,
    /// Angle around the axis, and its gradient.
    pub around: F<S>,
    pub around_gradient: V3<S>,
    pub off_axis: F<S>,
    /// Coordinate that stripes lie across, and its gradient.
    pub level: F<S>,
    pub level_gradient: V3<S>,
}

impl<S: Simd> SurfacePlaces<S> {
    /// Returns the darkness of `pattern` at this place.
    #[inline(always)]
    pub fn darkness(&self, pattern: [f32; 3], covered: &PixelShifts<S>) -> F<S> {
        const REACH: f32 = LINE_REACH as f32;
        let simd = self.along.simd;
        let [ruling, along_step, around_step] = pattern;
        if ruling > f32::from(Ruling::Chequer as u8) {
            return 0.5
                - wave(self.level / along_step, covered.range(self.level_gradient) / along_step) * 0.5;
        }
        let (along, around) = (self.along / along_step, self.around / around_step);
        let along_covered = covered.range(self.along_gradient) / along_step;
        let around_covered = covered.range(self.around_gradient) / around_step;
        if ruling == f32::from(Ruling::Chequer as u8) {
            return 0.5 - wave(along, along_covered) * wave(around, around_covered) * 0.5;
        }
        let width = REACH * along_step / (self.off_axis * around_step).max(1e-30);
        let quarter = FRAC_PI_2 / around_step;
        let parallels = line(along, all(simd, REACH), quarter, along_covered);
        parallels.max(line(around, width, quarter, around_covered))
    }
}

/// A place about an axis: how far from it, and the unit vector from there.
#[derive(Debug, Clone, Copy)]
pub struct OffAxis<S: Simd> {
    pub distance: F<S>,
    pub outward: V2<S>,
}

impl<S: Simd> OffAxis<S> {
    #[inline(always)]
    pub fn new(place: V3<S>) -> Self {
        let distance = V2::new(place.x, place.y).length().max(1e-30);
        Self { distance, outward: V2::new(place.x / distance, place.y / distance) }
    }

    /// Gradient of the angle around the axis.
    #[inline(always)]
    pub fn around_gradient(&self) -> V3<S> {
        let zero = all(self.distance.simd, 0.0);
        V3::new(-self.outward.y / self.distance, self.outward.x / self.distance, zero)
    }
}

#[inline(always)]
pub fn along_axis<S: Simd>(simd: S) -> V3<S> {
    V3::all(simd, [0.0, 0.0, 1.0])
}

/// The arc from the outermost place of a circle of this `radius` to that in the direction of (`off`, `z`),
/// and its gradient.
#[inline(always)]
pub fn arc_to<S: Simd>(off: F<S>, outward: V2<S>, z: F<S>, radius: F<S>) -> (F<S>, V3<S>) {
    let length = V2::new(off, z).length().max(1e-30);
    let gradient = V3::new(-outward.x * z / length, -outward.y * z / length, off / length);
    (radius * angle_to(z, off), gradient)
}

/// atan2(y, x), within 1e-6.
#[inline(always)]
pub fn angle_to<S: Simd>(y: F<S>, x: F<S>) -> F<S> {
    let (width, height) = (x.abs(), y.abs());
    let slope = width.min(height) / width.max(height).max(1e-30);
    let s = slope * slope;
    let high = 0.042_909_61 + s * (-0.016_165_737 + s * 0.002_866_225_7);
    let low = -0.142_089 + s * (0.106_562_64 + s * (-0.075_289_64 + s * high));
    let small = slope * (1.0 + s * (-0.333_331_45 + s * (0.199_935_51 + s * low)));
    let steep = select(height.simd_gt(width), FRAC_PI_2 - small, small);
    let angle = select(x.simd_lt(0.0), PI - steep, steep);
    select(y.simd_lt(0.0), -angle, angle)
}
