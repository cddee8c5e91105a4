//! PNG files, with the texts in which they remember how they were made.

use std::io::{BufReader, Write};
use std::path::Path;

use anyhow::Context as _;
use relativity_render::Picture;

use super::provenance::{SOFTWARE, command_in_texts};
use crate::platform::files;

/// Keyword of the text that names the program.
const SOFTWARE_KEYWORD: &str = "Software";

/// What a PNG file holds.
#[derive(Debug, Clone)]
pub struct PngFile {
    /// The picture.
    pub picture: Picture,
    /// Keywords and texts, in the order of the file.
    pub texts: Vec<(String, String)>,
}

/// `picture` as a PNG file with `texts`, keywords first, and one that names this program.
///
/// # Errors
///
/// Those of `out`.
pub fn write(picture: &Picture, texts: &[(&str, &str)], out: impl Write) -> anyhow::Result<()> {
    let [width, height] = picture.size;
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    for &(keyword, text) in [(SOFTWARE_KEYWORD, SOFTWARE)].iter().chain(texts) {
        encoder.add_itxt_chunk(keyword.to_owned(), text.to_owned())?;
    }
    let rgb: Vec<u8> = picture.rgba.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    Ok(writer.finish()?)
}

/// Whether `path` is a whole PNG file that this program made with just these `texts`.
#[must_use]
pub fn is_made(path: &Path, texts: &[(&str, &str)]) -> bool {
    PngFile::read(path).is_ok_and(|file| {
        let has = |(keyword, text): &(&str, &str)| file.texts.iter().any(|(k, t)| k == keyword && t == text);
        has(&(SOFTWARE_KEYWORD, SOFTWARE)) && texts.iter().all(has)
    })
}

impl PngFile {
    /// The file at `path`: of any kind that PNG knows, with 8 bits per component.
    ///
    /// # Errors
    ///
    /// A file that cannot be read to its end, named.
    pub fn read(path: &Path) -> anyhow::Result<Self> {
        Self::decoded(path).with_context(|| path.display().to_string())
    }

    fn decoded(path: &Path) -> anyhow::Result<Self> {
        let mut decoder = png::Decoder::new(BufReader::new(files::open(path)?));
        decoder
            .set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
        let mut reader = decoder.read_info()?;
        let mut bytes = vec![0; reader.output_buffer_size().context("it is too large")?];
        let frame = reader.next_frame(&mut bytes)?;
        reader.finish()?;
        let channels = frame.color_type.samples();
        let pixels = bytes[..frame.buffer_size()].chunks_exact(channels);
        let rgba = pixels.map(|pixel| match *pixel {
            [grey, alpha] => [grey, grey, grey, alpha],
            [r, g, b, alpha] => [r, g, b, alpha],
            _ => [0, 0, 0, u8::MAX], // the transformations leave no other kind
        });
        let picture = Picture { size: [frame.width, frame.height], rgba: rgba.collect() };
        Ok(Self { picture, texts: texts(reader.info()) })
    }

    /// The command that made it, as it records it; empty if it does not.
    #[must_use]
    pub fn command(&self) -> &str {
        command_in_texts(&self.texts)
    }
}

/// Keywords and texts.
fn texts(info: &png::Info<'_>) -> Vec<(String, String)> {
    let text = |chunk: &png::text_metadata::ITXtChunk| Some((chunk.keyword.clone(), chunk.get_text().ok()?));
    info.utf8_text.iter().filter_map(text).collect()
}

/// The command that made the PNG file at `path`, as it records it; empty if it does not.
///
/// # Errors
///
/// A file that cannot be read.
pub fn command(path: &Path) -> anyhow::Result<String> {
    let reader = png::Decoder::new(BufReader::new(files::open(path)?)).read_info()?;
    Ok(command_in_texts(&texts(reader.info())).to_owned())
}
