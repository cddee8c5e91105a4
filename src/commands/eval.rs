//! `gamow eval`: what both eyes see of the point in each row of a CSV file.

use std::io::{Read, Write};
use std::path::PathBuf;

use anyhow::Context as _;
use clap::Args;
use csv::ByteRecord;
use gamow_platform::progress::Count;

use crate::columns::{GivenInputs, HELP, Header, InputError, ModelArgs, unit};
use crate::files::csv_in;
use crate::files::table_out::TableWriter;
use crate::files::whole::ReportArgs;

/// Writes what two eyes see of the point in each row of a CSV file, as CSV or JSON.
///
/// The header names the columns, in any order: exactly one of beta, gamma, rapidity; d (eye separation); y
/// and z (the point's depth and height); T (when the light arrives); optionally x0 (the point's x at t = 0,
/// else 0), roll and turn (by how much the head is tilted and turned, in degrees, else 0), and
/// `wheel_radius`, rho and angle (of a point on a wheel that rolls, whose hub is at x0, y and z: the radius
/// of the wheel, how far the point is from the hub in radii, and where it is at t' = 0 by the clocks that
/// ride with the hub, from +x towards +z, in radians), and how the observer moves (`observer_beta` and
/// others, below). All other columns pass through.
///
/// In JSON a field of a column that is passed through is a text, or null where it is empty.
///
/// A bad row ends the run with one line that names file, line and column, and exit status 2. With --out no
/// file is then written; standard output has the rows before it.
#[derive(Debug, Args)]
#[command(before_long_help = EXAMPLES, after_long_help = HELP)]
pub struct EvalArgs {
    /// CSV file; standard input if none or -.
    file: Option<PathBuf>,
    #[command(flatten)]
    report: ReportArgs,
    #[command(flatten, next_help_heading = "Columns")]
    model: ModelArgs,
}

const EXAMPLES: &str = "\
Examples:
  printf 'beta,d,y,z,T\\n0.9,0.3,0.5,0.5,0\\n' | gamow eval
  printf 'gamma,d,y,z,T,x0,name\\n1e9,0.1,3,2,4,-1,rider\\n' | gamow eval --intensity-exponent photons
  printf 'beta,d,y,z,T,wheel_radius,rho,angle\\n0.9,0.1,3,2,4,0.5,1,0\\n' | gamow eval
  printf 'observer_beta,beta,d,x0,y,z,T\\n0.9,0,0.1,5,3,2,0\\n' | gamow eval --stereo
  printf 'beta,d,y,z,T,name\\n0.9,0.3,0.5,0.5,0,crank\\n' | gamow eval --json
  gamow curve | cut -d, -f 1-6 | gamow eval --model published --out published.csv";

/// Runs the command `gamow eval`.
pub fn run(args: &EvalArgs) -> anyhow::Result<()> {
    let (name, input) = csv_in::open(args.file.as_deref())?;
    let progress = args.report.count_of_rows();
    args.report.write_table(unit, |table| evaluate(&name, input, args.model, table, &progress))?;
    progress.end();
    Ok(())
}

/// Whether these are the columns of observations: what stands before a header has not these names.
fn is_header(names: &csv_in::Names) -> bool {
    ["d", "y", "z", "T"].iter().filter(|name| !matches!(names.place(name), Ok(None))).count() > 2
}

/// Reads rows of `input`, called `name` in errors, and writes each into `table` with the columns appended.
fn evaluate(
    name: &str,
    input: impl Read,
    model: ModelArgs,
    table: &mut TableWriter<impl Write>,
    progress: &Count,
) -> anyhow::Result<()> {
    let plain = GivenInputs { is_turned: false, on_wheel: false, is_riding: false };
    model.columns(plain)?; // what has no such columns is no matter of a row
    let mut input = csv_in::CsvReader::new(input, is_header).with_context(|| name.to_owned())?;
    let mut row = ByteRecord::new();

    input.read(&mut row).with_context(|| name.to_owned())?;
    let place = |input: &csv_in::CsvReader<_>, row: &ByteRecord| format!("{name}:{}", input.line(row));
    let header =
        Header::new(row.clone(), |given| model.columns(given)).with_context(|| place(&input, &row))?;
    table.head(&mut row, &model.columns(header.given())?)?;

    let mut count = 0;
    while input.read(&mut row).with_context(|| name.to_owned())? {
        let values = input
            .check_closed(&row)
            .map_err(InputError::from)
            .and_then(|()| header.observation(&row))
            .and_then(|observation| Ok(model.values(&observation, header.given())?))
            .with_context(|| place(&input, &row))?;
        table.row(&mut row, &values)?;
        count += 1;
        progress.note(count);
        if input.is_drained() {
            table.flush()?; // let a reader at the other end see these rows while we wait for more
        }
    }
    Ok(())
}
