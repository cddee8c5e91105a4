//! The system's fonts, for characters that the program's own lack.
//!
//! The toolkit asks for a font where it meets such a character. Files of well-known names come first, those
//! of the regular style before others. What is in a file is found out once, in blocks of 256 characters, so
//! that a character that no font has costs one reading of the folders.
//!
//! The toolkit joins and stacks the letters of a word, and sets words of all scripts from left to right.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};

use eframe::egui::{
    FallbackRequest, FontData, FontFamily, FontInsert, FontPriority, FontProvider, InsertFontFamily,
};
use gamow_platform::{environment, files};
use skrifa::{FontRef, MetadataProvider as _};

/// Names of files, in lower case and without blanks, that begin like these are tried first.
const KNOWN: [&str; 22] = [
    "notosanscjk",
    "notosans-",
    "notosans",
    "sourcehansans",
    "pingfang",
    "hiragino",
    "applesdgothic",
    "arialunicode",
    "msyh",
    "yugoth",
    "malgun",
    "nirmala",
    "leelaw",
    "segoeui.",
    "tahoma.",
    "wqy",
    "droidsansfallback",
    "dejavusans.",
    "lohit",
    "freesans.",
    "thonburi",
    "unifont",
];
/// Parts of the names of other styles, which are tried last.
const STYLES: [&str; 8] = ["bold", "italic", "oblique", "light", "thin", "black", "condensed", "mono"];
/// Greatest number of characters that a sentence names.
const MOST_NAMED: usize = 8;
/// Bytes of the longest font that is read, and the number of folders below each other that are looked
/// through.
const MOST_BYTES: u64 = 64 << 20;
const DEEPEST: usize = 5;

/// Fonts in folders, and the characters that none of them has.
pub struct SystemFonts {
    folders: Vec<PathBuf>,
    files: OnceLock<Vec<FontFile>>,
    /// Characters that no font has, and whether there are new ones among them.
    missing: Mutex<(BTreeSet<char>, bool)>,
}

/// A file in a folder of fonts, which may turn out to be none.
struct FontFile {
    path: PathBuf,
    /// Blocks of 256 characters of which it has some; none of what is no font.
    blocks: OnceLock<BTreeSet<u32>>,
}

impl Default for SystemFonts {
    fn default() -> Self {
        Self::in_folders(folders())
    }
}

impl SystemFonts {
    fn in_folders(folders: Vec<PathBuf>) -> Self {
        Self { folders, files: OnceLock::new(), missing: Mutex::default() }
    }

    /// Returns a sentence on the characters that no font has, if more are known than when this was last
    /// asked.
    pub fn newly_missing(&self) -> Option<String> {
        let mut known = self.missing.lock().unwrap_or_else(PoisonError::into_inner);
        let (missing, is_new) = &mut *known;
        if !std::mem::take(is_new) {
            return None;
        }
        let code = |&wanted: &char| format!("U+{:04X}", u32::from(wanted));
        let codes: Vec<String> = missing.iter().take(MOST_NAMED).map(code).collect();
        let more = missing.len().saturating_sub(MOST_NAMED);
        let more = if more > 0 { format!(", and {more} more") } else { String::new() };
        Some(format!(
            "No font here has the characters {}{more}. Install one that does, such as Noto Sans, and start again.",
            codes.join(", ")
        ))
    }

    fn files(&self) -> &[FontFile] {
        self.files.get_or_init(|| {
            let mut paths = Vec::new();
            self.folders.iter().for_each(|folder| look_through(folder, DEEPEST, &mut paths));
            paths.sort_by_cached_key(|path| (rank(path), path.clone()));
            paths.into_iter().map(|path| FontFile { path, blocks: OnceLock::new() }).collect()
        })
    }
}

impl FontProvider for SystemFonts {
    fn font_for(&self, request: &FallbackRequest<'_>) -> Option<FontInsert> {
        let wanted = request.cluster.chars().next()?;
        let found = self.files().iter().find_map(|file| file.font_with(wanted));
        if found.is_none() {
            let mut missing = self.missing.lock().unwrap_or_else(PoisonError::into_inner);
            missing.1 |= missing.0.insert(wanted);
        }
        found
    }
}

impl FontFile {
    /// The font for the toolkit, if it has this character.
    fn font_with(&self, wanted: char) -> Option<FontInsert> {
        let block = u32::from(wanted) / BLOCK;
        if self.blocks.get().is_some_and(|blocks| !blocks.contains(&block)) {
            return None;
        }
        let bytes = files::read(&self.path, MOST_BYTES).ok()?;
        let has_it = FontRef::from_index(&bytes, 0).is_ok_and(|font| {
            let characters = font.charmap();
            self.blocks.get_or_init(|| characters.mappings().map(|(code, _)| code / BLOCK).collect());
            characters.map(wanted).is_some()
        });
        self.blocks.get_or_init(BTreeSet::new);
        let families = [FontFamily::Proportional, FontFamily::Monospace]
            .map(|family| InsertFontFamily { family, priority: FontPriority::Lowest });
        has_it.then(|| {
            FontInsert::new(&files::shown(&self.path), FontData::from_owned(bytes), families.to_vec())
        })
    }
}

/// Number of characters in a block.
const BLOCK: u32 = 256;

/// The folders that hold the fonts of this system and of its user.
fn folders() -> Vec<PathBuf> {
    let of_user = environment::data_folder("fonts");
    if cfg!(windows) {
        return environment::variable("WINDIR")
            .map(|windows| Path::new(&windows).join("Fonts"))
            .into_iter()
            .collect();
    }
    let shared: &[&str] = if cfg!(target_os = "macos") {
        &["/System/Library/Fonts", "/Library/Fonts"]
    } else {
        &["/usr/share/fonts", "/usr/local/share/fonts"]
    };
    of_user.into_iter().chain(shared.iter().map(PathBuf::from)).collect()
}

/// Adds the files of fonts in `folder`, and in those inside it, to `found`.
fn look_through(folder: &Path, deepest: usize, found: &mut Vec<PathBuf>) {
    for path in files::list_folder(folder).unwrap_or_default() {
        let ending = path.extension().map(OsStr::to_ascii_lowercase);
        if ending.is_some_and(|ending| ["ttf", "otf", "ttc", "otc"].iter().any(|known| ending == *known)) {
            found.push(path);
        } else if deepest > 0 {
            look_through(&path, deepest - 1, found);
        }
    }
}

/// The place in the order of trying: other styles last, and of each well-known names first.
fn rank(path: &Path) -> (bool, usize) {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase().replace(' ', "");
    let known = KNOWN.iter().position(|known| name.starts_with(known));
    (STYLES.iter().any(|style| name.contains(style)), known.unwrap_or(KNOWN.len()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::FontFace;

    #[test]
    fn a_font_is_found_by_its_characters_and_what_none_has_is_told_once() {
        let folder = tempfile::tempdir().expect("a folder");
        let inside = folder.path().join("truetype").join("katex");
        std::fs::create_dir_all(&inside).expect("made");
        std::fs::write(inside.join("KaTeX_AMS-Regular.ttf"), FontFace::Ams.file()).expect("written");
        std::fs::write(inside.join("Broken.ttf"), b"no font").expect("written");
        let system = SystemFonts::in_folders(vec![folder.path().to_owned(), folder.path().join("none")]);
        let found = |cluster: &str| {
            let family = &FontFamily::Proportional;
            system.font_for(&FallbackRequest { cluster, family }).map(|font| font.name)
        };
        assert!(found("ℏ").is_some_and(|name| name.ends_with("KaTeX_AMS-Regular.ttf")));
        assert_eq!(system.newly_missing(), None);
        assert_eq!(found("語"), None);
        assert_eq!(found("語"), None);
        let told = system.newly_missing().expect("it is new");
        assert!(told.starts_with("No font here has the characters U+8A9E. Install"), "{told}");
        assert_eq!(system.newly_missing(), None);
    }

    #[test]
    fn well_known_fonts_of_the_regular_style_come_first() {
        let mut names = [
            "Zapf.ttf",
            "NotoSans-Bold.ttf",
            "DejaVuSans.ttf",
            "NotoSansCJK-Regular.ttc",
            "Arial Unicode.ttf",
        ];
        names.sort_by_key(|name| rank(Path::new(name)));
        assert_eq!(
            names,
            [
                "NotoSansCJK-Regular.ttc",
                "Arial Unicode.ttf",
                "DejaVuSans.ttf",
                "Zapf.ttf",
                "NotoSans-Bold.ttf"
            ]
        );
    }
}
