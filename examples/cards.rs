//! Makes the pictures of the start page's cards, a JPEG for each lesson and preset; `convert` compresses
//! them.
//!
//! ```text
//! cargo run --release --example cards -- assets/cards [NAME...]
//! ```
//!
//! Without names all are made. They are compiled into the program: for a new lesson or preset an empty file
//! has to be there before.

use std::env;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::Context as _;
use gamow::files::png;
use gamow::flags::choices::RendererChoice;
use gamow::lesson::{Library, card};

/// Rays per pixel and direction.
const SAMPLES: u32 = 3;
/// Quality of the compression, of 100.
const QUALITY: &str = "82";

fn main() -> anyhow::Result<()> {
    let mut words = env::args().skip(1);
    let folder = words.next().context("which folder is it to be? cards FOLDER [NAME...]")?;
    let names: Vec<_> = words.collect();
    for lesson in
        Library::own().all().iter().filter(|lesson| names.is_empty() || names.contains(&lesson.name))
    {
        let mut bytes = Vec::new();
        png::write(&card::drawn(lesson, RendererChoice::Reference, SAMPLES)?, &[], &mut bytes)?;
        let file = Path::new(&folder).join(format!("{}.jpg", lesson.name));
        let mut converter = Command::new("convert")
            .args(["png:-", "-strip", "-sampling-factor", "4:4:4", "-quality", QUALITY])
            .arg(format!("jpg:{}", file.display()))
            .stdin(Stdio::piped())
            .spawn()
            .context("ImageMagick's `convert` does not start")?;
        converter.stdin.take().context("it is piped")?.write_all(&bytes)?;
        anyhow::ensure!(converter.wait()?.success(), "{} cannot be written", file.display());
    }
    Ok(())
}
