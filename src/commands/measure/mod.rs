//! `gamow measure`: follows a point through a stereo sequence and measures its angles, ready for `gamow fit`.
//!
//! It uses what an observer knows: the pictures, when they were taken, and where the cameras stood and
//! looked.

mod locate;
mod place;
mod remark;

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use clap::Args;
use csv::ByteRecord;
use gamow_platform::{files, messages, progress};
use relativity_core::{math, threads};
use relativity_render::Camera;

use self::locate::Target;
use self::place::PixelPlace;
use self::remark::{Remark, Remarks};
use crate::columns::{ANGLES, ROLL, TURN, unit};
use crate::files::exr::{EYES, Measurements};
use crate::files::png::PngFile;
use crate::files::whole::ReportArgs;
use crate::flags::choices::{FileKind, Layout};
use crate::flags::{COORDINATES, coordinates, within};
use crate::settings::{CameraArgs, MAX_LENGTH, NO_PAIR, ON_A_RIDE, PictureSettings, Settings};
use crate::studio::Sheet;
use crate::time_range::time_within;

/// Follows a point through a stereo sequence and measures its angles, as CSV or JSON.
///
/// Takes files of one observation time each: measurements (.exr) or pictures (.png) in a layout that has both
/// eyes' whole pictures, such as side by side. Those of `gamow render` record everything else; for
/// photographs, flags give it.
///
/// The columns are the observation time, the separation of the eyes (with roll and turn, in degrees, of a
/// head that is tilted or turned), the angles from each eye, their differences, and the standard deviations
/// of these: what `gamow fit` reads.
///
/// The standard deviations follow from how pixels sample what is seen. The middle of a disc of radius r
/// pixels has 0.15/sqrt(r) pixels in each direction, in each eye; a mark on a surface, by how its
/// surroundings bend, a hundredth of one or less, and up to 0.3 beside an outline. Errors against the truth
/// were measured to be 0.7 to 1.4 times as large, of a mark 0.4 to 0.8 times; those of dtheta a third where
/// both eyes have the point equally high. They do not cover what pixels do not decide: the middle of a large
/// body is not quite where its centre is seen.
///
/// A mark on a wheel is followed round. A fit takes it for a point that does not turn, unless flags say where
/// on its wheel the mark is; for a --point in files of `gamow render` a remark gives these flags.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES)]
pub struct MeasureArgs {
    /// Files, or folders of files.
    #[arg(required = true, value_name = "DIR|FILES")]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    target: TargetArgs,
    #[command(flatten)]
    report: ReportArgs,
    #[command(flatten, next_help_heading = "Photographs")]
    taken: TakenArgs,
}

/// The circumstances in which the pictures were taken.
#[derive(Debug, Clone, Args)]
struct TakenArgs {
    /// Separation of the eyes [default: as the file records it]
    #[arg(long, value_parser = within(0.0..=MAX_LENGTH), allow_hyphen_values = true)]
    d: Option<f64>,
    /// Observation times: one per file, in the order of the files (by name in a folder), or the first and the
    /// last of evenly spaced ones [default: as the files record them]
    #[arg(
        long, visible_alias = "time", value_name = "T,T,...", value_delimiter = ',', value_parser = within(COORDINATES),
        allow_hyphen_values = true
    )]
    times: Vec<f64>,
    #[command(flatten)]
    camera: CameraArgs,
}

/// The target: a mark on a surface, a body or a colour.
#[derive(Debug, Clone, Args)]
#[group(required = true, multiple = false)]
struct TargetArgs {
    /// In .exr files: the mark on a body's surface at these rest-frame coordinates; on a wheel that turns,
    /// those at t' = 0.
    #[arg(long, value_name = "X,Y,Z", value_parser = coordinates, allow_hyphen_values = true)]
    point: Option<[f64; 3]>,
    /// In .exr files: the middle of what is seen of the body of this name in the scene, or of this number.
    #[arg(long, value_name = "NAME|NUMBER")]
    object: Option<String>,
    /// In .png files: the middle of all pixels of this colour.
    #[arg(long, value_name = "RRGGBB", value_parser = locate::colour)]
    marker: Option<[u8; 3]>,
}

const EXAMPLES: &str = "\
Examples:
  gamow render --frames 60 --exr --size 1440x1080 --out ride
  gamow measure ride --point=-0.032,2.968,2 --out ride.csv
  gamow fit ride.csv --fit-x0
  gamow measure ride --object 'front tyre'
  gamow measure ride --point=0,3,2 | gamow fit --wheel-radius 0.525 --rho 1 --angle 0
  gamow measure photos --marker ff2000 --times 0,6 --d 0.1 --fov 50 --gaze 90,0 --layout over-under";

/// Number of columns: T, d, roll, turn, the angles, and the standard deviations of their differences.
const COLUMNS: usize = 4 + ANGLES.len() + 2;
/// Columns of roll and turn, which are left out where the head is held straight.
const HEAD: std::ops::Range<usize> = 2..4;

/// Runs the command `gamow measure`.
pub fn run(args: &MeasureArgs) -> anyhow::Result<()> {
    let mut bar = None;
    let table = args.measured_noting(|files, all| {
        bar.get_or_insert_with(|| progress::bar(all as u64, "files")).set_position(files as u64);
    });
    if let Some(bar) = bar {
        bar.finish_and_clear();
    }
    let table = table?;
    table.remarks.iter().for_each(messages::remark);
    args.report.write_table(unit, |out| {
        out.head(&mut ByteRecord::new(), &table.columns)?;
        Ok(table.rows.iter().try_for_each(|row| out.row(&mut ByteRecord::new(), row))?)
    })
}

/// The measured angles, as a table.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredTable {
    /// Names of the columns as `gamow fit` reads them.
    pub columns: Vec<&'static str>,
    /// A row for each file that shows the target to both eyes, by time, with a value for each column.
    pub rows: Vec<Vec<f64>>,
    /// Remarks on what was found, a line each.
    pub remarks: Vec<String>,
}

impl MeasureArgs {
    /// Measures the target in all files.
    ///
    /// # Errors
    ///
    /// A file that cannot be read or does not say enough, a target that no file shows to both eyes, and work
    /// that is given up.
    pub fn measured(&self) -> anyhow::Result<MeasuredTable> {
        self.measured_noting(|_, _| {})
    }

    /// Measures the target in all files; calls `note` after each with the number of files so far and of all.
    fn measured_noting(&self, mut note: impl FnMut(usize, usize)) -> anyhow::Result<MeasuredTable> {
        let target = self.target.target();
        let files = files(&self.inputs, target)?;
        let times = self.taken.times_of(files.len())?;
        let (mut rows, mut noted_of_all) = (Vec::new(), Remarks::default());
        let goes_on = threads::goes_on();
        for ((file, time), number) in files.iter().zip(times).zip(1..) {
            anyhow::ensure!(goes_on(), "given up");
            let name = files::shown(file);
            if let Some((row, noted)) = measured(file, &name, target, &self.taken, time)? {
                noted_of_all.note(&name, &noted);
                rows.push(row);
            }
            note(number, files.len());
        }
        anyhow::ensure!(!rows.is_empty(), "none of {} files shows the target to both eyes", files.len());
        rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let is_partial = rows.len() < files.len();
        let count = is_partial
            .then(|| format!("{} of {} files show the target to both eyes", rows.len(), files.len()));
        let remarks = count.into_iter().chain(noted_of_all.lines(files.len())).collect();
        let is_turned = rows.iter().any(|row| row[HEAD] != [0.0; 2]);
        let written: Vec<usize> = (0..COLUMNS).filter(|column| is_turned || !HEAD.contains(column)).collect();
        let names = [&["T", "d", ROLL, TURN], ANGLES, &["sigma_dphi", "sigma_dtheta"]].concat();
        Ok(MeasuredTable {
            columns: written.iter().map(|&column| names[column]).collect(),
            rows: rows.iter().map(|row| written.iter().map(|&column| row[column]).collect()).collect(),
            remarks,
        })
    }
}

impl TargetArgs {
    fn target(&self) -> Target<'_> {
        match (self.point, &self.object, self.marker) {
            (Some(point), _, _) => Target::Point(point),
            (_, Some(body), _) => Target::Body(body),
            (_, _, marker) => Target::Marker(marker.unwrap_or_default()), // clap wants one of them
        }
    }
}

/// The files among `inputs` and in its folders that can show `target`.
fn files(inputs: &[PathBuf], target: Target<'_>) -> anyhow::Result<Vec<PathBuf>> {
    let kind = target.file_kind();
    let mut files = Vec::new();
    for input in inputs {
        let name = || files::shown(input);
        if files::is_folder(input) {
            let inside = files::list_folder(input).with_context(name)?;
            files.extend(inside.into_iter().filter(|path| FileKind::from_path(path) == Some(kind)));
        } else {
            anyhow::ensure!(
                FileKind::from_path(input) == Some(kind),
                "{}: it should end in .{}",
                name(),
                kind.extension()
            );
            files.push(input.clone());
        }
    }
    let places = || inputs.iter().map(|input| files::shown(input)).collect::<Vec<_>>().join(", ");
    anyhow::ensure!(!files.is_empty(), "{}: there is no .{} file", places(), kind.extension());
    Ok(files)
}

impl TakenArgs {
    /// Returns the observation times that flags give to this number of files, if they do.
    fn times_of(&self, files: usize) -> anyhow::Result<Vec<Option<f64>>> {
        let file = |index: usize| match *self.times.as_slice() {
            [] => None,
            [from, to] => Some(time_within([from, to], index as f64 / (files.max(2) - 1) as f64)),
            ref times => Some(times[index]),
        };
        let count = self.times.len();
        anyhow::ensure!(
            [0, 2, files].contains(&count) && (count != 2 || files > 1),
            "--times: {count} for {files} files: give one for each, or the first and the last"
        );
        Ok((0..files).map(file).collect())
    }

    /// The settings with which a picture of `size` was taken, which those of `recorded` stand for where flags
    /// say nothing. Without a record the whole file is one eye's if `is_of_one`.
    fn settings(
        &self,
        recorded: Option<Settings>,
        size: [u32; 2],
        is_of_one: bool,
        time: Option<f64>,
    ) -> anyhow::Result<Settings> {
        let is_recorded = recorded.is_some();
        let (mut settings, mut missing) =
            self.camera.settings(recorded, size, is_of_one.then_some(Layout::Left));
        settings.time = time.or(settings.time);
        settings.motion.d = self.d.unwrap_or(settings.motion.d);
        if settings.time.is_none() {
            missing.push("--time");
        }
        if self.d.is_none() && !is_recorded {
            missing.push("--d");
        }
        anyhow::ensure!(
            missing.is_empty(),
            "it does not record {}, which must then be given",
            missing.join(", ")
        );
        Ok(settings)
    }
}

/// A row, and what looks wrong; none if an eye does not see the target.
fn measured(
    path: &Path,
    name: &str,
    target: Target<'_>,
    taken: &TakenArgs,
    time: Option<f64>,
) -> anyhow::Result<Option<([f64; COLUMNS], Vec<Remark>)>> {
    let mut remarks = Vec::new();
    let (places, size, settings) = match target {
        Target::Marker(colour) => {
            let file = PngFile::read(path)?;
            let recorded = Settings::recorded_in(file.command(), path)?;
            anyhow::ensure!(!recorded.as_ref().is_some_and(Settings::is_comparing), "{name}: {NO_PAIR}");
            let settings = taken.settings(recorded, file.picture().size, false, time);
            let settings = settings.with_context(|| name.to_owned())?;
            let sheet = sheet(&settings.picture, file.picture().size).with_context(|| name.to_owned())?;
            let mut place = |eye| {
                let mask = locate::colour_in(&sheet.picture_of(eye, &file.frames)?, colour);
                let parts = mask.parts();
                remarks.extend((parts > 1).then_some(Remark::Parts { eye, parts }));
                mask.middle()
            };
            ([place(0), place(1)], settings.picture.size.0, settings)
        }
        Target::Point(_) | Target::Body(_) => {
            let file = Measurements::read(path)?;
            let recorded = Settings::recorded_in(&file.command(), path)?;
            let settings =
                taken.settings(recorded, file.size, true, time).with_context(|| name.to_owned())?;
            let place =
                |eye| locate::in_layer(&file, eye, target, &settings).with_context(|| name.to_owned());
            let [left, right] = EYES.map(place);
            let (left, right) = (left?, right?);
            remarks.extend(remark::of_hidden_shares([left.hidden, right.hidden]));
            ([left.place, right.place], file.size, settings)
        }
    };
    anyhow::ensure!(!settings.ride.is_on(), "{name}: {ON_A_RIDE}");
    let [Some(left), Some(right)] = places else { return Ok(None) };
    let cameras = settings.recorded_cameras(size);
    let cameras = cameras.map_err(|flag| anyhow::anyhow!("{name}: it does not record {flag}"))?;
    remarks.extend(remark::of_target(&settings, target).with_context(|| name.to_owned())?);
    if let Target::Marker(_) = target {
        remarks.extend(remark::of_places(&settings, &cameras, [left, right]));
    }
    Ok(Some((row(&settings, &cameras, [left, right]), remarks)))
}

fn row(settings: &Settings, cameras: &[Camera; 2], [left, right]: [PixelPlace; 2]) -> [f64; COLUMNS] {
    let (left, right) = (Angles::new(&cameras[0], left), Angles::new(&cameras[1], right));
    let baseline = settings.baseline();
    [
        settings.time.unwrap_or_default(),
        baseline.separation,
        settings.motion.roll,
        settings.motion.turn,
        left.phi,
        right.phi,
        left.theta,
        right.theta,
        left.phi - right.phi,
        left.theta - right.theta,
        math::hypot(left.sigma_phi, right.sigma_phi),
        math::hypot(left.sigma_theta, right.sigma_theta),
    ]
}

/// Returns the sheet of a file of this `size` that shows both eyes in this `picture`.
fn sheet(picture: &PictureSettings, size: [u32; 2]) -> anyhow::Result<Sheet> {
    let layout = picture.layout;
    let has_both = layout.loses_nothing() && picture.eyes().len() == 2;
    anyhow::ensure!(has_both, "its layout, {}, does not have the whole pictures of both eyes", layout.name());
    Sheet::of_file(picture, picture.size.0, size).context("its size has changed since it was made")
}

/// Azimuth and elevation of a place in a picture, radians.
struct Angles {
    phi: f64,
    theta: f64,
    /// Standard deviation of the difference of azimuths, radians.
    sigma_phi: f64,
    sigma_theta: f64,
}

impl Angles {
    fn new(camera: &Camera, PixelPlace { at: [u, v], sigma }: PixelPlace) -> Self {
        let angles = |place| {
            let line = camera.line_of_sight(place);
            [math::atan2(line.y, line.x), math::atan2(line.z, math::hypot(line.x, line.y))]
        };
        let change_per_pixel = |du: f64, dv: f64| {
            let (after, before) = (angles([u + du, v + dv]), angles([u - du, v - dv]));
            [after[0] - before[0], after[1] - before[1]]
        };
        let (across, down) = (change_per_pixel(0.5, 0.0), change_per_pixel(0.0, 0.5));
        let of_angle = |angle: usize| math::hypot(across[angle] * sigma[0], down[angle] * sigma[1]);
        let [phi, theta] = angles([u, v]);
        Self { phi, theta, sigma_phi: of_angle(0), sigma_theta: of_angle(1) }
    }
}
