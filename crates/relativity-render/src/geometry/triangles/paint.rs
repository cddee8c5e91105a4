//! The paint of triangles: a measured material, or what their corners have, times what their texture has
//! there.

use std::array::from_fn;
use std::sync::Arc;

use glam::DVec3;

use super::texture::MipMap;
use super::{RawModel, TrianglePoint, Triangles};
use crate::colour::paint::{Material, Paint};
use crate::colour::sunlit;

impl Triangles {
    /// Returns the paint at a `point`: reflectances in linear sRGB.
    #[must_use]
    pub fn paint(&self, point: TrianglePoint) -> [f64; 3] {
        self.paint_over(point, |_| 0.0)
    }

    /// Returns the paint at a `point` on average over what a sample of a picture covers of its triangle: that
    /// much, its `range`, of a coordinate with a gradient along the axes of the box.
    pub(crate) fn paint_over(&self, point: TrianglePoint, range: impl Fn(DVec3) -> f64) -> [f64; 3] {
        let own = self.corner_paint(point);
        let Some(texture) = self.texture_of(point.triangle) else { return own };
        let corners = self.texture_corners(point.triangle);
        let place = place_between(corners, point.weights.map(f64::from));
        let gradients = self.gradients(point.triangle, corners);
        let colour = texture.colour(place, gradients.map(range));
        from_fn(|part| own[part] * colour[part])
    }

    /// Whether there is a surface where the second and the third corner of a triangle have these weights: its
    /// texture may have holes.
    pub(crate) fn is_solid(&self, triangle: u32, weights: [f64; 2]) -> bool {
        // The measured material of a leaf has the form of its picture.
        let number = self.texture_numbers.get(triangle as usize).copied().unwrap_or(RawModel::NO_TEXTURE);
        let texture = self.textures.get(number as usize).filter(|texture| texture.cutoff > 0);
        texture.is_none_or(|texture| texture.is_solid(place_between(self.texture_corners(triangle), weights)))
    }

    /// The places of a triangle's corners in its texture.
    fn texture_corners(&self, triangle: u32) -> [[f64; 2]; 3] {
        self.faces[triangle as usize].map(|corner| self.texture_places[corner as usize].map(f64::from))
    }

    /// Returns the measured material of this triangle, if it has one.
    #[must_use]
    pub fn material(&self, triangle: u32) -> Option<Material> {
        self.materials.get(triangle as usize).copied().flatten()
    }

    /// The textures with their smaller copies, as [`Self::texture_numbers`] names them.
    #[must_use]
    pub fn textures(&self) -> &[Arc<MipMap>] {
        &self.textures
    }

    /// The number of each triangle's texture, [`RawModel::NO_TEXTURE`] of those that have none; empty if none
    /// has one.
    #[must_use]
    pub fn texture_numbers(&self) -> &[u32] {
        &self.texture_numbers
    }

    /// The place of each corner in the texture of its triangles; empty if there is no texture.
    #[must_use]
    pub fn texture_places(&self) -> &[[f32; 2]] {
        &self.texture_places
    }

    fn texture_of(&self, triangle: u32) -> Option<&MipMap> {
        let number = self.texture_numbers.get(triangle as usize).copied()?;
        let number = if self.material(triangle).is_some() { RawModel::NO_TEXTURE } else { number };
        (number != RawModel::NO_TEXTURE).then(|| &*self.textures[number as usize])
    }

    /// Returns the paint of the corners, mixed at `point`.
    pub(super) fn corner_paint(&self, point: TrianglePoint) -> [f64; 3] {
        if let Some(material) = self.material(point.triangle) {
            return sunlit::colour(Paint::Measured(material), 0.0);
        }
        if self.paints.is_empty() {
            return [1.0; 3];
        }
        let [second, third] = point.weights;
        let weights = [1.0 - second - third, second, third];
        let corners = self.faces[point.triangle as usize];
        from_fn(|part| {
            let of_corner = |(corner, weight): (u32, f32)| weight * self.paints[corner as usize][part];
            f64::from(corners.into_iter().zip(weights).map(of_corner).sum::<f32>()).clamp(0.0, 1.0)
        })
    }

    /// Returns the changes per length along a triangle of the places in its texture, of which its corners
    /// have these.
    fn gradients(&self, triangle: u32, [first, second, third]: [[f64; 2]; 3]) -> [DVec3; 2] {
        let [a, b, c] = self.corners_of(triangle);
        let (along, across) = (b - a, c - a);
        let normal = along.cross(across);
        let scale = 1.0 / normal.length_squared();
        from_fn(|side| {
            let turned = across.cross(normal) * (second[side] - first[side])
                + normal.cross(along) * (third[side] - first[side]);
            turned * scale
        })
    }
}

/// The place where the second and the third corner, of corners at these places, have these weights.
fn place_between([a, b, c]: [[f64; 2]; 3], [second, third]: [f64; 2]) -> [f64; 2] {
    from_fn(|side| a[side] + second * (b[side] - a[side]) + third * (c[side] - a[side]))
}
