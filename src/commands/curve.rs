//! `gamow curve`: what both eyes see of one point over a range of observation times.

use std::io::Write;

use clap::Args;
use csv::ByteRecord;
use relativity_core::{Baseline, SourcePoint};

use crate::columns::{GivenInputs, ModelArgs, Observation, ObservationError, ROLL, TURN, WHEEL, help_with};
use crate::files::csv_out;
use crate::files::whole::OutArgs;
use crate::flags::{COORDINATES, HeadArgs, SpeedArgs, WheelArgs, finite_number, within};
use crate::time_range::{passage_times, time_within};

/// Speed of the paper's cyclist.
const CYCLIST_BETA: f64 = 0.9;

/// Writes what two eyes see of one point over a range of observation times, as CSV.
///
/// Without flags: the tracked point of the paper's cyclist. The first columns are the inputs, under the names that
/// `gamow eval` reads; roll and turn, in radians, are among them where the head is tilted or turned, and `wheel_radius`, rho and
/// angle where the point is on a wheel.
#[derive(Debug, Args)]
#[command(after_long_help = help_with(EXAMPLES))]
pub struct CurveArgs {
    #[command(flatten)]
    speed: SpeedArgs,
    /// Separation of the apertures.
    #[arg(long, default_value_t = 0.1, value_parser = finite_number, allow_hyphen_values = true)]
    d: f64,
    #[command(flatten)]
    head: HeadArgs,
    /// Depth of the point.
    #[arg(long, default_value_t = 3.0, value_parser = finite_number, allow_hyphen_values = true)]
    y: f64,
    /// Height of the point.
    #[arg(long, default_value_t = 2.0, value_parser = finite_number, allow_hyphen_values = true)]
    z: f64,
    /// The point's objective x at t = 0.
    #[arg(long, default_value_t = 0.0, value_parser = finite_number, allow_hyphen_values = true)]
    x0: f64,
    #[command(flatten)]
    wheel: WheelArgs,
    /// First observation time [default: when the point, or the hub of its wheel, is seen at x = -2 R, R being its distance at x = 0]
    #[arg(long, value_name = "T", value_parser = within(COORDINATES), allow_hyphen_values = true)]
    from: Option<f64>,
    /// Last observation time [default: when it is seen at x = +2 R]
    #[arg(long, value_name = "T", value_parser = within(COORDINATES), allow_hyphen_values = true)]
    to: Option<f64>,
    /// Number of observation times, 2 to 1000000000.
    #[arg(long, default_value_t = 201, value_name = "N", value_parser = clap::value_parser!(u64).range(2..=1_000_000_000))]
    samples: u64,
    #[command(flatten)]
    out: OutArgs,
    #[command(flatten)]
    model: ModelArgs,
}

const EXAMPLES: &str = "\
Examples:
  gamow curve --samples 5
  gamow curve --beta 0.9 --d 0.3 --y 0.5 --z 0.5 --from -2 --to 5 --model published
  gamow curve --stereo | cut -d, -f 6,23-26
  gamow curve --stereo --roll 90
  gamow curve --conformal --samples 5 | cut -d, -f 6,23-26
  gamow curve --wheel-radius 0.525 --rho 1 --angle 0 --from -2 --to 8
  gamow curve --gamma 1e6 --x0 -10 --from 0 --to 20 --out curve.csv";

/// Runs the command `gamow curve`.
pub fn run(args: &CurveArgs) -> anyhow::Result<()> {
    let first = args.observation(0.0)?;
    args.model.values(&first, args.given_inputs())?; // so that a bad flag leaves no header behind on standard output
    let [from, to] = args.time_range(&first)?;
    if from >= to {
        anyhow::bail!("--from {from} is not before --to {to}");
    }
    args.out.write(|out| write_curve(args, first, [from, to], out))
}

fn write_curve(
    args: &CurveArgs,
    first: Observation,
    [from, to]: [f64; 2],
    out: &mut dyn Write,
) -> anyhow::Result<()> {
    let (parameter, speed) = args.speed.parameter(CYCLIST_BETA);
    let mut output = csv_out::Rows::new(out);
    let mut row = ByteRecord::from(vec![parameter.name(), "d"]);
    let Baseline { roll, turn, .. } = first.baseline;
    let told = args.given_inputs();
    let head: &[f64] = if told.is_turned { &[roll, turn] } else { &[] };
    row.extend(&[ROLL, TURN][..head.len()]);
    let wheel = args.wheel.given();
    let wheel = wheel.as_ref().map_or(&[][..], |wheel| wheel);
    row.extend(&WHEEL[..wheel.len()]);
    row.extend(["y", "z", "x0", "T"]);
    row.extend(args.model.columns(told)?);
    output.write(&mut row, &[])?;
    for sample in 0..args.samples {
        let time = time_within([from, to], sample as f64 / (args.samples - 1) as f64);
        let values = args.model.values(&Observation { time, ..first }, told)?;
        row.clear();
        let inputs = [&[speed, args.d], head, wheel, &[args.y, args.z, args.x0, time]].concat();
        output.write(&mut row, &[inputs, values].concat())?;
    }
    Ok(output.flush()?)
}

impl CurveArgs {
    fn observation(&self, time: f64) -> anyhow::Result<Observation> {
        let source = self.wheel.source(SourcePoint { x0: self.x0, y: self.y, z: self.z });
        let baseline = self.head.baseline(self.d);
        Ok(Observation { speed: self.speed.speed(CYCLIST_BETA)?, source, baseline, time })
    }

    /// Returns what the flags determine.
    fn given_inputs(&self) -> GivenInputs {
        let is_turned = self.head.radians().into_iter().flatten().any(|angle| angle != 0.0);
        GivenInputs { is_turned, on_wheel: self.wheel.given().is_some() }
    }

    /// The observation times to start and end at.
    fn time_range(&self, observation: &Observation) -> anyhow::Result<[f64; 2]> {
        if let (Some(from), Some(to)) = (self.from, self.to) {
            return Ok([from, to]);
        }
        let &Observation { speed, source, baseline, .. } = observation;
        let Some(times) =
            passage_times(&speed, source.place(), baseline.apertures()).map_err(ObservationError::from)?
        else {
            anyhow::bail!("a point at rest passes at no time; --from and --to are needed");
        };
        Ok([self.from.unwrap_or(times[0]), self.to.unwrap_or(times[1])])
    }
}
