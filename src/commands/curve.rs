//! `gamow curve`: what both eyes see of one point over a range of observation times.

use clap::Args;
use csv::ByteRecord;
use relativity_core::{Aperture, SourcePoint, StereoError};

use crate::columns::{
    CLOCK, GivenInputs, HELP, ModelArgs, OBSERVER_DIRECTION, OBSERVER_PLACE, Observation, ObservationError,
    ROLL, TURN, WHEEL, observer_speed, unit,
};
use crate::files::whole::ReportArgs;
use crate::flags::{
    COORDINATES, GivenObserver, HeadArgs, ObserverArgs, SpeedArgs, SpeedParameter, WheelArgs, finite_number,
    within,
};
use crate::time_range::{passage_times, time_within};

/// Speed of the paper's cyclist.
const CYCLIST_BETA: f64 = 0.9;

/// Writes what two eyes see of one point over a range of observation times, as CSV or JSON.
///
/// Without flags: the tracked point of the paper's cyclist. The first columns are the inputs, under the names
/// that `gamow eval` reads; roll and turn, in degrees, are among them where the head is tilted or turned, and
/// `wheel_radius`, rho and angle where the point is on a wheel.
///
/// With a moving observer (--observer-beta and others) the range is one of the observer's clock, the column
/// `clock`, which shows 0 at --observer-x, --observer-y and --observer-z at T = 0; each row has the
/// observer's place, and T there.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES, after_long_help = HELP)]
pub struct CurveArgs {
    #[command(flatten)]
    speed: SpeedArgs,
    /// Separation of the eyes.
    #[arg(long, default_value_t = 0.1, value_parser = finite_number, allow_hyphen_values = true)]
    d: f64,
    /// Depth of the point.
    #[arg(long, default_value_t = 3.0, value_parser = finite_number, allow_hyphen_values = true)]
    y: f64,
    /// Height of the point.
    #[arg(long, default_value_t = 2.0, value_parser = finite_number, allow_hyphen_values = true)]
    z: f64,
    /// The point's x at t = 0.
    #[arg(long, default_value_t = 0.0, value_parser = finite_number, allow_hyphen_values = true)]
    x0: f64,
    /// First observation time [default: when the point, or the hub of its wheel, is seen at x = -2 R, R being
    /// its distance at x = 0]
    #[arg(long, value_name = "T", value_parser = within(COORDINATES), allow_hyphen_values = true)]
    from: Option<f64>,
    /// Last observation time [default: when it is seen at x = +2 R]
    #[arg(long, value_name = "T", value_parser = within(COORDINATES), allow_hyphen_values = true)]
    to: Option<f64>,
    /// Number of observation times, 2 to 1000000000.
    #[arg(long, default_value_t = 201, value_name = "N", value_parser = clap::value_parser!(u64).range(2..=1_000_000_000))]
    samples: u64,
    #[command(flatten)]
    report: ReportArgs,
    #[command(flatten, next_help_heading = "Head")]
    head: HeadArgs,
    #[command(flatten, next_help_heading = "Wheel")]
    wheel: WheelArgs,
    #[command(flatten, next_help_heading = "Observer")]
    observer: ObserverArgs,
    #[command(flatten, next_help_heading = "Columns")]
    model: ModelArgs,
}

const EXAMPLES: &str = "\
Examples:
  gamow curve --samples 5
  gamow curve --beta 0.9 --d 0.3 --y 0.5 --z 0.5 --from -2 --to 5 --model published
  gamow curve --stereo | cut -d, -f 6,23-26
  gamow curve --stereo --roll 90
  gamow curve --samples 5 --json
  gamow curve --conformal --samples 5 | cut -d, -f 6,23-26
  gamow curve --wheel-radius 0.525 --rho 1 --angle 0 --from -2 --to 8
  gamow curve --beta 0 --x0 5 --observer-beta 0.9 --stereo
  gamow curve --gamma 1e6 --x0 -10 --from 0 --to 20 --out curve.csv";

/// Runs the command `gamow curve`.
pub fn run(args: &CurveArgs) -> anyhow::Result<()> {
    let curve = args.curve()?; // so that a bad flag leaves no header behind on standard output
    let progress = args.report.count_of_rows();
    args.report.write_table(unit, |table| {
        table.head(&mut ByteRecord::new(), &curve.columns()?)?;
        let mut row = ByteRecord::new();
        for (count, values) in (0..).zip(curve.rows()) {
            row.clear();
            table.row(&mut row, &values?)?;
            progress.note(count);
        }
        Ok(())
    })?;
    progress.end();
    Ok(())
}

/// A table of what two eyes see of one point.
#[derive(Debug)]
pub struct StereoTable<'a> {
    args: &'a CurveArgs,
    first: Observation,
    range: [f64; 2],
}

impl StereoTable<'_> {
    /// The names of the columns: the inputs, and what is seen.
    ///
    /// # Errors
    ///
    /// Stereo columns of a model that has none.
    pub fn columns(&self) -> Result<Vec<&'static str>, StereoError> {
        let inputs = self.args.inputs(&self.first).into_iter().map(|(name, _)| name);
        Ok(inputs.chain(self.args.model.columns(self.args.given_inputs())?).collect())
    }

    /// The rows, each at its observation time, with a value for each column; NaN where there is none.
    pub fn rows(&self) -> impl Iterator<Item = anyhow::Result<Vec<f64>>> {
        let &Self { args, range, .. } = self;
        let given = args.given_inputs();
        (0..args.samples).map(move |sample| {
            let time = time_within(range, sample as f64 / (args.samples - 1) as f64);
            let observation = args.observation(time)?;
            let values = args.model.values(&observation, given)?;
            let inputs = args.inputs(&observation).into_iter().map(|(_, value)| value);
            Ok(inputs.chain(values).collect())
        })
    }
}

impl CurveArgs {
    /// The table that the flags describe.
    ///
    /// # Errors
    ///
    /// A value out of range, an empty range of times, or a point at rest, which never passes.
    pub fn curve(&self) -> anyhow::Result<StereoTable<'_>> {
        let first = self.observation(0.0)?;
        self.model.values(&first, self.given_inputs())?;
        let range = self.time_range(&first)?;
        let [from, to] = range;
        anyhow::ensure!(from < to, "--from {from} must be below --to {to}");
        Ok(StereoTable { args: self, first, range })
    }

    /// Returns the number of rows.
    #[must_use]
    pub const fn samples(&self) -> u64 {
        self.samples
    }

    /// The observation at a time: T of eyes at rest, else of the observer's clock.
    fn observation(&self, time: f64) -> anyhow::Result<Observation> {
        let source = self.wheel.source(SourcePoint { x0: self.x0, y: self.y, z: self.z });
        let baseline = self.head.baseline(self.d);
        let speed = self.speed.speed(CYCLIST_BETA)?;
        let Some(given) = self.observer.given() else {
            return Ok(Observation::at_rest(speed, source, baseline, time));
        };
        Ok(Observation { speed, source, baseline, observer: given.observer(0.0)?, clock: time })
    }

    /// The columns of the inputs and their values, as `gamow eval` reads them.
    fn inputs(&self, observation: &Observation) -> Vec<(&'static str, f64)> {
        let (parameter, speed) = self.speed.parameter(CYCLIST_BETA);
        let mut inputs = vec![(parameter.name(), speed), ("d", self.d)];
        if self.given_inputs().is_turned {
            let [roll, turn] = self.head.degrees().map(Option::unwrap_or_default);
            inputs.extend([(ROLL, roll), (TURN, turn)]);
        }
        inputs.extend(self.wheel.given().into_iter().flat_map(|wheel| WHEEL.into_iter().zip(wheel)));
        inputs.extend([("y", self.y), ("z", self.z), ("x0", self.x0)]);
        let observer = observation.observer.at(observation.clock);
        if let Some(GivenObserver { speed, direction, .. }) = self.observer.given() {
            let (parameter, value) = speed.unwrap_or((SpeedParameter::Beta, 0.0));
            inputs.push((observer_speed(parameter), value));
            inputs.extend(OBSERVER_DIRECTION.into_iter().zip(direction));
            inputs.extend(OBSERVER_PLACE.into_iter().zip(observer.place));
            inputs.push((CLOCK, observation.clock));
        }
        inputs.push(("T", observer.time));
        inputs
    }

    /// Returns what the flags determine.
    fn given_inputs(&self) -> GivenInputs {
        let is_turned = self.head.radians().into_iter().flatten().any(|angle| angle != 0.0);
        GivenInputs {
            is_turned,
            on_wheel: self.wheel.given().is_some(),
            is_riding: self.observer.given().is_some(),
        }
    }

    /// The observation times to start and end at.
    fn time_range(&self, observation: &Observation) -> anyhow::Result<[f64; 2]> {
        if let (Some(from), Some(to)) = (self.from, self.to) {
            return Ok([from, to]);
        }
        let &Observation { speed, source, baseline, ref observer, .. } = observation;
        let times = if self.observer.given().is_some() {
            let (speed, point) =
                observer.relative_motion(&speed, source.place()).map_err(ObservationError::from)?;
            passage_times(&speed, point, [Aperture::default(); 2])
        } else {
            passage_times(&speed, source.place(), baseline.apertures())
        };
        let Some(times) = times.map_err(ObservationError::Domain)? else {
            anyhow::bail!("a point at rest never passes; --from and --to are needed");
        };
        Ok([self.from.unwrap_or(times[0]), self.to.unwrap_or(times[1])])
    }
}
