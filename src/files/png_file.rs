//! PNG files that remember how they were made.
//!
//! The text chunk `Parameters` holds a command line that makes the picture again; `Scene-Fingerprint` tells
//! whether the scene file is still the same.

use std::fs::File;
use std::io::{BufReader, Write};
use std::path::Path;

use relativity_render::Picture;

/// Where a picture comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    /// Name of the scene.
    pub title: String,
    /// A command line that makes the picture again.
    pub parameters: String,
    /// Fingerprint of the scene's content.
    pub scene_fingerprint: String,
}

/// Program and version.
pub const SOFTWARE: &str = concat!("gamow ", env!("CARGO_PKG_VERSION"));

impl Provenance {
    fn chunks(&self) -> [(&'static str, &str); 4] {
        [
            ("Title", &self.title),
            ("Software", SOFTWARE),
            ("Parameters", &self.parameters),
            ("Scene-Fingerprint", &self.scene_fingerprint),
        ]
    }
}

/// `picture` as a PNG file.
///
/// # Errors
///
/// Those of `out`.
pub fn write(picture: &Picture, provenance: &Provenance, out: impl Write) -> anyhow::Result<()> {
    let [width, height] = picture.size;
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    for (keyword, text) in provenance.chunks() {
        encoder.add_itxt_chunk(keyword.to_owned(), text.to_owned())?;
    }
    let rgb: Vec<u8> = picture.rgba.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    Ok(writer.finish()?)
}

/// Whether `path` is a whole PNG file of just this provenance.
#[must_use]
pub fn is_made(path: &Path, provenance: &Provenance) -> bool {
    texts(path).is_some_and(|texts| {
        let has = |(keyword, text): &(&str, &str)| texts.iter().any(|(k, t)| k == keyword && t == text);
        provenance.chunks().iter().all(has)
    })
}

/// Keywords and texts of a PNG file that can be read to its end.
fn texts(path: &Path) -> Option<Vec<(String, String)>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?)).read_info().ok()?;
    let mut pixels = vec![0; reader.output_buffer_size()?];
    reader.next_frame(&mut pixels).ok()?;
    reader.finish().ok()?;
    let text = |chunk: &png::text_metadata::ITXtChunk| Some((chunk.keyword.clone(), chunk.get_text().ok()?));
    reader.info().utf8_text.iter().map(text).collect()
}
