//! EXR files of what every pixel shows, for measurement: for each of the layers `left` and `right` every
//! [`Channel`], in f32.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{BufReader, Read, Seek, Write};
use std::path::Path;

use anyhow::Context as _;
use exr::block::reader::{ChunksReader as _, Reader};
use exr::meta::header::Header;
use exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes, LineOrder,
    ReadChannels as _, ReadLayers as _, SmallVec, Text, WritableImage, f16, read,
};
use gamow_platform::files::{self, Regular};
use gamow_platform::sizes;
use relativity_core::doppler::{intensity_factor, received_wavelength};
use relativity_render::picture::rectify::LightCorrection;
use relativity_render::{Appearance, Emission, Hit, HitImage, Paint, PreparedScene};

use super::provenance::{SOFTWARE, command_in_comments};

/// The layers: the eyes, in the order in which two eyes are given everywhere.
pub const EYES: [&str; 2] = ["left", "right"];

/// The wavelength of light that has none of its own, and of nothing.
const NO_WAVELENGTH_NM: f64 = 0.0;

/// The angle on a wheel of what turns on none, and of nothing: no angle, which lie in [-pi, pi].
pub const NO_ANGLE: f32 = -10.0;

/// The number of the measured material of what has none.
const NO_MATERIAL: f32 = -1.0;

/// The number of the triangle of what is made of none, and of nothing.
const NO_TRIANGLE: f32 = -1.0;

/// A measured quantity, in a channel of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// Number of the body, -1 where nothing is seen.
    Id,
    /// Number of the group it moves with, -1 where nothing is seen.
    Group,
    /// From the aperture to the place where the light left.
    Distance,
    /// Time when the light left.
    EmissionTime,
    /// When that was by the clocks of the group that the body moves with.
    ProperTime,
    /// Point of a wheel that emitted the light: its angle about the axle at t' = 0 by those clocks, radians
    /// from +x towards +z; -10 for bodies that turn about no axle.
    MaterialAngle,
    /// Number of the measured material that reflects daylight there, in the order of
    /// [`relativity_render::Material::ALL`]; -1 of other paint, of light and of nothing.
    Material,
    /// Received over rest frequency.
    Doppler,
    /// Received wavelength, nm; 0 where the light is white.
    WavelengthNm,
    /// Received over rest intensity, before any exposure: D^n of one wavelength, the luminance of what has
    /// many; 3.4e38 where it is more.
    Intensity,
    /// Place where the light left, in the rest frame of the body's group, along the motion.
    RestX,
    /// Depth of that place.
    RestY,
    /// Height of that place.
    RestZ,
    /// Number of the triangle in its model, -1 where none is seen. Numbers up to 2^24 are exact in f32, which
    /// is more than a model has.
    Triangle,
    /// Barycentric coordinates of that place: the weight of the triangle's second corner; 0 where none is
    /// seen.
    TriangleB,
    /// The weight of its third corner; 0 where none is seen.
    TriangleC,
}

/// Every channel, in the order of [`Channel`].
static CHANNELS: [Definition; 16] = [
    same(Channel::Id, "id", -1.0, |hit, _| hit.body as f64),
    same(Channel::Group, "group", -1.0, |hit, light| light.scene.group_of(hit.body) as f64),
    // Rest lengths along a ray: s* = s/D.
    corrected(Channel::Distance, "distance", |hit, _| hit.distance, |doppler, _| 1.0 / doppler),
    same(Channel::EmissionTime, "emission_time", 0.0, |hit, _| hit.emission_time),
    same(Channel::ProperTime, "proper_time", 0.0, |hit, _| hit.proper_time),
    same(Channel::MaterialAngle, "material_angle", NO_ANGLE, material_angle),
    same(Channel::Material, "material", NO_MATERIAL, material),
    corrected(Channel::Doppler, "doppler", |hit, _| hit.doppler_factor, |doppler, _| 1.0 / doppler),
    corrected(Channel::WavelengthNm, "wavelength_nm", received_nm, wavelength_correction),
    corrected(Channel::Intensity, "intensity", received_intensity, intensity_correction),
    same(Channel::RestX, "rest_x", 0.0, |hit, _| hit.rest_position.x),
    same(Channel::RestY, "rest_y", 0.0, |hit, _| hit.rest_position.y),
    same(Channel::RestZ, "rest_z", 0.0, |hit, _| hit.rest_position.z),
    same(Channel::Triangle, "triangle", NO_TRIANGLE, |hit, _| {
        hit.triangle.map_or(NO_TRIANGLE.into(), |point| f64::from(point.triangle))
    }),
    same(Channel::TriangleB, "triangle_b", 0.0, |hit, light| triangle_weight(hit, light, 0)),
    same(Channel::TriangleC, "triangle_c", 0.0, |hit, light| triangle_weight(hit, light, 1)),
];

/// A row of the table of channels.
struct Definition {
    channel: Channel,
    /// Name in the file, after the layer's.
    name: &'static str,
    /// Value where nothing is seen.
    nothing: f32,
    /// Computes the value where a body is seen.
    value: fn(&Hit, &ChannelLight<'_>) -> f64,
    /// Factor of the value on the way to the frame of the bodies, for a Doppler factor.
    factor: fn(f64, LightCorrection) -> f64,
}

/// A channel that is the same in the frame of the bodies.
const fn same(
    channel: Channel,
    name: &'static str,
    nothing: f32,
    value: fn(&Hit, &ChannelLight<'_>) -> f64,
) -> Definition {
    Definition { channel, name, nothing, value, factor: |_, _| 1.0 }
}

/// A channel that is not.
const fn corrected(
    channel: Channel,
    name: &'static str,
    value: fn(&Hit, &ChannelLight<'_>) -> f64,
    factor: fn(f64, LightCorrection) -> f64,
) -> Definition {
    Definition { channel, name, nothing: 0.0, value, factor }
}

impl Channel {
    const fn definition(self) -> &'static Definition {
        &CHANNELS[self as usize]
    }

    /// Returns the name in a file, after that of the layer and a dot.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.definition().name
    }

    /// The channel that is called `name` in a file, whichever layer it is in. Colours, as other programs
    /// write them, are intensities.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        match name.rsplit('.').next()? {
            "R" | "G" | "B" | "Y" => Some(Self::Intensity),
            name => CHANNELS.iter().find(|row| row.name == name).map(|row| row.channel),
        }
    }

    /// Returns the value where nothing is seen.
    #[must_use]
    pub const fn nothing(self) -> f32 {
        self.definition().nothing
    }

    /// Returns the factor of the value when light with the Doppler factor `doppler` is corrected to the frame
    /// of the bodies.
    #[must_use]
    pub fn factor(self, doppler: f64, correction: LightCorrection) -> f64 {
        (self.definition().factor)(doppler, correction)
    }
}

/// The data that channels need beside the hits.
#[derive(Debug, Clone, Copy)]
pub struct ChannelLight<'a> {
    /// Scene, in whose bodies turning wheels are looked up.
    pub scene: &'a PreparedScene,
    /// Appearance, by which wavelength and intensity are worked out.
    pub appearance: Appearance,
}

fn material_angle(hit: &Hit, light: &ChannelLight<'_>) -> f64 {
    let spin = light.scene.bodies()[hit.body].spin;
    spin.map_or(f64::from(NO_ANGLE), |spin| spin.angle(hit.material_position))
}

fn material(hit: &Hit, light: &ChannelLight<'_>) -> f64 {
    let body = &light.scene.bodies()[hit.body];
    let of_triangle =
        || hit.triangle.zip(body.triangles.as_ref()).and_then(|(point, all)| all.material(point.triangle));
    let material = match body.emission {
        Emission::Painted(Paint::Measured(own)) => Some(own),
        Emission::Painted(Paint::Smooth(_)) => of_triangle(),
        Emission::Wavelength(_) | Emission::Glowing(_) => None,
    };
    material.map_or(NO_MATERIAL.into(), |material| material.number() as f64)
}

/// Returns the weight of a triangle's second corner in its file, or of its third: `corner` is 0 or 1.
fn triangle_weight(hit: &Hit, light: &ChannelLight<'_>, corner: usize) -> f64 {
    let triangles = light.scene.bodies()[hit.body].triangles.as_ref();
    let weights = hit.triangle.zip(triangles).map(|(point, triangles)| triangles.weights_in_file(point));
    weights.map_or(0.0, |weights| f64::from(weights[corner]))
}

/// Returns `value` as files store it: beyond f32 its largest number.
fn in_f32(value: f64) -> f32 {
    (value as f32).clamp(f32::MIN, f32::MAX)
}

fn received_nm(hit: &Hit, light: &ChannelLight<'_>) -> f64 {
    let rest_nm = light.scene.bodies()[hit.body].emission.wavelength_nm();
    rest_nm.map_or(NO_WAVELENGTH_NM, |rest_nm| received_wavelength(rest_nm, hit.doppler_factor))
}

fn received_intensity(hit: &Hit, light: &ChannelLight<'_>) -> f64 {
    let emission = light.scene.bodies()[hit.body].emission;
    relativity_render::received_intensity(emission, &light.appearance, hit.doppler_factor)
}

fn wavelength_correction(doppler: f64, correction: LightCorrection) -> f64 {
    if correction.doppler_shift { doppler } else { 1.0 }
}

fn intensity_correction(doppler: f64, correction: LightCorrection) -> f64 {
    correction.intensity_exponent.map_or(1.0, |exponent| 1.0 / intensity_factor(doppler, exponent))
}

/// The contents of an EXR file: channels in f32, and comments on how it was made.
#[derive(Debug, Clone)]
pub struct Measurements {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Values by the name of the channel, such as `left.id`, row by row from the top left.
    pub channels: BTreeMap<String, Vec<f32>>,
    attributes: LayerAttributes,
}

impl Measurements {
    /// Returns the measurements of both eyes, with `comments` on how the file was made.
    #[must_use]
    pub fn of_eyes(eyes: &[HitImage; 2], light: ChannelLight<'_>, comments: &str) -> Self {
        let mut channels = BTreeMap::new();
        for (eye, image) in EYES.into_iter().zip(eyes) {
            for Definition { name, nothing, value, .. } in &CHANNELS {
                let sample =
                    |hit: &Option<Hit>| hit.as_ref().map_or(*nothing, |hit| in_f32(value(hit, &light)));
                channels.insert(format!("{eye}.{name}"), image.hits.iter().map(sample).collect());
            }
        }
        let attributes =
            LayerAttributes { software_name: Some(Text::from(SOFTWARE)), ..LayerAttributes::default() };
        Self { size: eyes[0].size, channels, attributes }.with_comments(comments)
    }

    /// The first layer of the file at `path`.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, named.
    pub fn read(path: &Path) -> anyhow::Result<Self> {
        let read = || Self::decode(BufReader::new(files::open(path)?));
        read().with_context(|| files::shown(path))
    }

    /// The first layer of the file whose bytes `input` gives.
    ///
    /// # Errors
    ///
    /// What is wrong with it; more than [`sizes::MEASURED_VALUES`].
    pub fn decode(input: impl Read + Seek) -> anyhow::Result<Self> {
        let layer = first_layer(input)?;
        let channels = layer.channel_data.list.into_iter().map(|channel| {
            let values = match channel.sample_data {
                FlatSamples::F32(values) => values,
                FlatSamples::F16(values) => values.into_iter().map(f16::to_f32).collect(),
                FlatSamples::U32(values) => values.into_iter().map(|value| value as f32).collect(),
            };
            (channel.name.to_string(), values)
        });
        let size = [layer.size.0 as u32, layer.size.1 as u32];
        Ok(Self { size, channels: channels.collect(), attributes: layer.attributes })
    }

    /// Into an EXR file.
    ///
    /// # Errors
    ///
    /// Those of `out`.
    pub fn write(self, out: impl Write + Seek) -> anyhow::Result<()> {
        let [width, height] = self.size.map(|side| side as usize);
        let channel = |(name, values): (String, Vec<f32>)| {
            AnyChannel::new(Text::from(name.as_str()), FlatSamples::F32(values))
        };
        let channels: SmallVec<[_; 4]> = self.channels.into_iter().map(channel).collect();
        // Blocks are compressed side by side: in the order in which they come out, no two files would be
        // alike.
        let line_order = LineOrder::Increasing;
        let encoding = Encoding { compression: Compression::ZIP16, line_order, ..Encoding::default() };
        let layer = Layer::new((width, height), self.attributes, encoding, AnyChannels::sort(channels));
        Ok(Image::from_layer(layer).write().to_buffered(out)?)
    }

    /// Returns this file with other values: those that `values` gives for each channel's name and values.
    #[must_use]
    pub fn map(&self, size: [u32; 2], values: impl Fn(&str, &[f32]) -> Vec<f32>) -> Self {
        let channel = |(name, old): (&String, &Vec<f32>)| (name.clone(), values(name, old));
        let channels = self.channels.iter().map(channel).collect();
        Self { size, channels, attributes: self.attributes.clone() }
    }

    /// Returns this file with `comments` on how it was made.
    #[must_use]
    pub fn with_comments(mut self, comments: &str) -> Self {
        self.attributes.comments = Some(Text::from_slice_unchecked(comments.as_bytes())); // in UTF-8
        self
    }

    /// The `channel` of the layer `eye`, one of [`EYES`].
    ///
    /// # Errors
    ///
    /// A channel that the file lacks.
    pub fn channel(&self, eye: &str, channel: Channel) -> anyhow::Result<&[f32]> {
        let name = format!("{eye}.{}", channel.name());
        self.channels.get(&name).map(Vec::as_slice).with_context(|| format!("there is no channel {name}"))
    }

    /// The command that made it, as it records it; empty if it does not.
    #[must_use]
    pub fn command(&self) -> String {
        command_in_comments(&said(&self.attributes)).to_owned()
    }
}

fn first_layer(input: impl Read + Seek) -> anyhow::Result<Layer<AnyChannels<FlatSamples>>> {
    let layers = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    Ok(layers.all_attributes().from_chunks(opened(input)?)?.layer_data)
}

/// The file whose bytes `input` gives, of which the headers were read and found to promise no more than is
/// read.
fn opened<R: Read + Seek>(input: R) -> anyhow::Result<Reader<R>> {
    let reader = exr::block::read(input, false)?;
    for header in reader.headers() {
        let (size, channels, most) = (header.layer_size, header.channels.list.len(), sizes::MEASURED_VALUES);
        let values = (size.0 as u64).checked_mul(size.1 as u64).and_then(|n| n.checked_mul(channels as u64));
        anyhow::ensure!(
            values.is_some_and(|values| values <= most),
            "it has {}x{} pixels of {channels} channels; the limit is {most} values, those of 4230x4230 \
                pixels of 30",
            size.0,
            size.1
        );
    }
    Ok(reader)
}

/// The comments; none if there are none.
fn said(attributes: &LayerAttributes) -> Cow<'_, str> {
    String::from_utf8_lossy(attributes.comments.as_ref().map(Text::as_slice).unwrap_or_default())
}

fn file(path: &Path) -> anyhow::Result<Reader<BufReader<Regular>>> {
    opened(BufReader::new(files::open(path)?))
}

/// The command that made the EXR file at `path`, as it records it; empty if it does not.
///
/// # Errors
///
/// A file that cannot be read.
pub fn command(path: &Path) -> anyhow::Result<String> {
    let file = file(path)?;
    let first = file.headers().first().context("it has no layer")?;
    Ok(command_in_comments(&said(&first.own_attributes)).to_owned())
}

/// Returns whether `path` is a whole EXR file with just these `comments`: all of its blocks are there and can
/// be decompressed.
#[must_use]
pub fn is_made(path: &Path, comments: &str) -> bool {
    let says = |header: &Header| said(&header.own_attributes) == comments;
    file(path).is_ok_and(|file| file.headers().iter().any(says) && is_whole(file))
}

fn is_whole(file: Reader<BufReader<Regular>>) -> bool {
    let blocks = file.all_chunks(true);
    blocks.is_ok_and(|blocks| blocks.decompress_parallel(true, |_, _| Ok(())).is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIGHT: LightCorrection = LightCorrection { doppler_shift: true, intensity_exponent: Some(3.0) };

    impl Measurements {
        /// Some of this `size`.
        #[must_use]
        pub fn for_tests([width, height]: [u32; 2]) -> Self {
            let channel = |name: &str| {
                let values = (0..width * height).map(|i| (i.wrapping_mul(i) % 1009) as f32);
                (name.to_owned(), values.collect())
            };
            let channels = ["left.id", "right.id"].into_iter().map(channel).collect();
            Self { size: [width, height], channels, attributes: LayerAttributes::default() }
        }
    }

    #[test]
    fn a_file_is_the_same_bytes_every_time() {
        let bytes = || {
            let mut file = std::io::Cursor::new(Vec::new());
            Measurements::for_tests([200, 800]).write(&mut file).expect("there is room");
            file.into_inner()
        };
        let first = bytes();
        assert!((0..5).all(|_| bytes() == first));
    }

    #[test]
    fn channels_are_found_by_their_whole_name_in_any_layer() {
        for (place, &Definition { channel, .. }) in CHANNELS.iter().enumerate() {
            assert_eq!(channel as usize, place);
            assert_eq!(Channel::from_name(channel.name()), Some(channel));
            assert_eq!(Channel::from_name(&format!("left.{}", channel.name())), Some(channel));
        }
        assert_eq!(["left.grid", "grid", "left", "Id"].map(Channel::from_name), [None; 4]);
    }

    #[test]
    fn light_from_ahead_is_corrected_to_longer_fainter_and_nearer() {
        let factor = |name: &str| Channel::from_name(name).map(|channel| channel.factor(2.0, LIGHT));
        assert_eq!(factor("left.wavelength_nm"), Some(2.0));
        assert_eq!([factor("intensity"), factor("R")], [Some(0.125); 2]);
        assert_eq!([factor("distance"), factor("doppler")], [Some(0.5); 2]);
        assert_eq!([factor("id"), factor("emission_time"), factor("rest_x")], [Some(1.0); 3]);
        let untouched = LightCorrection { doppler_shift: false, intensity_exponent: None };
        assert_eq!(Channel::WavelengthNm.factor(2.0, untouched), 1.0);
        assert_eq!(Channel::Intensity.factor(2.0, untouched), 1.0);
    }
}
