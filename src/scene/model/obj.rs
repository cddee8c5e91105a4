//! Wavefront OBJ: corners, faces, and the colours and textures of materials.
//!
//! Faces are divided from their first corner, as flat convex ones may be. Objects and groups name its parts.
//! Everything else in a file (normals, lines, smoothing) is passed over. The crate `tobj` reads what
//! [`lines`](super::lines) have been checked of it: numbers in f64, and faces by material.

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::path::Path;

use gamow_platform::messages;
use relativity_render::colour::srgb_decoded;
use relativity_render::{RawModel, Wrap};
use tobj::{LoadError, LoadOptions, Mesh};

use super::super::light::measured;
use super::companions::Companions;
use super::lines::{Lines, Problems};
use super::materials::{Map, Material, Materials};
use super::parts::{NamedModel, NamedPart};
use super::text::text_of;
use super::textures::{HALF_OPAQUE, Textures, cutoff};

/// Paint of what has none.
const WHITE: [f32; 3] = [1.0; 3];

/// Reads the model in the bytes of an OBJ file.
pub(super) fn model(bytes: &[u8], companions: &Companions<'_>) -> Result<NamedModel, String> {
    let (problems, text) = (Problems::default(), text_of(bytes));
    let mut lines = Lines::new(&text, &problems);
    let options =
        LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..LoadOptions::default() };
    let materials = RefCell::new(Materials::default());
    let library = |names: &Path| {
        let loaded = materials.borrow_mut().load(&names.to_string_lossy(), companions);
        loaded.unwrap_or_else(|problem| {
            problems.add(&problem);
            Err(LoadError::OpenFileFailed)
        })
    };
    let loaded = tobj::load_obj_buf(&mut lines, &options, library);
    problems.first()?;
    let (meshes, _) = loaded.map_err(|error| problems.located(&error.to_string()))?;
    let materials = materials.into_inner().all;
    let mut reader = ModelReader { companions, textures: Textures::new(), model: RawModel::default() };
    // Those of several materials are in several pieces.
    let (mut parts, mut numbers) = (Vec::<NamedPart>::new(), HashMap::new());
    for tobj::Model { mesh, name } in &meshes {
        let material = mesh.material_id.and_then(|number| materials.get(number));
        let first = reader.model.triangles.len();
        reader.add(mesh, material)?;
        let number = *numbers.entry(name).or_insert_with(|| {
            parts.push(NamedPart { name: name.clone(), triangles: Vec::new() });
            parts.len() - 1
        });
        parts[number].triangles.push(first..reader.model.triangles.len());
    }
    let ModelReader { textures, mut model, .. } = reader;
    textures.put_into(&mut model);
    let used: HashSet<_> = meshes.iter().filter_map(|it| it.mesh.material_id).collect();
    Ok(NamedModel { model, parts, materials: used.len() })
}

/// A model that is being read.
struct ModelReader<'a> {
    companions: &'a Companions<'a>,
    /// By the folders and names of their files, their continuation, and their cutoffs.
    textures: Textures<(String, String, Wrap, u16)>,
    model: RawModel,
}

impl ModelReader<'_> {
    /// Adds the triangles of a mesh of one material.
    fn add(&mut self, mesh: &Mesh, material: Option<&Material>) -> Result<(), String> {
        let map = material.and_then(|it| it.picture.as_ref()).filter(|_| !mesh.texcoord_indices.is_empty());
        let cutoff = material.map_or(0, |it| self.cutoff_of(it));
        let texture = map.map_or(RawModel::NO_TEXTURE, |map| self.texture(map, cutoff));
        // Beside a picture, black is what some programs write for no colour.
        let diffuse = material.and_then(|it| it.diffuse).filter(|it| map.is_none() || *it != [0.0; 3]);
        let paint = diffuse.unwrap_or(WHITE);
        let (places, colours) = (mesh.positions.as_chunks::<3>().0, mesh.vertex_color.as_chunks::<3>().0);
        let (in_textures, model) = (mesh.texcoords.as_chunks::<2>().0, &mut self.model);
        let mut numbers = HashMap::new();
        for (at, &corner) in mesh.indices.iter().enumerate() {
            let in_texture = map.map(|map| (map, mesh.texcoord_indices[at] as usize));
            let key = (corner, in_texture.map(|(_, number)| number));
            let number = *numbers.entry(key).or_insert_with(|| {
                let own = colours[corner as usize];
                let own = (!own[0].is_nan()).then(|| own.map(|part| srgb_decoded(part) as f32));
                model.corners.push(places[corner as usize]);
                model.paints.push(own.unwrap_or(paint));
                let place = in_texture.map_or([0.0; 2], |(map, number)| map.placed(in_textures[number]));
                model.texture_places.push(place);
                model.corners.len() as u32 - 1
            });
            match model.triangles.last_mut().filter(|_| at % 3 != 0) {
                Some(triangle) => triangle[at % 3] = number,
                None => model.triangles.push([number; 3]),
            }
        }
        model.texture_numbers.resize(model.triangles.len(), texture);
        let measured = material.map_or(Ok(None), |material| measured(&material.name))?;
        model.materials.resize(model.triangles.len(), measured);
        Ok(())
    }

    /// Returns the cutoff of the texture of a `material`: one half where the library names the same picture
    /// for the opacity, else 0.
    fn cutoff_of(&self, material: &Material) -> u16 {
        let Some(mask) = &material.mask else { return 0 };
        if material.picture.as_ref().is_some_and(|picture| picture.file == mask.file) {
            return cutoff(HALF_OPAQUE);
        }
        let name = messages::excerpt(&mask.file);
        self.companions.remark(format!("the mask {name} is left out: only a picture's own opacity is read"));
        0
    }

    /// Returns the number of the texture of a material, with this cutoff.
    fn texture(&mut self, map: &Map, cutoff: u16) -> u32 {
        let key = (map.folder.clone(), map.file.clone(), map.wrap, cutoff);
        self.textures.number(key, [map.wrap; 2], cutoff, self.companions, || {
            Ok((self.companions.find(&map.file, &["", &map.folder])?, map.file.clone()))
        })
    }
}
