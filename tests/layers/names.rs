//! Comments: doc comments name what exists, so that a word that a renaming left behind is found; and comments
//! break at the width of code.

use std::collections::{BTreeMap, HashSet};
use std::path::Path;

use super::read_folder;

/// Returns the folders of all crates, from the root.
fn crates() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates");
    let entries = std::fs::read_dir(folder).expect("it can be listed");
    let name = |entry: std::fs::DirEntry| format!("crates/{}", entry.file_name().to_string_lossy());
    let others = entries.map(|entry| name(entry.expect("it can be listed")));
    [".".to_owned()].into_iter().chain(others).collect()
}

fn is_in_word(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

/// Returns every word of `source` outside of lines that are comments.
fn code_words(source: &str) -> HashSet<&str> {
    let code = source.lines().filter(|line| !line.trim_start().starts_with("//"));
    code.flat_map(|line| line.split(|letter| !is_in_word(letter))).collect()
}

/// Whether `name` can be that of a parameter: in small letters, and no symbol of a formula such as `n_x`.
fn can_be_a_parameter(name: &str) -> bool {
    let is_symbol = name.len() < 2 || name.as_bytes()[1] == b'_';
    name.chars().all(|letter| is_in_word(letter) && !letter.is_uppercase())
        && name.starts_with(|letter: char| letter.is_ascii_lowercase())
        && !is_symbol
}

/// Returns the names in doc comments of functions of `source` that are no words of its code, and none of
/// `also`, those of shaders.
fn unknown_names(source: &str, also: &HashSet<&str>) -> Vec<String> {
    let words = code_words(source);
    let (mut unknown, mut comment) = (Vec::new(), String::new());
    for line in source.lines().map(str::trim_start) {
        if let Some(text) = line.strip_prefix("///") {
            comment += text;
        } else if !line.starts_with("#[") {
            if line.starts_with("fn ") || line.contains(" fn ") {
                let named = comment.split('`').skip(1).step_by(2).filter(|name| can_be_a_parameter(name));
                let unknown_here = named.filter(|name| !words.contains(name) && !also.contains(name));
                unknown.extend(unknown_here.map(str::to_owned));
            }
            comment.clear();
        }
    }
    unknown
}

/// Returns the text of all files in `folder`, one after the other; empty where there is no such folder.
fn read_all(folder: &Path) -> String {
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    let paths = entries.map(|entry| entry.expect("it can be listed").path());
    paths.map(|path| std::fs::read_to_string(path).expect("it is text")).collect()
}

#[test]
fn names_in_the_comments_of_functions_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut faults = Vec::new();
    for name in crates() {
        let mut sources = BTreeMap::new();
        read_folder(&root.join(&name).join("src"), "", &mut sources);
        let shaders = read_all(&root.join(&name).join("shaders"));
        let also = code_words(&shaders);
        for (file, source) in &sources {
            let unknown = unknown_names(source, &also).into_iter();
            faults.extend(unknown.map(|unknown| format!("{name}/src/{file}: {unknown}")));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn a_name_that_is_left_behind_is_found() {
    let source = "/// Moves `body` by `offset` if it `is_usual`, along `n_x`: see `Body`.\n#[must_use]\n\
        pub(crate) const fn moved(body: Body, offset: f64, is_default: bool) -> Body {\n";
    assert_eq!(unknown_names(source, &HashSet::new()), ["is_usual"]);
    assert!(unknown_names(source, &HashSet::from(["is_usual"])).is_empty());
}

/// The width of code in `rustfmt.toml`, which does not wrap comments itself.
const WIDTH: usize = 110;

#[test]
fn comments_break_at_the_width_of_code() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources = BTreeMap::new();
    for name in crates() {
        for folder in ["src", "tests", "benches", "examples"] {
            let path = root.join(&name).join(folder);
            if path.is_dir() {
                read_folder(&path, &format!("{name}/{folder}/"), &mut sources);
            }
        }
    }
    assert!(sources.len() > 900, "{} files", sources.len());
    for (file, source) in &sources {
        for (index, line) in source.lines().enumerate() {
            let is_comment = line.trim_start().starts_with("//");
            assert!(!is_comment || line.chars().count() <= WIDTH, "{file}:{}: {line}", index + 1);
        }
    }
}
