//! The house keeps its layers: imports run down, never in a circle, each crate knows only what it should, and
//! each test is run.

mod houses;
mod imports;
mod made_up;
mod modules;
mod names;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use houses::{CORE, House, PLATFORM, PROGRAM, PYTHON, RENDERERS, Table};
use imports::{Imports, circles, imports};

#[test]
fn the_core_keeps_its_layers() {
    assert_kept(&CORE);
}

#[test]
fn the_renderers_keep_their_layers() {
    assert_kept(&RENDERERS);
}

#[test]
fn the_platform_keeps_its_layers() {
    assert_kept(&PLATFORM);
}

#[test]
fn the_program_keeps_its_layers() {
    assert_kept(&PROGRAM);
}

#[test]
fn the_python_package_keeps_its_layers() {
    assert_kept(&PYTHON);
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

/// The pictures of rows in the description of the architecture are the tables of houses, from top to bottom.
#[test]
fn the_architecture_is_drawn_as_it_is() {
    let page = include_str!("../../docs/architecture.md");
    let pictures = page.split("```text\n").skip(1).filter_map(|rest| rest.split("```").next());
    let is_room = |word: &&str| word.ends_with('/') || word.contains(".rs");
    let row = |line: &'static str| line.split_whitespace().filter(is_room).collect::<BTreeSet<_>>();
    let rows: Vec<BTreeSet<&str>> = pictures.flat_map(str::lines).map(row).collect();
    for table in PROGRAM.tables.iter().chain(RENDERERS.tables) {
        let mut rows = rows.iter();
        for floor in table.floors.iter().filter(|floor| floor[0] != "lib.rs") {
            let is_floor = |row: &&BTreeSet<&str>| {
                row.len() == floor.len()
                    && floor.iter().all(|room| row.iter().any(|drawn| drawn.trim_end_matches('/') == *room))
            };
            assert!(rows.any(|row| is_floor(&row)), "no row shows {floor:?} below those above it");
        }
    }
}

#[track_caller]
fn assert_kept(house: &House) {
    let name = house.name;
    let mut sources = BTreeMap::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(house.folder);
    read_folder(&folder, "", &mut sources);
    assert!(sources.len() > 10, "{} holds {} files", folder.display(), sources.len());
    let faults = faults(house, &imports(name, &sources));
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

/// What is wrong with the imports of a crate, a line each.
fn faults(house: &House, imports: &Imports) -> Vec<String> {
    let mut faults: Vec<String> = circles(&imports.inside)
        .into_iter()
        .map(|circle| format!("a circle: {} -> {}", circle.join(" -> "), circle[0]))
        .collect();
    for table in house.tables {
        faults.extend(imports.inside.iter().filter_map(|(from, to)| misplaced(table, from, to)));
        faults.extend(knots(table, &imports.inside));
    }
    faults.extend(imports.inside.iter().filter(|(from, to)| are_apart(house, from, to)).map(neither));
    for (file, path) in &imports.outside {
        let is_named =
            |names: &[&str]| names.iter().any(|name| path == name || path.starts_with(&format!("{name}::")));
        let is_misplaced =
            house.only_in.iter().any(|(room, names)| is_named(names) && !file.starts_with(room));
        if is_misplaced || is_named(house.never) {
            faults.push(format!("{file} names {path}"));
        }
    }
    faults
}

fn neither((from, to): &(String, String)) -> String {
    format!("{from} imports {to}: neither knows the other")
}

/// What is wrong with the height of an import inside the folder of `table`, if anything.
fn misplaced(table: &Table, from: &str, to: &str) -> Option<String> {
    let (here, there) = (room(table, from)?, room(table, to)?);
    let level = |room| table.floors.iter().position(|rooms| rooms.contains(&room));
    let fault = match (level(here), level(there)) {
        (Some(here), Some(there)) if here <= there => return None,
        (Some(_), Some(_)) => "upwards",
        _ => "one of them stands in no room of the table",
    };
    Some(format!("{from} imports {to}: {fault}"))
}

/// The circles of rooms, a line each. Those of one room's files are found by file.
fn knots(table: &Table, inside: &BTreeSet<(String, String)>) -> Vec<String> {
    let rooms = inside.iter().filter_map(|(from, to)| Some((room(table, from)?, room(table, to)?)));
    let rooms =
        rooms.filter(|(from, to)| from != to).map(|(from, to)| (from.to_owned(), to.to_owned())).collect();
    circles(&rooms).into_iter().map(|knot| format!("a knot of rooms: {}", knot.join(" -> "))).collect()
}

/// The room of `table` that a file belongs to: the file itself, or its folder. None if it lies elsewhere.
fn room<'a>(table: &Table, file: &'a str) -> Option<&'a str> {
    file.strip_prefix(table.inside)?.split('/').next()
}

/// Whether two files stand in folders, or in parts of a folder, that do not know each other.
fn are_apart(house: &House, from: &str, to: &str) -> bool {
    let inside = |folder: &&str| Some((from.strip_prefix(*folder)?, to.strip_prefix(*folder)?));
    let part = |file: &str| file.split(['/', '.']).next().map(str::to_owned);
    let differ = |(from, to)| part(from) != part(to) && ![from, to].contains(&"mod.rs");
    let stand_in = |[a, b]: [&str; 2]| from.starts_with(a) && to.starts_with(b);
    house.parts_apart.iter().filter_map(inside).any(differ)
        || house.strangers.iter().any(|&[a, b]| stand_in([a, b]) || stand_in([b, a]))
}
