//! `gamow fit` of readings of which some stand out: they are named by their lines, and a robust loss has them
//! count less.

use serde_json::Value;

use super::{gamow, run, words};

/// Readings of the paper's point with even noise, where rows are moved by so much.
fn readings(moved: &[(usize, f64)]) -> String {
    let curve = words("curve --samples 60").table();
    let [times, dphi, dtheta] = ["T", "dphi", "dtheta"].map(|name| curve.column(name));
    let noise = |row: usize| 2e-4 * (((row * row + 3 * row) as f64 * 0.618_033_988_749_895).fract() - 0.5);
    (0..times.len()).fold("# by hand\nT,dphi,dtheta\n".to_owned(), |text, row| {
        let off = moved.iter().find(|(at, _)| *at == row).map_or(0.0, |(_, by)| *by);
        text + &format!(
            "{},{},{}\n",
            times[row],
            dphi[row] + noise(2 * row),
            dtheta[row] + noise(2 * row + 1) + off
        )
    })
}

fn report(csv: &str, flags: &str) -> (Value, String) {
    let command = format!("fit --d 0.1 --bootstrap 200 {flags}");
    let fit = |more: &[&str]| run(gamow().args(command.split_whitespace()).args(more), csv.as_bytes());
    let json = serde_json::from_slice(&fit(&["--json"]).stdout).expect("JSON");
    (json, String::from_utf8(fit(&[]).stdout).expect("text"))
}

#[test]
fn readings_that_stand_out_are_named_by_their_lines() {
    let (json, table) = report(&readings(&[(20, 0.004), (50, -0.003)]), "");
    let outliers = json["outliers"].as_array().expect("a list");
    let places: Vec<_> =
        outliers.iter().map(|found| (found["line"].as_u64(), found["curve"].as_u64())).collect();
    // Two lines stand above the rows.
    assert_eq!(places, [(Some(23), Some(1)), (Some(53), Some(1))]);
    assert!(outliers[0]["deviation"].as_f64() > Some(5.0) && outliers[1]["deviation"].as_f64() < Some(-5.0));
    let line = table.lines().find(|line| line.starts_with("outliers ")).expect("a line");
    assert!(line.contains("readings stand out, in standard deviations: dtheta in line 23 by "), "{line}");
}

#[test]
fn readings_with_even_noise_have_none_that_stands_out() {
    let (json, table) = report(&readings(&[]), "");
    assert!(json["outliers"].is_null() && !table.contains("stand out"), "{table}");
}

#[test]
fn a_robust_loss_keeps_a_gross_outlier_from_moving_the_fit() {
    let [good, bad] = [&[][..], &[(20, 0.3)]].map(readings);
    let z = |csv: &str, flags: &str| {
        let (json, table) = report(csv, flags);
        let z = &json["parameters"]["z"];
        ([&z["value"], &z["uncertainty"]].map(|number| number.as_f64().expect("a number")), json, table)
    };
    for (flags, name, scale) in [
        ("--loss soft-l1", "soft-l1", 1.287),
        ("--loss soft_l1", "soft-l1", 1.287),
        ("--loss huber --loss-scale 2", "huber", 2.0),
        ("--loss cauchy", "cauchy", 2.385),
    ] {
        let ([expected, _], ..) = z(&good, flags);
        let ([found, uncertainty], json, table) = z(&bad, flags);
        assert!((found - expected).abs() < uncertainty, "{flags}: {found} for {expected} +- {uncertainty}");
        assert!((found - 2.0).abs() < 4.0 * uncertainty, "{flags}: {found} +- {uncertainty}");
        assert_eq!(
            (json["loss"]["name"].as_str(), json["loss"]["scale"].as_f64()),
            (Some(name), Some(scale))
        );
        // Even noise of half a width of 1e-4.
        let scatter = json["loss"]["scatter_dtheta"].as_f64().expect("a number");
        assert!((3e-5..1.2e-4).contains(&scatter), "{scatter}");
        let line = table.lines().find(|line| line.starts_with("loss ")).expect("a line");
        assert!(
            line.contains(&format!("{name}, readings count less from {scale} standard deviations")),
            "{line}"
        );
        assert!(table.contains("a reading stands out, in standard deviations: dtheta in line 23"), "{table}");
    }
    let linear = run(gamow().args("fit --d 0.1 --loss-scale 2".split_whitespace()), good.as_bytes());
    assert_eq!(linear.status, Some(2));
    assert!(linear.stderr.contains("--loss-scale: the loss linear has no scale"));
}
