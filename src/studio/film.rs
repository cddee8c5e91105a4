//! Films: frames at evenly spread observation times, as one animated file or as a folder of pictures.

use std::cell::Cell;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use anyhow::Context as _;
use gamow_platform::{files, threads};
use relativity_render::Picture;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{Studio, StudioFrame};
use crate::files::png::AnimationTiming;
use crate::files::provenance::Provenance;
use crate::files::whole::write_whole;
use crate::files::{gif, mp4, png};
use crate::flags::choices::FileKind;
use crate::time_range::time_within;

/// Frames a second: a whole number of hundredths of a second each, as a GIF needs.
pub const FRAMES_PER_SECOND: u16 = 25;
/// Number of frames from which the size of a film is estimated, at least.
const FEW: u32 = 5;
/// Number of frames at most by which the colours of a GIF are chosen, and of how many pixels in a row one is
/// drawn for that.
const SAMPLED_FRAMES: usize = 20;
const SAMPLED_PIXELS: u32 = 3;
/// Number of frames for which each of two alternating pictures is shown: no faster than flashes may be shown
/// to everybody.
const FRAMES_PER_TURN: usize = 5;

/// The kind of a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum FilmKind {
    /// An animated GIF, of 255 colours.
    Gif,
    /// A video of H.264.
    Mp4,
    /// An animated picture (PNG).
    Png,
    /// A folder with a picture for each frame.
    Folder,
}

/// The part of a film that is made.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Written {
    /// Frames that are drawn; the last of them may wait to be written.
    pub drawn: u32,
    /// Frames that are written.
    pub frames: u32,
    /// Size of the written frames, bytes.
    pub bytes: u64,
}

impl Written {
    /// The size of a film of so many `frames`, bytes, estimated from those that are written; none before the
    /// first.
    #[must_use]
    pub fn expected_bytes(&self, frames: u32) -> Option<u64> {
        self.bytes.saturating_mul(frames.into()).checked_div(self.frames.into())
    }

    /// The same while it is worth saying: once a few are written, and before all are.
    #[must_use]
    pub fn forecast(&self, frames: u32) -> Option<u64> {
        self.expected_bytes(frames).filter(|_| (FEW..frames).contains(&self.frames))
    }
}

/// A writer that counts the bytes of what it writes; none of them twice that takes the place of another.
struct Counted<'a, W> {
    out: W,
    at: u64,
    bytes: &'a Cell<u64>,
}

impl<W: Write> Write for Counted<'_, W> {
    fn write(&mut self, part: &[u8]) -> io::Result<usize> {
        let written = self.out.write(part)?;
        self.at += written as u64;
        self.bytes.set(self.bytes.get().max(self.at));
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

impl<W: Seek> Seek for Counted<'_, W> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = self.out.seek(to)?;
        Ok(self.at)
    }
}

/// A film that was given up before its end.
#[derive(Debug, Error)]
#[error("the film was stopped")]
pub struct Stopped;

impl FilmKind {
    /// The kinds of animated files.
    const FILES: [Self; 3] = [Self::Gif, Self::Mp4, Self::Png];
    /// The endings of their names, the default first.
    pub const ENDINGS: [&'static str; 3] = ["gif", "mp4", "png"];
    /// The endings, in words.
    pub const NAMED_ENDINGS: &'static str = ".gif, .mp4 or .png";

    /// Returns the kind that `path` names by its ending; a folder if it has none.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        let Some(extension) = path.extension() else { return Some(Self::Folder) };
        let number = Self::ENDINGS.iter().position(|ending| extension.eq_ignore_ascii_case(ending))?;
        Some(Self::FILES[number])
    }

    /// Returns about how many bytes a film of so many `frames` will have, each of this many `pixels`: within
    /// a factor of two for the presets.
    #[must_use]
    pub fn typical_bytes(self, frames: u32, pixels: f64) -> f64 {
        let bytes_per_pixel = match self {
            Self::Gif => 0.13,
            Self::Mp4 => 0.035,
            Self::Png | Self::Folder => 0.2,
        };
        bytes_per_pixel * f64::from(frames) * pixels
    }
}

/// Returns the number of frames of a film in which T runs through `range` once, at `rate` units a second; 2
/// or more.
#[must_use]
pub fn frame_count([from, to]: [f64; 2], rate: f64) -> u32 {
    (f64::from(FRAMES_PER_SECOND) * (to - from) / rate).round().clamp(2.0, f64::from(u32::MAX)) as u32
}

/// Returns T of each of `frames` frames of a loop through `range`: after the last comes the first again.
#[must_use]
pub fn loop_times(range: [f64; 2], frames: u32) -> Vec<f64> {
    (0..frames).map(|frame| time_within(range, f64::from(frame) / f64::from(frames))).collect()
}

/// Returns the path of frame `number` of a sequence in `folder`.
#[must_use]
pub fn frame_path(folder: &Path, number: u32, kind: FileKind) -> PathBuf {
    folder.join(format!("frame_{number:05}.{}", kind.extension()))
}

/// An animated file that is being written.
enum AnimationFile<W: Write + Seek> {
    Gif(gif::GifWriter<W>),
    Mp4(Box<mp4::Mp4Writer<W>>),
    Png(png::PngWriter<W>),
}

impl<W: Write + Seek> AnimationFile<W> {
    /// Begins a film of this `kind` with `frames` frames of this `size`, whose provenance is `record`: a GIF
    /// if it has a `palette`.
    fn new(
        kind: FilmKind,
        palette: Option<gif::Palette>,
        size: [u32; 2],
        frames: usize,
        record: &Provenance,
        out: W,
    ) -> anyhow::Result<Self> {
        if let Some(palette) = palette {
            return Ok(Self::Gif(gif::GifWriter::new(size, 100 / FRAMES_PER_SECOND, palette, out)?));
        }
        let animation = AnimationTiming { frames: u32::try_from(frames)?, seconds: [1, FRAMES_PER_SECOND] };
        if kind == FilmKind::Mp4 {
            return Ok(Self::Mp4(Box::new(mp4::Mp4Writer::new(size, animation, out)?)));
        }
        Ok(Self::Png(png::PngWriter::new(size, Some(animation), None, &record.texts(), out)?))
    }

    /// Adds frames. Returns how many, of these or earlier ones, reached the file meanwhile.
    fn write(&mut self, frames: &[Picture]) -> anyhow::Result<usize> {
        match self {
            Self::Gif(film) => film.write(frames)?,
            Self::Mp4(film) => return film.write(frames),
            Self::Png(film) => frames.iter().try_for_each(|frame| film.write(frame))?,
        }
        Ok(frames.len())
    }

    /// Waits for some frames that did not reach the file yet. Returns their number.
    fn catch_up(&mut self) -> anyhow::Result<usize> {
        if let Self::Mp4(film) = self { film.catch_up() } else { Ok(0) }
    }

    fn finish(self) -> anyhow::Result<()> {
        match self {
            Self::Gif(film) => film.finish(),
            Self::Mp4(film) => film.finish(),
            Self::Png(film) => film.finish(),
        }
    }
}

impl Studio {
    /// Makes the film of the frames at these `times` at `path`, an animated file whole or not at all. Before
    /// each frame, and while the last ones are encoded, `goes_on` is asked with what is written. Returns the
    /// size of all, bytes.
    ///
    /// # Errors
    ///
    /// [`Stopped`] once `goes_on` is false; those of the renderer and of the file system.
    pub fn make_film(
        &mut self,
        times: &[f64],
        kind: FilmKind,
        path: &Path,
        mut goes_on: impl FnMut(Written) -> bool,
    ) -> anyhow::Result<u64> {
        let (frames, bytes) = (Cell::new(0), Cell::new(0));
        let mut ask = |drawn: u32| {
            anyhow::ensure!(goes_on(Written { drawn, frames: frames.get(), bytes: bytes.get() }), Stopped);
            Ok(())
        };
        if kind == FilmKind::Folder {
            files::create_folder(path).with_context(|| files::shown(path))?;
            for (number, &time) in (0..).zip(times) {
                let frame = self.frame(Some(time))?;
                ask(number)?;
                let file = frame_path(path, number, FileKind::Png);
                files::check_replaceable(&file).with_context(|| files::shown(&file))?;
                self.make_file(&frame, FileKind::Png, &file)?;
                bytes.set(bytes.get() + files::size(&file).with_context(|| files::shown(&file))?);
                frames.set(number + 1);
            }
            return Ok(bytes.get());
        }
        let (&first, rest) = times.split_first().context("there is nothing to show")?;
        let palette = if kind == FilmKind::Gif { Some(self.palette(times)?) } else { None };
        write_whole(path, |file| {
            let frame = self.frame(Some(first))?;
            ask(0)?;
            let record = self.provenance(&frame, path);
            let picture = self.shown_in_film(&frame, 0)?;
            let out = Counted { out: file, at: 0, bytes: &bytes };
            let mut film = AnimationFile::new(kind, palette, picture.size, times.len(), &record, out)?;
            let mut drawn = vec![picture];
            for (number, &time) in (1..).zip(rest) {
                // As many at once as there are threads to encode them.
                if drawn.len() >= threads::count() {
                    frames.set(frames.get() + film.write(&drawn)? as u32);
                    drawn.clear();
                }
                let frame = self.frame(Some(time))?;
                ask(number)?;
                drawn.push(self.shown_in_film(&frame, number)?);
            }
            let mut more = film.write(&drawn)?;
            loop {
                frames.set(frames.get() + more as u32);
                ask(times.len() as u32)?;
                // Frames that were drawn faster than they are encoded come now.
                more = film.catch_up()?;
                if more == 0 {
                    return film.finish();
                }
            }
        })?;
        Ok(bytes.get())
    }

    /// The colours of a film of the frames at these `times`, from a few of them, drawn small.
    fn palette(&mut self, times: &[f64]) -> anyhow::Result<gif::Palette> {
        let step = times.len().div_ceil(SAMPLED_FRAMES);
        let samples = (0..).zip(times).step_by(step);
        let small = |(number, &time)| {
            let mut frame = self.frame(Some(time))?;
            let size = &mut frame.settings.picture.size.0;
            *size = size.map(|side| side.div_ceil(SAMPLED_PIXELS));
            self.shown_in_film(&frame, number)
        };
        let samples = samples.map(small).collect::<anyhow::Result<Vec<_>>>()?;
        Ok(gif::Palette::new(&samples))
    }

    /// Draws the frame of this number: where the eyes take turns, the picture of one of them.
    fn shown_in_film(&mut self, frame: &StudioFrame, number: u32) -> anyhow::Result<Picture> {
        let mut still = self.still(frame)?;
        let turn = (number as usize / FRAMES_PER_TURN) % still.frames.len();
        Ok(still.frames.swap_remove(turn))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_does_not_show_its_first_moment_twice() {
        assert_eq!(loop_times([-1.0, 3.0], 4), [-1.0, 0.0, 1.0, 2.0]);
        assert_eq!(frame_count([0.0, 10.0], 2.0), 125);
        assert_eq!(frame_count([0.0, 10.0], 1e6), 2);
    }

    #[test]
    fn the_ending_of_a_name_says_the_kind_of_a_film() {
        for ending in FilmKind::ENDINGS {
            let path = format!("a/ride.{}", ending.to_uppercase());
            assert!(FilmKind::from_path(Path::new(&path)).is_some_and(|kind| kind != FilmKind::Folder));
        }
        assert_eq!(FilmKind::from_path(Path::new("ride.avi")), None);
        assert_eq!(FilmKind::from_path(Path::new("a/ride")), Some(FilmKind::Folder));
    }
}
