//! The triangles of glTF meshes.

use std::borrow::Cow;
use std::rc::Rc;

use glam::{DMat4, DVec3};
use gltf::mesh::{Mode, Semantic};
use gltf::{Accessor, Node, Primitive};

use super::super::super::light::measured;
use super::super::accessor::{PLACES, read, read_indices};
use super::super::limits::check_count;
use super::{LocalMesh, ModelReader, deform};

impl ModelReader<'_> {
    /// Adds the triangles of a `primitive` of `node`, as `placed`; a skinned one is where its joints are.
    pub(super) fn add(
        &mut self,
        primitive: &Primitive<'_>,
        node: &Node<'_>,
        placed: DMat4,
    ) -> Result<(), String> {
        let mode = primitive.mode();
        let (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan, Some(places)) =
            (mode, primitive.get(&Semantic::Positions))
        else {
            self.companions.remark("lines and points are left out".to_owned());
            return Ok(());
        };
        let count = places.count();
        check_count(self.model.corners.len().saturating_add(count) / 3)?;
        let local = self.local(primitive, node, &places)?;
        let indices = &local.indices;
        let triangles =
            if mode == Mode::Triangles { indices.len() / 3 } else { indices.len().saturating_sub(2) };
        let material = primitive.material();
        let coat = self.coat(&material);
        if triangles == 0 || Self::is_unseen(&material, &coat) {
            return Ok(());
        }
        check_count(self.model.triangles.len() + triangles)?;
        let mut corners = Cow::Borrowed(&local.corners);
        if primitive.morph_targets().next().is_some() {
            deform::morph(corners.to_mut(), primitive, node, &self.buffers, &mut self.moves)?;
        }
        let joints = self.joints(node)?.filter(|_| primitive.get(&Semantic::Joints(0)).is_some());
        let placed = match &joints {
            Some(joints) => {
                deform::skin(corners.to_mut(), primitive, joints, &self.buffers, &mut self.moves)?;
                DMat4::IDENTITY
            }
            None => placed,
        };
        let texture = self.add_colours(primitive, count, &coat)?;
        let sides = joints.as_ref().and_then(|joints| joints.first()).unwrap_or(&placed);
        let is_mirrored = sides.determinant() < 0.0;
        let model = &mut self.model;
        let first = model.corners.len() as u32;
        for number in 0..triangles {
            let [a, b, c] = corners_of(mode, number).map(|place| first + indices[place]);
            let is_reversed = is_mirrored != (mode == Mode::TriangleStrip && number % 2 == 1);
            model.triangles.push(if is_reversed { [a, c, b] } else { [a, b, c] });
            model.reversed.push(is_reversed);
        }
        model.texture_numbers.resize(model.triangles.len(), texture);
        let measured = material.name().map_or(Ok(None), measured)?;
        model.materials.resize(model.triangles.len(), measured);
        model.corners.extend(corners.iter().map(|&corner| placed.transform_point3(corner).to_array()));
        Ok(())
    }

    /// Returns the corners of `primitive` of `node`, which are at these `places`, and how its triangles name
    /// them.
    fn local(
        &mut self,
        primitive: &Primitive<'_>,
        node: &Node<'_>,
        places: &Accessor<'_>,
    ) -> Result<Rc<LocalMesh>, String> {
        let key = (node.mesh().map(|mesh| mesh.index()), primitive.index());
        if let Some((_, local)) = self.latest.as_ref().filter(|(known, _)| *known == key) {
            return Ok(Rc::clone(local));
        }
        let corner = |corner: [f32; 3]| DVec3::from(corner.map(f64::from));
        let corners = read::<3>(places, &PLACES, &self.buffers, false)?.into_iter().map(corner).collect();
        let indices = self.indices(primitive, places.count())?;
        let local = Rc::new(LocalMesh { corners, indices });
        self.latest = Some((key, Rc::clone(&local)));
        Ok(local)
    }

    /// The numbers of corners of `primitive`, which has `count` of them, as its triangles name them.
    fn indices(&self, primitive: &Primitive<'_>, count: usize) -> Result<Vec<u32>, String> {
        let Some(indices) = primitive.indices() else { return Ok((0..count as u32).collect()) };
        let indices = read_indices(&indices, &self.buffers)?;
        match indices.iter().find(|&&index| index as usize >= count) {
            Some(index) => Err(format!("a triangle names corner {index}, and its mesh has {count}")),
            None => Ok(indices),
        }
    }
}

/// The places, in the list of indices, of the corners of the triangle of this number, in their order there.
fn corners_of(mode: Mode, number: usize) -> [usize; 3] {
    match mode {
        Mode::TriangleStrip => [number, number + 1, number + 2],
        Mode::TriangleFan => [0, number + 1, number + 2],
        _ => [3 * number, 3 * number + 1, 3 * number + 2],
    }
}
