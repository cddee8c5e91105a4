//! Extensions of glTF: those that are read, those that are refused, and what the crate leaves unread of them.

use std::collections::HashMap;

use gamow_platform::messages;
use gltf::json::Root;
use serde::Deserialize;

use super::Companions;

/// Extensions that a file may require: they are read, or change nothing but light.
const KNOWN: [&str; 22] = [
    "EXT_mesh_gpu_instancing",
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "KHR_xmp_json_ld",
    "MSFT_texture_dds",
];
/// Extensions that compress geometry.
const COMPRESSING: [&str; 3] =
    ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];
/// Beginnings of the names of extensions that change no geometry.
const HARMLESS: [&str; 7] = [
    "KHR_materials_",
    "EXT_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "MSFT_texture_",
    "KHR_lights_",
    "EXT_lights_",
];
/// Other extensions that change no geometry.
const ALSO_HARMLESS: [&str; 9] = [
    "KHR_animation_pointer",
    "KHR_audio_emitter",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_techniques_webgl",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "EXT_mesh_features",
    "EXT_structural_metadata",
];

/// Refuses the extensions that a file requires and that are not known, and remarks on those that it uses and
/// that may change its geometry.
pub fn check(root: &Root, companions: &Companions<'_>) -> Result<(), String> {
    let is_known = |name: &&String| KNOWN.contains(&name.as_str());
    if let Some(name) = root.extensions_required.iter().find(|name| !is_known(name)) {
        return Err(compression(root).unwrap_or_else(|| {
            format!("it needs the extension {}, which is not known here", messages::excerpt(name))
        }));
    }
    let is_harmless =
        |name: &str| HARMLESS.iter().any(|begin| name.starts_with(begin)) || ALSO_HARMLESS.contains(&name);
    let used = root.extensions_used.iter().filter(|name| !is_known(name));
    for name in used.filter(|name| !is_harmless(name) && !COMPRESSING.contains(&name.as_str())) {
        companions.remark(format!("the extension {} is left out", messages::excerpt(name)));
    }
    Ok(())
}

/// Returns the sentence about the compression that a file uses, with the way out; `None` without any.
pub fn compression(root: &Root) -> Option<String> {
    let mut used = root.extensions_required.iter().chain(&root.extensions_used);
    let name = used.find(|name| COMPRESSING.contains(&name.as_str()))?;
    Some(format!(
        "its triangles are compressed ({name}), which is not read here; `npx @gltf-transform/cli copy compressed.glb plain.glb` decompresses it"
    ))
}

/// The part of a file that the crate does not read.
#[derive(Default, Deserialize)]
pub struct Extended {
    #[serde(default)]
    nodes: Vec<Holder<OfNode>>,
    #[serde(default)]
    materials: Vec<Holder<OfMaterial>>,
}

/// An object of a file.
#[derive(Deserialize)]
struct Holder<T> {
    extensions: Option<T>,
}

/// Extensions of a node.
#[derive(Deserialize)]
struct OfNode {
    #[serde(rename = "KHR_node_visibility")]
    visibility: Option<Visibility>,
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    instancing: Option<Instancing>,
}

#[derive(Deserialize)]
struct Visibility {
    #[serde(default = "seen")]
    visible: bool,
}

const fn seen() -> bool {
    true
}

#[derive(Deserialize)]
struct Instancing {
    #[serde(default)]
    attributes: HashMap<String, usize>,
}

/// Extensions of a material.
#[derive(Deserialize)]
struct OfMaterial {
    #[serde(rename = "KHR_materials_pbrSpecularGlossiness")]
    glossiness: Option<Glossiness>,
    #[serde(rename = "KHR_materials_emissive_strength")]
    strength: Option<Strength>,
}

#[derive(Deserialize)]
struct Strength {
    #[serde(default = "one", rename = "emissiveStrength")]
    strength: f32,
}

const fn one() -> f32 {
    1.0
}

/// A material of the older model of specular colour and glossiness.
#[derive(Deserialize)]
pub struct Glossiness {
    /// The diffuse colour, linear, and its opacity.
    #[serde(default = "white", rename = "diffuseFactor")]
    pub factor: [f32; 4],
    /// The picture that multiplies it.
    #[serde(rename = "diffuseTexture")]
    pub texture: Option<TextureInfo>,
}

const fn white() -> [f32; 4] {
    [1.0; 4]
}

/// The use of a texture.
#[derive(Clone, Deserialize)]
pub struct TextureInfo {
    /// The number of the texture.
    pub index: usize,
    #[serde(default, rename = "texCoord")]
    set: u32,
    extensions: Option<OfTexture>,
}

#[derive(Clone, Deserialize)]
struct OfTexture {
    #[serde(rename = "KHR_texture_transform")]
    transform: Option<TextureTransform>,
}

/// The move of places in a texture.
#[derive(Clone, Copy, Deserialize)]
pub struct TextureTransform {
    #[serde(default)]
    pub offset: [f32; 2],
    #[serde(default)]
    pub rotation: f32,
    #[serde(default = "unit")]
    pub scale: [f32; 2],
    #[serde(rename = "texCoord")]
    set: Option<u32>,
}

const fn unit() -> [f32; 2] {
    [1.0; 2]
}

impl TextureInfo {
    /// The number of the set of places.
    pub fn set(&self) -> u32 {
        self.transform().and_then(|transform| transform.set).unwrap_or(self.set)
    }

    /// The move of these places, if there is one.
    pub fn transform(&self) -> Option<TextureTransform> {
        self.extensions.as_ref()?.transform
    }
}

impl From<gltf::texture::Info<'_>> for TextureInfo {
    fn from(info: gltf::texture::Info<'_>) -> Self {
        let transform = info.texture_transform().map(|it| TextureTransform {
            offset: it.offset(),
            rotation: it.rotation(),
            scale: it.scale(),
            set: it.tex_coord(),
        });
        let extensions = Some(OfTexture { transform });
        Self { index: info.texture().index(), set: info.tex_coord(), extensions }
    }
}

impl Extended {
    /// Parses the text of a file.
    pub fn parse(json: &str) -> Result<Self, String> {
        serde_json::from_str(json).map_err(|error| format!("it is not glTF: {error}"))
    }

    /// Whether the node of this number is hidden, with all that is in it.
    pub fn is_hidden(&self, node: usize) -> bool {
        self.node(node).and_then(|node| node.visibility.as_ref()).is_some_and(|it| !it.visible)
    }

    /// The numbers of the accessors of a node's instances, by name, if it has any.
    pub fn instances(&self, node: usize) -> Option<&HashMap<String, usize>> {
        self.node(node)?.instancing.as_ref().map(|it| &it.attributes)
    }

    fn node(&self, node: usize) -> Option<&OfNode> {
        self.nodes.get(node)?.extensions.as_ref()
    }

    fn material(&self, material: Option<usize>) -> Option<&OfMaterial> {
        self.materials.get(material?)?.extensions.as_ref()
    }

    /// The diffuse part of the material of this number, if it has specular colour and glossiness.
    pub fn glossiness(&self, material: Option<usize>) -> Option<&Glossiness> {
        self.material(material)?.glossiness.as_ref()
    }

    /// The strength of the light of the material of this number.
    pub fn strength(&self, material: Option<usize>) -> f32 {
        self.material(material).and_then(|it| it.strength.as_ref()).map_or(1.0, |it| it.strength)
    }
}
