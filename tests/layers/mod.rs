//! The house keeps its layers: imports run down, never in a circle, each crate knows only what it should, and each test is run.

mod imports;
mod made_up;
mod modules;
mod names;

use std::collections::BTreeMap;
use std::path::Path;

use imports::{Imports, circles, imports};

/// The rooms of the program, from the top. A room imports from those below it and beside it, and not upwards.
const ROOMS: [&[&str]; 10] = [
    &["main.rs"],
    &["cli.rs"],
    &["commands", "app"],
    &["lesson"],
    &["accuracy", "estimate", "studio"],
    &["caption", "comfort.rs", "map"],
    &["settings"],
    &["scene", "columns", "time_range.rs", "flags", "files", "plot", "quantity.rs", "units.rs"],
    &["eye.rs", "eye_colours.rs", "number_text.rs", "formula"],
    &["markup.rs"],
];

/// What a crate names only in files whose paths begin in one way, if at all.
const ONLY_IN: [(&str, &str, &[&str]); 3] = [
    ("relativity-core", "threads.rs", &["rayon"]),
    ("gamow", "app/", &["eframe", "egui_plot"]),
    ("gamow", "formula/", &["ratex_font", "ratex_layout", "ratex_parser", "ratex_types", "skrifa"]),
];

/// What a crate names nowhere.
const NEVER: [(&str, &[&str]); 3] = [
    ("relativity-core", &["std::fs", "std::time", "std::thread", "glam", "wgpu", "egui", "eframe", "log"]),
    ("relativity-render", &["std::fs", "std::time", "std::thread", "rayon", "egui", "eframe"]),
    ("gamow", &["std::fs", "std::thread", "std::time::Instant", "std::time::SystemTime"]),
];

#[test]
fn the_core_keeps_its_layers() {
    assert_kept("relativity-core", "crates/relativity-core/src");
}

#[test]
fn the_renderers_keep_their_layers() {
    assert_kept("relativity-render", "crates/relativity-render/src");
}

#[test]
fn the_platform_keeps_its_layers() {
    assert_kept("gamow-platform", "crates/gamow-platform/src");
}

#[test]
fn the_program_keeps_its_layers() {
    assert_kept("gamow", "src");
}

/// Folders of tests, and their programs.
const PROGRAMS: [(&str, [&str; 2]); 3] = [
    ("tests", ["program.rs", "ui/main.rs"]),
    ("crates/relativity-core/tests", ["claims.rs", "oracle/main.rs"]),
    ("crates/relativity-render/tests", ["cpu.rs", "gpu.rs"]),
];

/// A file that none of them names would be tested by nobody.
#[test]
fn every_file_of_tests_is_in_a_program() {
    for (folder, programs) in PROGRAMS {
        let mut sources = BTreeMap::new();
        read_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), "", &mut sources);
        let roots: Vec<&str> = programs.iter().map(|program| sources[*program].as_str()).collect();
        let is_named = |name: &str| roots.iter().any(|root| root.contains(&format!("mod {name};\n")));
        for file in sources.keys().filter(|file| !programs.contains(&file.as_str())) {
            let is_of_a_program = programs.iter().any(|program| {
                program.split_once('/').is_some_and(|(own, _)| file.starts_with(&format!("{own}/")))
            });
            let name = file.split(['/', '.']).next().expect("a file has a name");
            assert!(is_of_a_program || is_named(name), "{folder}/{file} is in no program");
        }
    }
}

/// The parts of the window's state that outlast a frame.
const LASTING: [&str; 3] = ["document", "scratch", "session"];

/// Whether a line assigns to a lasting part of `self.state`, or borrows it with `&mut`. A method that changes the part is not seen.
fn changes_what_lasts(line: &str) -> bool {
    LASTING.iter().any(|part| {
        let name = format!("self.state.{part}");
        line.match_indices(&name).any(|(start, _)| {
            let rest = line[start + name.len()..]
                .trim_start_matches(|c: char| c.is_alphanumeric() || "._".contains(c));
            let assigned = rest.trim_start_matches([' ', '+', '-', '*', '/', '&', '|', '^']);
            let is_assigned =
                assigned.starts_with('=') && !assigned.starts_with("==") && !assigned.starts_with("=>");
            is_assigned || line[..start].ends_with("&mut ")
        })
    })
}

/// The window calls functions of the state, in place of assigning to the document, the scratch or the session.
#[test]
fn the_window_changes_nothing_that_lasts_by_itself() {
    let mut sources = BTreeMap::new();
    read_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/app"), "", &mut sources);
    for (file, source) in &sources {
        let faults: Vec<&str> = source.lines().filter(|line| changes_what_lasts(line)).collect();
        assert!(faults.is_empty(), "{file}: {faults:#?}");
    }
    for line in [
        "self.state.document.time = 1.0;",
        "self.state.scratch.saddle.turn += 1;",
        "f(&mut self.state.session.orders)",
    ] {
        assert!(changes_what_lasts(line), "{line}");
    }
    for line in
        ["if self.state.document.time == 1.0 {", "self.state.frame.step = 1.0;", "g(&self.state.session)"]
    {
        assert!(!changes_what_lasts(line), "{line}");
    }
}

#[track_caller]
fn assert_kept(name: &str, folder: &str) {
    let mut sources = BTreeMap::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    read_folder(&folder, "", &mut sources);
    assert!(sources.len() > 10, "{} holds {} files", folder.display(), sources.len());
    let faults = faults(name, &imports(name, &sources));
    assert!(faults.is_empty(), "{} faults in {name}:\n{}", faults.len(), faults.join("\n"));
}

/// Adds the sources in `folder` to `sources`, their names after `prefix`.
fn read_folder(folder: &Path, prefix: &str, sources: &mut BTreeMap<String, String>) {
    for entry in std::fs::read_dir(folder).expect("it can be listed") {
        let path = entry.expect("it can be listed").path();
        let name = format!("{prefix}{}", path.file_name().expect("it has one").to_string_lossy());
        if path.is_dir() {
            read_folder(&path, &format!("{name}/"), sources);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            sources.insert(name, std::fs::read_to_string(&path).expect("it is text"));
        }
    }
}

/// What is wrong with the imports of the crate `name`, a line each.
fn faults(name: &str, imports: &Imports) -> Vec<String> {
    let mut faults: Vec<String> = circles(&imports.inside)
        .into_iter()
        .map(|circle| format!("a circle: {} -> {}", circle.join(" -> "), circle[0]))
        .collect();
    if name == "gamow" {
        faults.extend(imports.inside.iter().filter_map(|(from, to)| misplaced(from, to)));
    }
    for (file, path) in &imports.outside {
        let is_named =
            |names: &[&str]| names.iter().any(|name| path == name || path.starts_with(&format!("{name}::")));
        let only_in = ONLY_IN.iter().filter(|(owner, ..)| *owner == name);
        let is_misplaced =
            only_in.into_iter().any(|(_, room, names)| is_named(names) && !file.starts_with(room));
        if is_misplaced || NEVER.iter().any(|(owner, names)| *owner == name && is_named(names)) {
            faults.push(format!("{file} names {path}"));
        }
    }
    faults
}

/// What is wrong with an import of the program, if anything.
fn misplaced(from: &str, to: &str) -> Option<String> {
    let fault = |what: &str| Some(format!("{from} imports {to}: {what}"));
    let [Some(here), Some(there)] = [level(from), level(to)] else {
        return fault("one of them stands in no room of the table");
    };
    if here > there {
        fault("upwards")
    } else if are_apart(from, to) {
        fault("neither knows the other")
    } else {
        None
    }
}

/// The place of a file's room in the table.
fn level(file: &str) -> Option<usize> {
    let room = file.split('/').next()?;
    ROOMS.iter().position(|rooms| rooms.contains(&room))
}

/// Folders whose files and folders do not know each other.
const APART: [&str; 2] = ["commands/", "app/panels/"];

/// Whether two files stand beside each other in such a folder, or in the window and among the commands.
fn are_apart(from: &str, to: &str) -> bool {
    let inside = |folder| Some((from.strip_prefix(folder)?, to.strip_prefix(folder)?));
    let part = |file: &str| file.split(['/', '.']).next().map(str::to_owned);
    let differ = |(from, to)| part(from) != part(to) && ![from, to].contains(&"mod.rs");
    let is_window = |file: &str| file.starts_with("app/");
    let is_command = |file: &str| file.starts_with("commands/");
    APART.iter().filter_map(inside).any(differ)
        || is_window(from) && is_command(to)
        || is_command(from) && is_window(to)
}
