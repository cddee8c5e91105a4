//! The pictures of textures: PNG and JPEG, distinguished by their first bytes.

use std::io::Cursor;

use relativity_render::geometry::triangles::MOST_TEXELS;
use relativity_render::{Texture, Wrap};

use crate::files::jpeg;
use crate::files::png::PngFile;

/// The first bytes of each format.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";
const JPEG: &[u8] = b"\xff\xd8\xff";

/// Reads a texture with this cutoff; of its texels, at most `room` are wanted.
pub fn texture(bytes: &[u8], wrap: [Wrap; 2], cutoff: u16, room: u64) -> Result<Texture, String> {
    let (size, texels) = match bytes {
        _ if bytes.starts_with(PNG) => png(bytes, room).map_err(|error| format!("as PNG, {error}"))?,
        _ if bytes.starts_with(JPEG) => {
            jpeg::decode(bytes, |size| check(size, room)).map_err(|error| format!("as JPEG, {error}"))?
        }
        _ => return Err("it is neither PNG nor JPEG".to_owned()),
    };
    Ok(Texture { size, texels, wrap, cutoff })
}

fn png(bytes: &[u8], room: u64) -> Result<([u32; 2], Vec<[u8; 4]>), String> {
    // Width and height are the first numbers of the first chunk.
    let side = |at: usize| bytes.get(at..)?.first_chunk().map(|&word| u32::from_be_bytes(word));
    let (Some(width), Some(height)) = (side(16), side(20)) else {
        return Err("it ends too early".to_owned());
    };
    check([width, height], room)?;
    let picture =
        PngFile::decode(Cursor::new(bytes)).map_err(|error| format!("{error:#}"))?.frames.swap_remove(0);
    Ok((picture.size, picture.rgba))
}

/// Refuses more texels than there is `room` for, before they take memory.
fn check([width, height]: [u32; 2], room: u64) -> Result<(), String> {
    if u64::from(width) * u64::from(height) <= room {
        return Ok(());
    }
    Err(format!(
        "it has {width}x{height} pixels; the textures of a scene have at most {MOST_TEXELS} together"
    ))
}
