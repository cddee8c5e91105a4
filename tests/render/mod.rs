//! `gamow render`, run as its users run it. The reference renderer throughout: it needs no graphics adapter.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;

mod comparison;
mod errors;
mod films;
mod measure;
mod measurements;
mod pictures;
mod rectify;
mod ride;
mod sequences;

const WIDTH: u32 = 48;
const HEIGHT: u32 = 36;

fn folder() -> TempDir {
    tempfile::tempdir().expect("there is a place for temporary files")
}

/// `gamow render` with the words of `flags` in `folder`, of the cyclist, small and by the reference renderer.
fn command(folder: &Path, flags: &str) -> Command {
    let mut command = command_of_any_scene(folder, flags);
    if !flags.contains("--scene") && !flags.contains("--state") {
        command.arg("--scene=cyclist");
    }
    command
}

/// The same of the usual scene, unless `flags` or later ones name another.
fn command_of_any_scene(folder: &Path, flags: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    command.current_dir(folder).env_remove("RUST_LOG").arg("render").args(flags.split_whitespace());
    if !flags.contains("--size") {
        command.arg(format!("--size={WIDTH}x{HEIGHT}"));
    }
    if !flags.contains("--renderer") {
        command.arg("--renderer=reference");
    }
    command
}

fn output(folder: &Path, flags: &str) -> Output {
    command(folder, flags).output().expect("the program starts")
}

/// A run that must succeed; what it printed.
fn render(folder: &Path, flags: &str) -> String {
    let output = output(folder, flags);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{flags}: {stderr}");
    String::from_utf8(output.stdout).expect("it prints text")
}

/// `gamow` with the `words` in `folder`.
fn gamow_output(folder: &Path, words: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    command.current_dir(folder).env_remove("RUST_LOG").args(words.split_whitespace());
    command.output().expect("the program starts")
}

/// The same, which must succeed; what it printed.
fn run_gamow(folder: &Path, words: &str) -> String {
    let output = gamow_output(folder, words);
    assert!(output.status.success(), "{words}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("it prints text")
}

/// The one line of a run that must fail.
fn complaint_of(folder: &Path, words: &str) -> String {
    only_line(words, &gamow_output(folder, words))
}

/// The one line of a `gamow render` that must fail.
fn complaint(folder: &Path, flags: &str) -> String {
    only_line(flags, &output(folder, flags))
}

fn only_line(words: &str, output: &Output) -> String {
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{words}: {stderr}");
    assert!(stderr.starts_with("gamow: ") && stderr.trim_end().lines().count() == 1, "{words}: {stderr}");
    stderr
}

/// A PNG file: its size, its RGB bytes and its texts.
struct Png {
    size: [u32; 2],
    rgb: Vec<u8>,
    texts: BTreeMap<String, String>,
}

impl Png {
    fn read(path: &Path) -> Self {
        let file = File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let mut reader = png::Decoder::new(BufReader::new(file)).read_info().expect("it is a PNG file");
        let mut rgb = vec![0; reader.output_buffer_size().expect("it fits into memory")];
        reader.next_frame(&mut rgb).expect("all pixels are there");
        reader.finish().expect("the file is whole");
        let info = reader.info();
        let text = |chunk: &png::text_metadata::ITXtChunk| {
            (chunk.keyword.clone(), chunk.get_text().expect("the text is there"))
        };
        Self { size: [info.width, info.height], rgb, texts: info.utf8_text.iter().map(text).collect() }
    }

    fn row(&self, v: u32) -> &[u8] {
        let length = 3 * self.size[0] as usize;
        &self.rgb[v as usize * length..][..length]
    }
}

/// The picture of a run with these flags.
fn picture(flags: &str) -> Png {
    let folder = folder();
    render(folder.path(), &format!("{flags} --out picture.png"));
    Png::read(&folder.path().join("picture.png"))
}
