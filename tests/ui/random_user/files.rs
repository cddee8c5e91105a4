//! Files that the user opens and drops: good ones, ones of the wrong kind, and good ones with something
//! broken in them. All are in a folder of their own, and so is all that is saved.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use eframe::egui::DroppedFile;
use tempfile::TempDir;

use super::dice::Dice;

/// The texts typed where something else is expected. Infinity and NaN are spelt as the program never prints
/// them, so that the checks tell what was typed from a broken number.
pub const ODD_TEXTS: &[&str] = &[
    "",
    "-",
    "1e309",
    "-1e309",
    "nan",
    "INF",
    "0,5",
    "0.5",
    "1",
    "-1",
    "2",
    "7",
    "1e-300",
    "1e300",
    "0",
    "-0",
    "  ",
    "1 000",
    "٣",
    "½",
    "π",
    "😀👩‍👩‍👧",
    "a\u{0}b",
    "\u{1b}[31m",
    "\u{202e}abc",
    "0x10",
    "1e",
    "..",
    "%s%n",
    "9007199254740993",
    "3d",
    "360",
    "0.999999999999999999999",
    "100,200",
    "1,2,3",
    "fov",
    "save",
    "α β γ",
];

/// The folder with the files.
pub struct Files {
    folder: TempDir,
    all: Vec<PathBuf>,
}

/// A file that is let go over the window.
#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

const DATA: &str = "T,d,dphi,dtheta\n-3,0.1,0.0061,0.0021\n-2,0.1,0.0074,0.0019\n-1,0.1,0.0089,0.0013\n0,0.1,0.0101,0.0004\n\
                    1,0.1,0.0098,-0.0006\n2,0.1,0.0087,-0.0013\n3,0.1,0.0075,-0.0018\n";
const LESSON: &str = "---\ntitle: Tried\n---\n\nAbout.\n\n## One\n\n```state\nscene = \"rods\"\n[motion]\nbeta = 0.6\n```\n\nSee $\\gamma = \
     {gamma:.2}$.\n\n### Predict\n\nHow large?\n\n```number\ntruth = \"gamma\"\nunit = \"times\"\n```\n\n### Reveal\n\n```play\ntime = 2\n\
     seconds = 0.2\n```\n\n### Explain\n\nSo.\n\n## Two\n\n### Predict\n\n```curve\nof = \"doppler\"\nfrom = 0\nto = 3\n```\n\n### Reveal\n\n\
     Look.\n\n### Observe\n\nWhat?\n\n- [x] this\n- [ ] that\n\n## In a sentence\n\nThat.\n";

impl Files {
    pub fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
        let mut files = Self { folder, all: Vec::new() };
        for (kind, ending) in [("scenes", "toml"), ("presets", "toml"), ("lessons", "md")] {
            let mut sources: Vec<_> = std::fs::read_dir(root.join(kind)).expect("assets").flatten().collect();
            sources.sort_by_key(std::fs::DirEntry::file_name);
            for source in
                sources.iter().filter(|source| source.path().extension().is_some_and(|end| end == ending))
            {
                let name = format!("{kind}-{}", source.file_name().to_string_lossy());
                files.write(&name, &std::fs::read(source.path()).expect("an asset"));
            }
        }
        files.write("data.csv", DATA.as_bytes());
        files.write("tried.md", LESSON.as_bytes());
        files.write("empty.toml", b"");
        files.write("no text.md", &[0xff, 0xfe, 0, 1, 2]);
        files.write("odd\u{202e} name 名前.csv", DATA.as_bytes());
        files.write("picture.png", &picture());
        files.write("none.exr", b"\x76\x2f\x31\x01\x02\0\0\0nothing");
        files.write("other.xyz", b"what?");
        std::fs::create_dir(files.folder.path().join("folder.md")).expect("a folder");
        files.all.push(files.folder.path().join("folder.md"));
        files.all.push(files.folder.path().join("is not there.toml"));
        files
    }

    fn write(&mut self, name: &str, bytes: &[u8]) {
        let path = self.folder.path().join(name);
        std::fs::write(&path, bytes).expect("it can be written");
        self.all.push(path);
    }

    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// One of them; every third time a copy of it with something broken in it.
    pub fn any(&self, dice: &mut Dice) -> PathBuf {
        let path = dice.one_of(&self.all).clone();
        match std::fs::read(&path) {
            Ok(bytes) if dice.happens(33) => {
                let number = dice.below(40);
                let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
                let broken = self.folder.path().join(format!("broken {number}.{ending}"));
                // Undoing may lead back to a file that was opened: it stays as it is.
                if !broken.exists() {
                    std::fs::write(&broken, mutated(bytes, dice)).expect("it can be written");
                }
                broken
            }
            _ => path,
        }
    }

    /// Where something can be saved.
    pub fn to_write(&self, dice: &mut Dice) -> PathBuf {
        let names = [
            "a.png",
            "a.toml",
            "a.svg",
            "a.csv",
            "a.gif",
            "a.mp4",
            "a.json",
            "a.html",
            "film",
            "b",
            "no folder/a.png",
            "folder.md",
        ];
        self.folder.path().join("saved").with_file_name(format!("saved {}", dice.one_of(&names)))
    }

    pub fn dropped(path: PathBuf) -> eframe::egui::DroppedFileHandle {
        Arc::new(Dropped(path))
    }
}

/// A picture with settings in it.
fn picture() -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.png");
    let program = std::process::Command::new(env!("CARGO_BIN_EXE_gamow"))
        .args(["render", "--scene", "globe", "--size", "16x12", "--renderer", "rays", "--out"])
        .arg(&path)
        .output()
        .expect("the program runs");
    assert!(program.status.success(), "{}", String::from_utf8_lossy(&program.stderr));
    std::fs::read(&path).expect("a picture")
}

/// `bytes` with a few of them changed, removed, repeated or replaced by what may be troublesome.
fn mutated(mut bytes: Vec<u8>, dice: &mut Dice) -> Vec<u8> {
    for _ in 0..=dice.below(3) {
        let place = dice.below(bytes.len() + 1);
        match dice.below(4) {
            0 => bytes.truncate(place),
            1 => {
                let end = (place + dice.below(20)).min(bytes.len());
                bytes.drain(place..end);
            }
            2 => {
                let text = dice.one_of(ODD_TEXTS).as_bytes().to_vec();
                bytes.splice(place..place, text);
            }
            _ => {
                // A number becomes another.
                let digits = (0..bytes.len()).map(|after| (place + after) % bytes.len());
                if let Some(place) = digits.into_iter().find(|place| bytes[*place].is_ascii_digit()) {
                    let text = dice.one_of(ODD_TEXTS).as_bytes().to_vec();
                    bytes.splice(place..=place, text);
                }
            }
        }
    }
    bytes
}
