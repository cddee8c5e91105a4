//! Files of readings as spreadsheets, `NumPy`, R and the programs of laboratories write them, for
//! `gamow fit`.

use std::fmt::Write as _;

use serde_json::Value;

use super::{gamow, run, words};

/// Readings of the paper's point with d = 0.1: T, dphi and dtheta.
fn rows() -> Vec<[f64; 3]> {
    let table = words("curve --samples 60").table();
    let [times, dphi, dtheta] = ["T", "dphi", "dtheta"].map(|name| table.column(name));
    (0..times.len()).map(|row| [times[row], dphi[row], dtheta[row]]).collect()
}

/// A file with this header, a line for each row.
fn file(header: &str, line: impl Fn(usize, [f64; 3]) -> String) -> String {
    rows().into_iter().enumerate().fold(header.to_owned(), |mut text, (number, row)| {
        writeln!(text, "{}", line(number, row)).expect("strings grow");
        text
    })
}

fn commas(_: usize, [time, dphi, dtheta]: [f64; 3]) -> String {
    format!("{time},{dphi},{dtheta}")
}

/// The report on a file, and what was said of it on standard error.
fn read(bytes: &[u8]) -> (Value, String) {
    let outcome = run(gamow().args(["fit", "--d", "0.1", "--json", "--bootstrap", "0"]), bytes);
    assert_eq!(outcome.status, Some(0), "{}\n{}", outcome.stderr, String::from_utf8_lossy(&bytes[..80]));
    (serde_json::from_slice(&outcome.stdout).expect("JSON"), outcome.stderr)
}

/// Asserts that the file is the paper's point, with all its readings but so many, and that this is said of
/// it.
fn is_the_paper(bytes: &[u8], missing: u64, said: &str) {
    let (report, stderr) = read(bytes);
    for (name, truth) in [("beta", 0.9), ("y", 3.0), ("z", 2.0)] {
        let value = report["parameters"][name]["value"].as_f64().expect("a number");
        assert!((value - truth).abs() < 1e-7, "{name}: {value}");
    }
    assert_eq!(report["readings"], 120 - missing);
    let line = if said.is_empty() { String::new() } else { format!("gamow: standard input: {said}\n") };
    assert_eq!(stderr, line);
    assert_eq!(report["data"].as_str().unwrap_or_default(), said);
}

fn complaint(text: &str) -> String {
    run(gamow().args(["fit", "--d", "0.1"]), text.as_bytes()).complaint()
}

#[test]
fn comments_and_text_above_the_header_are_passed_over() {
    let plain = file("T,dphi,dtheta\n", commas);
    is_the_paper(plain.as_bytes(), 0, "");
    is_the_paper(format!("# {plain}").as_bytes(), 0, "the header is a comment");
    let above = format!("# 12 March\n\n# camera 2\n{plain}");
    is_the_paper(above.as_bytes(), 0, "3 lines passed over before the header");
    let above = format!("sep=,\nExperiment 4, left\n{plain}# end\n,,\n,,\n");
    let said =
        "2 lines passed over before the header; 1 comment passed over; 2 rows of empty fields passed over";
    is_the_paper(above.as_bytes(), 0, said);
    let tracker = "#multi:\t#\t#mass_A\t#\n#t\tdphi\tdtheta\n";
    let tabs = file(tracker, |number, row| commas(number, row).replace(',', "\t"));
    is_the_paper(tabs.as_bytes(), 0, "the header is a comment; 1 line passed over before the header");
}

/// Lines are counted in the file, whatever stands before the header.
#[test]
fn a_fault_below_a_preamble_is_found_in_its_line() {
    let fault = complaint("Experiment\n\nT,dphi\n0,0.1\n1,x\n");
    assert!(fault.starts_with("gamow: standard input:5: column dphi: \"x\""), "{fault}");
}

#[test]
fn blanks_separate_as_numpy_and_r_write_them() {
    let numpy = file("# T dphi dtheta\n", |_, [a, b, c]| format!("{a:.18e} {b:.18e} {c:.18e}"));
    is_the_paper(numpy.as_bytes(), 0, "the header is a comment");
    let aligned =
        file("       T      dphi     dtheta\n", |_, [a, b, c]| format!("{a:25.16} {b:25.18} {c:25.18}"));
    is_the_paper(aligned.as_bytes(), 0, "");
    let r = file("\"T\" \"dphi\" \"dtheta\"\n", |number, row| {
        let [a, b, c] = row;
        let c = if number == 7 { "NA".to_owned() } else { c.to_string() };
        format!("\"{}\" {a} {b} {c}", number + 1)
    });
    is_the_paper(r.as_bytes(), 1, "the first field of each row is its name; 1 reading not taken left out");
}

#[test]
fn readings_that_were_not_taken_are_left_out_and_counted() {
    let words = ["NaN", "nan", "NA", "#N/A", "-", "", "#NV", "n/a", "null", "#DIV/0!"];
    let text = file("T,dphi,dtheta,note,\n", |number, [time, dphi, dtheta]| match words.get(number) {
        Some(word) => format!("{time},{dphi},{word},\"a, b\",,,"),
        None => format!("{time},{dphi},{dtheta}, ,"),
    });
    is_the_paper(
        (text + ",0.1,0.2,,\n").as_bytes(),
        10,
        "1 row without a time left out; 10 readings not taken left out",
    );
}

#[test]
fn units_behind_names_and_below_them_are_converted() {
    let phyphox = file("\"Time (s)\";\"dphi (rad)\";\"dtheta [rad]\"\n", |_, [a, b, c]| {
        format!("{a:.16E};{b:.16E};{c:.16E}").replace('.', ",")
    });
    is_the_paper(phyphox.as_bytes(), 0, "");
    let logger = file("Latest: T (s),Latest: dphi (mrad),Latest: dtheta (mrad)\n", |_, [a, b, c]| {
        format!("{a},{},{}", 1e3 * b, 1e3 * c)
    });
    is_the_paper(logger.as_bytes(), 0, "dphi, dtheta converted from mrad to rad");
    let degrees = file("T / ms,dphi in deg,dtheta (°)\n", |_, [a, b, c]| {
        format!("{},{},{}", 1e3 * a, b.to_degrees(), c.to_degrees())
    });
    let said = "T converted from ms to s; dphi, dtheta converted from deg to rad";
    is_the_paper(degrees.as_bytes(), 0, said);
    let latin: Vec<u8> = degrees.chars().map(|letter| letter as u8).collect();
    is_the_paper(&latin, 0, said);
    let below = file("T,dphi,dtheta\n[ms],(deg),(deg)\n", |_, [a, b, c]| {
        format!("{},{},{}", 1e3 * a, b.to_degrees(), c.to_degrees())
    });
    is_the_paper(below.as_bytes(), 0, said);
}

#[test]
fn units_that_are_not_known_are_refused() {
    let pixels = complaint("T,dphi (px)\n0,0.1\n");
    assert!(
        pixels.contains(
            "column dphi: the unit \"px\" is not known; these are: rad, mrad, urad, deg, arcmin, arcsec"
        ),
        "{pixels}"
    );
    let below = complaint("T,dphi\ns,px\n0,0.1\n");
    assert!(below.contains("standard input:2: column dphi: the unit \"px\" is not known"), "{below}");
    let mixed = run(gamow().arg("fit"), b"T (s),d (m),dphi\n0,0.1,0.1\n").complaint();
    assert!(mixed.contains("column d: it is in m and the time in s, where c is not 1"), "{mixed}");
}

#[test]
fn utf_16_and_signs_of_typesetting_are_read() {
    let tabs = file("T\tdphi\tdtheta\r\n", |number, row| {
        commas(number, row).replace(',', "\t").replace('-', "\u{2212}") + "\r"
    });
    for order in [u16::to_le_bytes, u16::to_be_bytes] {
        let bytes: Vec<u8> = "\u{feff}".encode_utf16().chain(tabs.encode_utf16()).flat_map(order).collect();
        is_the_paper(&bytes, 0, "read as UTF-16");
    }
}

/// `gamow eval` passes its rows through, so that it takes of all this the encoding and what is above the
/// header.
#[test]
fn rows_to_evaluate_may_stand_below_a_preamble() {
    let plain = run(gamow().arg("eval"), b"beta,d,y,z,T\n0.9,0.1,3,2,4\n").text();
    let text = "Experiment\n# beta,d,y,z,T\n0.9,0.1,3,2,4\n";
    assert_eq!(run(gamow().arg("eval"), text.as_bytes()).text(), plain);
    let bytes: Vec<u8> =
        "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    assert_eq!(run(gamow().arg("eval"), &bytes).text(), plain);
}
