//! `gamow fit` of readings that something is wrong with: the warning, what explains them, and the command for
//! it.

use std::fmt::Write as _;

use serde_json::Value;

use super::{gamow, run, words};

/// Readings of a point at 0.7 c, y = 3, z = 2, with d = 0.05: noise of 3e-5 rad, each changed by `change`,
/// which takes T, dphi and dtheta.
fn readings(change: impl Fn([f64; 3]) -> [f64; 3]) -> String {
    let curve = words("curve --beta 0.7 --d 0.05 --from=-6 --to 6 --samples 41").table();
    let [times, dphi, dtheta] = ["T", "dphi", "dtheta"].map(|name| curve.column(name));
    // Twelve uniform numbers make a normal one, but for its tails.
    let noise = |index: usize| {
        let uniform = |part: usize| ((12 * index + part) as f64 * 0.754_877_666_246_693).fract();
        3e-5 * ((0..12).map(uniform).map(|u| (u * 997.0).fract()).sum::<f64>() - 6.0)
    };
    (0..times.len()).fold("T,dphi,dtheta\n".to_owned(), |mut text, row| {
        let noisy = [times[row], dphi[row] + noise(2 * row), dtheta[row] + noise(2 * row + 1)];
        let [time, dphi, dtheta] = change(noisy);
        writeln!(text, "{time},{dphi},{dtheta}").expect("strings grow");
        text
    })
}

fn report(csv: &str, flags: &str) -> Value {
    let mut command = gamow();
    command.args(["fit", "-", "--json", "--bootstrap", "100"]).args(flags.split_whitespace());
    serde_json::from_str(&run(&mut command, csv.as_bytes()).text()).expect("JSON")
}

/// Asserts that the fit warns, says nothing of uncertainty, and names these flags, by which it is right.
fn assert_explained(csv: &str, flags: &str) {
    let wrong = report(csv, "--d 0.05");
    assert!(wrong["warning"].is_string() && wrong["residuals"]["chance"] == false, "{flags}: {wrong}");
    for key in ["uncertainty", "ci95", "uncertainty_linear"] {
        assert!(wrong["parameters"]["beta"][key].is_null(), "{flags}: {wrong}");
    }
    let cause = wrong["cause"].as_str().expect("a cause");
    let (sentence, command) = cause.rsplit_once(": gamow fit - ").expect("a command");
    assert!(sentence.contains("explains the readings (the sum of squares falls "), "{sentence}");
    assert!(command.contains(flags) && command.contains("--d=0.05"), "{flags}: {cause}");
    let right = report(csv, command);
    assert!(right["warning"].is_null() && right["cause"].is_null(), "{right}");
    for (name, truth) in [("beta", 0.7), ("y", 3.0), ("z", 2.0)] {
        let value = right["parameters"][name]["value"].as_f64().expect("a number");
        let error = right["parameters"][name]["uncertainty"].as_f64().expect("it is stated");
        assert!((value - truth).abs() < 4.0 * error, "{flags}: {name} {value} +- {error}");
    }
}

#[test]
fn what_is_wrong_is_found_and_named_with_its_command() {
    assert_explained(&readings(|[time, a, b]| [time + 6.0, a, b]), "--fit-x0");
    assert_explained(&readings(|[time, a, b]| [time, a.to_degrees(), b.to_degrees()]), "--angle-unit deg");
    assert_explained(&readings(|[time, a, b]| [1e3 * time, a, b]), "--time-unit ms");
}

/// Taken as radians these angles are more than a turn.
#[test]
fn readings_that_are_no_radians_are_refused_with_the_flag_for_their_unit() {
    let csv = readings(|[time, a, b]| [time, 1e3 * a, 1e3 * b]);
    let line = run(gamow().args(["fit", "-", "--d", "0.05"]), csv.as_bytes()).complaint();
    assert!(line.contains("column dphi: ") && line.contains("--angle-unit"), "{line}");
    assert!(report(&csv, "--d 0.05 --angle-unit mrad")["warning"].is_null());
}

/// dphi has one sign only where the point is in front of the eyes.
#[test]
fn readings_right_minus_left_are_explained_by_the_other_sign() {
    let csv = readings(|[time, a, b]| [time, -a, -b]);
    let line = run(gamow().args(["fit", "--d", "0.05", "-"]), csv.as_bytes()).complaint();
    assert!(line.contains("the other sign of dphi explains the readings but for chance"), "{line}");
    assert!(report(&csv, "--d 0.05 --negate both")["warning"].is_null());
}

/// Curves that were read by two clocks.
#[test]
fn a_shift_between_the_curves_is_found() {
    let csv = {
        let (right, late) = (readings(|row| row), readings(|[time, a, b]| [time + 0.4, a, b]));
        let dphi =
            right.lines().skip(1).map(|line| line.rsplit_once(',').expect("three fields").0.to_owned() + ",");
        let dtheta = late.lines().skip(1).map(|line| {
            let fields: Vec<&str> = line.split(',').collect();
            format!("{},,{}", fields[0], fields[2])
        });
        dphi.chain(dtheta).fold("T,dphi,dtheta".to_owned(), |text, line| text + "\n" + &line)
    };
    let outcome =
        run(gamow().args(["fit", "-", "--json", "--d", "0.05", "--bootstrap", "0"]), csv.as_bytes());
    let wrong: Value = serde_json::from_slice(&outcome.stdout).expect("JSON");
    let cause = wrong["cause"].as_str().expect("a cause");
    assert!(cause.contains("dtheta later by -0.4") || cause.contains("dtheta later by -0.3"), "{cause}");
}

/// The other curve having no fit loses no remark.
#[test]
fn a_warning_stands_where_a_curve_alone_has_no_fit() {
    let late = report(&readings(|[time, a, b]| [time + 6.0, a, b]), "--d 0.05");
    assert!(late["fits"]["dtheta"]["problem"].is_string(), "{late}");
    assert!(late["fits"]["combined"].is_null() && late["warning"].is_string());
}

#[test]
fn good_readings_have_their_number_and_no_warning() {
    let csv = readings(|row| row);
    let good = report(&csv, "--d 0.05");
    assert!(good["warning"].is_null() && good["cause"].is_null(), "{good}");
    assert!((1.0..3.0).contains(&good["residuals"]["durbin_watson"].as_f64().expect("a number")));
    let table = run(gamow().args(["fit", "--d", "0.05"]), csv.as_bytes()).text();
    assert!(table.contains("both: 82 readings, rms ") && table.contains(" (chance)\n"), "{table}");
}
