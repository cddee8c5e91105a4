//! `gamow render`: pictures, sequences and measurements of a scene, without a window.

mod gpu_painter;
mod layout;
mod look;
mod painter;
mod sequence;
mod shot;
mod timings;

use std::path::{Path, PathBuf};

use clap::Args;
use relativity_render::{Appearance, Geometry, HitImage, Picture};

use self::look::LookArgs;
use self::painter::{Painter, RendererArgs};
use self::sequence::TimeArgs;
use self::shot::{Observer, ObserverArgs};
use self::timings::Timings;
use crate::files::exr::{Light, Measurements};
use crate::files::png;
use crate::files::provenance::Provenance;
use crate::files::whole::write_whole;
use crate::flags::choices::{FileKind, Layout, word};
use crate::scene::{PRESETS, Scene};

/// Draws what both eyes see, without a window, a display or a GPU.
///
/// Without flags: the stereo frame of the paper's cyclist at beta = 0.9, d = 0.1, as the visible strip runs
/// across it. A `.png` file is a picture, an `.exr` file holds what every pixel shows (object, distance,
/// time of emission, Doppler factor, ...), and with --frames a folder takes a sequence.
#[derive(Debug, Args)]
#[command(after_long_help = EXAMPLES)]
pub struct RenderArgs {
    /// What rides past: a preset (cyclist, street, two-balls, lattice) or a scene file.
    #[arg(long, default_value = PRESETS[0], value_name = "PRESET|FILE")]
    scene: String,
    #[command(flatten)]
    observer: ObserverArgs,
    #[command(flatten)]
    times: TimeArgs,
    /// How the pictures of the two eyes share a file. Those of an .exr file are layers of their own.
    #[arg(long, value_enum, default_value = "side-by-side")]
    layout: Layout,
    #[command(flatten)]
    look: LookArgs,
    #[command(flatten)]
    renderer: RendererArgs,
    /// Where to: FILE.png, FILE.exr, or a folder with --frames. Each file is written whole or not at all.
    #[arg(long, default_value = "gamow.png", value_name = "FILE|DIR")]
    out: PathBuf,
    /// Print how long each stage took.
    #[arg(long, conflicts_with = "frames")]
    timings: bool,
    /// Do all that --timings measures N times.
    #[arg(long, default_value_t = 5, value_name = "N", requires = "timings", value_parser = clap::value_parser!(u32).range(1..))]
    repeat: u32,
}

const EXAMPLES: &str = "\
Examples:
  gamow render --out cyclist.png
  gamow render --beta 0.6 --gaze 90,0 --fov 100 --layout anaglyph --out anaglyph.png
  gamow render --gamma 100 --time 0 --colour false --out false-colour.png
  gamow render --frames 200 --size 640x480 --out ride
  gamow render --renderer reference --out hits.exr
  gamow render --geometry published --time 1.5 --layout overlay --out published.png
  gamow render --renderer mesh --bound-px 0.1 --timings --repeat 20";

/// Names of the stages that draw the left and the right eye.
const EYES: [&str; 2] = ["left eye", "right eye"];

/// A scene, its observer and a renderer: everything that makes a picture but the observation time.
struct Studio {
    scene: Scene,
    scene_name: String,
    observer: Observer,
    appearance: Appearance,
    look: LookArgs,
    layout: Layout,
    painter: Painter,
    timings: Timings,
}

/// Runs `gamow render`.
pub fn run(args: &RenderArgs) -> anyhow::Result<()> {
    let Some(kind) = args.file_kind()? else {
        return sequence::run(&mut Studio::new(args)?, &args.times, &args.out);
    };
    let mut studio = Studio::new(args)?;
    let time = args.times.time.map_or_else(|| studio.observer.time_of_approach(), Ok)?;
    for _ in 0..if args.timings { args.repeat } else { 1 } {
        studio.make_file(time, kind, &args.out)?;
    }
    if args.timings {
        let [width, height] = studio.observer.size();
        println!("{}; {width}x{height} per eye", studio.painter.description());
        println!("{}", studio.timings);
    }
    Ok(())
}

impl RenderArgs {
    /// The kind of file to make, `None` for a sequence.
    fn file_kind(&self) -> anyhow::Result<Option<FileKind>> {
        let out = self.out.display();
        match (FileKind::of(&self.out), self.times.frames) {
            (Some(_), Some(_)) => anyhow::bail!("--out {out}: a sequence needs a folder, not a file"),
            (None, None) => {
                anyhow::bail!("--out {out}: a file must end in .png or .exr; a folder needs --frames")
            }
            (kind, _) => Ok(kind),
        }
    }
}

impl Studio {
    fn new(args: &RenderArgs) -> anyhow::Result<Self> {
        let scene = Scene::open(&args.scene)?;
        let observer = Observer::new(&args.observer, scene.tracked)?;
        let published = observer.geometry() == Geometry::Published;
        let mut timings = Timings::default();
        let painter = timings.timed("set up", || args.renderer.painter(&scene.bodies, published))?;
        Ok(Self {
            appearance: args.look.appearance(scene.ground_z),
            scene,
            scene_name: args.scene.clone(),
            observer,
            look: args.look.clone(),
            layout: args.layout,
            painter,
            timings,
        })
    }

    fn make_file(&mut self, time: f64, kind: FileKind, path: &Path) -> anyhow::Result<()> {
        let provenance = self.provenance(time)?;
        match kind {
            FileKind::Png => {
                let picture = self.picture(time)?;
                self.timings.timed("file", || {
                    write_whole(path, |file| png::write(&picture, &provenance.texts(), file))
                })
            }
            FileKind::Exr => {
                let hits = self.hits(time)?;
                let light = Light {
                    bodies: &self.scene.bodies,
                    intensity_exponent: self.appearance.intensity_exponent,
                };
                self.timings.timed("file", || {
                    let measurements = Measurements::of_eyes(&hits, light, &provenance.comments());
                    write_whole(path, |file| measurements.write(file))
                })
            }
        }
    }

    /// The picture at observation time `time`.
    fn picture(&mut self, time: f64) -> anyhow::Result<Picture> {
        let Self { observer, appearance, layout, painter, timings, .. } = self;
        let views = observer.views(time)?;
        let eye = |&eye: &usize| timings.timed(EYES[eye], || painter.picture(&views[eye], appearance));
        let eyes = layout.eyes().iter().map(eye).collect::<Result<_, _>>()?;
        Ok(timings.timed("layout", || layout.composed(eyes)))
    }

    /// What every pixel of the left and the right eye shows at observation time `time`.
    fn hits(&mut self, time: f64) -> anyhow::Result<[HitImage; 2]> {
        let Self { observer, painter, timings, .. } = self;
        let [left, right] = observer.views(time)?;
        Ok([
            timings.timed(EYES[0], || painter.hits(&left))?,
            timings.timed(EYES[1], || painter.hits(&right))?,
        ])
    }

    /// What makes the picture at observation time `time` again.
    fn provenance(&self, time: f64) -> anyhow::Result<Provenance> {
        let mut flags = vec![("scene", self.scene_name.clone())];
        flags.extend(self.observer.flags(time)?);
        flags.push(("layout", word(&self.layout)));
        flags.extend(self.look.flags());
        flags.extend(self.painter.flags());
        let flags: Vec<_> = flags.iter().map(|(flag, value)| format!("--{flag}={}", quoted(value))).collect();
        Ok(Provenance {
            title: self.scene.name.clone(),
            parameters: format!("gamow render {}", flags.join(" ")),
            scene_fingerprint: self.scene.fingerprint(),
        })
    }
}

/// `value` as one word for a POSIX shell.
fn quoted(value: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-+_.,/:".contains(c);
    if value.chars().all(plain) { value.to_owned() } else { format!("'{}'", value.replace('\'', r"'\''")) }
}
