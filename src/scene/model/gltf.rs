//! glTF 2.0, as text with files beside it (`.gltf`) or in one piece (`.glb`).
//!
//! Reference: Khronos Group, *glTF 2.0 Specification* (2021). The triangles of the nodes of its scene are read, with base colour factors and
//! colours of corners, both linear. Textures, skins, morphing and animations are passed over, as are lines and points; compressed and sparse
//! data are refused.
//!
//! The crate `gltf` reads text and numbers. It trusts indices, types and lengths, which are checked before they reach it; no file is
//! read but by `beside`.
//!
//! # Accuracy
//!
//! glTF has coordinates in f32, and so the crate has the numbers of nodes; they are placed in f64.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::{DMat4, DQuat, DVec3};
use gltf::buffer::Source;
use gltf::json::{Path, validation};
use gltf::mesh::{Mode, Semantic};
use gltf::scene::Transform;
use gltf::{Document, Gltf, Node, Primitive};
use relativity_render::Model;

use super::accessor::{COLOURS, INDICES, PLACES, check};
use super::limits::check_count;
use crate::platform::sizes;

/// Extensions that a file may require.
const KNOWN: [&str; 2] = ["KHR_materials_unlit", "KHR_texture_transform"];
/// Length of the head of a `.glb`, bytes.
const HEAD: u32 = 12;

/// Reads a model; `beside` reads the files that it names.
pub(super) fn model(bytes: &[u8], beside: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<Model, String> {
    let Gltf { document, blob } = document(bytes)?;
    let buffers = buffers(&document, blob, beside)?;
    let mut model = Model::default();
    for (node, placed) in placed_nodes(&document)? {
        for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
            add(&primitive, &buffers, placed, &mut model)?;
        }
    }
    Ok(model)
}

/// Reads the text of a file, and checks that all numbers in it name something.
fn document(bytes: &[u8]) -> Result<Gltf, String> {
    let length = bytes.get(8..).and_then(|rest| rest.first_chunk()).map(|&word| u32::from_le_bytes(word));
    if bytes.starts_with(b"glTF") && length.is_none_or(|length| length < HEAD) {
        return Err("it is a damaged .glb: its text is not there".to_owned());
    }
    let gltf =
        Gltf::from_slice_without_validation(bytes).map_err(|error| format!("it is not glTF: {error}"))?;
    let root = gltf.document.as_json();
    if !root.asset.version.starts_with("2.") {
        return Err(format!("it is glTF {:?}, and must be 2.0", root.asset.version));
    }
    if let Some(extension) = root.extensions_required.iter().find(|name| !KNOWN.contains(&name.as_str())) {
        return Err(format!("it needs the extension {extension}, which is not known here"));
    }
    // The check below takes the places of corners for granted.
    let mut accessors = root
        .meshes
        .iter()
        .flat_map(|mesh| &mesh.primitives)
        .flat_map(|primitive| primitive.attributes.values());
    if let Some(accessor) = accessors.find(|accessor| accessor.value() >= root.accessors.len()) {
        return Err(format!("there is no accessor {accessor}"));
    }
    let mut problem = None;
    validation::Validate::validate(root, root, Path::new, &mut |path, error| {
        if problem.is_none() {
            problem = wrong(path().as_str(), error);
        }
    });
    problem.map_or(Ok(gltf), Err)
}

/// Returns the sentence of an error that the crate found at this place; `None` of one without a consequence here.
fn wrong(path: &str, error: validation::Error) -> Option<String> {
    match error {
        // Extensions have been looked at; extents, and places of meshes that have none, are not needed.
        validation::Error::Unsupported => None,
        validation::Error::Missing if path.contains("attributes") => None,
        validation::Error::IndexOutOfBounds => Some(format!("{path} names something that there is not")),
        validation::Error::Missing => Some(format!("{path} is missing")),
        validation::Error::Invalid => Some(format!("{path} has a value that glTF 2.0 has not")),
        validation::Error::Oversize => Some(format!("{path} is too large")),
    }
}

/// Returns the binary data of a file: its own (`blob`), in its text, or in files beside.
fn buffers(
    document: &Document,
    mut blob: Option<Vec<u8>>,
    beside: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<Vec<u8>>, String> {
    let mut all = Vec::new();
    let mut length = 0;
    for buffer in document.buffers() {
        let data = match buffer.source() {
            Source::Uri(uri) => data_at(uri, beside)?,
            Source::Bin => blob.take().ok_or_else(|| format!("buffer {} has no data", buffer.index()))?,
        };
        length += data.len() as u64;
        if length > sizes::MODEL_BYTES {
            return Err(format!(
                "its buffers have more than {} bytes, the most of a model",
                sizes::MODEL_BYTES
            ));
        }
        all.push(data);
    }
    Ok(all)
}

/// Returns the data at `uri`: in itself, or in a file beside.
fn data_at(uri: &str, beside: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        let decoded = encoded.and_then(|encoded| STANDARD.decode(encoded).ok());
        return decoded.ok_or_else(|| "a buffer in it is not base64".to_owned());
    }
    let name = percent_encoding::percent_decode_str(uri).decode_utf8();
    beside(&name.map_err(|_| "the name of a file in it is not UTF-8 text".to_owned())?)
}

/// Returns the nodes of the scene, and from the axes of each to those of the scene.
fn placed_nodes(document: &Document) -> Result<Vec<(Node<'_>, DMat4)>, String> {
    let roots: Vec<Node<'_>> = match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => scene.nodes().collect(),
        None => {
            let mut is_child = vec![false; document.nodes().len()];
            document
                .nodes()
                .flat_map(|node| node.children())
                .for_each(|child| is_child[child.index()] = true);
            document.nodes().filter(|node| !is_child[node.index()]).collect()
        }
    };
    let mut is_seen = vec![false; document.nodes().len()];
    let mut waiting: Vec<_> = roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY)).collect();
    let mut placed = Vec::new();
    while let Some((node, around)) = waiting.pop() {
        if std::mem::replace(&mut is_seen[node.index()], true) {
            return Err(format!("node {} is in its tree twice: nodes must not form circles", node.index()));
        }
        let own = around * transform(&node);
        let children: Vec<_> = node.children().map(|child| (child, own)).collect();
        waiting.extend(children.into_iter().rev());
        placed.push((node, own));
    }
    Ok(placed)
}

fn transform(node: &Node<'_>) -> DMat4 {
    match node.transform() {
        Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)))
        }
        Transform::Decomposed { translation, rotation, scale } => DMat4::from_scale_rotation_translation(
            scale.map(f64::from).into(),
            turn(rotation.map(f64::from)),
            translation.map(f64::from).into(),
        ),
    }
}

/// Returns the rotation of this quaternion; none of a quaternion of no length.
fn turn(quaternion: [f64; 4]) -> DQuat {
    let turn = DQuat::from_array(quaternion);
    if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY }
}

/// Adds the triangles of `primitive` to `model`, as `placed`.
fn add(
    primitive: &Primitive<'_>,
    buffers: &[Vec<u8>],
    placed: DMat4,
    model: &mut Model,
) -> Result<(), String> {
    let mode = primitive.mode();
    let (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan, Some(places)) =
        (mode, primitive.get(&Semantic::Positions))
    else {
        return Ok(());
    };
    let count = places.count();
    check(&places, &PLACES, buffers)?;
    check_count(model.corners.len().saturating_add(count) / 3)?;
    let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
    let indices: Vec<u32> = match primitive.indices() {
        Some(indices) => {
            check(&indices, &INDICES, buffers)?;
            reader.read_indices().into_iter().flat_map(gltf::mesh::util::ReadIndices::into_u32).collect()
        }
        None => (0..count as u32).collect(),
    };
    if let Some(index) = indices.iter().find(|&&index| index as usize >= count) {
        return Err(format!("a triangle names corner {index}, and its mesh has {count}"));
    }
    let triangles = if mode == Mode::Triangles { indices.len() / 3 } else { indices.len().saturating_sub(2) };
    if triangles == 0 {
        return Ok(());
    }
    check_count(model.triangles.len() + triangles)?;
    model.paints.extend(paints(primitive, count, buffers)?);
    let first = model.corners.len() as u32;
    let is_mirrored = placed.determinant() < 0.0;
    model.triangles.extend((0..triangles).map(|number| {
        let [a, b, c] = corners_of(mode, number).map(|place| first + indices[place]);
        if is_mirrored { [a, c, b] } else { [a, b, c] }
    }));
    let corner = |corner: [f32; 3]| placed.transform_point3(DVec3::from(corner.map(f64::from))).to_array();
    model.corners.extend(reader.read_positions().into_iter().flatten().map(corner));
    Ok(())
}

/// Returns the paints of the `count` corners of `primitive`: its material's, times their own.
fn paints(primitive: &Primitive<'_>, count: usize, buffers: &[Vec<u8>]) -> Result<Vec<[f32; 3]>, String> {
    let [red, green, blue, _] = primitive.material().pbr_metallic_roughness().base_color_factor();
    let factor = [red, green, blue];
    let Some(colours) = primitive.get(&Semantic::Colors(0)) else {
        return Ok(vec![factor.map(|part| part.clamp(0.0, 1.0)); count]);
    };
    check(&colours, &COLOURS, buffers)?;
    if colours.count() != count {
        return Err("a mesh has not as many colours as corners".to_owned());
    }
    let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
    let colours = reader.read_colors(0).into_iter().flat_map(gltf::mesh::util::ReadColors::into_rgb_f32);
    let paint = |own: [f32; 3]| std::array::from_fn(|part| (own[part] * factor[part]).clamp(0.0, 1.0));
    Ok(colours.map(paint).collect())
}

/// The places, in the list of indices, of the corners of the triangle of this number.
fn corners_of(mode: Mode, number: usize) -> [usize; 3] {
    match mode {
        Mode::TriangleStrip if number % 2 == 1 => [number + 1, number, number + 2],
        Mode::TriangleStrip => [number, number + 1, number + 2],
        Mode::TriangleFan => [0, number + 1, number + 2],
        _ => [3 * number, 3 * number + 1, 3 * number + 2],
    }
}
