//! The checker itself, on small made-up crates: it finds what it should, and nothing else.

use std::collections::BTreeMap;

use super::houses::PROGRAM;
use super::modules::modules;
use super::{faults, imports};

/// The faults of a program of these files.
fn faults_of(files: &[(&str, &str)]) -> Vec<String> {
    let sources: BTreeMap<String, String> =
        files.iter().map(|&(file, text)| (file.to_owned(), text.to_owned())).collect();
    faults(&PROGRAM, &imports(PROGRAM.name, &sources))
}

/// Asserts that these files have one fault, and that its line contains every part.
#[track_caller]
fn assert_fault(files: &[(&str, &str)], parts: &[&str]) {
    let faults = faults_of(files);
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert!(parts.iter().all(|part| faults[0].contains(part)), "{faults:?}");
}

#[test]
fn imports_downwards_are_no_fault() {
    let faults = faults_of(&[
        ("main.rs", "fn main() { gamow::cli::run() }"),
        ("lib.rs", "pub mod cli; mod app; mod scene;"),
        ("cli/mod.rs", "use crate::app; pub fn run() { app::shell::launch(); }"),
        ("app/mod.rs", "pub mod shell;"),
        ("app/shell/mod.rs", "use crate::scene::{self, Scene}; pub fn launch() -> Scene { scene::open() }"),
        ("scene.rs", "pub struct Scene; pub const fn open() -> Scene { Scene }"),
    ]);
    // `scene.rs` is not in the table.
    assert_eq!(faults, ["app/shell/mod.rs imports scene.rs: one of them stands in no room of the table"]);
}

#[test]
fn a_circle_is_found_through_re_exports() {
    assert_fault(
        &[
            ("lib.rs", "mod lesson;"),
            ("lesson/mod.rs", "mod a; mod b; pub use b::Second;"),
            ("lesson/a.rs", "use super::Second; pub struct First(Second);"),
            ("lesson/b.rs", "pub enum Second { Of(Box<super::a::First>) }"),
        ],
        &["a circle", "lesson/a.rs", "lesson/b.rs"],
    );
}

#[test]
fn a_circle_is_found_through_names_used_without_an_import() {
    let files = [
        ("lib.rs", "mod lesson;"),
        ("lesson/mod.rs", "mod panel; pub type Asks = u8; fn show() { println!(\"{}\", panel::shown()); }"),
        ("lesson/panel.rs", "pub fn shown() -> super::Asks { 1 }"),
    ];
    assert_fault(&files, &["a circle", "lesson/mod.rs", "lesson/panel.rs"]);
}

#[test]
fn what_only_tests_import_is_no_fault() {
    let faults = faults_of(&[
        ("lib.rs", "mod lesson;"),
        ("lesson/mod.rs", "mod a; mod b;"),
        ("lesson/a.rs", "use super::b::B; pub struct A(B); #[cfg(test)] mod tests;"),
        ("lesson/b.rs", "pub struct B; #[cfg(test)] mod tests { use crate::lesson::a::A; }"),
        ("lesson/a/tests.rs", "use crate::commands::eval;"),
    ]);
    assert_eq!(faults, [""; 0]);
}

#[test]
fn an_import_upwards_is_found() {
    let files = [
        ("lib.rs", "mod app; mod files;"),
        ("app/mod.rs", "pub struct State { pub a: u8 }"),
        ("files/mod.rs", "fn f() { use crate::app::State as Shown; }"),
    ];
    assert_fault(&files, &["files/mod.rs imports app/mod.rs: upwards"]);
}

#[test]
fn a_value_of_the_window_that_knows_a_command_is_found() {
    let files = [
        ("lib.rs", "mod app;"),
        ("app/mod.rs", "mod commands; mod state;"),
        ("app/commands/mod.rs", "use crate::app::state::State; pub enum Command { Undo }"),
        ("app/state/mod.rs", "mod order; pub struct State;"),
        ("app/state/order.rs", "use crate::app::commands::Command; pub struct Order(Command);"),
    ];
    let faults = faults_of(&files);
    let [upwards, knot] = faults.as_slice() else { panic!("{faults:?}") };
    assert_eq!(upwards, "app/state/order.rs imports app/commands/mod.rs: upwards");
    assert!(knot.starts_with("a knot of rooms"), "{knot}");
}

#[test]
fn a_knot_of_rooms_without_a_circle_of_files_is_found() {
    let files = [
        ("lib.rs", "mod plot; mod units; mod files;"),
        ("plot/mod.rs", "mod axis; mod label; use crate::files::FILE;"),
        ("plot/axis.rs", "use crate::units::METRE;"),
        ("plot/label.rs", "pub const LABEL: u8 = 1;"),
        ("units.rs", "pub const METRE: u8 = 1;"),
        ("files/mod.rs", "mod name; pub const FILE: u8 = 1;"),
        ("files/name.rs", "use crate::plot::label::LABEL;"),
    ];
    assert_fault(&files, &["a knot of rooms", "files", "plot"]);
}

#[test]
fn a_limit_of_visibility_is_no_import() {
    let files = [
        ("app/mod.rs", "mod a; fn f() { a::g(); }"),
        ("app/a.rs", "pub struct A { pub(in crate::app) b: u8 } pub(in crate::app) fn g() {}"),
    ];
    assert_eq!(faults_of(&files), Vec::<String>::new());
}

#[test]
fn commands_and_the_window_stand_apart() {
    let commands = "pub mod eval; pub mod fit;";
    let eval = "pub fn eval() {}";
    let lib = ("lib.rs", "mod commands; mod app;");
    let window = ("app/mod.rs", "fn f() { crate::commands::eval::eval(); }");
    let fit = ("commands/fit/mod.rs", "use crate::commands::eval::*;");
    let files = |window: (&'static str, &'static str), fit: (&'static str, &'static str)| {
        faults_of(&[lib, ("commands/mod.rs", commands), ("commands/eval.rs", eval), window, fit])
    };
    let none = |file| (file, "");
    let [from_window, from_command] =
        [files(window, none("commands/fit/mod.rs")), files(none("app/mod.rs"), fit)]
            .map(|faults| faults.join("\n"));
    assert!(from_window.starts_with("app/mod.rs imports commands/eval.rs:"), "{from_window}");
    assert!(from_command.starts_with("commands/fit/mod.rs imports commands/eval.rs:"), "{from_command}");
}

#[test]
fn panels_stand_apart_but_have_parts_and_share_a_room() {
    let files = [
        ("lib.rs", "mod app;"),
        ("app/mod.rs", "mod panels; mod widgets;"),
        ("app/widgets/mod.rs", "pub struct Row;"),
        ("app/panels/mod.rs", "mod bar; mod plots; pub type Asks = u8;"),
        ("app/panels/bar.rs", "use super::Asks; use crate::app::widgets::Row; use super::plots::show;"),
        ("app/panels/plots/mod.rs", "mod fit; pub fn show() { fit::show() }"),
        ("app/panels/plots/fit.rs", "pub fn show() -> crate::app::panels::Asks { 1 }"),
    ];
    assert_fault(&files, &["app/panels/bar.rs imports app/panels/plots/mod.rs: neither"]);
}

#[test]
fn what_belongs_to_one_room_or_to_none_is_found_elsewhere() {
    let files = [
        ("lib.rs", "mod files; mod formula;"),
        ("files/mod.rs", "use std::{fs, io}; const A: u8 = { 1 }; static B: u8 = { 2 };"),
        ("formula/mod.rs", "use ratex_layout::layout;"),
    ];
    assert_fault(&files, &["files/mod.rs names std::fs"]);
    let files = [
        ("lib.rs", "mod markup; mod formula;"),
        ("markup.rs", "use ratex_layout::layout;"),
        ("formula/mod.rs", "use ratex_layout::layout;"),
    ];
    assert_fault(&files, &["markup.rs names ratex_layout"]);
}

#[test]
fn items_of_every_kind_are_told_apart() {
    let items = "
        pub(super) const fn first<F: Fn() -> [u8; 2]>(f: F) -> impl Iterator<Item = u8> { f().into_iter() }
        const SECOND: fn() -> u8 = { || 2 };
        #[derive(Debug)]
        pub struct Third { pub a: u8 }
        made! { fn hidden() {} }
        pub(crate) unsafe trait Fourth {}
        macro_rules! fifth { () => { 5 } }
        static SIXTH: u8 = 6;
        pub type Seventh = u8;";
    let sources = BTreeMap::from([("lib.rs".to_owned(), items.to_owned())]);
    let modules = modules(&sources);
    let expected = ["Fourth", "SECOND", "SIXTH", "Seventh", "Third", "fifth", "first"];
    assert!(modules[&vec![]].items.iter().eq(expected), "{:?}", modules[&vec![]].items);
}
