//! Models as they are given: corners, triangles, paint and textures.

use std::sync::Arc;

use super::error::TrianglesError;
use super::limits::{MOST_COORDINATE, MOST_TEXELS, MOST_TRIANGLES, MOST_WRAPS};
use super::texture::MipMap;
use crate::colour::paint::Material;

/// Corners and triangles of a model, not yet prepared.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RawModel {
    /// Corners, in the rest frame of the group.
    pub corners: Vec<[f64; 3]>,
    /// Three corners of each triangle, counter-clockwise as seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the file gives the second and the third corner of each triangle in the other order, as of
    /// mirrored ones. None at all: of no triangle.
    pub reversed: Vec<bool>,
    /// Paint of each corner: reflectances in linear sRGB, 0 to 1, which mix evenly between corners. None at
    /// all is white paint.
    pub paints: Vec<[f32; 3]>,
    /// The measured material of each triangle, which takes the place of its paint and texture; `None` of
    /// those that have smooth paint. None at all: all have.
    pub materials: Vec<Option<Material>>,
    /// Pictures whose colours multiply the paint of triangles, which models may share.
    pub textures: Vec<Arc<MipMap>>,
    /// Number of the texture of each triangle, [`Self::NO_TEXTURE`] of those that have none. None at all: no
    /// triangle has one.
    pub texture_numbers: Vec<u32>,
    /// Place of each corner in the texture of its triangles: from the top left, 1 to the right is its whole
    /// width, 1 down its whole height. They are there if textures are.
    pub texture_places: Vec<[f32; 2]>,
    /// Whether triangles are seen from both sides; else only from where their corners run counter-clockwise.
    pub is_two_sided: bool,
}

impl RawModel {
    /// The texture number of triangles that have none.
    pub const NO_TEXTURE: u32 = u32::MAX;

    /// Finds what [`Triangles`](super::Triangles) refuse.
    pub(super) fn check(&self) -> Result<(), TrianglesError> {
        if self.triangles.len() > MOST_TRIANGLES {
            return Err(TrianglesError::TooMany { count: self.triangles.len() });
        }
        if !self.paints.is_empty() && self.paints.len() != self.corners.len() {
            return Err(TrianglesError::PaintCount {
                paints: self.paints.len(),
                corners: self.corners.len(),
            });
        }
        let is_far = |corner: &[f64; 3]| {
            corner.iter().any(|part| !(-MOST_COORDINATE..=MOST_COORDINATE).contains(part))
        };
        if let Some(number) = self.corners.iter().position(is_far) {
            return Err(TrianglesError::Coordinate { number, place: self.corners[number] });
        }
        if !self.materials.is_empty() && self.materials.len() != self.triangles.len() {
            return Err(TrianglesError::MaterialCount {
                materials: self.materials.len(),
                triangles: self.triangles.len(),
            });
        }
        let is_unreal = |paint: &[f32; 3]| paint.iter().any(|part| !(0.0..=1.0).contains(part));
        if let Some(number) = self.paints.iter().position(is_unreal) {
            return Err(TrianglesError::Paint { number, paint: self.paints[number] });
        }
        let count = self.corners.len();
        let lacks = |triangle: &[u32; 3]| triangle.iter().any(|&corner| corner as usize >= count);
        match self.triangles.iter().position(lacks) {
            Some(triangle) => Err(TrianglesError::NoCorner { triangle, count }),
            None if self.triangles.is_empty() => Err(TrianglesError::NoArea),
            None => self.check_textures(),
        }
    }

    fn check_textures(&self) -> Result<(), TrianglesError> {
        let texels = self.textures.iter().map(|texture| texture.count()).fold(0, u64::saturating_add);
        if texels > MOST_TEXELS {
            return Err(TrianglesError::ManyTexels { texels });
        }
        let has = |number: &u32| *number == Self::NO_TEXTURE || (*number as usize) < self.textures.len();
        let places = if self.texture_numbers.is_empty() { 0 } else { self.corners.len() };
        let is_counted =
            self.texture_numbers.is_empty() || self.texture_numbers.len() == self.triangles.len();
        if !is_counted || self.texture_places.len() != places || !self.texture_numbers.iter().all(has) {
            return Err(TrianglesError::TextureCount);
        }
        let is_far = |place: &[f32; 2]| place.iter().any(|part| !(-MOST_WRAPS..=MOST_WRAPS).contains(part));
        match self.texture_places.iter().position(is_far) {
            Some(number) => Err(TrianglesError::TexturePlace { number, place: self.texture_places[number] }),
            None => Ok(()),
        }
    }
}
