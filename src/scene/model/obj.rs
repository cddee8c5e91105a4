//! Wavefront OBJ: corners, faces, and the colours and textures of materials.
//!
//! Faces are divided from their first corner, as flat convex ones may be. Objects and groups name its parts.
//! Everything else in a file (normals, lines, smoothing) is passed over. The crate `tobj` reads what
//! [`lines`](super::lines) have been checked of it: numbers in f64, and faces by material.

use std::collections::HashMap;
use std::path::Path;

use relativity_render::colour::srgb_decoded;
use relativity_render::{RawModel, Wrap};
use tobj::{LoadError, LoadOptions, MTLLoadResult, Material, Mesh};

use super::super::light::measured;
use super::lines::{Lines, Problems, text_of};
use super::parts::{NamedModel, NamedPart};
use super::textures::Textures;

/// Paint of what has none.
const WHITE: [f32; 3] = [1.0; 3];

/// Reads a model; `beside` reads the files that it names.
pub(super) fn model(
    bytes: &[u8],
    beside: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<NamedModel, String> {
    let problems = Problems::default();
    let mut lines = Lines::new(text_of(bytes)?, &problems);
    let options =
        LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..LoadOptions::default() };
    let library = |name: &Path| {
        let read = library(&name.to_string_lossy(), beside);
        read.unwrap_or_else(|problem| {
            problems.add(&problem);
            Err(LoadError::OpenFileFailed)
        })
    };
    let loaded = tobj::load_obj_buf(&mut lines, &options, library);
    problems.first()?;
    let (meshes, materials) = loaded.map_err(|error| problems.located(&error.to_string()))?;
    let materials = materials.map_err(|error| problems.located(&error.to_string()))?;
    let (mut model, mut textures) = (RawModel::default(), Textures::new());
    // Those of several materials are in several pieces.
    let (mut parts, mut numbers) = (Vec::<NamedPart>::new(), HashMap::new());
    for tobj::Model { mesh, name } in &meshes {
        let material = mesh.material_id.and_then(|number| materials.get(number));
        let first = model.triangles.len();
        add(mesh, material, beside, &mut model, &mut textures)?;
        let number = *numbers.entry(name).or_insert_with(|| {
            parts.push(NamedPart { name: name.clone(), triangles: Vec::new() });
            parts.len() - 1
        });
        parts[number].triangles.push(first..model.triangles.len());
    }
    textures.put_into(&mut model);
    Ok(NamedModel { model, parts })
}

/// Reads the materials in the file called `name`: their diffuse colours, linear, and textures.
fn library(name: &str, beside: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<MTLLoadResult, String> {
    let bytes = beside(&name.replace('\\', "/"))?;
    let mut kept = String::new();
    for line in text_of(&bytes)?.lines() {
        let (word, rest) = line.trim().split_once(char::is_whitespace).unwrap_or((line.trim(), ""));
        let needed = match word {
            "newmtl" => (rest.is_empty()).then_some("a name"),
            "map_Kd" => (rest.is_empty()).then_some("a file"),
            "Kd" => {
                let numbers = rest.split_whitespace().take(3).map(str::parse::<f64>);
                (numbers.flatten().count() < 3).then_some("three numbers")
            }
            _ => continue,
        };
        if let Some(needed) = needed {
            return Err(format!("{word} in {name} needs {needed}"));
        }
        kept.extend([word, " ", rest.trim(), "\n"]);
    }
    Ok(tobj::load_mtl_buf(&mut kept.as_bytes()))
}

/// Adds the triangles of a mesh of one material to `model`.
fn add(
    mesh: &Mesh,
    material: Option<&Material>,
    beside: &dyn Fn(&str) -> Result<Vec<u8>, String>,
    model: &mut RawModel,
    textures: &mut Textures<String>,
) -> Result<(), String> {
    let texture = match material.and_then(|material| material.diffuse_texture.as_ref()) {
        Some(name) if !mesh.texcoord_indices.is_empty() => Some(texture(name, beside, textures)?),
        _ => None,
    };
    let diffuse =
        material.and_then(|material| material.diffuse).map(|colour| colour.map(|part| part.clamp(0.0, 1.0)));
    // Beside a texture, black is what some programs write for no colour.
    let diffuse = diffuse.filter(|colour| texture.is_none() || *colour != [0.0; 3]);
    let paint = diffuse.map_or(WHITE, |colour| colour.map(|part| part as f32));
    let (places, colours) = (mesh.positions.as_chunks::<3>().0, mesh.vertex_color.as_chunks::<3>().0);
    let in_textures = mesh.texcoords.as_chunks::<2>().0;
    let mut numbers = HashMap::new();
    for (at, &corner) in mesh.indices.iter().enumerate() {
        let in_texture = texture.map(|_| mesh.texcoord_indices[at] as usize);
        let number = *numbers.entry((corner, in_texture)).or_insert_with(|| {
            let own = colours[corner as usize];
            let own = (!own[0].is_nan()).then(|| own.map(|part| srgb_decoded(part) as f32));
            model.corners.push(places[corner as usize]);
            model.paints.push(own.unwrap_or(paint));
            // The first row of a picture is at the top.
            let place = in_texture.map_or([0.0, 1.0], |number| in_textures[number]);
            model.texture_places.push([place[0] as f32, (1.0 - place[1]) as f32]);
            model.corners.len() as u32 - 1
        });
        match model.triangles.last_mut().filter(|_| at % 3 != 0) {
            Some(triangle) => triangle[at % 3] = number,
            None => model.triangles.push([number; 3]),
        }
    }
    model.texture_numbers.resize(model.triangles.len(), texture.unwrap_or(RawModel::NO_TEXTURE));
    let measured = material.map_or(Ok(None), |material| measured(&material.name))?;
    model.materials.resize(model.triangles.len(), measured);
    Ok(())
}

/// Returns the number of the texture in the file called `name`.
fn texture(
    name: &str,
    beside: &dyn Fn(&str) -> Result<Vec<u8>, String>,
    textures: &mut Textures<String>,
) -> Result<u32, String> {
    if name.starts_with('-') {
        return Err(format!("map_Kd {name} has options, which are not known here"));
    }
    let name = name.replace('\\', "/");
    textures.number(name.clone(), [Wrap::Repeat; 2], || Ok((beside(&name)?, name)))
}
