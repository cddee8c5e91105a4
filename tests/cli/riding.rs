//! Observers who move: `eval`, `curve` and `fit`.

use super::numbers::assert_near;
use super::{Table, gamow, run, words};

const HEAD: &str = "observer_beta,beta,d,x0,y,z,T";

/// A row of the derivation, worked out in 60-digit arithmetic: a lamp 5 ahead, 3 aside and 2 up, from a
/// bicycle at 0.9 c.
#[test]
fn eval_tells_what_a_rider_sees_of_a_lamp() {
    let input = format!("{HEAD}\n0.9,0,0.1,5,3,2,0\n");
    let table = run(gamow().args(["eval", "--stereo"]), input.as_bytes()).table();
    for (name, expected) in [
        ("doppler_left", 3.981_735_471),
        ("phi_left", 0.121_085_324_4),
        ("dphi", -0.004_595_314_193),
        ("dtheta", -0.003_019_919_708),
        ("t_left", -6.361_051_121),
        ("distance_left", 24.916_960_13),
        ("y_left", 3.0),
        ("stereo_x", 2.657_816_4),
    ] {
        // Eight digits of each.
        assert_near(table.column(name)[0], expected, 5e-8 * f64::abs(expected));
    }
}

/// `curve` writes each row's event, from which `eval` finds the same.
#[test]
fn a_riders_curve_is_what_eval_makes_of_its_rows() {
    let flags =
        "--samples 9 --stereo --conformal --roll 20 --observer-gamma 3 --observer-azimuth 30 --observer-z=-1";
    let text = words(&format!("curve {flags} --from -4 --to 5")).text();
    let table = Table::parsed(&text);
    let names: Vec<&str> = text.lines().next().expect("a header").split(',').collect();
    let inputs = names.iter().position(|&name| name == "T").expect("T is an input") + 1;
    let rows: String =
        text.lines().map(|line| line.split(',').take(inputs).collect::<Vec<_>>().join(",") + "\n").collect();
    let again = run(gamow().args(["eval", "--stereo", "--conformal"]), rows.as_bytes()).table();
    for name in &names[inputs..] {
        for (a, b) in table.column(name).into_iter().zip(again.column(name)) {
            assert_near(a, b, 1e-12 * (1.0 + a.abs()));
        }
    }
}

#[test]
fn an_observer_at_rest_has_the_columns_of_no_observer() {
    let plain = words("curve --samples 7 --from -3 --to 9").table();
    let rest = words("curve --samples 7 --from -3 --to 9 --observer-beta 0").table();
    for name in ["x_left", "t_right", "doppler_left", "phi_left", "dphi", "dtheta", "tau_right"] {
        assert_eq!(plain.column(name), rest.column(name), "{name}");
    }
    assert_eq!(rest.column("clock"), rest.column("T"));
    assert!(rest.column("y_left").iter().all(|&y| y == 3.0));
}

/// Two eyes are a speedometer: a lamp's disparities give the rider's own speed, and the distance of the lamp.
#[test]
fn a_riders_own_speed_is_fitted_from_a_lamp() {
    for flags in ["--observer-beta 0.9 --x0 5", "--observer-beta 0.6 --x0=-2 --roll 15 --turn=-20"] {
        let curve = words(&format!("curve --beta 0 --from=-3 --to 9 {flags}")).text();
        let report = run(gamow().args(["fit", "--riding", "--fit-x0", "--json"]), curve.as_bytes()).text();
        let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
        let value = |name: &str| report["parameters"][name]["value"].as_f64().expect("a number");
        let (beta, x0) = if flags.contains("0.9") { (0.9, 5.0) } else { (0.6, -2.0) };
        assert_near(value("beta"), beta, 1e-7);
        assert_near(value("y"), 3.0, 1e-5);
        assert_near(value("z"), 2.0, 1e-5);
        // Contracted, and behind.
        assert_near(value("x0"), -x0 * (1.0_f64 - beta * beta).sqrt(), 1e-5);
        assert_eq!(report["riding"], true);
    }
}

#[test]
fn extreme_riders_have_numbers() {
    for flags in [
        "--gamma 1e14 --observer-gamma 1e15 --observer-azimuth 180",
        "--beta 0 --observer-gamma 1e30",
        "--gamma 1e14 --observer-gamma 1e14 --observer-azimuth 90 --observer-elevation 30",
        "--beta 1e-300 --observer-beta 1e-300 --observer-azimuth 1e-300",
    ] {
        let curve = format!("curve --samples 5 --from -1e3 --to 1e3 {flags}");
        let text = words(&format!("{curve} --stereo")).text();
        assert!(!text.contains("NaN") && !text.contains("inf"), "{flags}: {text}");
        let table = words(&curve).table();
        assert!(table.column("doppler_left").iter().all(|&d| d > 0.0), "{flags}");
    }
}

#[test]
fn a_column_or_flag_that_is_not_right_is_named() {
    let told = |head: &str, row: &str, args: &[&str]| {
        run(gamow().arg("eval").args(args), format!("{head}\n{row}\n").as_bytes()).complaint()
    };
    let row = "0.9,0,0.1,5,3,2,0";
    let line = told(&HEAD.replace("observer_beta", "observer_bta"), row, &[]);
    assert!(line.contains("column observer_bta is none of the observer's"), "{line}");
    let line = told(HEAD, "1.9,0,0.1,5,3,2,0", &[]);
    assert!(line.contains("observer_beta = 1.9 is out of range"), "{line}");
    let line = told(HEAD, row, &["--model", "published"]);
    assert!(line.contains("both eyes at rest"), "{line}");
    let line = told(&format!("{HEAD},observer_gamma"), &format!("{row},2"), &[]);
    assert!(line.contains("observer_beta and observer_gamma both give the speed"), "{line}");
    let line = run(gamow().args(["fit", "--riding"]), b"T,dphi,d\n0,0.1,0.1\n").complaint();
    assert!(line.contains("clock"), "{line}");
}
