//! PNG files, with the texts in which they remember how they were made.

use std::io::{BufRead, BufReader, Seek, Write};
use std::path::Path;

use anyhow::Context as _;
use gamow_platform::{files, sizes};
use relativity_render::Picture;

use super::provenance::{SOFTWARE, command_in_texts};

/// Keyword of the text that names the program.
const SOFTWARE_KEYWORD: &str = "Software";

/// Time for which a frame of an animated file is shown, seconds as a fraction: two of them alternate three
/// times a second, which is no more often than flashes may be shown to everybody (W3C, *Web Content
/// Accessibility Guidelines* 2.2, 2.3.1).
pub const FRAME_SECONDS: [u16; 2] = [1, 6];

/// The contents of a PNG file.
#[derive(Debug, Clone)]
pub struct PngFile {
    /// The picture, and, where it is animated, those that follow, all of one size.
    pub frames: Vec<Picture>,
    /// Keywords and texts, in the order of the file.
    pub texts: Vec<(String, String)>,
}

/// A picture for a PNG file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Still {
    /// Pictures of one size, one or several, which are shown one after the other without an end.
    pub frames: Vec<Picture>,
    /// Pixels per metre, if they matter.
    pub pixels_per_metre: Option<u32>,
}

/// `picture` as a PNG file with `texts`, keywords first, and one that names this program.
///
/// # Errors
///
/// Those of `out`.
pub fn write(picture: &Picture, texts: &[(&str, &str)], out: impl Write) -> anyhow::Result<()> {
    write_frames(&[picture], None, texts, out)
}

impl Still {
    /// Writes the picture as a PNG file with `texts`, as [`write()`].
    ///
    /// # Errors
    ///
    /// Those of `out`; no frame.
    pub fn write(&self, texts: &[(&str, &str)], out: impl Write) -> anyhow::Result<()> {
        write_frames(&self.frames.iter().collect::<Vec<_>>(), self.pixels_per_metre, texts, out)
    }
}

fn write_frames(
    frames: &[&Picture],
    pixels_per_metre: Option<u32>,
    texts: &[(&str, &str)],
    out: impl Write,
) -> anyhow::Result<()> {
    let size = frames.first().context("there is nothing to show")?.size;
    let animation = (frames.len() > 1).then(|| {
        Ok::<_, anyhow::Error>(AnimationTiming {
            frames: u32::try_from(frames.len())?,
            seconds: FRAME_SECONDS,
        })
    });
    let mut writer = PngWriter::new(size, animation.transpose()?, pixels_per_metre, texts, out)?;
    for frame in frames {
        writer.write(frame)?;
    }
    writer.finish()
}

/// The timing of an animated file, whose frames repeat without an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AnimationTiming {
    /// Number of frames, 1 or more.
    pub frames: u32,
    /// Time for which each is shown, seconds as a fraction.
    pub seconds: [u16; 2],
}

/// A PNG file that is written frame by frame.
pub struct PngWriter<W: Write> {
    writer: png::Writer<W>,
}

impl<W: Write> PngWriter<W> {
    /// A file of frames of this `size`, pixels, one alone unless there is an `animation`, with `texts`,
    /// keywords first, and one that names this program.
    ///
    /// # Errors
    ///
    /// Those of `out`.
    pub fn new(
        [width, height]: [u32; 2],
        animation: Option<AnimationTiming>,
        pixels_per_metre: Option<u32>,
        texts: &[(&str, &str)],
        out: W,
    ) -> anyhow::Result<Self> {
        let mut encoder = png::Encoder::new(out, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let dimensions =
            |per_metre| png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter };
        encoder.set_pixel_dims(pixels_per_metre.map(dimensions));
        if let Some(AnimationTiming { frames, seconds: [numerator, denominator] }) = animation {
            encoder.set_animated(frames, 0)?;
            encoder.set_frame_delay(numerator, denominator)?;
        }
        for &(keyword, text) in [(SOFTWARE_KEYWORD, SOFTWARE)].iter().chain(texts) {
            encoder.add_itxt_chunk(keyword.to_owned(), text.to_owned())?;
        }
        Ok(Self { writer: encoder.write_header()? })
    }

    /// Adds a frame of the file's size.
    ///
    /// # Errors
    ///
    /// Those of the file; more frames than it was to have.
    pub fn write(&mut self, frame: &Picture) -> anyhow::Result<()> {
        Ok(self.writer.write_image_data(&rgb(frame))?)
    }

    /// Finishes the file.
    ///
    /// # Errors
    ///
    /// Those of the file; fewer frames than it was to have.
    pub fn finish(self) -> anyhow::Result<()> {
        Ok(self.writer.finish()?)
    }
}

/// The pixels of an opaque picture.
#[must_use]
fn rgb(picture: &Picture) -> Vec<u8> {
    picture.rgba.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]).collect()
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
        let read = || Self::decode(BufReader::new(files::open(path)?));
        read().with_context(|| files::shown(path))
    }

    /// The file whose bytes `input` gives, as [`Self::read`].
    ///
    /// # Errors
    ///
    /// What is wrong with it; more than [`sizes::PICTURE_PIXELS`].
    pub fn decode(input: impl BufRead + Seek) -> anyhow::Result<Self> {
        let mut decoder = png::Decoder::new(input);
        decoder
            .set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
        let mut reader = decoder.read_info()?;
        let (width, height) = reader.info().size();
        let (pixels, most) = (u64::from(width) * u64::from(height), sizes::PICTURE_PIXELS);
        anyhow::ensure!(
            pixels <= most,
            "it has {width}x{height} pixels; the limit is {most}, those of 8192x8192"
        );
        let mut bytes = vec![0; reader.output_buffer_size().context("it is too large")?];
        let frame = reader.next_frame(&mut bytes)?;
        let mut frames = vec![picture(&frame, &bytes)];
        let more = reader.info().animation_control().map_or(1, |control| control.num_frames);
        for _ in 1..more.min(MOST_FRAMES) {
            let next = reader.next_frame(&mut bytes)?;
            // Others show what changed, in a part of the picture.
            let is_whole = [next.width, next.height] == frames[0].size;
            frames.extend(is_whole.then(|| picture(&next, &bytes)));
        }
        reader.finish()?;
        Ok(Self { frames, texts: texts(reader.info()) })
    }

    /// The picture; of an animated one, the first.
    #[must_use]
    pub fn picture(&self) -> &Picture {
        &self.frames[0]
    }

    /// The command that made it, as it records it; empty if it does not.
    #[must_use]
    pub fn command(&self) -> &str {
        command_in_texts(&self.texts)
    }
}

/// Greatest number of frames that are read.
const MOST_FRAMES: u32 = 2;

/// The pixels of a decoded frame.
fn picture(frame: &png::OutputInfo, bytes: &[u8]) -> Picture {
    let pixels = bytes[..frame.buffer_size()].chunks_exact(frame.color_type.samples());
    let rgba = pixels.map(|pixel| match *pixel {
        [grey, alpha] => [grey, grey, grey, alpha],
        [r, g, b, alpha] => [r, g, b, alpha],
        _ => [0, 0, 0, u8::MAX], // the transformations leave no other kind
    });
    Picture { size: [frame.width, frame.height], rgba: rgba.collect() }
}

/// Keywords and texts: those in UTF-8, and in Latin-1 as other programs write them, be they compressed or
/// not.
fn texts(info: &png::Info<'_>) -> Vec<(String, String)> {
    // What says too much when it is decompressed says nothing.
    let utf8 = info.utf8_text.iter().map(|chunk| {
        let mut chunk = chunk.clone();
        (chunk.keyword.clone(), chunk.decompress_text().and_then(|()| chunk.get_text()))
    });
    let plain = info.uncompressed_latin1_text.iter();
    let plain = plain.map(|chunk| (chunk.keyword.clone(), Ok(chunk.text.clone())));
    let compressed = info.compressed_latin1_text.iter().map(|chunk| {
        let mut chunk = chunk.clone();
        (chunk.keyword.clone(), chunk.decompress_text().and_then(|()| chunk.get_text()))
    });
    let all = utf8.chain(plain).chain(compressed);
    all.filter_map(|(keyword, text)| Some((keyword, text.ok()?))).collect()
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
