//! The file in which the windowing library keeps what is remembered. It believes what it finds there, so that it is
//! looked through before: what cannot be is named and as usual again, and the old file is kept aside.

use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::memory;
use super::notice::Notice;
use super::toolkit;
use crate::files::whole::write_whole;
use crate::platform::files;
use crate::platform::sizes::TEXT_BYTES;

/// Its name, in the folder that the library has for it.
pub const FILE: &str = "app.ron";
/// How many files are kept aside; then the last makes room.
const MOST_ASIDE: u32 = 9;
/// How many problems are told one by one.
const MOST_TOLD: usize = 5;
/// Where the library keeps the window's place and size.
const WINDOW: &str = "window";

/// All that is remembered, each under its key.
pub type Kept = BTreeMap<String, String>;

/// The file as it can be used.
#[derive(Debug, Default)]
pub struct Looked {
    /// What had to be put right.
    pub notice: Option<Notice>,
    /// The file in whose place what is remembered is kept, where that one is and stays unusable.
    pub instead: Option<PathBuf>,
}

/// Has what is remembered in the file at `path` be such that the windowing library can use it.
pub fn look_through(path: &Path) -> Looked {
    let (mended, problems) = match read(path) {
        Ok(None) => return Looked::default(),
        Ok(Some(kept)) => {
            let (mended, problems) = mended(kept.clone());
            if mended == kept {
                return Looked::default();
            }
            (mended, problems)
        }
        Err(reason) => (Kept::new(), vec![reason]),
    };
    if problems.is_empty() {
        // Nothing that anybody would miss.
        return Looked { notice: None, instead: write(path, &mended).err().map(|_| unused(path)) };
    }
    let aside = aside(path);
    let put_right = files::rename(path, &aside).map_err(anyhow::Error::from);
    let put_right = put_right.and_then(|()| if mended.is_empty() { Ok(()) } else { write(path, &mended) });
    let (where_it_is, instead) = match put_right {
        Ok(()) => (format!("The old file is kept as {}.", files::shown(&aside)), None),
        Err(error) => {
            let text = format!("{} could not be replaced: {error:#}.", files::shown(path));
            (text, Some(unused(path)))
        }
    };
    let text = format!(
        "Of what was remembered this cannot be, and is as usual again: {}. {where_it_is}",
        told(&problems)
    );
    Looked { notice: Some(Notice::error(text)), instead }
}

/// The first few problems, and how many more there are.
fn told(problems: &[String]) -> String {
    let told = problems.iter().take(MOST_TOLD).cloned().collect::<Vec<_>>().join("; ");
    match problems.len().saturating_sub(MOST_TOLD) {
        0 => told,
        more => format!("{told}; and {more} more"),
    }
}

/// What is in the file at `path`, if there is one.
pub fn read(path: &Path) -> Result<Option<Kept>, String> {
    if files::is_special(path) {
        return Err("it is no file".to_owned());
    }
    match files::size(path) {
        Ok(bytes) if bytes > TEXT_BYTES => {
            return Err(format!("the file has {bytes} bytes, more than {TEXT_BYTES}"));
        }
        Ok(_) => {}
        Err(_) => return Ok(None),
    }
    let text = files::read_to_string(path).map_err(|error| format!("the file cannot be read ({error})"))?;
    ron::from_str(&text).map(Some).map_err(|error| format!("the file cannot be read ({error})"))
}

/// Writes `kept` as the windowing library does.
pub fn write(path: &Path, kept: &Kept) -> anyhow::Result<()> {
    let text = ron::ser::to_string_pretty(kept, ron::ser::PrettyConfig::default())?;
    write_whole(path, |file| Ok(file.write_all(text.as_bytes())?))
}

/// What of `kept` can be used; and what cannot, a line each.
fn mended(mut kept: Kept) -> (Kept, Vec<String>) {
    let mut problems = Vec::new();
    if let Some(text) = kept.get_mut(toolkit::KEY) {
        let (used, problem) = toolkit::kept(text);
        *text = used;
        problems.extend(problem);
    }
    if let Some(problem) = kept.get(WINDOW).and_then(|text| window_problem(text)) {
        kept.remove(WINDOW);
        problems.push(problem);
    }
    problems.extend(memory::mend(&mut kept));
    (kept, problems)
}

/// A window's place and size, as the library keeps them.
#[derive(Deserialize)]
struct Window {
    normal_geometry: Geometry,
    #[serde(rename = "fullscreen")]
    _is_full: bool,
    #[serde(rename = "maximized")]
    _is_maximised: bool,
}

#[derive(Deserialize)]
struct Geometry {
    outer_position_pixels: Option<Pair>,
    scale_factor: f64,
    inner_size_points: Pair,
}

#[derive(Deserialize)]
struct Pair {
    x: f64,
    y: f64,
}

/// Furthest that a window can lie on any screen, and largest, pixels: X11 has 16 bits for it.
const FURTHEST: f64 = 32_767.0;

/// What cannot be in a window's place and size.
fn window_problem(text: &str) -> Option<String> {
    let geometry = match ron::from_str::<Window>(text) {
        Ok(window) => window.normal_geometry,
        Err(error) => return Some(format!("the window's place and size cannot be read ({error})")),
    };
    if let Some(Pair { x, y }) = geometry.outer_position_pixels
        && !(x.abs() <= FURTHEST && y.abs() <= FURTHEST)
    {
        return Some(format!("the window's place, {x}, {y}: must be within {FURTHEST} pixels"));
    }
    let Pair { x, y } = geometry.inner_size_points;
    let sizes = 1.0..=FURTHEST;
    if !(sizes.contains(&x) && sizes.contains(&y)) {
        return Some(format!("the window's size, {x} x {y}: must be between 1 and {FURTHEST} points"));
    }
    let scale = geometry.scale_factor;
    let is_right = (0.1..=20.0).contains(&scale);
    (!is_right).then(|| format!("the scale of the window's screen, {scale}: must be between 0.1 and 20"))
}

/// The name under which the file at `path` is kept aside: one that is free.
fn aside(path: &Path) -> PathBuf {
    let named = |number: u32| path.with_extension(format!("ron.old{number}"));
    (1..MOST_ASIDE).map(named).find(|path| !files::is_there(path)).unwrap_or_else(|| named(MOST_ASIDE))
}

/// A file beside that at `path` from which nothing is read.
fn unused(path: &Path) -> PathBuf {
    let unused = path.with_extension("unused.ron");
    // What is left of the last time is no more to be believed.
    let _ = files::remove(&unused);
    unused
}

#[cfg(test)]
mod tests;
