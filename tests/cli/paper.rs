//! `gamow paper`: all figures are there, and the report holds the known numbers.

use std::fs;
use std::path::Path;

use super::{Table, gamow, run};

#[test]
fn the_paper_is_reproduced_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("paper");
    run(gamow().args(["paper", "--out"]).arg(&out), b"").text();

    let figures = [
        "construction",
        "phi",
        "phi-difference",
        "theta",
        "theta-difference",
        "bicycle-2d",
        "bicycle-2d-one-eye",
        "bicycle-2d-two-eyes",
        "fit-phi",
        "fit-theta",
        "stereo-at-rest",
        "stereo-approaching",
        "stereo-abreast",
        "stereo-abreast-0.6",
        "stereo-receding",
    ];
    for figure in figures {
        let read = |extension: &str| {
            fs::read_to_string(out.join(format!("{figure}.{extension}"))).expect("the figure is there")
        };
        let (svg, csv) = (read("svg"), read("csv"));
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{figure}");
        let drawn: String = svg.split('"').filter(|part| !part.starts_with("data:")).collect();
        assert!(!drawn.contains("NaN") && !csv.contains("NaN"), "{figure}");
        let columns = csv.lines().map(|line| line.split(',').count());
        assert!(
            csv.lines().count() > 1 && columns.clone().all(|count| Some(count) == columns.clone().next())
        );
        // Its pictures are in it.
        let pictures: Vec<_> = svg.split("href=\"").skip(1).collect();
        assert_eq!(pictures.is_empty(), !figure.starts_with("stereo"), "{figure}");
        for picture in pictures {
            assert!(picture.starts_with("data:image/png;base64,iVBORw0KGgo"), "{figure}");
        }
    }

    let report = fs::read_to_string(out.join("report.md")).expect("the report is there");
    let rows = [
        "| least delta-phi, rad | -0.34 | -0.3295 | -0.0858 | -0.6678 |",
        "| largest delta-theta, rad | 0.19 | 0.2240 | 0.0045 | 0.3219 |",
        "| zeros of delta-theta, T | two, the later at 0.72 | 0.5667, 0.7228 | 0.5043, 0.7228 | 0.7228 |",
        "| time between these zeros as beta tends to 1 | tends to 0 | 0.1398 | 0.2025 | one zero |",
        "| 2, delta-phi | beta | 0.901(5) | 0.9000 |",
        "| joint | z | - | 2.0000 |",
        "| z | 2.01 | 0.06 | 0.08 | 2.00(8) |",
        "| paper | 0.0050 | 0.050 | 0.070 | 1 : 10 : 14 |",
        "- **E7.** ",
        "- **E8.** ",
        "- **E9.** ",
    ];
    for row in rows {
        assert!(report.contains(row), "{row} is missing from\n{report}");
    }
    // The paper has 15 figures and 3 tables.
    let numbers: Vec<&str> =
        report.split("![Fig. ").skip(1).filter_map(|rest| Some(rest.split_once(". ")?.0)).collect();
    assert_eq!(numbers, (1..=15).map(|number| number.to_string()).collect::<Vec<_>>());
    for table in ["\nTable 1, ", "\n| 2, delta-phi | ", "\n| 3, delta-theta | "] {
        assert!(report.contains(table), "{table}");
    }
    assert_the_construction_is_two_light_rays(&out);
    // What was found comes first.
    let places = ["1. **Parallax", "2. **The method", "3. **The paper's", "## Numbers", "## Errata"]
        .map(|part| report.find(part));
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{places:?}");

    let page = fs::read_to_string(out.join("report.html")).expect("the page is there");
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    assert_eq!(page.matches("<figure>\n<svg").count(), figures.len());
    assert!(page.contains("<td>least delta-phi, rad</td><td>-0.34</td><td>-0.3295</td>"));
    for outside in [".svg\"", ".png\""] {
        assert!(!page.contains(outside), "the page refers to a file");
    }
    assert!(!page.contains("<img"));
    assert_the_bicycle_can_be_worked_out_again(&out);
}

/// The numbers behind the figure are those of `gamow eval` for the T in their headers, to the last digit.
fn assert_the_bicycle_can_be_worked_out_again(out: &Path) {
    let csv = fs::read_to_string(out.join("bicycle-2d-two-eyes.csv")).expect("it is there");
    let table = Table::parsed(&csv);
    let (rest_x, rest_y) = (table.column("rest_x"), table.column("rest_y"));
    let gamma = 1.0 / (0.1_f64 * 1.9).sqrt();
    let columns: Vec<_> = table.names.iter().filter(|name| name.starts_with("x_")).collect();
    assert_eq!(columns.len(), 12);
    for name in columns {
        let (quantity, time) = name.split_once("_at_T_").expect("the time is there");
        let (column, model) = quantity.rsplit_once('_').expect("the model is there");
        let rows = rest_x.iter().zip(&rest_y).map(|(x, y)| format!("0.9,0.3,{y},0,{time},{}\n", x / gamma));
        let input = "beta,d,y,z,T,x0\n".to_owned() + &rows.collect::<String>();
        let seen = run(gamow().args(["eval", "--model", model]), input.as_bytes()).table().column(column);
        for (ours, seen) in table.column(name).iter().zip(&seen) {
            assert!((ours - seen).abs() < 1e-12 * (1.0 + seen.abs()), "{name}: {ours} is not {seen}");
        }
    }
}

/// Both events of Fig. 1 lie on the point's world line, and their light arrives at T.
fn assert_the_construction_is_two_light_rays(out: &Path) {
    let csv = fs::read_to_string(out.join("construction.csv")).expect("it is there");
    let table = Table::parsed(&csv);
    let [eye, x, distance, t, time] =
        ["eye_x", "event_x", "event_distance", "event_t", "T"].map(|name| table.column(name));
    for i in 0..2 {
        assert!((x[i] - 0.9 * t[i]).abs() < 1e-12, "it passes x = 0 at t = 0");
        assert!(((x[i] - eye[i]).hypot(distance[i]) - (time[i] - t[i])).abs() < 1e-12, "light goes at c");
    }
}
