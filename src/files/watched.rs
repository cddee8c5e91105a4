//! Writers that remember how they failed, so that a failure is named once, whatever a library on the way made
//! of it.

use std::io::{self, BufWriter, Seek, SeekFrom, Write};

use anyhow::Context as _;

const BUFFER_BYTES: usize = 1 << 16;

/// A writer with a buffer, whose failure [`write_named`] reports.
pub type Named<W> = BufWriter<Watched<W>>;

/// A writer that keeps its first failure.
#[derive(Debug)]
pub struct Watched<W> {
    to: W,
    failure: Option<io::Error>,
}

impl<W> Watched<W> {
    #[cfg(test)]
    pub(super) const fn to(&self) -> &W {
        &self.to
    }

    fn kept<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        if let Err(error) = &result
            && self.failure.is_none()
            && error.kind() != io::ErrorKind::Interrupted
        {
            self.failure =
                Some(error.raw_os_error().map_or_else(|| error.kind().into(), io::Error::from_raw_os_error));
        }
        result
    }
}

impl<W: Write> Write for Watched<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.to.write(bytes);
        self.kept(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        let flushed = self.to.flush();
        self.kept(flushed)
    }
}

impl<W: Seek> Seek for Watched<W> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let place = self.to.seek(to);
        self.kept(place)
    }
}

/// Hands a writer into `to`, which is called `name`, to `write`, and gives `to` back once all has reached it.
///
/// # Errors
///
/// Those of `to`, with its name; else those of `write`, after what it wrote before.
pub fn write_named<W: Write>(
    to: W,
    name: impl Fn() -> String,
    write: impl FnOnce(&mut Named<W>) -> anyhow::Result<()>,
) -> anyhow::Result<W> {
    let mut out = BufWriter::with_capacity(BUFFER_BYTES, Watched { to, failure: None });
    let written = write(&mut out);
    let flushed = out.flush();
    let (Watched { to, failure }, _) = out.into_parts();
    failure.map_or(flushed, Err).with_context(name)?;
    written.map(|()| to)
}
