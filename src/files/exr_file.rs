//! EXR files of what every pixel shows, for measurement.
//!
//! Channels in f32, for each of the layers `left` and `right`: `id` (number of the object, -1 where
//! nothing is seen), `distance`, `emission_time`, `doppler`, `wavelength_nm` and `intensity` as received,
//! and the place on the object in its rest frame, `rest_x`, `rest_y`, `rest_z`. All but `id` are 0 where
//! nothing is seen.

use std::io::{Seek, Write};
use std::path::Path;

use exr::meta::MetaData;
use exr::meta::header::Header;
use exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec,
    Text, WritableImage,
};
use relativity_core::doppler::{intensity_factor, received_wavelength};
use relativity_render::{Body, Hit, HitImage};

use super::png_file::{Provenance, SOFTWARE};

/// One measured quantity: its name, and its value for a hit.
type Channel<'a> = (&'static str, Box<dyn Fn(&Hit) -> f64 + 'a>);

/// What the channels need to know beside the hits.
#[derive(Debug, Clone, Copy)]
pub struct Light<'a> {
    /// The scene's bodies.
    pub bodies: &'a [Body],
    /// Exponent of the received intensity; `None` leaves it at 1.
    pub intensity_exponent: Option<f64>,
}

impl<'a> Light<'a> {
    fn channels(self) -> Vec<Channel<'a>> {
        let wavelength_nm = move |hit: &Hit| {
            received_wavelength(self.bodies[hit.body].rest_wavelength_nm, hit.doppler_factor)
        };
        let intensity = move |hit: &Hit| {
            self.intensity_exponent.map_or(1.0, |exponent| intensity_factor(hit.doppler_factor, exponent))
        };
        vec![
            ("id", Box::new(|hit| hit.body as f64)),
            ("distance", Box::new(|hit| hit.distance)),
            ("emission_time", Box::new(|hit| hit.emission_time)),
            ("doppler", Box::new(|hit| hit.doppler_factor)),
            ("wavelength_nm", Box::new(wavelength_nm)),
            ("intensity", Box::new(intensity)),
            ("rest_x", Box::new(|hit| hit.rest_position.x)),
            ("rest_y", Box::new(|hit| hit.rest_position.y)),
            ("rest_z", Box::new(|hit| hit.rest_position.z)),
        ]
    }
}

/// What both eyes see as an EXR file.
///
/// # Errors
///
/// Those of `out`.
pub fn write(
    eyes: &[HitImage; 2],
    light: Light<'_>,
    provenance: &Provenance,
    out: impl Write + Seek,
) -> anyhow::Result<()> {
    let layers = ["left", "right"].into_iter().zip(eyes);
    let channels: SmallVec<[_; 4]> = layers
        .flat_map(|(eye, image)| {
            light.channels().into_iter().map(move |channel| samples(eye, image, channel))
        })
        .collect();
    let [width, height] = eyes[0].size.map(|side| side as usize);
    let attributes = LayerAttributes {
        software_name: Some(Text::from(SOFTWARE)),
        comments: Some(Text::from_slice_unchecked(comments(provenance).as_bytes())), // in UTF-8
        ..LayerAttributes::default()
    };
    let encoding = Encoding { compression: Compression::ZIP16, ..Encoding::default() };
    let layer = Layer::new((width, height), attributes, encoding, AnyChannels::sort(channels));
    Ok(Image::from_layer(layer).write().to_buffered(out)?)
}

/// What parts the command in the comments from the fingerprint.
pub(super) const FINGERPRINT_LINE: &str = "\nScene-Fingerprint ";

/// What the file says of how it was made.
fn comments(provenance: &Provenance) -> String {
    provenance.parameters.clone() + FINGERPRINT_LINE + &provenance.scene_fingerprint
}

/// Whether `path` is an EXR file of just this provenance. (Files are written whole or not at all.)
#[must_use]
pub fn is_made(path: &Path, provenance: &Provenance) -> bool {
    let expected = comments(provenance);
    let is_expected = |header: &Header| {
        header.own_attributes.comments.as_ref().is_some_and(|text| text.as_slice() == expected.as_bytes())
    };
    MetaData::read_from_file(path, false).is_ok_and(|meta| meta.headers.iter().any(is_expected))
}

fn samples(eye: &str, image: &HitImage, (name, value): Channel<'_>) -> AnyChannel<FlatSamples> {
    let nothing = if name == "id" { -1.0 } else { 0.0 };
    let sample = |hit: &Option<Hit>| hit.as_ref().map_or(nothing, |hit| value(hit) as f32);
    let samples = image.hits.iter().map(sample).collect();
    AnyChannel::new(Text::from(format!("{eye}.{name}").as_str()), FlatSamples::F32(samples))
}
