//! Results as JSON: the same as the text of the same command.

use serde_json::Value;

use super::{gamow, run, words};

/// The rows of a table in JSON, and its units.
fn table(outcome: super::Outcome) -> (Vec<Value>, Value) {
    let value: Value = serde_json::from_str(&outcome.text()).expect("it is JSON");
    (value["rows"].as_array().expect("rows").clone(), value["units"].clone())
}

/// Asserts that `json` holds the fields of a CSV table as numbers, null where they are empty.
fn assert_same(csv: &str, json: &[Value]) {
    let mut lines = csv.lines();
    let names: Vec<_> = lines.next().expect("a header").split(',').collect();
    assert_eq!(lines.clone().count(), json.len());
    for (line, row) in lines.zip(json) {
        assert_eq!(row.as_object().expect("an object").len(), names.len());
        for (name, field) in names.iter().zip(line.split(',')) {
            assert_eq!(row[name].as_f64(), field.parse().ok(), "{name} in {line}");
            assert_eq!(row[name].is_null(), field.is_empty(), "{name} in {line}");
        }
    }
}

#[test]
fn tables_in_json_are_those_in_csv() {
    for arguments in [
        "curve",
        "curve --gamma 1e9 --stereo --samples 50",
        "curve --roll 30 --turn 10 --stereo --conformal --samples 7",
        "curve --wheel-radius 0.525 --rho 1 --angle 0 --from -2 --to 8 --stereo",
        "curve --beta 0 --x0 5 --observer-beta 0.9 --stereo --samples 9",
        // The left eye sees the point along the line between the eyes: it has no u there.
        "curve --y 0 --z 0 --x0 -5 --conformal --from 0 --to 9 --samples 5",
    ] {
        let (json, units) = table(words(&format!("{arguments} --json")));
        assert_same(&words(arguments).text(), &json);
        for (name, value) in json[0].as_object().expect("an object") {
            let unit = units[name].as_str().unwrap_or_else(|| panic!("{name} has a unit"));
            assert!(["1", "rad", "deg", "length", "time"].contains(&unit), "{name}: {unit}");
            assert!(value.is_number() || value.is_null(), "{name}");
        }
    }
}

#[test]
fn eval_passes_texts_through() {
    let input = "name, T,d,y,z,beta,note\n007,4,0.1,3,2,0.9,\n\"a \"\"b\"\"\",\u{2212}4,1e-1,3,2,0.5,x\n";
    let (rows, units) = table(run(gamow().args(["eval", "--json"]), input.as_bytes()));
    assert_eq!((&rows[0]["name"], &rows[0]["note"]), (&Value::from("007"), &Value::Null));
    assert_eq!((&rows[1]["name"], &rows[1]["note"]), (&Value::from("a \"b\""), &Value::from("x")));
    assert_eq!((rows[1]["T"].as_f64(), rows[1]["d"].as_f64()), (Some(-4.0), Some(0.1)));
    assert_eq!((units["T"].as_str(), units["dphi"].as_str()), (Some("time"), Some("rad")));
    assert!(units.get("name").is_none());
    let csv = super::eval(input).text();
    let dphi = csv.lines().nth(1).and_then(|line| line.split(',').nth(19)).expect("a field");
    assert_eq!(rows[0]["dphi"].as_f64(), dphi.parse().ok());
}

#[test]
fn two_columns_of_one_name_are_no_json() {
    let input = "beta,d,y,z,T,note,note\n0.9,0.3,0.5,0.5,0,a,b\n";
    super::eval(input).text();
    let complaint = run(gamow().args(["eval", "--json"]), input.as_bytes()).complaint();
    assert_eq!(complaint, "gamow: column note is there twice; in JSON each needs a name of its own");
}

#[test]
fn the_list_in_json_is_that_in_text() {
    let json: Value = serde_json::from_str(&words("--list --json").text()).expect("it is JSON");
    let text = words("--list").text();
    let lessons = json.as_array().expect("a list");
    assert_eq!(lessons.len(), text.lines().count());
    for (lesson, line) in lessons.iter().zip(text.lines()) {
        let name = lesson["name"].as_str().expect("a name");
        assert!(line.starts_with(&format!("{name} ")), "{line}");
        assert!(line.ends_with(lesson["title"].as_str().expect("a title")), "{line}");
        let time = lesson["minutes"].as_u64().map(|minutes| format!(" {minutes} min "));
        assert_eq!(time.is_some(), lesson["kind"] == "lesson", "{line}");
        assert!(time.is_none_or(|time| line.contains(&time)), "{line}");
        assert!(lesson["error"].is_null());
    }
    let bodies: Vec<String> =
        serde_json::from_str(&words("--list --scene street --json").text()).expect("a list of names");
    assert_eq!(bodies.join("\n"), words("--list --scene street").text().trim_end());
}
