//! glTF 2.0, as text with files beside it (`.gltf`) or in one piece (`.glb`).
//!
//! Reference: Khronos Group, *glTF 2.0 Specification* (2021), and its extensions `KHR_texture_transform`,
//! `KHR_mesh_quantization`, `KHR_node_visibility`, `EXT_mesh_gpu_instancing` and
//! `KHR_materials_pbrSpecularGlossiness`. The triangles of the nodes of its scene are read, morphed and
//! skinned as they are by default, with base colour factors and colours of corners, both linear, and base
//! colour textures. Other textures and animations are passed over, as are lines and points; compressed data
//! are refused.
//!
//! The crate `gltf` reads text and numbers. It trusts indices, types and lengths, which are checked before
//! they reach it; no file is read but by `companions`.
//!
//! # Accuracy
//!
//! glTF has coordinates in f32, and so the crate has the numbers of nodes; they are placed in f64.

mod deform;
mod document;
mod extensions;
mod material;
mod mesh;
mod nodes;

use std::collections::HashMap;
use std::iter;
use std::rc::Rc;

use glam::{DMat4, DVec3};
use gltf::Document;
use relativity_render::RawModel;

use self::deform::{Joints, Moves};
use self::document::Text;
use self::extensions::Extended;
use self::nodes::{PlacedNode, Tree};
use super::companions::Companions;
use super::parts::{NamedModel, NamedPart};
use super::report::counted;
use super::textures::Textures;

/// Reads the model in the bytes of a glTF file, `.gltf` or `.glb`.
pub(super) fn model(bytes: &[u8], companions: &Companions<'_>) -> Result<NamedModel, String> {
    let text = document::text(bytes, companions)?;
    let compression = extensions::compression(text.document.as_json());
    read(text, companions).map_err(|problem| compression.unwrap_or(problem))
}

fn read(text: Text, companions: &Companions<'_>) -> Result<NamedModel, String> {
    let Text { document, extended, blob } = text;
    let buffers = document::buffers(&document, blob, companions)?;
    let tree = Tree::new(&document, &extended)?;
    if tree.hidden > 0 {
        companions.remark(format!("{} hidden by its nodes", counted(tree.hidden, "mesh is", "meshes are")));
    }
    if let Some(left) = passed_over(&document) {
        companions.remark(left);
    }
    let mut reader = ModelReader {
        document: &document,
        extended: &extended,
        tree: &tree,
        buffers,
        companions,
        textures: Textures::new(),
        joints: HashMap::new(),
        moves: Moves::default(),
        latest: None,
        model: RawModel::default(),
    };
    // Parts that have not ended, and how deep their nodes lie.
    let (mut parts, mut open) = (Vec::<NamedPart>::new(), Vec::<(usize, usize)>::new());
    for placed in &tree.placed {
        let first = reader.model.triangles.len();
        while let Some((part, _)) = open.pop_if(|(_, outer)| *outer >= placed.depth) {
            parts[part].triangles[0].end = first;
        }
        if let Some(name) = placed.node.name().or_else(|| placed.node.mesh()?.name()) {
            open.push((parts.len(), placed.depth));
            let triangles = iter::once(first..first).collect();
            parts.push(NamedPart { name: name.to_owned(), triangles });
        }
        reader.add_node(placed)?;
    }
    for (part, _) in open {
        parts[part].triangles[0].end = reader.model.triangles.len();
    }
    let ModelReader { textures, mut model, .. } = reader;
    textures.put_into(&mut model);
    Ok(NamedModel { model, parts, materials: document.materials().len() })
}

/// Returns what a file has beside its triangles, if there is anything.
fn passed_over(document: &Document) -> Option<String> {
    let counts = [
        (document.animations().len(), "animation", "animations"),
        (document.cameras().len(), "camera", "cameras"),
    ];
    let counts = counts.into_iter().filter(|(count, ..)| *count > 0);
    let has_lights = document.extensions_used().any(|name| name == "KHR_lights_punctual");
    let lights = has_lights.then(|| "its lights".to_owned());
    let all: Vec<_> = counts.map(|(count, one, many)| counted(count, one, many)).chain(lights).collect();
    (!all.is_empty()).then(|| format!("left out: {}", all.join(", ")))
}

/// The numbers of a mesh, if there is one, and of a primitive in it.
type MeshKey = (Option<usize>, usize);

/// A primitive in the axes of its mesh.
struct LocalMesh {
    corners: Vec<DVec3>,
    indices: Vec<u32>,
}

/// A model that is being read.
struct ModelReader<'a> {
    document: &'a Document,
    extended: &'a Extended,
    tree: &'a Tree<'a>,
    buffers: Vec<Vec<u8>>,
    companions: &'a Companions<'a>,
    /// By their numbers in the file, and their cutoffs.
    textures: Textures<(usize, u16)>,
    /// The joints of skins, by the numbers of these.
    joints: HashMap<usize, Joints>,
    moves: Moves,
    /// The primitive that was decoded last, since the next node often has the same mesh.
    latest: Option<(MeshKey, Rc<LocalMesh>)>,
    model: RawModel,
}

impl ModelReader<'_> {
    /// Adds the triangles of a node's mesh: once, or once for each of its instances.
    fn add_node(&mut self, placed: &PlacedNode<'_>) -> Result<(), String> {
        let PlacedNode { node, axes, .. } = placed;
        let Some(mesh) = node.mesh() else { return Ok(()) };
        let instances = match self.extended.instances(node.index()) {
            Some(_) if node.skin().is_some() => {
                return Err(format!(
                    "node {} has instances of a skinned mesh, which are not known here",
                    node.index()
                ));
            }
            Some(attributes) => nodes::instances(self.document, attributes, &self.buffers)?,
            None => vec![DMat4::IDENTITY],
        };
        for primitive in mesh.primitives() {
            for instance in &instances {
                self.add(&primitive, node, *axes * *instance)?;
            }
        }
        Ok(())
    }

    /// Returns the joints of the skin of `node`, if it has one.
    fn joints(&mut self, node: &gltf::Node<'_>) -> Result<Option<Joints>, String> {
        let Some(skin) = node.skin() else { return Ok(None) };
        if let Some(joints) = self.joints.get(&skin.index()) {
            return Ok(Some(joints.clone()));
        }
        let joints = deform::joints(&skin, self.tree, &self.buffers)?;
        self.joints.insert(skin.index(), joints.clone());
        Ok(Some(joints))
    }
}
