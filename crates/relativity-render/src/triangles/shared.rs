//! The written form of the triangles that bodies share, for another instance of the program: without their hierarchy, which reading builds anew.

use std::borrow::Cow;
use std::sync::Arc;

use glam::{DVec3, Vec3};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Triangles;
use crate::hierarchy::Hierarchy;

/// The written part of triangles, with the corners as they were rounded.
#[derive(Serialize, Deserialize)]
struct Saved<'a> {
    corners: Cow<'a, [Vec3]>,
    faces: Cow<'a, [[u32; 3]]>,
    paints: Cow<'a, [[f32; 3]]>,
    is_two_sided: bool,
    middle: DVec3,
    half: DVec3,
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
            paints: Cow::from(&triangles.paints),
            is_two_sided,
            middle,
            half,
            fingerprint,
        }
    }
}

/// Reads the triangles of a body, if it is made of them.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Arc<Triangles>>, D::Error> {
    let Some(saved) = Option::<Saved<'static>>::deserialize(deserializer)? else { return Ok(None) };
    let Saved { corners, faces, paints, is_two_sided, middle, half, fingerprint } = saved;
    if faces.iter().flatten().any(|&corner| corner as usize >= corners.len()) {
        return Err(serde::de::Error::custom("a triangle has a corner that there is not"));
    }
    let (corners, faces, paints) = (corners.into_owned(), faces.into_owned(), paints.into_owned());
    let hierarchy = Hierarchy::default();
    let mut read = Triangles { corners, faces, paints, is_two_sided, hierarchy, middle, half, fingerprint };
    read.hierarchy = Hierarchy::new(read.pieces(), DVec3::ZERO);
    Ok(Some(Arc::new(read)))
}
