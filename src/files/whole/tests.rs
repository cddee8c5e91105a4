//! Writes that fail at, within and before the end of each piece that is written.

use std::collections::BTreeSet;
use std::io::{Cursor, Seek, SeekFrom};

use csv::ByteRecord;
use relativity_render::Picture;

use super::*;
use crate::files::csv_out::CsvWriter;
use crate::files::exr::Measurements;
use crate::files::png::Still;
use crate::files::{gif, mp4, png};

/// A place that a file is written to.
trait Place: Write + Seek {}
impl<P: Write + Seek> Place for P {}

/// A place that takes this number of further bytes, wherever they go, and notes how many are left after each
/// piece.
struct Failing<P> {
    to: P,
    left: usize,
    ends: Vec<usize>,
}

impl<P> Failing<P> {
    fn new(to: P, left: usize) -> Self {
        Self { to, left, ends: Vec::new() }
    }
}

impl<P: Write> Write for Failing<P> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.to.write(&bytes[..bytes.len().min(self.left)])?;
        self.left -= written;
        self.ends.push(self.left);
        if written == 0 && !bytes.is_empty() { Err(io::ErrorKind::StorageFull.into()) } else { Ok(written) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

impl<P: Seek> Seek for Failing<P> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.to.seek(to)
    }
}

fn picture() -> Picture {
    Picture { size: [3, 2], rgba: (0..6).map(|i| [40 * i, 7, 200 - i, u8::MAX]).collect() }
}

fn csv(out: &mut dyn Place) -> anyhow::Result<()> {
    let mut rows = CsvWriter::new(out);
    for row in 0..9 {
        rows.write(&mut ByteRecord::from(vec!["a,b"]), &[f64::from(row), 0.1])?;
    }
    Ok(rows.flush()?)
}

fn film(out: &mut dyn Place) -> anyhow::Result<()> {
    let frames = [picture(), picture()];
    let mut film = gif::GifWriter::new([3, 2], 4, gif::Palette::new(&frames), out)?;
    film.write(&frames)?;
    film.finish()
}

fn video(out: &mut dyn Place) -> anyhow::Result<()> {
    let timing = png::AnimationTiming { frames: 2, seconds: [1, 25] };
    let mut film = mp4::Mp4Writer::new([3, 2], timing, out)?;
    film.write(&[picture(), picture()])?;
    film.finish()
}

/// Each kind of file, and a small one of it.
type Kind = (&'static str, fn(&mut dyn Place) -> anyhow::Result<()>);
const KINDS: [Kind; 8] = [
    ("csv", csv),
    ("png", |out| png::write(&picture(), &[("Title", "two by three")], out)),
    ("apng", |out| {
        Still { frames: vec![picture(), picture()], pixels_per_metre: Some(5000) }
            .write(&[("Title", "x")], out)
    }),
    ("gif", film),
    ("mp4", video),
    ("exr", |out| Measurements::for_tests([2, 40]).write(out)),
    ("json", |out| write_json(&[[1.5, 2.5], [3.5, 4.5]], out)),
    // Pages, drawings and settings are written as one text.
    ("text", |out| Ok(out.write_all(&b"a line of text\n".repeat(30))?)),
];

/// Returns the numbers of bytes after which a place is tried to fail, where one with all the room there is
/// has `left` so many after each piece. What is between goes to the place in one piece, as do its neighbours.
fn failures(left: &[usize]) -> BTreeSet<usize> {
    let ends = left.iter().map(|left| usize::MAX - left);
    let length = ends.clone().max().unwrap_or_default();
    let around = [0].into_iter().chain(ends).flat_map(|end| [end.saturating_sub(1), end, end + 1]);
    around.filter(|&bytes| bytes < length).collect()
}

#[test]
fn no_kind_of_file_hides_that_a_byte_of_it_is_missing() {
    for (kind, write) in KINDS {
        let mut out = Failing::new(Cursor::new(Vec::new()), usize::MAX);
        write(&mut out).expect("there is room");
        let failures = failures(&out.ends);
        assert!(!failures.is_empty(), "{kind}");
        for bytes in failures {
            let mut out = Failing::new(Cursor::new(Vec::new()), bytes);
            assert!(write(&mut out).is_err(), "{kind} after {bytes} bytes");
        }
    }
}

#[test]
fn a_write_that_fails_anywhere_leaves_what_was_there_and_names_the_file() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let path = folder.path().join("out");
    std::fs::write(&path, "precious").expect("it is writable");
    for (kind, write) in KINDS {
        // Through a buffer fewer bytes are written where some take the place of others.
        let attempt = |left: usize, through: &mut dyn FnMut(&[usize])| {
            write_whole_through(
                &path,
                |file| Failing::new(file, left),
                |out| {
                    let written = write(out);
                    out.flush()?;
                    through(&out.get_ref().to().ends);
                    written
                },
            )
        };
        let mut tried = BTreeSet::new();
        attempt(usize::MAX, &mut |left| tried = failures(left)).expect("there is room");
        assert!(!tried.is_empty(), "{kind}");
        std::fs::write(&path, "precious").expect("it is writable");
        for bytes in tried {
            let error = attempt(bytes, &mut |_| ()).expect_err("there is no room");
            let said = format!("{}: no storage space", path.display());
            assert_eq!(format!("{error:#}"), said, "{kind} after {bytes} bytes");
            assert_eq!(std::fs::read(&path).expect("it is there"), b"precious", "{kind} after {bytes}");
            assert_eq!(std::fs::read_dir(folder.path()).expect("it is there").count(), 1, "{kind}");
        }
    }
}

#[test]
fn what_went_wrong_before_is_not_laid_on_the_file() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let error = write_whole(&folder.path().join("out"), |_| anyhow::bail!("rows.csv:3: no number"));
    assert_eq!(format!("{:#}", error.expect_err("it is bad")), "rows.csv:3: no number");
}
