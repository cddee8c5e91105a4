//! `gamow fit`: the chain from curves to speed, its JSON, and its complaints.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::io::{BufRead as _, BufReader};
use std::process::Stdio;

use relativity_core::{Aperture, Model, SourcePoint, Speed, Turning, WheelPoint};
use serde_json::Value;

use super::{Table, gamow, run, words};

/// Delta-phi and Delta-theta of the paper's tracked point by `gamow curve`, with a deterministic noise of
/// about 1 % added, as CSV with the given columns.
fn noisy_curve(columns: &[&str], model: &str) -> String {
    let curve = run(gamow().args(["curve", "--samples", "240", "--model", model]), b"").text();
    let mut lines = curve.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().expect("a header");
    let places: Vec<usize> = columns
        .iter()
        .map(|column| names.iter().position(|name| name == column).expect("curve writes it"))
        .collect();
    let mut text = columns.join(",") + "\n";
    for (index, line) in lines.enumerate() {
        let cells = places.iter().map(|&place| match names[place] {
            "dphi" | "dtheta" => noisy(line[place], 4 * index + 2 * place),
            _ => line[place].to_owned(),
        });
        writeln!(text, "{}", cells.collect::<Vec<_>>().join(",")).expect("strings grow");
    }
    text
}

/// `cell` plus a normal deviate (Box and Muller's) of standard deviation 2e-4, about 1 % of the curves.
fn noisy(cell: &str, index: usize) -> String {
    let uniform = |index: usize| ((index as f64 + 1.0) * 0.618_033_988_749_895).fract().max(1e-9);
    let deviate = (-2.0 * uniform(index).ln()).sqrt() * (TAU * uniform(index * index)).cos();
    (cell.parse::<f64>().expect("a number") + 2e-4 * deviate).to_string()
}

fn fitted(csv: &str, arguments: &str) -> Value {
    let text = run(gamow().arg("fit").args(arguments.split_whitespace()), csv.as_bytes()).text();
    serde_json::from_str(&text).expect("JSON")
}

fn complaint(csv: &str, arguments: &str) -> String {
    run(gamow().arg("fit").args(arguments.split_whitespace()), csv.as_bytes()).complaint()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn semicolons_and_tabs_separate_and_commas_are_decimal_points_there() {
    let text = noisy_curve(&["T", "d", "dphi", "dtheta"], "exact");
    let right = fitted(&text, "--json --bootstrap 20");
    for separator in [";", "\t"] {
        let commas = text.replace(',', separator).replace('.', ",");
        // As a spreadsheet writes it: with a byte order mark, a blank line and the line ends of Windows.
        let written = format!("\u{feff}\n{}", commas.replace('\n', "\r\n"));
        for text in [commas, written, text.replace(',', separator)] {
            assert_eq!(fitted(&text, "--json --bootstrap 20"), right);
        }
    }
    let wrong = complaint("T;d;dphi\n0,5;0,1;-0,1\n1,5;0,1;-0,1,2\n", "");
    assert!(wrong.contains("standard input:3: column dphi: \"-0,1,2\" is not a number"), "{wrong}");
    // Among commas a semicolon is no separator, and a comma no decimal point.
    let wrong = complaint("T,d,dphi\n0,0.1,-0;1\n", "");
    assert!(wrong.contains("column dphi: \"-0;1\" is not a number"), "{wrong}");
    let wrong = complaint("T,d,dphi\n0,0.1,\"-0,1\"\n", "");
    assert!(wrong.contains("column dphi: \"-0,1\" is not a number"), "{wrong}");
}

#[test]
fn a_row_of_semicolons_is_evaluated() {
    let with = |text: &str| run(gamow().arg("eval"), text.as_bytes()).text();
    assert_eq!(
        with("note;beta;d;y;z;T\na, b;0,9;0,1;3;2;0,5\n"),
        with("note,beta,d,y,z,T\n\"a, b\",0.9,0.1,3,2,0.5\n")
    );
}

#[test]
fn noise_free_curves_give_the_object_back_in_every_model() {
    for model in ["exact", "one-cone", "published"] {
        let curve = run(gamow().args(["curve", "--model", model]), b"").text();
        let report = fitted(&curve, &format!("--model {model} --json --bootstrap 20"));
        for (name, truth) in [("beta", 0.9), ("y", 3.0), ("z", 2.0)] {
            let fits = [&report, &report["fits"]["dphi"], &report["fits"]["dtheta"]];
            for fit in fits {
                let value = number(&fit["parameters"][name]["value"]);
                assert!((value - truth).abs() < 1e-9, "{model} {name} {value}");
            }
        }
    }
}

/// The curves of a point on a wheel, one that rolls past as the paper's cyclist does.
fn of_a_wheel(beta: f64, wheel: WheelPoint) -> String {
    let speed = Speed::from_beta(beta).expect("in range");
    let mut csv = "T,dphi,dtheta\n".to_owned();
    for step in 0..240 {
        let time = -6.0 + 0.07 * f64::from(step);
        let both = Model::Exact.disparity(&speed, wheel, Aperture::pair(0.1), time).expect("in the domain");
        writeln!(csv, "{time},{},{}", both.dphi, both.dtheta).expect("strings grow");
    }
    csv
}

/// y and z are the hub's, with the sign of z by either curve: mirrored, the point would turn the other way.
/// Taken for a fixed one, it has another speed.
#[test]
fn a_point_on_a_rolling_wheel_is_fitted_by_its_wheel() {
    let hub = SourcePoint { x0: 0.0, y: 3.0, z: -2.0 };
    for (beta, rho, angle) in [(0.9, 1.0, 0.5), (0.6, 0.85, -2.5)] {
        let wheel = WheelPoint { hub, radius: 0.525, rho, angle, turning: Turning::Rolling };
        let csv = of_a_wheel(beta, wheel);
        let flags = format!("--d 0.1 --wheel-radius 0.525 --rho {rho} --angle={angle}");
        let report = fitted(&csv, &format!("{flags} --json --bootstrap 20"));
        for (name, truth) in [("beta", beta), ("y", 3.0), ("z", -2.0)] {
            for fit in [&report, &report["fits"]["dphi"], &report["fits"]["dtheta"]] {
                let value = number(&fit["parameters"][name]["value"]);
                assert!((value - truth).abs() < 1e-7, "{name}: {value} for {truth}");
            }
        }
        assert_eq!(number(&report["wheel"]["wheel_radius"]), 0.525);
        assert_eq!([number(&report["wheel"]["rho"]), number(&report["wheel"]["angle"])], [rho, angle]);
        let table =
            run(gamow().arg("fit").args(format!("{flags} --bootstrap 0").split_whitespace()), csv.as_bytes());
        let told = format!(
            "wheel      radius 0.525, rho {rho}, angle {angle}, taken as known: y, z and x0 are the hub's"
        );
        assert!(table.text().contains(&told));
        let fixed = fitted(&csv, "--d 0.1 --json --bootstrap 0");
        assert!((number(&fixed["parameters"]["beta"]["value"]) - beta).abs() > 1e-3);
        assert!(number(&fixed["rms"]) > 1e3 * number(&report["rms"]));
    }
    let incomplete = run(gamow().args(["fit", "--d", "0.1", "--rho", "0.5"]), b"");
    assert!(incomplete.status == Some(2) && incomplete.stderr.contains("--wheel-radius"));
}

/// Delta-phi tells the sides of the eyes' level apart by the wheel's wiggle alone, which noise hides where
/// the point is near the hub.
#[test]
fn a_side_that_fits_within_the_noise_is_remarked_on() {
    let hub = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    let remark = "the sign of z is uncertain: z = ";
    for (rho, is_uncertain) in [(0.02, true), (1.0, false)] {
        let wheel = WheelPoint { hub, radius: 0.525, rho, angle: 0.5, turning: Turning::Rolling };
        let clean = Table::parsed(&of_a_wheel(0.6, wheel));
        let noisy = |row: usize| {
            let noise = 1e-3 * ((row * 37 % 101) as f64 / 50.0 - 1.0);
            let [time, dphi] = ["T", "dphi"].map(|name| clean.column(name)[row]);
            format!("{time},{},1e-3\n", dphi + noise)
        };
        let csv = "T,dphi,sigma_dphi\n".to_owned() + &(0..240).map(noisy).collect::<String>();
        let flags = format!("--d 0.1 --wheel-radius 0.525 --rho {rho} --angle=0.5 --bootstrap 0");
        let table = run(gamow().arg("fit").args(flags.split_whitespace()), csv.as_bytes()).text();
        assert_eq!(table.contains(remark), is_uncertain, "{table}");
        let report = fitted(&csv, &format!("{flags} --json"));
        assert_eq!(report["other_side"].is_string(), is_uncertain);
    }
}

#[test]
fn a_turned_head_gives_the_object_back_by_columns_and_by_flags() {
    for head in ["--roll 90", "--turn -40", "--roll 30 --turn 90"] {
        let curve = words(&format!("curve {head}")).text();
        assert!(curve.starts_with("beta,d,roll,turn,y,z,x0,T,x_left"), "{}", &curve[..60]);
        // Without the columns, by flags.
        let bare: String = {
            let table = Table::parsed(&curve);
            let [times, dphi, dtheta] = ["T", "dphi", "dtheta"].map(|name| table.column(name));
            let row = |i: usize| format!("{},{},{}\n", times[i], dphi[i], dtheta[i]);
            "T,dphi,dtheta\n".to_owned() + &(0..times.len()).map(row).collect::<String>()
        };
        for (csv, arguments) in [(&curve, String::new()), (&bare, format!("--d 0.1 {head}"))] {
            let report = fitted(csv, &format!("{arguments} --json --bootstrap 0"));
            for (name, truth) in [("beta", 0.9), ("y", 3.0), ("z", 2.0)] {
                let value = number(&report["parameters"][name]["value"]);
                assert!((value - truth).abs() < 1e-8, "{head} {arguments} {name} {value}");
            }
        }
        let complaint = complaint(&curve, "--model published");
        assert!(complaint.contains("the published model needs both on a line along x"), "{complaint}");
    }
}

#[test]
fn the_json_holds_values_intervals_and_the_combined_fit() {
    let report = fitted(&noisy_curve(&["T", "dphi", "dtheta"], "exact"), "--d 0.1 --json");
    assert_eq!(report["model"], "exact");
    assert_eq!(report["converged"], true);
    assert!((1e-4..4e-4).contains(&number(&report["rms"])));
    let (fits, truths) = (&report["fits"], [("beta", 0.9), ("y", 3.0), ("z", 2.0)]);
    for (name, truth) in truths {
        let parameters = [&report, &fits["dphi"], &fits["dtheta"]].map(|fit| &fit["parameters"]);
        for parameter in
            parameters.iter().map(|parameters| &parameters[name]).chain([&fits["combined"][name]])
        {
            let [value, uncertainty] = ["value", "uncertainty"].map(|key| number(&parameter[key]));
            assert!((value - truth).abs() < 5.0 * uncertainty, "{name}: {parameter}");
            let [low, high] = [0, 1].map(|end| number(&parameter["ci95"][end]));
            assert!((3.0..5.0).contains(&((high - low) / uncertainty)), "{name}: {parameter}");
        }
    }
}

/// Below the eyes' level dphi is the same and dtheta has the other sign: so has z, and all else stays.
#[test]
fn below_the_eyes_the_mean_of_both_curves_is_mirrored() {
    let above = noisy_curve(&["T", "dphi", "dtheta"], "exact");
    let with_dtheta = |factor: f64| {
        let table = Table::parsed(&above);
        let [times, dphi, dtheta] = ["T", "dphi", "dtheta"].map(|name| table.column(name));
        let row = |i: usize| format!("{},{},{}\n", times[i], dphi[i], factor * dtheta[i]);
        "T,dphi,dtheta\n".to_owned() + &(0..times.len()).map(row).collect::<String>()
    };
    let flags = "--d 0.1 --bootstrap 50";
    let [above, below] = [1.0, -1.0].map(|factor| {
        let report = fitted(&with_dtheta(factor), &format!("{flags} --json"));
        ["beta", "y", "z"].map(|name| {
            let mean = &report["fits"]["combined"][name];
            ["value", "uncertainty", "disagreement"].map(|key| number(&mean[key]))
        })
    });
    assert!(above[2][0] > 1.9 && below[2][0] < -1.9, "{above:?} {below:?}");
    for (above, below) in above.iter().zip(below) {
        for (above, below) in above.iter().zip(below) {
            assert!((above.abs() - below.abs()).abs() < 1e-6 * above.abs(), "{above} {below}");
        }
        assert!(above[2] < 3.0);
    }
    let table = |factor: f64| {
        run(gamow().arg("fit").args(flags.split_whitespace()), with_dtheta(factor).as_bytes()).text()
    };
    let remark = "standard errors between dphi and dtheta: the model may be wrong";
    assert!(!table(-1.0).contains(remark) && table(1.2).contains(remark), "{}", table(1.2));
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let csv = noisy_curve(&["T", "dphi", "dtheta"], "exact");
    let report = |seed: &str| {
        let mut command = gamow();
        command.args(["fit", "--d", "0.1", "--json", "--bootstrap", "50", "--seed", seed]);
        run(&mut command, csv.as_bytes()).text()
    };
    assert_eq!(report("3"), report("3"));
    assert_ne!(report("3"), report("4"));
}

#[test]
fn the_table_shows_all_parameters_and_an_output_file_is_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("fit.txt");
    let csv = noisy_curve(&["T", "dphi"], "published");
    let mut command = gamow();
    command.args(["fit", "--d", "0.1", "--model", "published", "--fit-x0", "--out"]).arg(&file);
    assert_eq!(run(&mut command, csv.as_bytes()).text(), "");
    let table = std::fs::read_to_string(&file).expect("written");
    for name in ["model      published", "dphi: 240 readings", "  beta ", "  y ", "  z ", "  x0 "] {
        assert!(table.contains(name), "{name:?} is missing:\n{table}");
    }
}

#[test]
fn faults_in_the_file_are_located() {
    let header = "T,dphi,sigma_dphi\n";
    let needed = "the header should name T, dphi or dtheta, and d unless --d gives it, and it names";
    let cases = [
        ("T,phi\n", "1: column dphi or dtheta is missing; ".to_owned() + needed + " T, phi"),
        ("dphi\n", "1: column T is missing; ".to_owned() + needed + " dphi"),
        (
            "T,dphi,sigma_dphi\n0,x,1\n",
            "2: column dphi: \"x\" is not a number; it should be one such as 0.9 or 1e-3".to_owned(),
        ),
        ("T,dphi,sigma_dphi\n0,-0.1,1\n\n1,-0.1,0\n", "4: column sigma_dphi: 0 is not usable".to_owned()),
    ];
    for (csv, expected) in cases {
        assert_eq!(complaint(csv, "--d 0.1"), format!("gamow: standard input:{expected}"));
    }
    let no_separation = complaint(header, "");
    assert!(no_separation.contains("column d is missing"), "{no_separation}");
}

#[test]
fn what_the_data_cannot_tell_is_said() {
    let few = complaint("T,dphi\n0,-0.1\n1,-0.2\n", "--d 0.1");
    let expected = "2 samples of dphi are too few: 3 parameters need at least 6";
    assert_eq!(few, format!("gamow: standard input: {expected}"));
    let flat: String = (0..20).fold("T,dphi\n".to_owned(), |text, time| text + &format!("{time},-0.1\n"));
    assert!(complaint(&flat, "--d 0.1").contains("the curve of dphi is flat"));
    let not_there = complaint("T,dphi\n0,-0.1\n1,-0.2\n", "--d 0.1 --use dtheta");
    assert!(not_there.contains("0 samples of dtheta are too few"), "{not_there}");
}

#[test]
fn readings_that_were_not_made_are_left_out() {
    let mut csv = noisy_curve(&["T", "dphi", "dtheta"], "exact");
    csv.push_str("9.0,,\n9.1,-0.002,\n");
    let outcome = run(gamow().args(["fit", "--d", "0.1", "--json", "--bootstrap", "0"]), csv.as_bytes());
    assert_eq!(outcome.stderr, "gamow: standard input: 3 readings not taken left out\n");
    let report: Value = serde_json::from_slice(&outcome.stdout).expect("JSON");
    assert_eq!(report["readings"], 481);
    assert_eq!(report["fits"]["dtheta"]["readings"], 240);
}

/// Sigmas that are not those of the scatter are said to be: too large, too small, and not at all where they
/// fit.
#[test]
fn sigmas_that_the_scatter_contradicts_are_named() {
    let csv = noisy_curve(&["T", "d", "dphi", "dtheta"], "exact");
    let with_sigma = |sigma: &str| {
        let mut lines = csv.lines();
        let header = lines.next().expect("a header").to_owned() + ",sigma_dphi,sigma_dtheta";
        lines.fold(header, |text, line| text + "\n" + line + "," + sigma + "," + sigma)
    };
    let remark = |csv: &str| fitted(csv, "--json --bootstrap 0")["sigmas"].clone();
    assert!(remark(&csv).is_null() && remark(&with_sigma("2e-4")).is_null());
    let upper = remark(&with_sigma("1.2e-3"));
    let upper = upper.as_str().expect("a sentence");
    assert!(
        upper.starts_with("the readings scatter 0.1") && upper.contains("they are upper bounds"),
        "{upper}"
    );
    let table = run(gamow().args(["fit", "--bootstrap", "0"]), with_sigma("1.2e-3").as_bytes()).text();
    assert!(table.contains(&format!("sigmas     {upper}\n")), "{table}");
    let lower = remark(&with_sigma("5e-5"));
    assert!(lower.as_str().is_some_and(|text| text.contains("they are too small")), "{lower}");
}

/// Why a search ended is told in words of this program.
#[test]
fn why_there_is_no_fit_is_told_in_plain_words() {
    let wild: String = (0..12).fold("T,d,dphi\n".to_owned(), |text, i| {
        let value = if i % 2 == 0 { 1.0 } else { -1.0 };
        text + &format!("{i},0.1,{value}\n")
    });
    let huge = "T,d,dphi\n0,0.1,1e40\n1,0.1,-1e40\n2,0.1,1e40\n3,0.1,2e40\n4,0.1,0\n";
    for (csv, flags) in [(wild.as_str(), ""), (wild.as_str(), "--fit-x0"), (huge, ""), (huge, "--fit-x0")] {
        let line = complaint(csv, flags);
        let foreign = ["LostPatience", "NoImprovement", "Numerical", "User(", "Orthogonal", "Converged {"];
        assert!(!foreign.iter().any(|word| line.contains(word)), "{line}");
        assert!(line.starts_with("gamow: standard input"), "{line}");
    }
}

#[test]
fn separations_out_of_range_are_named() {
    for d in ["-1", "0", "1e61"] {
        let outcome = run(gamow().args(["fit", "--d", d]), b"T,dphi\n0,0.1\n");
        assert_eq!(outcome.status, Some(2));
        let expected = format!("gamow: --d {d}: must be above 0 and at most 1e60");
        assert!(outcome.stderr.starts_with(&expected), "{}", outcome.stderr);
        let complaint = run(gamow().arg("fit"), format!("T,d,dphi\n0,{d},0.1\n").as_bytes()).complaint();
        let expected = format!(
            "gamow: standard input:2: column d: {d} is out of range: it must be above 0 and at most 1e60"
        );
        assert_eq!(complaint, expected);
    }
    for (flag, value) in [("x0", "1e61"), ("bootstrap", "1"), ("bootstrap", "100000000")] {
        let outcome = run(gamow().args(["fit", &format!("--{flag}"), value]), b"");
        assert_eq!(outcome.status, Some(2));
        assert!(outcome.stderr.starts_with(&format!("gamow: --{flag} {value}: ")));
    }
}

#[test]
#[cfg(unix)]
fn an_interrupted_bootstrap_ends_with_the_replicates_drawn() {
    use std::io::Write as _;
    let data = words("curve --samples 2000").text();
    let mut child = gamow()
        .args(["fit", "--json", "--bootstrap", "10000000"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin.write_all(data.as_bytes()).expect("it reads");
    drop(stdin);
    // It says what it costs, once it can tell.
    let mut said = BufReader::new(child.stderr.take().expect("it is piped")).lines();
    let told = said.next().expect("it tells").expect("it is text");
    assert!(told.starts_with("gamow: 10000000 replicates take about "), "{told}");
    let kill = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(kill.expect("there is kill").success());
    let ended = said.next().expect("it tells").expect("it is text");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(0));
    let drawn = ended.strip_prefix("gamow: interrupted after ").and_then(|rest| rest.split(' ').next());
    let drawn: usize = drawn.and_then(|drawn| drawn.parse().ok()).expect("it says how many");
    let report = String::from_utf8(output.stdout).expect("it is text");
    assert!(report.contains(&format!("\"replicates\": {drawn},")), "{report}");
    let asked = run(gamow().args(["fit", "--json", "--bootstrap", &drawn.to_string()]), data.as_bytes());
    assert_eq!(asked.text(), report, "as if so many had been asked for");
}
