//! Pictures and measurements in, as `gamow render` writes them, with what they say of how they were made.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use anyhow::Context as _;
use exr::meta::MetaData;
use exr::prelude::{FlatSamples, LayerAttributes, Text, f16, read_first_flat_layer_from_file};
use relativity_render::{Gaze, Picture};

use super::exr_file::FINGERPRINT_LINE;
use crate::flags::choices::{FileKind, GazeChoice};
use crate::flags::words::words;

/// How a file was made, as it records it.
#[derive(Debug, Clone, Default)]
pub struct Recorded {
    /// The command line.
    pub command: String,
    flags: BTreeMap<String, String>,
}

impl Recorded {
    fn new(command: String) -> Self {
        let flag = |word: String| {
            let (name, value) = word.strip_prefix("--")?.split_once('=')?;
            Some((name.to_owned(), value.to_owned()))
        };
        Self { flags: words(&command).into_iter().filter_map(flag).collect(), command }
    }

    fn of_png(info: &png::Info<'_>) -> Self {
        let mut texts = info.utf8_text.iter().filter(|chunk| chunk.keyword == "Parameters");
        Self::new(texts.find_map(|chunk| chunk.get_text().ok()).unwrap_or_default())
    }

    fn of_exr(attributes: &LayerAttributes) -> Self {
        let comments = attributes.comments.as_ref().map(Text::as_slice).unwrap_or_default();
        let comments = String::from_utf8_lossy(comments);
        let (command, _) = comments.rsplit_once(FINGERPRINT_LINE).unwrap_or((&comments, ""));
        Self::new(command.to_owned())
    }

    /// The value of the flag `name`.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        self.flags.get(name).map(String::as_str)
    }

    /// The number that the flag `name` has as its value.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.text(name)?.parse().ok()
    }

    /// Where both eyes looked.
    #[must_use]
    pub fn gaze(&self) -> Option<Gaze> {
        self.text("gaze")?.parse::<GazeChoice>().ok()?.fixed()
    }
}

/// How the file of this `kind` at `path` was made, without its pixels.
///
/// # Errors
///
/// A file that cannot be read.
pub fn recorded(path: &Path, kind: FileKind) -> anyhow::Result<Recorded> {
    match kind {
        FileKind::Png => {
            let reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
            Ok(Recorded::of_png(reader.info()))
        }
        FileKind::Exr => {
            let meta = MetaData::read_from_file(path, false)?;
            let first = meta.headers.first().context("it has no layer")?;
            Ok(Recorded::of_exr(&first.own_attributes))
        }
    }
}

/// A picture, of any kind that PNG knows, with 8 bits per component; and how it was made.
///
/// # Errors
///
/// A file that cannot be read, named.
pub fn picture(path: &Path) -> anyhow::Result<(Picture, Recorded)> {
    decoded_png(path).with_context(|| path.display().to_string())
}

fn decoded_png(path: &Path) -> anyhow::Result<(Picture, Recorded)> {
    let mut decoder = png::Decoder::new(BufReader::new(File::open(path)?));
    decoder.set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
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
    Ok((picture, Recorded::of_png(reader.info())))
}

/// The channels of an EXR file, all in f32.
#[derive(Debug, Clone)]
pub struct Measurements {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Values by the name of the channel, such as `left.id`, row by row from the top left.
    pub channels: BTreeMap<String, Vec<f32>>,
    /// What else the file says.
    pub attributes: LayerAttributes,
    /// How it was made.
    pub recorded: Recorded,
}

/// The first layer of an EXR file.
///
/// # Errors
///
/// A file that cannot be read, named.
pub fn measurements(path: &Path) -> anyhow::Result<Measurements> {
    let name = || path.display().to_string();
    let layer = read_first_flat_layer_from_file(path).with_context(name)?.layer_data;
    let channels = layer.channel_data.list.into_iter().map(|channel| {
        let values = match channel.sample_data {
            FlatSamples::F32(values) => values,
            FlatSamples::F16(values) => values.into_iter().map(f16::to_f32).collect(),
            FlatSamples::U32(values) => values.into_iter().map(|value| value as f32).collect(),
        };
        (channel.name.to_string(), values)
    });
    let recorded = Recorded::of_exr(&layer.attributes);
    Ok(Measurements {
        size: [layer.size.0 as u32, layer.size.1 as u32],
        channels: channels.collect(),
        attributes: layer.attributes,
        recorded,
    })
}

impl Measurements {
    /// The channel called `name`.
    ///
    /// # Errors
    ///
    /// That it is not there.
    pub fn channel(&self, name: &str) -> anyhow::Result<&[f32]> {
        self.channels.get(name).map(Vec::as_slice).with_context(|| format!("there is no channel {name}"))
    }
}
