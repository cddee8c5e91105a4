//! The text and the data of a glTF file, checked before they are read.

use std::borrow::Cow;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use gamow_platform::sizes;
use gltf::Document;
use gltf::binary::Glb;
use gltf::buffer::Source;
use gltf::json::{Path, Root, deserialize, validation};

use super::super::text::text_of;
use super::Companions;
use super::extensions::{self, Extended};

/// Length of the head of a `.glb`, bytes.
const HEAD: u32 = 12;

/// The text of a file.
pub struct Text {
    pub document: Document,
    pub extended: Extended,
    /// The data of a `.glb`.
    pub blob: Option<Vec<u8>>,
}

/// Reads the text of a file, and checks that all numbers in it name something.
pub fn text(bytes: &[u8], companions: &Companions<'_>) -> Result<Text, String> {
    let length = bytes.get(8..).and_then(|rest| rest.first_chunk()).map(|&word| u32::from_le_bytes(word));
    let is_binary = bytes.starts_with(b"glTF");
    if is_binary && length.is_none_or(|length| length < HEAD) {
        return Err("it is a damaged .glb: its text is not there".to_owned());
    }
    let no_gltf = |error: &dyn std::fmt::Display| format!("it is not glTF: {error}");
    let glb = is_binary.then(|| Glb::from_slice(bytes)).transpose().map_err(|error| no_gltf(&error))?;
    let text = text_of(glb.as_ref().map_or(bytes, |glb| &glb.json));
    let root: Root = deserialize::from_str(&text).map_err(|error| no_gltf(&error))?;
    check(&root, companions)?;
    // Most files have none: to look for them is cheaper than to read the text once more.
    let has_extensions = text.contains("\"extensions\"");
    let extended = if has_extensions { Extended::parse(&text)? } else { Extended::default() };
    drop(text);
    let blob = glb.and_then(|glb| glb.bin).map(Cow::into_owned);
    Ok(Text { document: Document::from_json_without_validation(root), extended, blob })
}

/// Checks that all numbers in a text name something.
fn check(root: &Root, companions: &Companions<'_>) -> Result<(), String> {
    if !root.asset.version.starts_with("2.") {
        return Err(format!("it is glTF {:?}, and must be 2.0", root.asset.version));
    }
    extensions::check(root, companions)?;
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
    problem.map_or(Ok(()), Err)
}

/// Returns the sentence of an error that the crate found at this place; `None` of one without a consequence
/// here.
fn wrong(path: &str, error: validation::Error) -> Option<String> {
    match error {
        // Extensions have been looked at; extents, and places of meshes that have none, are not needed.
        validation::Error::Unsupported => None,
        validation::Error::Missing if path.contains("attributes") => None,
        // The corners of compressed triangles have no data, and are looked at when they are read.
        validation::Error::Missing if path.starts_with("accessors") && path.ends_with("bufferView") => None,
        // A texture may have pictures of other formats alone.
        validation::Error::Missing if path.starts_with("textures") && path.ends_with("source") => None,
        validation::Error::IndexOutOfBounds => Some(format!("{path} names something that there is not")),
        validation::Error::Missing => Some(format!("{path} is missing")),
        validation::Error::Invalid => Some(format!("{path} has a value that glTF 2.0 has not")),
        validation::Error::Oversize => Some(format!("{path} is too large")),
    }
}

/// Returns the binary data of a file: its own (`blob`), in its text, or in files beside.
pub fn buffers(
    document: &Document,
    mut blob: Option<Vec<u8>>,
    companions: &Companions<'_>,
) -> Result<Vec<Vec<u8>>, String> {
    let mut all = Vec::new();
    let mut length = 0;
    for buffer in document.buffers() {
        let data = match buffer.source() {
            Source::Uri(uri) => data_at(uri, "a buffer", companions)?,
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
pub fn data_at(uri: &str, what: &str, companions: &Companions<'_>) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let encoded = data.split_once(";base64,").map(|(_, encoded)| encoded);
        let decoded = encoded.and_then(|encoded| STANDARD.decode(encoded).ok());
        return decoded.ok_or_else(|| format!("{what} in it is not base64"));
    }
    let name = percent_encoding::percent_decode_str(uri).decode_utf8();
    let name = name.map_err(|_| format!("the name of {what} in it is not UTF-8 text"))?;
    companions.find(&name, &[""])
}
