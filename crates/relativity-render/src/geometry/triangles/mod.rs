//! Surfaces made of triangles: models from files, at rest in their group, or turning there as wheels do.
//!
//! A triangle is flat in its rest frame, where rays are straight: so the ray of a pixel meets it exactly, and
//! what light makes of it in a picture (a curved triangle) needs no division. Along the light to a model that
//! turns, which is a curve for it, rays are followed in arcs (`scene/wheel/model.rs`). One hierarchy of
//! boxes, built once, serves every speed, time and eye.
//!
//! # Light
//!
//! A triangle reflects daylight as its paint does: a measured material, or smooth paint, which is what the
//! corners have, times the [`texture`]. Where the opacity of that is below its cutoff, there is a hole.

mod crossing;
mod edges;
mod error;
mod limits;
mod model;
pub(crate) mod packed;
mod paint;
#[cfg(feature = "serde")]
pub(crate) mod shared;
pub mod texture;

use std::collections::HashSet;
use std::sync::{Arc, OnceLock};

use glam::{DVec3, Vec3};
use relativity_core::threads::prelude::*;

use self::edges::Edges;
pub use self::error::TrianglesError;
pub use self::limits::{LEAST_SIZE, MOST_COORDINATE, MOST_TEXELS, MOST_TRIANGLES, MOST_WRAPS};
pub use self::model::RawModel;
pub use self::texture::{Texture, Wrap};
use crate::colour::paint::Material;
use crate::geometry::hierarchy::{BodyPart, Hierarchy};
use crate::geometry::intersect::{Entry, Solid};
use crate::geometry::ray::Ray;
use crate::geometry::shape::strokes::Onlooker;
use crate::geometry::shape::{BoxForm, PreparedShape};
use crate::geometry::triangle_point::TrianglePoint;
use texture::MipMap;

/// The least side of the box around triangles, as a part of its greatest: that of a flat model is not 0.
const LEAST_SIDE: f64 = 1e-4;

/// Triangles in a box, prepared for rays.
#[derive(Debug)]
pub struct Triangles {
    /// From the middle of the box, along its own axes.
    corners: Vec<Vec3>,
    faces: Vec<[u32; 3]>,
    reversed: Vec<bool>,
    paints: Vec<[f32; 3]>,
    materials: Vec<Option<Material>>,
    textures: Vec<Arc<MipMap>>,
    texture_numbers: Vec<u32>,
    texture_places: Vec<[f32; 2]>,
    /// Whether they are seen from both sides.
    pub(crate) is_two_sided: bool,
    hierarchy: Hierarchy,
    middle: DVec3,
    half: DVec3,
    fingerprint: u64,
    edges: OnceLock<Edges>,
}

impl Triangles {
    /// Prepares `model`. Triangles without an area stay in the numbering and are never seen.
    ///
    /// # Accuracy
    ///
    /// Corners are rounded to f32 from the middle of the box around them: to 6e-8 of half its size.
    ///
    /// # Errors
    ///
    /// No triangle with an area; more than [`MOST_TRIANGLES`]; a corner that is not finite or beyond
    /// [`MOST_COORDINATE`]; a model smaller than [`LEAST_SIZE`]; a triangle with a corner that there is not;
    /// paint that is not between 0 and 1, or not for every corner; materials for other than every triangle;
    /// textures with more than [`MOST_TEXELS`], for other than every triangle, or whose places are beyond
    /// [`MOST_WRAPS`].
    pub fn new(model: RawModel) -> Result<Self, TrianglesError> {
        model.check()?;
        let RawModel { corners, triangles, reversed, paints, materials, textures, .. } = model;
        let RawModel { texture_numbers, texture_places, is_two_sided, .. } = model;
        let used = triangles.iter().flatten().map(|&corner| DVec3::from(corners[corner as usize]));
        let [low, high] = used.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], corner| {
            [low.min(corner), high.max(corner)]
        });
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let largest = half.max_element();
        if largest == 0.0 {
            return Err(TrianglesError::NoArea);
        }
        if 2.0 * largest < LEAST_SIZE {
            return Err(TrianglesError::Small { size: 2.0 * largest });
        }
        let corners: Vec<_> =
            corners.par_iter().map(|&corner| (DVec3::from(corner) - middle).as_vec3()).collect();
        let mut prepared = Self {
            corners,
            faces: triangles,
            reversed,
            paints,
            materials,
            textures,
            texture_numbers,
            texture_places,
            is_two_sided,
            hierarchy: Hierarchy::default(),
            middle,
            half: half.max(DVec3::splat(LEAST_SIDE * largest)),
            fingerprint: 0,
            edges: OnceLock::new(),
        };
        prepared.hierarchy = Hierarchy::new(prepared.pieces(), DVec3::ZERO);
        if prepared.hierarchy.is_empty() {
            return Err(TrianglesError::NoArea);
        }
        prepared.fingerprint = prepared.hashed();
        Ok(prepared)
    }

    /// The middle of the box around them, in the rest frame of the group.
    #[must_use]
    pub const fn middle(&self) -> DVec3 {
        self.middle
    }

    /// Half the sides of that box.
    #[must_use]
    pub const fn half(&self) -> DVec3 {
        self.half
    }

    /// Returns the number of triangles, those without an area among them.
    #[must_use]
    pub fn count(&self) -> usize {
        self.faces.len()
    }

    /// Returns the weights of the second and the third corner at a `point`, in the order of the file.
    #[must_use]
    pub fn weights_in_file(&self, point: TrianglePoint) -> [f32; 2] {
        let [second, third] = point.weights;
        let is_reversed = self.reversed.get(point.triangle as usize).is_some_and(|is_reversed| *is_reversed);
        if is_reversed { [third, second] } else { [second, third] }
    }

    /// A hash of all corners, triangles and paints: equal for equal models, and as good as never equal for
    /// others.
    #[must_use]
    pub const fn fingerprint(&self) -> u64 {
        self.fingerprint
    }

    /// Returns the ends of the model's sharp edges, from the middle of the box around it; at most 240, the
    /// longest.
    pub fn sharp_edges(&self) -> impl Iterator<Item = [DVec3; 2]> {
        self.edges().sharp()
    }

    /// Returns the ends of the edges where the surface turns away from `onlooker`, in the axes of the box
    /// around the model, from its middle; at most 240, the longest, and none of the sharp ones.
    pub fn turning_edges(&self, onlooker: Onlooker) -> impl Iterator<Item = [DVec3; 2]> {
        self.edges().turning(onlooker)
    }

    /// Returns the edges, which the first call finds.
    fn edges(&self) -> &Edges {
        self.edges.get_or_init(|| Edges::new(&self.corners, &self.faces, 2.0 * self.half.max_element()))
    }

    /// The corners that triangles have, from the middle of the box.
    pub fn corners(&self) -> impl Iterator<Item = DVec3> {
        self.faces.iter().flatten().map(|&corner| self.corners[corner as usize].as_dvec3())
    }

    /// Returns the first entry of `ray` into these triangles in the box `solid`, in front of the camera.
    ///
    /// # Accuracy
    ///
    /// Places are within 1e-14 of the box's size of the triangle's plane. No ray passes between two triangles
    /// that share corners.
    pub(crate) fn entry(&self, solid: &Solid, ray: &Ray) -> Option<Entry> {
        let (start, from_start) = ray.nearest_to(solid.centre());
        let radius = solid.bounding_radius();
        if start.length_squared() >= radius * radius {
            return None;
        }
        let PreparedShape::Box(BoxForm { axes, .. }) = solid.form else { return None };
        let behind = -ray.from_camera - from_start;
        let crossing = self.crossing(axes.transpose() * start, axes.transpose() * ray.direction, behind)?;
        Some(Entry {
            distance: from_start + crossing.distance,
            position: solid.centre() + (start + ray.direction * crossing.distance),
            normal: axes * crossing.normal,
            triangle: Some(crossing.point),
        })
    }

    /// Returns the point of a triangle in the box `solid` that is nearest to `place`, and its unit normal on
    /// the side from which a ray along `direction` comes.
    pub(crate) fn point_in(
        &self,
        solid: &Solid,
        triangle: u32,
        place: DVec3,
        direction: DVec3,
    ) -> (TrianglePoint, DVec3) {
        let PreparedShape::Box(BoxForm { axes, .. }) = solid.form else {
            return (TrianglePoint { triangle, weights: [0.0; 2] }, -direction);
        };
        let [a, b, c] = self.corners_of(triangle.min(self.faces.len() as u32 - 1));
        let (across, from_first) = ((b - a).cross(c - a), axes.transpose() * (place - solid.centre()) - a);
        let share = |part: DVec3| (part.dot(across) / across.length_squared()) as f32;
        let weights = [share(from_first.cross(c - a)), share((b - a).cross(from_first))];
        (TrianglePoint { triangle, weights }, axes * facing(across, axes.transpose() * direction))
    }

    /// Length of an edge in sides of the box: the sum of what it is along each axis.
    pub(crate) fn relative_length(&self, edge: DVec3) -> f64 {
        (edge.abs() / (2.0 * self.half)).element_sum()
    }

    /// The hierarchy of the triangles' boxes, from the middle of the box around all.
    pub(crate) const fn hierarchy(&self) -> &Hierarchy {
        &self.hierarchy
    }

    /// Returns the corners of the triangle of this number, from the middle of the box.
    pub(crate) fn corners_of(&self, triangle: u32) -> [DVec3; 3] {
        self.faces[triangle as usize].map(|corner| self.corners[corner as usize].as_dvec3())
    }

    /// The boxes around triangles that have an area, each that is seen: of those that have the same corners
    /// the first, unless there are holes.
    fn pieces(&self) -> impl Iterator<Item = BodyPart> {
        let has_holes = self.textures.iter().any(|texture| texture.cutoff > 0);
        let mut is_repeated = self.repeated();
        (0..self.faces.len() as u32).filter_map(move |triangle| {
            let [a, b, c] = self.corners_of(triangle);
            let corners = [a.min(b).min(c), a.max(b).max(c)];
            let has_area = (b - a).cross(c - a) != DVec3::ZERO;
            (has_area && (has_holes || !is_repeated(triangle))).then_some(BodyPart {
                body: triangle,
                is_one_of_some: false,
                corners,
            })
        })
    }

    /// Returns a test of whether an earlier triangle has the same corners; it takes triangles in order.
    fn repeated(&self) -> impl FnMut(u32) -> bool {
        let face = |triangle: u32| {
            let mut face = self.faces[triangle as usize];
            if self.is_two_sided {
                face.sort_unstable();
            }
            face
        };
        // A set that no file can make slow is dear: only triangles that share a slot of a table are put into
        // it. Each has eight, of which one in nine is shared by chance.
        let slots = (8 * self.faces.len()).next_power_of_two();
        let slot = move |[a, b, c]: [u32; 3]| {
            let mixed = [a, b, c].into_iter().fold(0_u64, |mixed, corner| {
                (mixed ^ u64::from(corner)).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29)
            });
            mixed as usize & (slots - 1)
        };
        let mut shared = vec![0_u8; slots];
        for triangle in 0..self.faces.len() as u32 {
            let count = &mut shared[slot(face(triangle))];
            *count = count.saturating_add(1);
        }
        let mut known = HashSet::new();
        move |triangle| {
            let face = face(triangle);
            shared[slot(face)] > 1 && !known.insert(face)
        }
    }

    /// FNV-1a over words of four bytes.
    fn hashed(&self) -> u64 {
        let floats = self.corners.iter().flat_map(Vec3::to_array);
        let floats = floats.chain(self.paints.iter().flatten().copied());
        let floats = floats.chain(self.texture_places.iter().flatten().copied());
        let sides = u32::from(self.is_two_sided);
        let middle = self.middle.to_array().map(f64::to_bits);
        let texels =
            self.textures.iter().flat_map(|texture| &texture.texels).copied().map(u32::from_le_bytes);
        let wraps = self.textures.iter().flat_map(|texture| texture.wrap).map(|wrap| wrap as u32);
        let cutoffs = self.textures.iter().map(|texture| u32::from(texture.cutoff));
        let words = floats.map(f32::to_bits).chain(self.faces.iter().flatten().copied()).chain([sides]);
        let words =
            words.chain(self.texture_numbers.iter().copied()).chain(texels).chain(wraps).chain(cutoffs);
        let materials = self.materials.iter().map(|material| material.map_or(0, |of| of.number() as u64 + 1));
        let words = words.map(u64::from).chain(middle).chain(materials);
        words.fold(0xcbf2_9ce4_8422_2325, |hash: u64, word| (hash ^ word).wrapping_mul(0x0100_0000_01b3))
    }
}

/// The unit vector along `across` or against it, on the side from which a ray along `direction` comes.
pub(crate) fn facing(across: DVec3, direction: DVec3) -> DVec3 {
    let normal = across.normalize();
    if normal.dot(direction) > 0.0 { -normal } else { normal }
}

impl PartialEq for Triangles {
    fn eq(&self, other: &Self) -> bool {
        self.fingerprint == other.fingerprint && self.faces.len() == other.faces.len()
    }
}

impl RawModel {
    /// Prepares the model, to be shared by bodies.
    ///
    /// # Errors
    ///
    /// As [`Triangles::new`].
    pub fn prepared(self) -> Result<Arc<Triangles>, TrianglesError> {
        Triangles::new(self).map(Arc::new)
    }
}
