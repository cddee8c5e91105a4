//! `gamow paper`: all figures are there, and the report holds the known numbers.

use std::fs;

use super::{gamow, run};

#[test]
fn the_paper_is_reproduced_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("paper");
    run(gamow().args(["paper", "--out"]).arg(&out), b"").text();

    let figures = [
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
        assert!(!svg.contains("NaN") && !csv.contains("NaN"), "{figure}");
        let columns = csv.lines().map(|line| line.split(',').count());
        assert!(
            csv.lines().count() > 1 && columns.clone().all(|count| Some(count) == columns.clone().next())
        );
        for picture in svg.split("href=\"").skip(1) {
            let file = picture.split('"').next().expect("it is quoted");
            assert!(fs::metadata(out.join(file)).is_ok_and(|file| file.len() > 1000), "{figure}: {file}");
        }
    }

    let report = fs::read_to_string(out.join("report.md")).expect("the report is there");
    let rows = [
        "| least delta-phi, rad | -0.34 | -0.3295 | -0.0858 | -0.6678 |",
        "| largest delta-theta, rad | 0.19 | 0.2240 | 0.0045 | 0.3219 |",
        "| zeros of delta-theta, T | two, the later at 0.72 | 0.5667, 0.7228 | 0.5043, 0.7228 | 0.7228 |",
        "| delta-phi | beta | 0.901(5) | 0.9000000000 |",
        "| joint | z | - | 2.0000000000 |",
    ];
    for row in rows {
        assert!(report.contains(row), "{row} is missing from\n{report}");
    }
}
