//! glTF 2.0, as text with files beside it (`.gltf`) or in one piece (`.glb`).
//!
//! Reference: Khronos Group, *glTF 2.0 Specification* (2021), and its extension `KHR_texture_transform`. The
//! triangles of the nodes of its scene are read, with base colour factors and colours of corners, both
//! linear, and base colour textures. Other textures, skins, morphing and animations are passed over, as are
//! lines and points; compressed and sparse data are refused.
//!
//! The crate `gltf` reads text and numbers. It trusts indices, types and lengths, which are checked before
//! they reach it; no file is read but by `beside`.
//!
//! # Accuracy
//!
//! glTF has coordinates in f32, and so the crate has the numbers of nodes; they are placed in f64.

use std::iter;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use gamow_platform::sizes;
use glam::{DMat4, DQuat, DVec3};
use gltf::buffer::Source;
use gltf::json::{Path, validation};
use gltf::mesh::util::{ReadColors, ReadIndices, ReadTexCoords};
use gltf::mesh::{Mode, Semantic};
use gltf::scene::Transform;
use gltf::texture::{Info, WrappingMode};
use gltf::{Document, Gltf, Node, Primitive};
use relativity_core::math;
use relativity_render::{RawModel, Wrap};

use super::super::light::measured;
use super::accessor::{COLOURS, INDICES, PLACES, TEXTURE_PLACES, check, data_of};
use super::limits::check_count;
use super::parts::{NamedModel, NamedPart};
use super::textures::Textures;

/// Extensions that a file may require.
const KNOWN: [&str; 2] = ["KHR_materials_unlit", "KHR_texture_transform"];
/// Length of the head of a `.glb`, bytes.
const HEAD: u32 = 12;

/// Reads files that a model names.
type ReadBeside<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// Reads a model; `beside` reads the files that it names.
pub(super) fn model(bytes: &[u8], beside: ReadBeside<'_>) -> Result<NamedModel, String> {
    let Gltf { document, blob } = document(bytes)?;
    let buffers = buffers(&document, blob, beside)?;
    let mut reader = ModelReader {
        document: &document,
        buffers,
        beside,
        textures: Textures::new(),
        model: RawModel::default(),
    };
    // Parts that have not ended, and how deep their nodes lie.
    let (mut parts, mut open) = (Vec::<NamedPart>::new(), Vec::<(usize, usize)>::new());
    for PlacedNode { node, axes, depth } in placed_nodes(&document)? {
        let first = reader.model.triangles.len();
        while let Some((part, _)) = open.pop_if(|(_, outer)| *outer >= depth) {
            parts[part].triangles[0].end = first;
        }
        if let Some(name) = node.name().or_else(|| node.mesh()?.name()) {
            open.push((parts.len(), depth));
            let triangles = iter::once(first..first).collect();
            parts.push(NamedPart { name: name.to_owned(), triangles });
        }
        for primitive in node.mesh().iter().flat_map(gltf::Mesh::primitives) {
            reader.add(&primitive, axes)?;
        }
    }
    for (part, _) in open {
        parts[part].triangles[0].end = reader.model.triangles.len();
    }
    let ModelReader { textures, mut model, .. } = reader;
    textures.put_into(&mut model);
    Ok(NamedModel { model, parts })
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

/// Returns the sentence of an error that the crate found at this place; `None` of one without a consequence
/// here.
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
    beside: ReadBeside<'_>,
) -> Result<Vec<Vec<u8>>, String> {
    let mut all = Vec::new();
    let mut length = 0;
    for buffer in document.buffers() {
        let data = match buffer.source() {
            Source::Uri(uri) => data_at(uri, "a buffer", beside)?,
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

/// Returns the data at `uri`, those of `what`: in itself, or in a file beside.
fn data_at(uri: &str, what: &str, beside: ReadBeside<'_>) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        let decoded = encoded.and_then(|encoded| STANDARD.decode(encoded).ok());
        return decoded.ok_or_else(|| format!("{what} in it is not base64"));
    }
    let name = percent_encoding::percent_decode_str(uri).decode_utf8();
    beside(&name.map_err(|_| format!("the name of {what} in it is not UTF-8 text"))?)
}

/// A node with its place in the scene.
struct PlacedNode<'a> {
    node: Node<'a>,
    /// From its axes to those of the scene.
    axes: DMat4,
    /// Number of nodes that it lies in.
    depth: usize,
}

/// Returns the nodes of the scene, each before those that it is around.
fn placed_nodes(document: &Document) -> Result<Vec<PlacedNode<'_>>, String> {
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let roots: Vec<Node<'_>> = scene.map_or_else(|| roots(document), |scene| scene.nodes().collect());
    let mut is_seen = vec![false; document.nodes().len()];
    let mut waiting: Vec<_> = roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY, 0)).collect();
    let mut placed = Vec::new();
    while let Some((node, around, depth)) = waiting.pop() {
        if std::mem::replace(&mut is_seen[node.index()], true) {
            return Err(format!("node {} is in its tree twice: nodes must not form circles", node.index()));
        }
        let own = around * transform(&node);
        let children: Vec<_> = node.children().map(|child| (child, own, depth + 1)).collect();
        waiting.extend(children.into_iter().rev());
        placed.push(PlacedNode { node, axes: own, depth });
    }
    Ok(placed)
}

/// Returns the nodes that are in no other.
fn roots(document: &Document) -> Vec<Node<'_>> {
    let mut is_child = vec![false; document.nodes().len()];
    document.nodes().flat_map(|node| node.children()).for_each(|child| is_child[child.index()] = true);
    document.nodes().filter(|node| !is_child[node.index()]).collect()
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

/// A model that is being read.
struct ModelReader<'a> {
    document: &'a Document,
    buffers: Vec<Vec<u8>>,
    beside: ReadBeside<'a>,
    /// By the numbers that the file has for them.
    textures: Textures<usize>,
    model: RawModel,
}

impl ModelReader<'_> {
    /// Adds the triangles of `primitive`, as `placed`.
    fn add(&mut self, primitive: &Primitive<'_>, placed: DMat4) -> Result<(), String> {
        let mode = primitive.mode();
        let (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan, Some(places)) =
            (mode, primitive.get(&Semantic::Positions))
        else {
            return Ok(());
        };
        let count = places.count();
        check(&places, &PLACES, &self.buffers)?;
        check_count(self.model.corners.len().saturating_add(count) / 3)?;
        let indices = self.indices(primitive, count)?;
        let triangles =
            if mode == Mode::Triangles { indices.len() / 3 } else { indices.len().saturating_sub(2) };
        if triangles == 0 {
            return Ok(());
        }
        check_count(self.model.triangles.len() + triangles)?;
        self.add_paints(primitive, count)?;
        let texture = self.add_texture_places(primitive, count)?;
        let model = &mut self.model;
        let first = model.corners.len() as u32;
        let is_mirrored = placed.determinant() < 0.0;
        model.triangles.extend((0..triangles).map(|number| {
            let [a, b, c] = corners_of(mode, number).map(|place| first + indices[place]);
            if is_mirrored { [a, c, b] } else { [a, b, c] }
        }));
        model.texture_numbers.resize(model.triangles.len(), texture);
        let measured = primitive.material().name().map_or(Ok(None), measured)?;
        model.materials.resize(model.triangles.len(), measured);
        let corner =
            |corner: [f32; 3]| placed.transform_point3(DVec3::from(corner.map(f64::from))).to_array();
        let reader = primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
        model.corners.extend(reader.read_positions().into_iter().flatten().map(corner));
        Ok(())
    }

    /// The numbers of corners of `primitive`, which has `count` of them, as its triangles name them.
    fn indices(&self, primitive: &Primitive<'_>, count: usize) -> Result<Vec<u32>, String> {
        let Some(indices) = primitive.indices() else { return Ok((0..count as u32).collect()) };
        check(&indices, &INDICES, &self.buffers)?;
        let reader = primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
        let indices: Vec<u32> = reader.read_indices().into_iter().flat_map(ReadIndices::into_u32).collect();
        match indices.iter().find(|&&index| index as usize >= count) {
            Some(index) => Err(format!("a triangle names corner {index}, and its mesh has {count}")),
            None => Ok(indices),
        }
    }

    /// Adds the paints of the `count` corners of `primitive`: its material's, times their own.
    fn add_paints(&mut self, primitive: &Primitive<'_>, count: usize) -> Result<(), String> {
        let [red, green, blue, _] = primitive.material().pbr_metallic_roughness().base_color_factor();
        let factor = [red, green, blue];
        let paint = |own: [f32; 3]| std::array::from_fn(|part| (own[part] * factor[part]).clamp(0.0, 1.0));
        let Some(colours) = primitive.get(&Semantic::Colors(0)) else {
            self.model.paints.extend(iter::repeat_n(paint([1.0; 3]), count));
            return Ok(());
        };
        check(&colours, &COLOURS, &self.buffers)?;
        if colours.count() != count {
            return Err("a mesh has not as many colours as corners".to_owned());
        }
        let reader = primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
        let colours = reader.read_colors(0).into_iter().flat_map(ReadColors::into_rgb_f32);
        self.model.paints.extend(colours.map(paint));
        Ok(())
    }

    /// Adds the places of the `count` corners of `primitive` in its texture, and returns the number of that.
    fn add_texture_places(&mut self, primitive: &Primitive<'_>, count: usize) -> Result<u32, String> {
        let material = primitive.material();
        let info = material.pbr_metallic_roughness().base_color_texture();
        let found = info.and_then(|info| {
            let transform = info.texture_transform();
            let set = transform.and_then(|transform| transform.tex_coord()).unwrap_or(info.tex_coord());
            Some((primitive.get(&Semantic::TexCoords(set))?, info, set))
        });
        let Some((places, info, set)) = found else {
            self.model.texture_places.extend(iter::repeat_n([0.0; 2], count));
            return Ok(RawModel::NO_TEXTURE);
        };
        check(&places, &TEXTURE_PLACES, &self.buffers)?;
        if places.count() != count {
            return Err("a mesh has not as many places in its texture as corners".to_owned());
        }
        let reader = primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
        let places = reader.read_tex_coords(set).into_iter().flat_map(ReadTexCoords::into_f32);
        self.model.texture_places.extend(places.map(|place| transformed(&info, place)));
        self.texture(&info.texture())
    }

    /// Returns the number of a `texture`, which is read unless it was before.
    fn texture(&mut self, texture: &gltf::Texture<'_>) -> Result<u32, String> {
        let sampler = texture.sampler();
        let wrap = [sampler.wrap_s(), sampler.wrap_t()].map(|mode| match mode {
            WrappingMode::Repeat => Wrap::Repeat,
            WrappingMode::MirroredRepeat => Wrap::Mirror,
            WrappingMode::ClampToEdge => Wrap::Clamp,
        });
        let number = texture.source().index();
        // The crate takes for granted that an image says where it is, and of which kind.
        let image = &self.document.as_json().images[number];
        let (document, buffers, beside) = (self.document, &self.buffers, self.beside);
        self.textures.number(texture.index(), wrap, || {
            let name = format!("image {number}");
            match (&image.uri, image.buffer_view) {
                (Some(uri), _) if uri.starts_with("data:") => Ok((data_at(uri, "an image", beside)?, name)),
                (Some(uri), _) => Ok((data_at(uri, "an image", beside)?, uri.clone())),
                (None, Some(view)) => {
                    let view = document.views().nth(view.value());
                    let data = view.and_then(|view| data_of(&view, buffers));
                    Ok((data.ok_or_else(|| format!("{name} reaches beyond its data"))?.to_vec(), name))
                }
                (None, None) => Err(format!("{name} has no data")),
            }
        })
    }
}

/// Returns a place in the texture of `info`, as its `KHR_texture_transform` moves it.
///
/// The rotation is that of Khronos's own viewer: as seen on the picture, it turns the places
/// counter-clockwise.
fn transformed(info: &Info<'_>, place: [f32; 2]) -> [f32; 2] {
    let Some(transform) = info.texture_transform() else { return place };
    let ([du, dv], [width, height]) = (transform.offset(), transform.scale());
    let (sine, cosine) = math::sin_cos(f64::from(transform.rotation()));
    let [u, v] = [place[0] * width, place[1] * height].map(f64::from);
    [(cosine * u + sine * v) as f32 + du, (cosine * v - sine * u) as f32 + dv]
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
