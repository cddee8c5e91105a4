//! The paper's stereo frames of its cyclist, drawn as `gamow render` draws them.

use std::fmt::Write as _;
use std::path::Path;

use gamow_platform::{files, sizes};
use relativity_core::{Disparity, Model, PairError};
use relativity_render::{Geometry, Shading};

use super::curves::Setup;
use super::figures;
use crate::files::html::data_uri;
use crate::flags::choices::{FileKind, RendererChoice, Size};
use crate::flags::{SpeedParameter, SpeedSetting};
use crate::settings::{Daylight, PictureSettings, Preset, Settings};
use crate::studio::{Sheet, Studio};

/// A row of frames, as one figure of the paper shows them.
#[derive(Debug)]
pub struct Figure {
    /// Number of the figure in the paper.
    pub number: u8,
    /// Name of the figure's files.
    pub name: &'static str,
    /// Caption of the figure.
    pub caption: &'static str,
    /// The preset that the figure is drawn with.
    preset: &'static str,
    /// Whether the figure shows the cyclist itself, at rest.
    at_rest: bool,
    /// Places x where the tracked point is seen in each frame.
    places: &'static [f64],
}

/// The figures. The paper numbers its frames but does not say at which times they are; these show what it
/// describes.
pub const FIGURES: [Figure; 5] = [
    Figure {
        at_rest: true,
        ..figure(
            9,
            "stereo-at-rest",
            "The cyclist itself, as cameras that ride along see it",
            "abreast",
            &[0.0],
        )
    },
    figure(10, "stereo-approaching", "Approaching at beta = 0.9", "approaching", &[-12.0, -8.0, -5.0]),
    figure(11, "stereo-abreast", "Abreast at beta = 0.9", "abreast", &[-2.0, -0.5, 0.5]),
    figure(12, "stereo-abreast-0.6", "Abreast at beta = 0.6", "abreast-0.6", &[-2.0, -0.5, 0.5]),
    figure(13, "stereo-receding", "Receding at beta = 0.9", "receding", &[1.5, 3.0, 5.0]),
];

const fn figure(
    number: u8,
    name: &'static str,
    caption: &'static str,
    preset: &'static str,
    places: &'static [f64],
) -> Figure {
    Figure { number, name, caption, preset, at_rest: false, places }
}

const WIDTH: u32 = 400;
const HEIGHT: u32 = 300;
const CAPTION_HEIGHT: u32 = 26;
const REST_WAVELENGTH_NM: f64 = 700.0;

/// A drawn frame.
#[derive(Debug)]
pub struct StereoFrame {
    /// Name of the frame's file.
    pub file: String,
    /// The settings that draw the frame.
    pub settings: Settings,
    /// Observation time T.
    pub time: f64,
    /// Disparity of the tracked point.
    pub seen: Disparity,
}

/// Returns the number of frames of all figures.
pub fn frames() -> u64 {
    FIGURES.iter().map(|figure| figure.places.len() as u64).sum()
}

/// Draws every figure into `folder`, and calls `note` after each frame; the frames of each.
pub fn write_all(folder: &Path, note: impl Fn()) -> anyhow::Result<Vec<Vec<StereoFrame>>> {
    FIGURES.iter().map(|figure| figure.write(folder, &note)).collect()
}

impl Figure {
    fn write(&self, folder: &Path, note: impl Fn()) -> anyhow::Result<Vec<StereoFrame>> {
        let frames: Vec<StereoFrame> =
            (1..).zip(self.places).map(|(number, &x)| self.frame(number, x)).collect::<Result<_, _>>()?;
        for frame in &frames {
            let mut studio = Studio::new(frame.settings.clone())?;
            studio.make_file(&studio.frame(None)?, FileKind::Png, &folder.join(&frame.file))?;
            note();
        }
        figures::write_text(folder, &format!("{}.svg", self.name), &svg(folder, &frames)?)?;
        let column = |name: &str, value: fn(&StereoFrame) -> f64| {
            (name.to_owned(), frames.iter().map(value).collect::<Vec<f64>>())
        };
        let columns = [
            column("T", |frame| frame.time),
            column("x_left", |frame| frame.seen.primary.position[0]),
            column("x_right", |frame| frame.seen.secondary.position[0]),
            column("wavelength_left_nm", |frame| REST_WAVELENGTH_NM / frame.seen.primary.doppler_factor),
            column("wavelength_right_nm", |frame| REST_WAVELENGTH_NM / frame.seen.secondary.doppler_factor),
            column("dphi", |frame| frame.seen.dphi),
            column("dtheta", |frame| frame.seen.dtheta),
        ];
        figures::write_csv(folder, self.name, &columns)?;
        Ok(frames)
    }

    /// The frame in which the tracked point is seen at `x` from between the eyes.
    fn frame(&self, number: usize, x: f64) -> Result<StereoFrame, PairError> {
        let settings = self.settings();
        let setup = Setup { beta: settings.speed().beta(), ..Setup::CYCLIST };
        let time = setup.time_when_seen_at(x)?;
        let settings = Settings { time: Some(time), ..settings };
        let file = format!("{}-{number}.png", self.name);
        Ok(StereoFrame { file, settings, time, seen: setup.seen(Model::Exact, time)? })
    }

    /// Returns the settings of the figure's preset, for print.
    fn settings(&self) -> Settings {
        let preset = Preset::named(self.preset).expect("tests draw every figure");
        let mut settings = preset.settings.clone();
        if self.at_rest {
            settings.look.geometry = Geometry::Rest;
            settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, 0.0).expect("rest is a speed");
        }
        settings.light.light = Daylight::On;
        settings.light.shading = Shading::Emission;
        (settings.light.ground, settings.light.sky) = (false, false);
        settings.quality.renderer = RendererChoice::Reference;
        settings.picture.size = Size([WIDTH, HEIGHT]);
        settings
    }
}

/// The frames below each other, with their times; their pictures in `folder` are embedded.
fn svg(folder: &Path, frames: &[StereoFrame]) -> anyhow::Result<String> {
    let [width, frame_height] = Sheet::new(&PictureSettings::default(), [WIDTH, HEIGHT], true).size;
    let row = frame_height + CAPTION_HEIGHT;
    let height = row * frames.len() as u32;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"14\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    for (index, frame) in (0..).zip(frames) {
        let (top, text) = (row * index + CAPTION_HEIGHT, row * index + 18);
        let [left, right] = [&frame.seen.primary, &frame.seen.secondary]
            .map(|sighting| REST_WAVELENGTH_NM / sighting.doppler_factor);
        let picture = data_uri("image/png", &files::read(&folder.join(&frame.file), sizes::FILE_BYTES)?);
        let _ = writeln!(
            svg,
            "<text x=\"8\" y=\"{text}\">T = {:.3}; the tracked point at {left:.0} nm (left eye) and {right:.0} nm (right eye)</text>\n\
             <image x=\"0\" y=\"{top}\" width=\"{width}\" height=\"{frame_height}\" href=\"{picture}\"/>",
            frame.time
        );
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}
