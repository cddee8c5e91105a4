//! Animated pictures in GIF files.
//!
//! `CompuServe`, *Graphics Interchange Format, Version 89a* (1990).

use std::io::Write;

use anyhow::Context as _;
use gif::{Encoder, Frame, Repeat};
use relativity_render::Picture;

use super::png::rgb;

/// Care with which the 256 colours of a frame are chosen, from 1 (best) to 30 (fastest).
const SPEED: i32 = 10;

/// A file of frames that follow each other without an end, written frame by frame.
pub struct GifWriter<W: Write> {
    encoder: Encoder<W>,
    size: [u16; 2],
    hundredths: u16,
}

impl<W: Write> GifWriter<W> {
    /// Begins a file of frames of this `size`, pixels, each of which is shown for this number of `hundredths`
    /// of a second.
    ///
    /// # Errors
    ///
    /// Those of `out`; a picture larger than such a file can hold.
    pub fn new(size: [u32; 2], hundredths: u16, out: W) -> anyhow::Result<Self> {
        let side = |side| u16::try_from(side).context("a GIF has no more than 65535 pixels a side");
        let [width, height] = size;
        let size = [side(width)?, side(height)?];
        let mut encoder = Encoder::new(out, size[0], size[1], &[])?;
        encoder.set_repeat(Repeat::Infinite)?;
        Ok(Self { encoder, size, hundredths })
    }

    /// Adds a frame of the file's size, in the 256 colours that suit it best.
    ///
    /// # Errors
    ///
    /// Those of the file.
    pub fn write(&mut self, frame: &Picture) -> anyhow::Result<()> {
        let [width, height] = self.size;
        let mut frame = Frame::from_rgb_speed(width, height, &rgb(frame), SPEED);
        frame.delay = self.hundredths;
        Ok(self.encoder.write_frame(&frame)?)
    }

    /// Finishes the file.
    ///
    /// # Errors
    ///
    /// Those of the file.
    pub fn finish(self) -> anyhow::Result<()> {
        self.encoder.into_inner()?;
        Ok(())
    }
}
