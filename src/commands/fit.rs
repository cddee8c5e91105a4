//! `gamow fit`: speed and distance of a point from its measured disparities.

use std::io::Read;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use anyhow::Context as _;
use clap::Args;
use gamow_platform::interrupt::Noted;
use gamow_platform::{clock, messages, progress};
use relativity_core::{Curves, DEFAULT_REPLICATES, FitError, FitOptions, Loss, LossShape, Model, Passage};

use crate::estimate::FitReport;
use crate::estimate::correction::Correction;
use crate::estimate::data::{Data, Eyes, SEPARATION, is_separation};
use crate::estimate::{cause, outliers};
use crate::files::csv_in;
use crate::files::whole::ReportArgs;
use crate::flags::{COORDINATES, HeadArgs, WheelArgs, finite_number, within};
use crate::number_text;

/// Fits speed and distance of a point to the disparities that two eyes measured.
///
/// The header names the columns, in any order: T (when the light arrives); dphi, dtheta or both (left minus
/// right, radians); optionally `sigma_dphi` and `sigma_dtheta` (their standard deviations); d (eye
/// separation) unless --d gives it; roll and turn (degrees) where the head was tilted or turned, unless
/// --roll and --turn say so. Other columns are ignored. A disparity that was not measured is left
/// empty, or is NaN, NA, #N/A or -.
///
/// Files of spreadsheets, `NumPy`, R, phyphox, Logger Pro and Tracker are read as they are: with units behind
/// the names or in a row below them, as in `dphi (mrad)`; comments behind #; text above the header;
/// semicolons, tabs or blanks between the fields; UTF-16. What was done to a file is said in one line.
///
/// Data that do not determine the result are refused in one line, with exit status 2.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES, after_long_help = HELP)]
pub struct FitArgs {
    /// CSV file; standard input if none or -.
    file: Option<PathBuf>,
    /// Separation of the eyes; without it, the file's column d.
    #[arg(long, value_parser = separation, allow_hyphen_values = true)]
    d: Option<f64>,
    /// Model of the two eyes' views.
    #[arg(long, value_enum, default_value_t)]
    model: Model,
    /// Curves to fit [default: those that the file has]
    #[arg(long = "use", value_enum)]
    curves: Option<Curves>,
    /// Number of bootstrap replicates, up to 10 million; 0 for none. Ctrl-C ends with the report of those
    /// that were drawn
    #[arg(long, value_name = "N", default_value_t = DEFAULT_REPLICATES, value_parser = replicates, help_heading = "Bootstrap")]
    bootstrap: usize,
    /// Seed of the bootstrap.
    #[arg(long, value_name = "S", default_value_t = 1, help_heading = "Bootstrap")]
    seed: u64,
    /// The point's x at t = 0, if it is known.
    #[arg(long, default_value_t = 0.0, value_parser = within(COORDINATES), allow_hyphen_values = true)]
    x0: f64,
    /// Fit x0 too: the time of passage is unknown.
    #[arg(long, conflicts_with = "x0")]
    fit_x0: bool,
    /// Loss function, as in `SciPy`: residuals count by their squares, or less where they are large.
    #[arg(long, value_enum, default_value_t, help_heading = "Loss")]
    loss: LossShape,
    /// Residual from which on a reading counts less by a robust --loss: in sigmas where the file has them,
    /// else in standard deviations of each curve, from the median of its residuals [default: soft-l1 1.287,
    /// huber 1.345, cauchy 2.385]
    #[arg(long, value_name = "C", value_parser = within(LOSS_SCALES), help_heading = "Loss")]
    loss_scale: Option<f64>,
    /// The eyes rode past a point at rest, along x: the times are those of the rider's own clock, the file's
    /// column clock; beta is the rider's speed, and x0 how far behind the point is when the clock shows 0,
    /// contracted.
    #[arg(long, conflicts_with = "wheel_radius")]
    riding: bool,
    #[command(flatten)]
    report: ReportArgs,
    /// Tilt and turn of the head; without them, the file's columns roll and turn, else straight.
    #[command(flatten, next_help_heading = "Head")]
    head: HeadArgs,
    #[command(flatten, next_help_heading = "Readings")]
    correction: Correction,
    #[command(flatten, next_help_heading = "Wheel")]
    wheel: WheelArgs,
}

const HELP: &str = "\
The point is in front of the eyes (y > 0). dphi alone tells the magnitude of z; dtheta tells its sign too.

Uncertainties are standard errors over the bootstrap replicates. The 95 % intervals lie about the best fit as the \
replicates do, and are at least as wide as a standard error that counts readings of much weight rightly, by Student's t; \
`linear` is the standard error from the covariance at the best fit. Where the residuals follow one another (Durbin and \
Watson's test, wrong for 1 in 1,000 fits of good readings), no uncertainty follows: the fit says so, and looks for the cause. With both curves, the joint fit is the best use of the data; \
the paper's weighted mean of the two fits stands beside it, with their correlation accounted for.

By --loss soft-l1, huber or cauchy a few wrong readings hardly move the fit, and the replicates are refitted by the same loss. \
Good readings give standard errors 1.026 times those of least squares, by the default of --loss-scale.

A point of a wheel that rolls is fitted by where on its wheel it is, which has to be known (--wheel-radius, --rho, --angle): y, \
z and x0 are then the hub's, and dphi alone tells the sign of z, too.";

const EXAMPLES: &str = "\
Examples:
  gamow curve | gamow fit
  gamow fit data.csv --d 0.1 --fit-x0
  gamow fit data.csv --d 0.1 --model published --use dphi --json
  gamow fit data.csv --d 0.1 --loss huber
  gamow curve --beta 0 --x0 5 --observer-beta 0.9 | gamow fit --riding --fit-x0
  gamow fit valve.csv --d 0.1 --wheel-radius 0.525 --rho 0.85 --angle 1.2";

fn separation(text: &str) -> Result<f64, String> {
    let value = finite_number(text)?;
    if is_separation(value) { Ok(value) } else { Err(format!("must be {SEPARATION}")) }
}

/// Scales of a robust loss: below, nearly all readings are outliers; above, none is.
const LOSS_SCALES: RangeInclusive<f64> = 0.1..=100.0;
/// The most replicates: each takes 56 bytes, in each of three fits.
const MOST_REPLICATES: usize = 10_000_000;
/// Duration, seconds, from which on that of the bootstrap is remarked on, and after which it can be
/// estimated.
const LONG: f64 = 10.0;
const TOLD_AFTER: f64 = 1.0;

fn replicates(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(number @ (0 | 2..=MOST_REPLICATES)) => Ok(number),
        _ => Err(format!("must be 0, or a number from 2 to {MOST_REPLICATES}")),
    }
}

/// Runs the command `gamow fit`.
pub fn run(args: &FitArgs) -> anyhow::Result<()> {
    let (name, input) = csv_in::open(args.file.as_deref())?;
    args.report.write(&args.fitted(&name, input)?)
}

impl FitArgs {
    /// The fit of the readings in `input`, a CSV file called `name` in errors, with the replicates that are
    /// drawn until `is_wanted`, which is called with their number, becomes false.
    ///
    /// # Errors
    ///
    /// One line that says where the readings are wrong, or why they tell too little.
    pub fn fitted_while(
        &self,
        name: &str,
        input: impl Read,
        is_wanted: impl FnMut(usize) -> bool,
    ) -> anyhow::Result<FitReport> {
        let eyes = Eyes { ride: self.riding, ..Eyes::given(self.d, self.head.radians()) };
        if self.riding && matches!(self.model, Model::Published(_)) {
            anyhow::bail!("--riding: the model {} has both eyes at rest", self.model.name());
        }
        let data = Data::read(name, input, eyes, self.correction.units())?;
        let corrected = self.correction.applied(data.observations.clone());
        let observations = corrected.with_context(|| name.to_owned())?;
        let curves = data.curves(self.curves);
        let passage = if self.fit_x0 { Passage::Fitted } else { Passage::Known(self.x0) };
        let loss = self.loss()?;
        let options = FitOptions { model: self.model, curves, passage, rolling: self.wheel.rolling(), loss };
        let wanted = self.bootstrap;
        let fitted = FitReport::while_wanted(&observations, &options, wanted, self.seed, is_wanted);
        let cause = |failed| {
            let cause = cause::find(&observations, &options, failed, data.said)?;
            let given = self.file.as_ref().filter(|file| file.as_os_str() != "-");
            let file = given.map_or("-", |_| name);
            Some(cause.told(file, &self.given_flags()))
        };
        match fitted {
            Ok(mut report) => {
                if self.correction.shift_dtheta.is_none() {
                    outliers::name_lines(&mut report.outliers, &data.lines);
                }
                let cause = report.warning.is_some().then(|| cause(Some(report.fit.rms))).flatten();
                let (riding, lines) = (self.riding, data.lines);
                Ok(FitReport { riding, lines, data: data.treatment, cause, ..report })
            }
            Err(error) => {
                let is_of_data = matches!(
                    error,
                    FitError::Unexplained { .. }
                        | FitError::Indistinguishable { .. }
                        | FitError::NotConverged(_)
                );
                let cause = if is_of_data { cause(None) } else { None };
                let told = cause.map_or_else(String::new, |cause| format!("; {cause}"));
                Err(anyhow::anyhow!("{name}: {error}{told}"))
            }
        }
    }

    /// The loss function with its scale.
    fn loss(&self) -> anyhow::Result<Loss> {
        let loss = Loss::of(self.loss);
        match self.loss_scale {
            Some(_) if !loss.is_robust() => anyhow::bail!("--loss-scale: the loss linear has no scale"),
            Some(scale) => Ok(Loss { scale, ..loss }),
            None => Ok(loss),
        }
    }

    /// The flags that are given beside those of the fit's options, a blank before each.
    fn given_flags(&self) -> String {
        let flag = |name: &str, value: Option<f64>| {
            value.map_or_else(String::new, |value| format!(" --{name}={value}"))
        };
        let [roll, turn] = self.head.degrees();
        let riding = if self.riding { " --riding" } else { "" };
        let eyes = [flag("d", self.d), flag("roll", roll), flag("turn", turn)].concat();
        format!("{eyes}{riding}{}", self.correction.flags())
    }

    /// Runs the fit with the replicates that are drawn until an interrupt.
    fn fitted(&self, name: &str, input: impl Read) -> anyhow::Result<FitReport> {
        let (wanted, noted) = (self.bootstrap, Noted::new());
        let progress = progress::bar(wanted as u64, "replicates");
        let (start, mut is_told) = (clock::Instant::now(), false);
        let report = self.fitted_while(name, input, |drawn| {
            progress.set_position(drawn as u64);
            let seconds = start.elapsed().as_secs_f64();
            if !is_told && drawn > 0 && seconds > TOLD_AFTER {
                is_told = true;
                let left = seconds / drawn as f64 * (wanted - drawn) as f64;
                if left > LONG {
                    let left = number_text::significant(left, 2);
                    let told = format!(
                        "gamow: {wanted} replicates take about {left} s more; Ctrl-C ends with those drawn by then"
                    );
                    progress.suspend(|| messages::remark(told));
                }
            }
            !noted.is_interrupted()
        });
        progress.finish_and_clear();
        let report = report?;
        if let Some(treatment) = &report.data {
            messages::remark(format_args!("gamow: {name}: {treatment}"));
        }
        if noted.is_interrupted() {
            let drawn = report.bootstrap.as_ref().map_or(0, |bootstrap| bootstrap.replicates);
            messages::remark(format_args!("gamow: interrupted after {drawn} of {wanted} replicates"));
        }
        Ok(report)
    }
}
