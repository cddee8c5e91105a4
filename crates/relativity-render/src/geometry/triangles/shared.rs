//! The written form of the triangles that bodies share, for another instance of the program.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use glam::{DVec3, Vec3};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::texture::MipMap;
use super::{RawModel, Triangles};
use crate::colour::paint::Material;
use crate::geometry::hierarchy::Hierarchy;

/// The written part of triangles, with the corners as they were rounded.
#[derive(Serialize, Deserialize)]
struct Saved<'a> {
    corners: Cow<'a, [Vec3]>,
    faces: Cow<'a, [[u32; 3]]>,
    reversed: Cow<'a, [bool]>,
    paints: Cow<'a, [[f32; 3]]>,
    materials: Cow<'a, [Option<Material>]>,
    textures: Vec<Cow<'a, MipMap>>,
    texture_numbers: Cow<'a, [u32]>,
    texture_places: Cow<'a, [[f32; 2]]>,
    is_two_sided: bool,
    middle: DVec3,
    half: DVec3,
    /// The hierarchy of the triangles. Building it anew from them would take longer than reading it.
    hierarchy: Cow<'a, Hierarchy>,
    fingerprint: u64,
}

/// Writes the triangles of a body, if it is made of them.
#[expect(clippy::ref_option, reason = "serde calls it so")]
pub fn serialize<S: Serializer>(
    triangles: &Option<Arc<Triangles>>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    triangles.as_deref().map(Saved::from).serialize(serializer)
}

impl<'a> From<&'a Triangles> for Saved<'a> {
    fn from(triangles: &'a Triangles) -> Self {
        let &Triangles { is_two_sided, middle, half, fingerprint, .. } = triangles;
        Self {
            corners: Cow::from(&triangles.corners),
            faces: Cow::from(&triangles.faces),
            reversed: Cow::from(&triangles.reversed),
            paints: Cow::from(&triangles.paints),
            materials: Cow::from(&triangles.materials),
            textures: triangles.textures.iter().map(|texture| Cow::Borrowed(&**texture)).collect(),
            texture_numbers: Cow::from(&triangles.texture_numbers),
            texture_places: Cow::from(&triangles.texture_places),
            is_two_sided,
            middle,
            half,
            hierarchy: Cow::Borrowed(&triangles.hierarchy),
            fingerprint,
        }
    }
}

/// Reads the triangles of a body, if it is made of them.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Arc<Triangles>>, D::Error> {
    let Some(saved) = Option::<Saved<'static>>::deserialize(deserializer)? else { return Ok(None) };
    if saved.faces.iter().flatten().any(|&corner| corner as usize >= saved.corners.len()) {
        return Err(serde::de::Error::custom("a triangle has a corner that there is not"));
    }
    if !saved.materials.is_empty() && saved.materials.len() != saved.faces.len() {
        return Err(serde::de::Error::custom("some triangles have materials, and some do not"));
    }
    let has = |&number: &u32| number == RawModel::NO_TEXTURE || (number as usize) < saved.textures.len();
    if !saved.texture_numbers.iter().all(has) {
        return Err(serde::de::Error::custom("a triangle has a texture that there is not"));
    }
    let read = Triangles {
        corners: saved.corners.into_owned(),
        faces: saved.faces.into_owned(),
        reversed: saved.reversed.into_owned(),
        paints: saved.paints.into_owned(),
        materials: saved.materials.into_owned(),
        textures: saved.textures.into_iter().map(|texture| Arc::new(texture.into_owned())).collect(),
        texture_numbers: saved.texture_numbers.into_owned(),
        texture_places: saved.texture_places.into_owned(),
        is_two_sided: saved.is_two_sided,
        hierarchy: saved.hierarchy.into_owned(),
        middle: saved.middle,
        half: saved.half,
        fingerprint: saved.fingerprint,
        edges: OnceLock::new(),
    };
    Ok(Some(Arc::new(read)))
}
