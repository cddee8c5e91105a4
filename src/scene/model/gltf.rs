//! glTF 2.0, as text with files beside it (`.gltf`) or in one piece (`.glb`).
//!
//! Reference: Khronos Group, *glTF 2.0 Specification* (2021). The triangles of the nodes of its scene are read, with base colour factors and
//! colours of corners, both linear. Textures, skins, morphing and animations are passed over, as are lines and points; compressed and sparse
//! data are refused.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::{DMat4, DQuat, DVec3};
use relativity_render::Model;
use serde::Deserialize;

use super::accessor::{Accessor, BufferView, Data};
use super::limits::check_count;

/// Marks of a `.glb`, as its little-endian words have them: the file, and its parts of text and of data.
const MAGIC: u32 = 0x4654_6c67;
const JSON: u32 = 0x4e4f_534a;
const BIN: u32 = 0x004e_4942;
/// Ways to assemble triangles: a list, a strip, a fan.
const LIST: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
struct Document {
    asset: Asset,
    extensions_required: Vec<String>,
    scene: Option<usize>,
    scenes: Vec<Scene>,
    nodes: Vec<Node>,
    meshes: Vec<Mesh>,
    materials: Vec<Material>,
    accessors: Vec<Accessor>,
    buffer_views: Vec<BufferView>,
    buffers: Vec<Buffer>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Asset {
    version: String,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Scene {
    nodes: Vec<usize>,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Node {
    children: Vec<usize>,
    mesh: Option<usize>,
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
}

#[derive(Deserialize)]
struct Mesh {
    primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
struct Primitive {
    attributes: Attributes,
    indices: Option<usize>,
    material: Option<usize>,
    mode: Option<u32>,
}

#[derive(Deserialize)]
struct Attributes {
    #[serde(rename = "POSITION")]
    position: Option<usize>,
    #[serde(rename = "COLOR_0")]
    colour: Option<usize>,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
struct Material {
    pbr_metallic_roughness: Roughness,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
struct Roughness {
    base_color_factor: Option<[f64; 4]>,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
struct Buffer {
    uri: Option<String>,
}

/// Reads a model; `beside` reads the files that it names.
pub(super) fn model(bytes: &[u8], beside: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<Model, String> {
    let (text, own) = if word(bytes, 0) == Some(MAGIC) { parts(bytes)? } else { (bytes, None) };
    let document: Document =
        serde_json::from_slice(text).map_err(|error| format!("it is not glTF: {error}"))?;
    if !document.asset.version.starts_with("2.") {
        return Err(format!("it is glTF {:?}, and must be 2.0", document.asset.version));
    }
    if let Some(extension) = document.extensions_required.first() {
        return Err(format!("it needs the extension {extension}, which is not known here"));
    }
    let buffer = |(number, buffer): (usize, &Buffer)| match (&buffer.uri, own) {
        (Some(uri), _) => data_at(uri, beside),
        (None, Some(own)) if number == 0 => Ok(own.to_vec()),
        (None, _) => Err(format!("buffer {number} has no data")),
    };
    let buffers = document.buffers.iter().enumerate().map(buffer).collect::<Result<Vec<_>, _>>()?;
    let data = Data { accessors: &document.accessors, views: &document.buffer_views, buffers: &buffers };
    let mut model = Model::default();
    for (node, placed) in document.placed_nodes()? {
        if let Some(number) = node.mesh {
            let mesh = document.meshes.get(number).ok_or_else(|| format!("there is no mesh {number}"))?;
            for primitive in &mesh.primitives {
                document.add(primitive, &data, placed, &mut model)?;
            }
        }
    }
    Ok(model)
}

/// The little-endian word at this byte.
fn word(bytes: &[u8], at: usize) -> Option<u32> {
    bytes.get(at..)?.first_chunk().map(|&word| u32::from_le_bytes(word))
}

/// Returns the text of a `.glb`, and its data if it has any.
fn parts(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let part = |at: usize, kind: u32| {
        let end = at.checked_add(8)?.checked_add(word(bytes, at)? as usize)?;
        (word(bytes, at + 4)? == kind).then(|| bytes.get(at + 8..end)).flatten().map(|part| (part, end))
    };
    let (text, end) = part(12, JSON).ok_or("it is a damaged .glb: its text is not there")?;
    Ok((text, part(end, BIN).map(|(data, _)| data)))
}

/// Returns the data at `uri`: in itself, or in a file beside.
fn data_at(uri: &str, beside: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        let decoded = encoded.and_then(|encoded| STANDARD.decode(encoded).ok());
        return decoded.ok_or_else(|| "a buffer in it is not base64".to_owned());
    }
    let name = percent_encoding::percent_decode_str(uri).decode_utf8();
    beside(&name.map_err(|_| "the name of a buffer in it is not UTF-8 text".to_owned())?)
}

impl Document {
    /// Returns the nodes of the scene, and from the axes of each to those of the scene.
    fn placed_nodes(&self) -> Result<Vec<(&Node, DMat4)>, String> {
        let roots: Vec<usize> = match (self.scenes.get(self.scene.unwrap_or(0)), self.scene) {
            (Some(scene), _) => scene.nodes.clone(),
            (None, None) => {
                let mut is_child = vec![false; self.nodes.len()];
                self.nodes.iter().flat_map(|node| &node.children).for_each(|&child| {
                    if let Some(is_child) = is_child.get_mut(child) {
                        *is_child = true;
                    }
                });
                (0..self.nodes.len()).filter(|&node| !is_child[node]).collect()
            }
            (None, Some(scene)) => return Err(format!("there is no scene {scene}")),
        };
        let mut is_seen = vec![false; self.nodes.len()];
        let mut waiting: Vec<_> = roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY)).collect();
        let mut placed = Vec::new();
        while let Some((number, around)) = waiting.pop() {
            let node = self.nodes.get(number).ok_or_else(|| format!("there is no node {number}"))?;
            if std::mem::replace(&mut is_seen[number], true) {
                return Err(format!("node {number} is in its tree twice: nodes must not form circles"));
            }
            let own = around * node.transform();
            placed.push((node, own));
            waiting.extend(node.children.iter().rev().map(|&child| (child, own)));
        }
        Ok(placed)
    }

    /// Adds the triangles of `primitive` to `model`, as `placed`.
    fn add(
        &self,
        primitive: &Primitive,
        data: &Data<'_>,
        placed: DMat4,
        model: &mut Model,
    ) -> Result<(), String> {
        let Some(mode @ (LIST | STRIP | FAN)) = Some(primitive.mode.unwrap_or(LIST)) else { return Ok(()) };
        let Some(position) = primitive.attributes.position else { return Ok(()) };
        let corners = data.vectors(position)?;
        let factor = match primitive.material.map(|number| (number, self.materials.get(number))) {
            None => [1.0; 4],
            Some((_, Some(material))) => {
                material.pbr_metallic_roughness.base_color_factor.unwrap_or([1.0; 4])
            }
            Some((number, None)) => return Err(format!("there is no material {number}")),
        };
        let colours = primitive.attributes.colour.map(|colour| data.vectors(colour)).transpose()?;
        if colours.as_ref().is_some_and(|colours| colours.len() != corners.len()) {
            return Err("a mesh has not as many colours as corners".to_owned());
        }
        let indices = match primitive.indices {
            Some(indices) => data.indices(indices)?,
            None => (0..corners.len() as u32).collect(),
        };
        if let Some(index) = indices.iter().find(|&&index| index as usize >= corners.len()) {
            return Err(format!("a triangle names corner {index}, and its mesh has {}", corners.len()));
        }
        let first = u32::try_from(model.corners.len()).map_err(|_| "it has too many corners".to_owned())?;
        let count = if mode == LIST { indices.len() / 3 } else { indices.len().saturating_sub(2) };
        if count == 0 {
            return Ok(());
        }
        check_count((model.triangles.len() + count).max(model.corners.len() / 3))?;
        let is_mirrored = placed.determinant() < 0.0;
        model.triangles.extend((0..count).map(|number| {
            let [a, b, c] = corners_of(mode, number).map(|place| first + indices[place]);
            if is_mirrored { [a, c, b] } else { [a, b, c] }
        }));
        model
            .corners
            .extend(corners.iter().map(|&corner| placed.transform_point3(DVec3::from(corner)).to_array()));
        let paint = |corner: usize| {
            let own = colours.as_ref().map_or([1.0; 3], |colours| colours[corner]);
            std::array::from_fn(|part| (own[part] * factor[part]).clamp(0.0, 1.0) as f32)
        };
        model.paints.extend((0..corners.len()).map(paint));
        Ok(())
    }
}

/// The places, in the list of indices, of the corners of the triangle of this number.
fn corners_of(mode: u32, number: usize) -> [usize; 3] {
    match mode {
        STRIP if number % 2 == 1 => [number + 1, number, number + 2],
        STRIP => [number, number + 1, number + 2],
        FAN => [0, number + 1, number + 2],
        _ => [3 * number, 3 * number + 1, 3 * number + 2],
    }
}

impl Node {
    fn transform(&self) -> DMat4 {
        if let Some(matrix) = self.matrix {
            return DMat4::from_cols_array(&matrix);
        }
        let turn = self.rotation.map(DQuat::from_array).filter(|turn| turn.length_squared() > 0.0);
        DMat4::from_scale_rotation_translation(
            self.scale.map_or(DVec3::ONE, DVec3::from),
            turn.map_or(DQuat::IDENTITY, DQuat::normalize),
            self.translation.map_or(DVec3::ZERO, DVec3::from),
        )
    }
}
