//! `gamow measure`: follows a point through a stereo sequence and measures its angles, ready for `gamow fit`.
//!
//! It uses what an observer knows: the pictures, when they were taken, and where the cameras stood and looked.

mod locate;

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use clap::Args;
use csv::ByteRecord;
use relativity_core::math;
use relativity_render::Camera;

use self::locate::Target;
use crate::columns::{ANGLES, ROLL, TURN};
use crate::files::csv_out;
use crate::files::exr::{EYES, Measurements};
use crate::files::png::PngFile;
use crate::files::whole::OutArgs;
use crate::flags::choices::{FileKind, Size};
use crate::flags::coordinates;
use crate::platform;
use crate::settings::{Picture, Settings};
use crate::studio::Sheet;

/// Follows a point through a stereo sequence and measures its angles, as CSV.
///
/// Takes the files of `gamow render`, one per observation time: measurements (.exr) or pictures (.png) in a layout that has both
/// eyes' whole pictures, such as side by side. The
/// columns are the observation time, the separation of the eyes (with roll and turn, in radians, of a head that is tilted or
/// turned), the angles from each eye, their differences, and the
/// standard deviation that the size of a pixel gives them: what `gamow fit` reads.
#[derive(Debug, Args)]
#[command(after_long_help = EXAMPLES)]
pub struct MeasureArgs {
    /// Files, or folders of files.
    #[arg(required = true, value_name = "DIR|FILES")]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    target: TargetArgs,
    #[command(flatten)]
    out: OutArgs,
}

/// What is followed.
#[derive(Debug, Clone, Args)]
#[group(required = true, multiple = false)]
struct TargetArgs {
    /// In .exr files: the mark on a body's surface at these rest-frame coordinates.
    #[arg(long, value_name = "X,Y,Z", value_parser = coordinates, allow_hyphen_values = true)]
    point: Option<[f64; 3]>,
    /// In .exr files: the middle of the body with this number.
    #[arg(long, value_name = "NUMBER")]
    object: Option<u32>,
    /// In .png files: the middle of all pixels of this colour.
    #[arg(long, value_name = "RRGGBB", value_parser = locate::colour)]
    marker: Option<[u8; 3]>,
}

const EXAMPLES: &str = "\
Examples:
  gamow render --frames 60 --exr --size 1440x1080 --out ride
  gamow measure ride --point=-0.032,2.968,2 --out ride.csv
  gamow fit ride.csv --fit-x0";

/// How many columns there are: T, d, roll, turn, the angles, and the standard deviations of their differences.
const COLUMNS: usize = 4 + ANGLES.len() + 2;
/// Those of roll and turn, which are left out where the head is held straight.
const HEAD: std::ops::Range<usize> = 2..4;

/// Standard deviation of what is rounded to whole units.
const ROUNDING: f64 = 0.288_675_134_594_812_9;

/// Runs `gamow measure`.
pub fn run(args: &MeasureArgs) -> anyhow::Result<()> {
    let target = args.target.target();
    let files = files(&args.inputs, target)?;
    let mut rows = Vec::new();
    for file in &files {
        rows.extend(measured(file, target)?);
    }
    anyhow::ensure!(!rows.is_empty(), "none of {} files shows the target to both eyes", files.len());
    rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
    if rows.len() < files.len() {
        eprintln!("{} of {} files show the target to both eyes", rows.len(), files.len());
    }
    args.out.write(|out| {
        let mut csv = csv_out::Rows::new(out);
        let names = [&["T", "d", ROLL, TURN], ANGLES, &["sigma_dphi", "sigma_dtheta"]].concat();
        let is_turned = rows.iter().any(|row| row[HEAD] != [0.0; 2]);
        let is_written = |column: usize| is_turned || !HEAD.contains(&column);
        csv.write(&mut (0..COLUMNS).filter(|&i| is_written(i)).map(|i| names[i]).collect(), &[])?;
        for row in &rows {
            let numbers: Vec<f64> = (0..COLUMNS).filter(|&i| is_written(i)).map(|i| row[i]).collect();
            csv.write(&mut ByteRecord::new(), &numbers)?;
        }
        Ok(csv.flush()?)
    })
}

impl TargetArgs {
    fn target(&self) -> Target {
        match (self.point, self.object, self.marker) {
            (Some(point), _, _) => Target::Point(point),
            (_, Some(body), _) => Target::Body(body),
            (_, _, marker) => Target::Marker(marker.unwrap_or_default()), // clap wants one of them
        }
    }
}

/// The files among `inputs` and in its folders that can show `target`.
fn files(inputs: &[PathBuf], target: Target) -> anyhow::Result<Vec<PathBuf>> {
    let kind = target.file_kind();
    let mut files = Vec::new();
    for input in inputs {
        let name = || input.display().to_string();
        if platform::files::is_folder(input) {
            let inside = platform::files::list_folder(input).with_context(name)?;
            files.extend(inside.into_iter().filter(|path| FileKind::of(path) == Some(kind)));
        } else {
            anyhow::ensure!(
                FileKind::of(input) == Some(kind),
                "{}: it should end in .{}",
                name(),
                kind.extension()
            );
            files.push(input.clone());
        }
    }
    anyhow::ensure!(!files.is_empty(), "there is no .{} file", kind.extension());
    Ok(files)
}

/// A row; none if an eye does not see the target.
fn measured(path: &Path, target: Target) -> anyhow::Result<Option<[f64; COLUMNS]>> {
    let name = path.display().to_string();
    let (places, size, settings) = match target {
        Target::Marker(colour) => {
            let file = PngFile::read(path)?;
            let settings = Settings::of_picture(file.command(), &name)?;
            let sheet = sheet(&settings.picture, file.picture().size).with_context(|| name.clone())?;
            let place = |eye| locate::colour_in(&sheet.picture_of(eye, &file.frames)?, colour);
            let Size(size) = settings.picture.size;
            ([0, 1].map(place), size, settings)
        }
        Target::Point(_) | Target::Body(_) => {
            let file = Measurements::read(path)?;
            let [left, right] =
                EYES.map(|eye| locate::in_layer(&file, eye, target).with_context(|| name.clone()));
            ([left?, right?], file.size, Settings::of_picture(&file.command(), &name)?)
        }
    };
    let [Some(left), Some(right)] = places else { return Ok(None) };
    let time = settings.time.with_context(|| format!("{name}: it does not record --time"))?;
    let cameras = settings.recorded_cameras(size);
    let [of_left, of_right] = cameras.map_err(|flag| anyhow::anyhow!("{name}: it does not record {flag}"))?;
    let (left, right) = (Angles::new(&of_left, left), Angles::new(&of_right, right));
    let baseline = settings.baseline();
    let sigma = |a: f64, b: f64| ROUNDING * math::hypot(a, b);
    Ok(Some([
        time,
        baseline.separation,
        baseline.roll,
        baseline.turn,
        left.phi,
        right.phi,
        left.theta,
        right.theta,
        left.phi - right.phi,
        left.theta - right.theta,
        sigma(left.phi_per_pixel, right.phi_per_pixel),
        sigma(left.theta_per_pixel, right.theta_per_pixel),
    ]))
}

/// How a file of this `size` is divided that shows both eyes as `picture` says.
fn sheet(picture: &Picture, size: [u32; 2]) -> anyhow::Result<Sheet> {
    let layout = picture.layout;
    let has_both = layout.loses_nothing() && picture.eyes().len() == 2;
    anyhow::ensure!(has_both, "its layout, {}, does not have the whole pictures of both eyes", layout.name());
    Sheet::of_file(picture, picture.size.0, size).context("it no longer has the size in which it was made")
}

/// Azimuth and elevation of a place in a picture.
struct Angles {
    phi: f64,
    theta: f64,
    /// By how much they change over a pixel, right and down together.
    phi_per_pixel: f64,
    theta_per_pixel: f64,
}

impl Angles {
    fn new(camera: &Camera, [u, v]: [f64; 2]) -> Self {
        let angles = |place| {
            let line = camera.line_of_sight(place);
            [math::atan2(line.y, line.x), math::atan2(line.z, math::hypot(line.x, line.y))]
        };
        let change = |du: f64, dv: f64| {
            let (after, before) = (angles([u + du, v + dv]), angles([u - du, v - dv]));
            [after[0] - before[0], after[1] - before[1]]
        };
        let (across, down) = (change(0.5, 0.0), change(0.0, 0.5));
        let [phi, theta] = angles([u, v]);
        Self {
            phi,
            theta,
            phi_per_pixel: math::hypot(across[0], down[0]),
            theta_per_pixel: math::hypot(across[1], down[1]),
        }
    }
}
