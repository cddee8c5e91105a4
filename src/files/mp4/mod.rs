//! Films of H.264 in MP4 files, encoded on all cores while further frames are drawn.

mod boxes;
mod h264;

use std::collections::VecDeque;
use std::io::{Seek, SeekFrom, Write};

use gamow_platform::threads::{self, Ahead, prelude::*};
use relativity_render::Picture;
use rusty_h264_common::YuvFrame;
use rusty_h264_encoder::EncoderConfig;

use self::boxes::Track;
use self::h264::GROUP;
use super::png::AnimationTiming;

/// Bytes of the frames that wait to be encoded, at most, or those of one group if that has more.
const WAITING_BYTES: usize = 1 << 29;

/// A file of frames that is written a few frames at a time. What a player needs before the first frame stands
/// at its beginning.
pub struct Mp4Writer<W: Write + Seek> {
    out: W,
    config: EncoderConfig,
    track: Track,
    /// Number of all the film's frames.
    frames: usize,
    /// Sizes of the frames in the file, bytes.
    sizes: Vec<u32>,
    /// The group that is not whole.
    begun: Vec<YuvFrame>,
    /// Groups that are being encoded, in order.
    ahead: VecDeque<Ahead<anyhow::Result<Vec<Vec<u8>>>>>,
    /// Number of groups that may be encoded at the same time.
    at_once: usize,
}

impl<W: Write + Seek> Mp4Writer<W> {
    /// Begins a file of frames of this `size`, pixels.
    ///
    /// # Errors
    ///
    /// Those of `out`, which must not be a pipe; a picture larger than such a file can hold.
    pub fn new(size: [u32; 2], timing: AnimationTiming, mut out: W) -> anyhow::Result<Self> {
        out.stream_position()?;
        let config = h264::config(size, timing.seconds)?;
        let track = Track {
            size: [config.width, config.height].map(|side| side as u32),
            seconds: timing.seconds.map(u32::from),
            parameters: h264::parameters(&config, timing.seconds),
        };
        let frames = timing.frames as usize;
        out.write_all(&track.header(&vec![0; frames]))?;
        let group_bytes = GROUP * config.width * config.height * 3 / 2;
        let at_once = (WAITING_BYTES / group_bytes).clamp(1, threads::count());
        let (sizes, begun, ahead) = <_>::default();
        Ok(Self { out, config, track, frames, sizes, begun, ahead, at_once })
    }

    /// Adds frames of the file's size. Returns the number of frames, of these or earlier ones, that reached
    /// the file meanwhile.
    ///
    /// # Errors
    ///
    /// Those of the file.
    pub fn write(&mut self, frames: &[Picture]) -> anyhow::Result<usize> {
        let before = self.sizes.len();
        let Self { config, begun, .. } = self;
        begun.par_extend(frames.par_iter().map(|frame| h264::planes(frame, config)));
        while self.begun.len() >= GROUP {
            let rest = self.begun.split_off(GROUP);
            self.encode(rest)?;
        }
        while self.ahead.front().is_some_and(Ahead::is_ready) {
            self.put_first()?;
        }
        Ok(self.sizes.len() - before)
    }

    /// Has the begun group encoded, and begins the next with `rest`.
    fn encode(&mut self, rest: Vec<YuvFrame>) -> anyhow::Result<()> {
        if self.ahead.len() >= self.at_once {
            self.put_first()?;
        }
        let (group, config) = (std::mem::replace(&mut self.begun, rest), self.config.clone());
        self.ahead.push_back(Ahead::new(move || h264::encoded(&group, &config)));
        Ok(())
    }

    /// Waits for the first group that is being encoded, and writes it.
    fn put_first(&mut self) -> anyhow::Result<()> {
        for frame in self.ahead.pop_front().map(Ahead::wait).transpose()?.into_iter().flatten() {
            self.out.write_all(&frame)?;
            self.sizes.push(frame.len().try_into()?);
        }
        Ok(())
    }

    /// Waits, after the last frame, for some of those that did not reach the file yet. Returns their number.
    ///
    /// # Errors
    ///
    /// Those of the file.
    pub fn catch_up(&mut self) -> anyhow::Result<usize> {
        let before = self.sizes.len();
        if !self.begun.is_empty() {
            self.encode(Vec::new())?;
        }
        self.put_first()?;
        Ok(self.sizes.len() - before)
    }

    /// Writes the remaining frames, and the header again with the sizes of all frames.
    ///
    /// # Errors
    ///
    /// Those of the file; fewer or more frames than it was to have.
    pub fn finish(mut self) -> anyhow::Result<()> {
        while self.catch_up()? > 0 {}
        let (written, frames) = (self.sizes.len(), self.frames);
        anyhow::ensure!(written == frames, "a film of {frames} frames was given {written}");
        self.out.seek(SeekFrom::Start(0))?;
        Ok(self.out.write_all(&self.track.header(&self.sizes))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A white square that moves to the right over a grey ramp, of sides that are odd.
    fn frame(number: usize) -> Picture {
        let size = [61, 41];
        let pixel = |at: u32| {
            let [x, y] = [at % size[0], at / size[0]];
            let is_white = (10..20).contains(&y) && (2 * number..2 * number + 10).contains(&(x as usize));
            if is_white { [255; 4] } else { [4 * x as u8, 4 * x as u8, 4 * x as u8, 255] }
        };
        Picture { size, rgba: (0..size[0] * size[1]).map(pixel).collect() }
    }

    fn film(frames: &[Picture], at_once: usize) -> Vec<u8> {
        let mut file = std::io::Cursor::new(Vec::new());
        let timing = AnimationTiming { frames: frames.len() as u32, seconds: [1, 25] };
        let mut film = Mp4Writer::new(frames[0].size, timing, &mut file).expect("it begins");
        for frames in frames.chunks(at_once) {
            film.write(frames).expect("it is written");
        }
        film.finish().expect("it ends");
        file.into_inner()
    }

    #[test]
    fn a_file_is_the_same_however_many_frames_are_written_at_once() {
        let frames: Vec<_> = (0..2 * GROUP + 3).map(frame).collect();
        let bytes = film(&frames, 1);
        assert!(bytes == film(&frames, 7) && bytes == film(&frames, frames.len()));
    }

    #[test]
    fn pictures_of_any_small_size_are_encoded() {
        for [width, height] in [[1, 1], [2, 1], [15, 17], [16, 16], [33, 5], [130, 2]] {
            let noise = |at: u32| [7, 11, 13].map(|factor| (at * at * factor % 251) as u8);
            let pixel = |at| {
                let [red, green, blue] = noise(at);
                [red, green, blue, 255]
            };
            let picture = |number: u32| Picture {
                size: [width, height],
                rgba: (0..width * height).map(|at| pixel(at + 31 * number)).collect(),
            };
            let frames: Vec<_> = (0..=GROUP as u32).map(picture).collect();
            assert!(!film(&frames, 5).is_empty());
        }
    }

    #[test]
    fn a_film_has_as_many_frames_as_were_announced() {
        let timing = AnimationTiming { frames: 3, seconds: [1, 25] };
        let mut film = Mp4Writer::new([61, 41], timing, std::io::Cursor::new(Vec::new())).expect("it begins");
        film.write(&[frame(0), frame(1)]).expect("they are written");
        assert_eq!(film.finish().expect_err("one is missing").to_string(), "a film of 3 frames was given 2");
    }
}
