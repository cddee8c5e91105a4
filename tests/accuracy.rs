//! `gamow accuracy`, run as its users run it. Costs are not looked at: they belong to the machine.

use std::collections::BTreeMap;
use std::fs;
use std::process::{Command, Output};
use std::sync::LazyLock;

use serde_json::Value;

fn command() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    command.env_remove("RUST_LOG").args(["accuracy", "--quick", "--scene=two-balls", "--size=96x72"]);
    command
}

fn succeeded(output: Output) -> String {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
    String::from_utf8(output.stdout).expect("it prints text")
}

fn output(command: &mut Command) -> String {
    succeeded(command.output().expect("the program starts"))
}

fn json(command: &mut Command) -> Value {
    serde_json::from_str(&output(command.arg("--json"))).expect("it is JSON")
}

/// The report that several tests look at.
static REPORT: LazyLock<Value> = LazyLock::new(|| json(&mut command()));

/// The entries of `list` in the report.
fn entries<'a>(report: &'a Value, list: &str) -> &'a [Value] {
    report[list].as_array().unwrap_or_else(|| panic!("{list} is a list"))
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is a number"))
}

/// The entry of the renderer that is called `name`.
fn renderer<'a>(report: &'a Value, name: &str) -> &'a Value {
    let found = entries(report, "renderers").iter().find(|entry| entry["method"] == name);
    found.unwrap_or_else(|| panic!("{name} was measured"))
}

/// Hides every graphics adapter.
#[cfg(target_os = "linux")]
fn without_adapter(command: &mut Command) -> &mut Command {
    command.env("WGPU_BACKEND", "dx12") // there is no Direct3D 12 on this system
}

#[test]
fn the_report_says_what_was_measured_where_and_how() {
    let report = &*REPORT;
    let setting = &report["setting"];
    assert_eq!(setting["scene"], "two-balls");
    assert_eq!(setting["size_px"], serde_json::json!([96, 72]));
    assert!(number(&setting["silhouette_resolution_px"]) < 0.001);
    for renderer in entries(report, "renderers") {
        assert!(number(&renderer["frame_ms"]) >= 0.0);
        let views = entries(renderer, "views");
        assert_eq!(views.len(), 7, "at rest, and three places at each of two speeds");
        for view in views {
            assert!(number(&view["wrong_share"]) >= 0.0 && view["place"].is_string());
            let [median, p99, worst] =
                ["median", "p99", "worst"].map(|key| number(&view["line_of_sight_arcseconds"][key]));
            assert!(median <= p99 && p99 <= worst);
        }
    }
}

/// Whether the name of a member says that it is a time.
fn is_a_time(name: &str) -> bool {
    name.ends_with("_ms") || name.ends_with("_ns")
}

/// Takes all members out of `report` that `timed` names, each of which it counts.
fn without(report: &mut Value, timed: &mut BTreeMap<String, usize>) {
    match report {
        Value::Object(members) => members.retain(|name, value| {
            if let Some(count) = timed.get_mut(name) {
                *count += 1;
                return false;
            }
            assert!(!is_a_time(name), "{name} is a time that nobody has marked");
            without(value, timed);
            true
        }),
        Value::Array(entries) => entries.iter_mut().for_each(|entry| without(entry, timed)),
        _ => {}
    }
}

#[test]
#[cfg(target_os = "linux")]
fn all_but_what_rests_on_the_clock_is_the_same_in_every_run() {
    let run = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
        command.env_remove("RUST_LOG").args(["accuracy", "--quick", "--scene=wheel", "--size=48x36"]);
        let mut report = json(without_adapter(&mut command));
        let names = entries(&report, "timed").iter().map(|name| name.as_str().expect("a name").to_owned());
        let mut timed = names.map(|name| (name, 0)).collect();
        without(&mut report, &mut timed);
        assert!(timed.values().all(|&count| count > 0), "{timed:?}");
        report
    };
    assert_eq!(run(), run());
}

#[test]
fn every_renderer_that_can_be_measured_is_held_against_the_reference() {
    let report = &*REPORT;
    let reference = renderer(report, "reference f64");
    // Through the core's light cone instead of back along the ray.
    assert!(number(&reference["worst_view"]["line_of_sight_arcseconds"]["worst"]) < 1e-6);
    if report["setting"]["device"].is_null() {
        assert_eq!(entries(report, "missing").len(), 1);
        return;
    }
    let rays = &renderer(report, "rays f32")["worst_view"];
    assert!(number(&rays["silhouettes_px"]["p99"]) < 0.05, "{rays}");
    assert!(number(&rays["doppler_relative"]["p99"]) < 1e-5, "{rays}");
}

#[test]
fn boxes_and_cylinders_are_drawn_as_exactly_as_round_bodies() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let file = folder.path().join("solids.toml");
    fs::write(&file, SOLIDS).expect("it can be written");
    let mut command = Command::new(env!("CARGO_BIN_EXE_gamow"));
    command.env_remove("RUST_LOG").args(["accuracy", "--quick", "--size=240x180", "--scene"]).arg(&file);
    let report = json(&mut command);
    if report["setting"]["device"].is_null() {
        return;
    }
    let rays = &renderer(&report, "rays f32")["worst_view"];
    assert!(number(&rays["wrong_share"]) < 0.001, "{rays}");
    assert!(number(&rays["silhouettes_px"]["p99"]) < 0.05, "{rays}");
    assert!(number(&rays["doppler_relative"]["worst"]) < 1e-5, "{rays}");
}

const SOLIDS: &str = r#"
name = "Solids"

[[object]]
shape = "box"
centre = [0, 3, 0]
size = [1, 1, 1]
angle = 25

[[object]]
shape = "box"
centre = [-1.2, 3.5, 0]
size = [0.6, 0.05, 1.2]
axis = [1, 1, 0]
angle = 40

[[object]]
shape = "cylinder"
from = [0.9, 3.5, -0.8]
to = [1.2, 3.2, 0.7]
radius = 0.3

[[object]]
shape = "cylinder"
from = [-0.6, 2.2, -0.5]
to = [-0.6, 2.25, -0.45]
radius = 0.3
"#;

#[test]
#[cfg(target_os = "linux")]
fn without_an_adapter_it_measures_what_it_can_and_says_what_is_missing() {
    let report = json(without_adapter(&mut command()));
    assert!(report["setting"]["device"].is_null());
    assert_eq!(entries(&report, "renderers").len(), 2);
    assert!(report["missing"][0].as_str().is_some_and(|missing| missing.contains("rays")));
}

#[test]
#[cfg(target_os = "linux")]
fn the_table_is_written_to_a_file() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let table = folder.path().join("table.txt");
    let printed = output(without_adapter(&mut command()).arg("--out").arg(&table));
    assert_eq!(printed, "");
    let table = fs::read_to_string(table).expect("it was written");
    assert!(table.contains("Pictures:") && table.contains("reference f64"), "{table}");
    assert!(table.contains("not measured: rays"), "{table}");
    assert!(!table.contains("NaN") && !table.contains("inf"), "{table}");
}
