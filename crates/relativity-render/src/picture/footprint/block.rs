//! Footprints of blocks: a block appears in the hull of the images of its corners, as far as that is in
//! front.

use glam::{DVec2, DVec3};

use super::projection::{Footprint, FootprintMap, ImageExtent, LOOSE_PX};
use crate::camera::Gauge;
use crate::geometry::block::Block;

/// Largest bulge, as a share of the shorter side of a block in the picture, at which halves do not get
/// rectangles of their own.
const LOOSE_SHARE: f64 = 0.25;

impl FootprintMap {
    /// Returns the footprint of `block`; `None` from inside it.
    ///
    /// C(p) = gamma (`p_x` - beta |p|) along x and p across it; |p| is convex: over the block it lies below
    /// what is interpolated between the corners, by the bulge at most. So the image lies in the hull of the
    /// images of the corners and of these moved by gamma beta times that along x, of which only what is in
    /// front of the camera can be seen.
    pub fn footprint_of_block(&self, block: &Block) -> Option<Footprint> {
        let distance = block.distance();
        if distance == 0.0 {
            return None;
        }
        let corners = block.corners();
        let bulge = self.bulge_of_block(block, &corners, distance);
        let mut hull = [DVec3::ZERO; 16];
        for (i, corner) in corners.into_iter().enumerate() {
            // As of a ball without a radius.
            let seen = self.apparent_centre(corner, 0.0).unwrap_or(corner);
            (hull[i], hull[i + 8]) = (seen, seen + DVec3::X * bulge);
        }
        let points = if bulge == 0.0 { &hull[..8] } else { &hull };
        if let Some(mercator) = &self.mercator {
            return self.conformal_footprint(mercator, points, 0.0, block.radius);
        }
        // All that can be in the picture is deeper than this.
        let slope = 0.5 * self.size / self.focal_length_px + DVec2::new(self.gauge.middle.abs(), 0.0);
        let nearest = 0.99 * distance * self.least_scale;
        let near = nearest / (1.0 + slope.length_squared()).sqrt();
        let images = Images::new(self, points, near);
        let radius_px = self.radius_px(block.radius, &hull);
        Some(images.rectangle(self, block, bulge, nearest, radius_px))
    }

    /// Returns the greatest distance along x between the image of a block and the interpolation of its
    /// corners' images.
    ///
    /// Along an axis the second derivative of |p| is the squared sine of the angle from there over |p|.
    fn bulge_of_block(&self, block: &Block, corners: &[DVec3; 8], distance: f64) -> f64 {
        if !self.geometry.has_doppler_effect() || self.beta == 0.0 {
            return 0.0;
        }
        let gap = block.half_axes.iter().map(|half| {
            let off_axis =
                corners.iter().map(|corner| corner.cross(*half).length_squared()).fold(0.0, f64::max);
            0.5 * half.length_squared().min(off_axis / (distance * distance)) / distance
        });
        self.gamma * self.beta * gap.sum::<f64>()
    }
}

/// The images of places of which the hull is wanted, focal lengths from the middle of the picture.
struct Images {
    /// 16, or where a line from before the near plane to behind it crosses that.
    places: [DVec2; 80],
    count: usize,
    /// Whether some are cut off by the near plane.
    is_cut: bool,
}

impl Images {
    /// Returns the footprint of the part of the hull of `points` that is deeper than `near`.
    fn new(projection: &FootprintMap, points: &[DVec3], near: f64) -> Self {
        let Gauge { right, up, forward, .. } = projection.gauge;
        let mut images = Self { places: [DVec2::ZERO; 80], count: 0, is_cut: false };
        let mut add = |place: DVec3, depth: f64| {
            images.places[images.count] = DVec2::new(place.dot(right), place.dot(up)) / depth;
            images.count += 1;
        };
        let depth = |place: &DVec3| place.dot(forward);
        let (front, behind) = (|place: &&DVec3| depth(place) > near, |place: &&DVec3| depth(place) <= near);
        for place in points.iter().filter(front) {
            add(*place, depth(place));
            for other in points.iter().filter(behind) {
                let share = (depth(place) - near) / (depth(place) - depth(other));
                add(place.lerp(*other, share), near);
            }
        }
        images.is_cut = points.iter().any(|place| behind(&place));
        images
    }

    fn rectangle(
        &self,
        projection: &FootprintMap,
        block: &Block,
        bulge: f64,
        nearest: f64,
        radius_px: f64,
    ) -> Footprint {
        let places = &self.places[..self.count];
        if places.is_empty() {
            return Footprint::Hidden;
        }
        let Gauge { right, up, .. } = projection.gauge;
        let upright = ImageExtent::new(places, DVec2::X);
        let along_axes =
            block.half_axes.map(|axis| DVec2::new(axis.dot(right), axis.dot(up)).try_normalize());
        let turned = along_axes.into_iter().flatten().map(|along| ImageExtent::new(places, along));
        let tightest = turned.fold(upright, |best, next| if next.area() < best.area() { next } else { best });
        // What is cut off may reach far out of the picture: there f32 would lose it.
        let limit = 1.0 + 0.5 * projection.size / projection.focal_length_px;
        let extent = if self.is_cut { upright.within(limit) } else { tightest };
        let sides = extent.high - extent.low;
        let bulge_px = bulge * projection.focal_length_px / nearest;
        let is_loose =
            bulge_px > LOOSE_PX + LOOSE_SHARE * sides.min_element().abs() * projection.focal_length_px;
        extent.footprint(projection, radius_px, is_loose)
    }
}
