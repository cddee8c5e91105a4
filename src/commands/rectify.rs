//! `gamow rectify`: a picture taken from one eye, as a camera moving along with the bodies would have taken
//! it.

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use clap::{Args, ValueEnum};
use gamow_platform::threads::prelude::*;
use gamow_platform::{files, progress};
use relativity_core::doppler::BOLOMETRIC_INTENSITY_EXPONENT;
use relativity_core::threads;
use relativity_render::picture::rectify::{LightCorrection, Rectification};
use relativity_render::{Camera, Picture, Projection, Velocity};

use crate::files::exr::{Channel, EYES, Measurements};
use crate::files::png::{self, PngFile};
use crate::files::provenance::Provenance;
use crate::files::whole::write_whole;
use crate::flags::choices::{FileKind, GazeChoice, Layout};
use crate::flags::{IntensityExponent, OnOff, SpeedArgs, SpeedParameter, field_of_view, switch};
use crate::settings::{CameraArgs, NO_PAIR, ON_A_RIDE, Settings};
use crate::studio::Sheet;

/// Corrects a picture taken from one eye to the frame of the bodies in it.
///
/// Computes the picture that a camera moving along with them would have taken at the same event: lines of
/// sight turned back by aberration, wavelengths multiplied by the Doppler factor D, intensities divided by
/// D^n. Works on any PNG picture with a known field of view, and on the EXR files of `gamow render`. A wheel
/// that rolls becomes one that turns, with the Doppler effect of its turning.
///
/// The colours of a PNG picture tell wavelengths by their hue only: the part of a colour that is not grey
/// counts as monochromatic. What the Doppler effect shifted out of sight stays dark.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES)]
pub struct RectifyArgs {
    /// Picture (.png) or measurements (.exr).
    image: PathBuf,
    #[command(flatten)]
    speed: SpeedArgs,
    /// The bodies move towards -x.
    #[arg(long)]
    backward: bool,
    /// Eye whose picture is corrected, where both are in it [default: left]
    #[arg(long, value_enum)]
    eye: Option<EyeChoice>,
    /// Field of view of the corrected picture, degrees [default: so that its centre is as large as before]
    #[arg(long, value_name = "DEG", value_parser = field_of_view)]
    out_fov: Option<f64>,
    /// Gaze of the moving camera [default: at what was in the centre]
    #[arg(long, value_name = "AZ,EL", allow_hyphen_values = true)]
    out_gaze: Option<GazeChoice>,
    /// Output: a file of the same kind, written whole or not at all.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Whether wavelengths are corrected too.
    #[arg(long, default_value = "on", value_name = "on|off", value_parser = switch, help_heading = "Light")]
    doppler_shift: OnOff,
    /// Exponent n of the received intensity D^n to divide by, as of `gamow render` [default: as the file
    /// records it, else surface]
    #[arg(
        long,
        value_name = "surface|photons|paper|N|off",
        allow_hyphen_values = true,
        help_heading = "Light"
    )]
    intensity_exponent: Option<IntensityExponent>,
    #[command(flatten, next_help_heading = "Photographs")]
    camera: CameraArgs,
}

/// The eye whose picture is corrected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
enum EyeChoice {
    #[default]
    Left,
    Right,
}

const EXAMPLES: &str = "\
Examples:
  gamow render --beta 0.6 --layout left --out seen.png
  gamow rectify seen.png --beta 0.6 --out corrected.png
  gamow rectify photo.png --gamma 3 --fov 60 --gaze 90,0 --out corrected.png";

/// Runs the command `gamow rectify`.
pub fn run(args: &RectifyArgs) -> anyhow::Result<()> {
    let kind = |path: &Path| {
        FileKind::from_path(path)
            .with_context(|| format!("{}: it should end in .png or .exr", files::shown(path)))
    };
    let (from, to) = (kind(&args.image)?, kind(&args.out)?);
    anyhow::ensure!(
        from == to,
        "--out {}: it should be of the same kind as the picture",
        files::shown(&args.out)
    );
    match from {
        FileKind::Png => args.rectify_picture(),
        FileKind::Exr => args.rectify_measurements(),
    }
}

impl RectifyArgs {
    fn rectify_picture(&self) -> anyhow::Result<()> {
        let file = PngFile::read(&self.image)?;
        let recorded = self.recorded(file.command());
        let name = files::shown(&self.image);
        anyhow::ensure!(!recorded.as_ref().is_some_and(Settings::is_comparing), "{name}: {NO_PAIR}");
        let settings = self.settings(recorded.clone(), file.picture().size)?;
        let (seen, eye) = self.of_an_eye(file, &settings).with_context(|| name.clone())?;
        let rectification = &self.rectifications(seen.size, &settings)?[eye];
        let light = self.light(recorded.as_ref());
        let corrected = progress::shown_while(1, || rectification.picture(&seen, light));
        let provenance = Provenance {
            title: format!("{name}, corrected"),
            parameters: self.parameters(rectification)?,
            scene_fingerprint: String::new(),
            models: String::new(),
        };
        write_whole(&self.out, |file| png::write(&corrected, &provenance.texts(), file))
    }

    /// Returns the part of `file` that is corrected: the picture of an eye (0 left, 1 right) in it, and whose
    /// it is.
    fn of_an_eye(&self, mut file: PngFile, settings: &Settings) -> anyhow::Result<(Picture, usize)> {
        let picture = &settings.picture;
        if let [eye] = *picture.eyes() {
            anyhow::ensure!(
                self.eye.is_none(),
                "--eye: the picture shows one eye, so there is nothing to choose"
            );
            return Ok((file.frames.swap_remove(0), eye));
        }
        anyhow::ensure!(
            picture.layout.loses_nothing(),
            "its layout, {}, has the whole picture of neither eye; `gamow render --layout left` draws one",
            picture.layout.name()
        );
        let eye = self.eye.unwrap_or_default() as usize;
        let sheet = Sheet::of_file(picture, picture.size.0, file.picture().size);
        let seen = sheet.and_then(|sheet| sheet.picture_of(eye, &file.frames));
        Ok((seen.context("its size has changed since it was made")?, eye))
    }

    fn rectify_measurements(&self) -> anyhow::Result<()> {
        let measured = Measurements::read(&self.image)?;
        let recorded = self.recorded(&measured.command());
        let settings = self.settings(recorded.clone(), measured.size)?;
        let rectifications = self.rectifications(measured.size, &settings)?;
        let sources = progress::shown_while(2, || rectifications.each_ref().map(sources));
        let light = self.light(recorded.as_ref());
        let corrected = measured.map(measured.size, |name, values| {
            let eye = usize::from(name.starts_with(EYES[1]));
            let channel = Channel::from_name(name);
            let nothing = channel.map_or(0.0, Channel::nothing);
            let factor = |doppler| channel.map_or(1.0, |channel| channel.factor(doppler, light));
            let value = |source: &Option<PixelSource>| {
                source
                    .map_or(nothing, |PixelSource { pixel, doppler }| values[pixel] * factor(doppler) as f32)
            };
            sources[eye].iter().map(value).collect()
        });
        let corrected = corrected.with_comments(&self.parameters(&rectifications[0])?);
        write_whole(&self.out, |file| corrected.write(file))
    }

    fn light(&self, recorded: Option<&Settings>) -> LightCorrection {
        let exponent = self.intensity_exponent.or(recorded.map(|settings| settings.light.intensity_exponent));
        let exponent = exponent.unwrap_or(IntensityExponent(Some(BOLOMETRIC_INTENSITY_EXPONENT)));
        LightCorrection { doppler_shift: self.doppler_shift, intensity_exponent: exponent.0 }
    }

    /// Returns the settings in the file's `command`, if `gamow render` made it.
    fn recorded(&self, command: &str) -> Option<Settings> {
        Settings::of_picture(command, &files::shown(&self.image)).ok()
    }

    fn speed(&self) -> anyhow::Result<(SpeedParameter, f64)> {
        self.speed.given().context("one of --beta, --gamma, --rapidity is needed")
    }

    /// Returns the rectifications of a picture of the left eye and of the right one, to the same camera.
    fn rectifications(&self, size: [u32; 2], settings: &Settings) -> anyhow::Result<[Rectification; 2]> {
        let (parameter, value) = self.speed()?;
        let velocity = Velocity { speed: parameter.speed(value)?, is_backward: self.backward };
        anyhow::ensure!(!settings.ride.is_on(), "{}: {ON_A_RIDE}", files::shown(&self.image));
        let grounds = settings.recorded_cameras(size).map_err(|flag| self.not_recorded(flag))?;
        // Where both eyes look, whatever the image shift of each.
        let projection = match grounds[0].projection {
            Projection::Mercator { right, .. } => Projection::Mercator { right, shift: 0.0 },
            _ => Projection::Gaze,
        };
        let centred = Camera { projection, ..grounds[0] };
        let mut rest = Rectification::rest_camera(&centred, &velocity);
        if let Some(fov) = self.out_fov {
            rest.horizontal_fov = fov.to_radians();
        }
        if let Some(choice) = self.out_gaze {
            let problem = "--out-gaze: a picture has one gaze; write azimuth and elevation like 90,0";
            rest.gaze = choice.fixed().context(problem)?;
        }
        Ok(grounds.map(|ground| Rectification::new(ground, rest, velocity)))
    }

    /// Returns the settings with which the picture was taken: one eye's, unless a flag names more.
    fn settings(&self, recorded: Option<Settings>, size: [u32; 2]) -> anyhow::Result<Settings> {
        let (settings, missing) = self.camera.settings(recorded, size, Some(Layout::Left));
        anyhow::ensure!(missing.is_empty(), self.not_recorded(&missing.join(", ")));
        Ok(settings)
    }

    fn not_recorded(&self, flags: &str) -> anyhow::Error {
        anyhow::anyhow!("{}: it does not record {flags}, which must then be given", files::shown(&self.image))
    }

    /// The command that corrects the picture again, with the camera that took the corrected one.
    fn parameters(&self, rectification: &Rectification) -> anyhow::Result<String> {
        let (parameter, value) = self.speed()?;
        let Camera { gaze, horizontal_fov, .. } = rectification.rest();
        Ok(format!(
            "gamow rectify --{}={value}{}{} --out-fov={} --out-gaze={},{}",
            parameter.name(),
            if self.backward { " --backward" } else { "" },
            self.eye.map_or("", |eye| if eye == EyeChoice::Left { " --eye=left" } else { " --eye=right" }),
            horizontal_fov.to_degrees(),
            gaze.azimuth.to_degrees(),
            gaze.elevation.to_degrees()
        ))
    }
}

/// The source of a pixel of the corrected picture.
#[derive(Debug, Clone, Copy)]
struct PixelSource {
    /// Number of the pixel in the picture from the ground.
    pixel: usize,
    /// Doppler factor of the light at that pixel's centre.
    doppler: f64,
}

/// The source of every pixel, row by row. Measurements are not interpolated: between two bodies lies none.
fn sources(rectification: &Rectification) -> Vec<Option<PixelSource>> {
    let [width, height] = rectification.rest().size;
    let source = |column: u32, row: u32| {
        let place = [f64::from(column) + 0.5, f64::from(row) + 0.5];
        let [u, v] = rectification.ground_place(place)?.map(f64::floor);
        let doppler = rectification.doppler_factor([u + 0.5, v + 0.5]);
        Some(PixelSource { pixel: v as usize * width as usize + u as usize, doppler })
    };
    let row_done = threads::in_parts(height);
    let row = |row: u32| {
        let sources: Vec<_> = (0..width).map(|column| source(column, row)).collect();
        row_done();
        sources
    };
    (0..height).into_par_iter().flat_map_iter(row).collect()
}
