//! The program `gamow`, run as its users run it: arguments and bytes in, bytes and exit status out.

use std::env;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;

mod causes;
mod class;
mod command_line;
mod completions;
mod data_files;
mod errors;
mod fit;
#[cfg(target_os = "linux")]
mod full;
mod garbage;
mod help;
#[cfg(unix)]
mod irregular;
mod json;
mod lessons;
mod numbers;
mod outliers;
mod pages;
mod paper;
mod quiet;
mod records;
mod riding;
mod streams;
mod wheels;
mod worksheets;

/// What a run left behind.
struct Outcome {
    status: Option<i32>,
    stdout: Vec<u8>,
    stderr: String,
}

impl Outcome {
    /// Standard output of a run that must have succeeded.
    fn text(self) -> String {
        assert_eq!((self.status, self.stderr.as_str()), (Some(0), ""));
        String::from_utf8(self.stdout).expect("output is text if the input was")
    }

    /// The numbers of a run that must have succeeded.
    fn table(self) -> Table {
        Table::parsed(&self.text())
    }

    /// The one line on standard error of a run that must have failed.
    fn complaint(self) -> String {
        assert_eq!(self.status, Some(2), "{}", self.stderr);
        let line = self.stderr.strip_suffix('\n').expect("the line is ended");
        assert!(!line.contains('\n'), "one line: {line}");
        line.to_owned()
    }
}

fn gamow() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    command.env_remove("RUST_LOG");
    command
}

/// Runs `line` as a shell in the folder `scratch` does, with `gamow` on the path.
fn shell(line: &str, scratch: &Path) -> Outcome {
    let program = Path::new(env!("CARGO_BIN_EXE_gamow"));
    let folder = program.parent().expect("a program is in a folder");
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = [folder.to_owned()].into_iter().chain(env::split_paths(&path));
    run(
        Command::new("sh")
            .args(["-c", line])
            .current_dir(scratch)
            .env("PATH", env::join_paths(folders).expect("paths join")),
        b"",
    )
}

fn run(command: &mut Command, input: &[u8]) -> Outcome {
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    let output = thread::scope(|scope| {
        // A program that has seen enough closes its end, so a failure to write is none of the test.
        scope.spawn(move || drop(stdin.write_all(input)));
        child.wait_with_output().expect("the program ends")
    });
    let stderr = String::from_utf8(output.stderr).expect("messages are text");
    Outcome { status: output.status.code(), stdout: output.stdout, stderr }
}

/// `gamow` with the words of `arguments`, and no input.
fn words(arguments: &str) -> Outcome {
    run(gamow().args(arguments.split_whitespace()), b"")
}

/// `gamow eval` of `input`.
fn eval(input: impl AsRef<[u8]>) -> Outcome {
    run(gamow().arg("eval"), input.as_ref())
}

/// A CSV file of numbers only.
struct Table {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Table {
    fn parsed(text: &str) -> Self {
        let mut lines = text.lines();
        let names = lines.next().expect("there is a header").split(',').map(str::to_owned).collect();
        let rows = lines
            .map(|line| line.split(',').map(|field| field.parse().expect("all are numbers")).collect())
            .collect();
        Self { names, rows }
    }

    fn column(&self, name: &str) -> Vec<f64> {
        let place = self.names.iter().position(|found| found == name).expect("the column is there");
        self.rows.iter().map(|row| row[place]).collect()
    }
}
