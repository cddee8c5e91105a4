//! Bad input: one line that says where and what is wrong, exit status 2, and no output file.

use std::fs;

use super::{eval, gamow, run, words};

/// A good header and row.
const GOOD: &str = "beta,d,y,z,T\n0.9,0.3,0.5,0.5,0\n";

#[track_caller]
fn assert_complaint(input: impl AsRef<[u8]>, expected: &str) {
    assert_eq!(eval(input).complaint(), format!("gamow: standard input:{expected}"));
}

#[test]
fn header_faults_are_named() {
    let needed = "the header should name d, y, z, T and one of beta, gamma, rapidity, and it names";
    let no_header = "there is no header; it should name the columns, as in beta,d,y,z,T";
    assert_complaint("", &format!("1: {no_header}"));
    assert_complaint("\n\n", &format!("2: {no_header}"));
    assert_complaint("beta,d,z,T\n", &format!("1: column y is missing; {needed} beta, d, z, T"));
    assert_complaint(
        "beta|d|y|z|T\n",
        &format!("1: column beta, gamma or rapidity is missing; {needed} beta|d|y|z|T"),
    );
    assert_complaint("beta,d,y,z,t\n", &format!("1: column T is missing; {needed} beta, d, y, z, t"));
    assert_complaint(
        "beta,d,y,z,T, d\n",
        "1: column d is there twice, as fields 2 and 6; it should be there once",
    );
    assert_complaint(
        "beta,d,y,z,T,rapidity\n",
        "1: columns beta and rapidity both give the speed; there should be one of beta, gamma, rapidity",
    );
    assert_complaint(
        "beta,d,y,z,T,dphi\n",
        "1: column dphi is there already, and would be appended again; it should be dropped or renamed",
    );
}

#[test]
fn a_published_model_has_no_stereo_columns_and_says_so() {
    let said =
        "gamow: the model published has no stereo position: it measures both eyes' angles from the left eye";
    let eval = run(gamow().args(["eval", "--stereo", "--model", "published"]), GOOD.as_bytes());
    assert!(eval.stdout.is_empty());
    assert_eq!(eval.complaint(), said);
    let curve = words("curve --stereo --model published");
    assert!(curve.stdout.is_empty());
    assert_eq!(curve.complaint(), said);
}

#[test]
fn a_head_that_cannot_be_held_so_is_one_clear_line() {
    let published =
        "the model published has both eyes along the motion: the head can be neither tilted nor turned";
    let complaint = words("curve --roll 10 --model published").complaint();
    assert!(complaint.contains(published), "{complaint}");
    let input = "beta,d,y,z,T,roll\n0.9,0.3,0.5,0.5,0,181\n";
    let complaint = run(gamow().arg("eval"), input.as_bytes()).complaint();
    let said = "column roll: roll = 181.0 is out of range: it must be between -180 and 180, in degrees";
    assert!(complaint.contains(said), "{complaint}");
    let complaint =
        words("render --scene two-balls --geometry published --turn 5 --size 8x6 --out never.png")
            .complaint();
    assert!(complaint.contains(published), "{complaint}");
}

#[test]
fn a_stereo_column_that_is_there_is_taken_only_with_the_flag() {
    let input = "beta,d,y,z,T,stereo_x\n0.9,0.3,0.5,0.5,0,1\n";
    eval(input).text();
    let complaint = run(gamow().args(["eval", "--stereo"]), input.as_bytes()).complaint();
    assert!(complaint.contains("column stereo_x is there already"), "{complaint}");
}

#[test]
fn values_that_are_no_numbers_are_named() {
    let cases = [
        ("", "\"\" is empty; it should be a number"),
        ("  ", "\"\" is empty; it should be a number"),
        ("0,5", "\"0,5\" is not a number; it should be one such as 0.9 or 1e-3"),
        ("0.5 m", "\"0.5 m\" is not a number; it should be one such as 0.9 or 1e-3"),
        ("NaN", "\"NaN\" is not finite; it should be a number that a 64-bit float can hold"),
        ("-inf", "\"-inf\" is not finite; it should be a number that a 64-bit float can hold"),
        ("1e999", "\"1e999\" is not finite; it should be a number that a 64-bit float can hold"),
    ];
    for (value, problem) in cases {
        assert_complaint(format!("{GOOD}0.9,0.3,\"{value}\",0.5,0\n"), &format!("3: column y: {problem}"));
    }
    assert_complaint(
        "beta,d,y,z,T\n\x1b[31m\"\t,0.3,0.5,0.5,0\n",
        "2: column beta: \"\\u{1b}[31m\\\"\" is not a number; it should be one such as 0.9 or 1e-3",
    );
    assert_complaint(
        b"beta,d,y,z,T\n0.9,0.3,\xff\xfe,0.5,0\n",
        "2: column y: \"\u{fffd}\u{fffd}\" is not a number; it should be one such as 0.9 or 1e-3",
    );
}

#[test]
fn values_out_of_range_are_named() {
    let cases = [
        ("beta,d,y,z,T\n1,0.3,0.5,0.5,0\n", "beta: beta = 1 is out of range"),
        ("beta,d,y,z,T\n-0.1,0.3,0.5,0.5,0\n", "beta: beta = -0.1 is out of range"),
        ("gamma,d,y,z,T\n0.999,0.3,0.5,0.5,0\n", "gamma: gamma = 0.999 is out of range"),
        ("rapidity,d,y,z,T\n-1,0.3,0.5,0.5,0\n", "rapidity: rapidity = -1 is out of range"),
        ("rapidity,d,y,z,T\n710,0.3,0.5,0.5,0\n", "rapidity: rapidity = 710 is out of range"),
        ("beta,d,y,z,T\n0.9,-0.3,0.5,0.5,0\n", "d: d = -0.3 is out of range"),
        ("beta,d,y,z,T\n0.9,1e61,0.5,0.5,0\n", "d: d = 1e61 is out of range"),
        ("beta,d,y,z,T\n0.9,0.3,1e61,0.5,0\n", "y: y = 1e61 is not"),
        ("beta,d,y,z,T\n0.9,0.3,0.5,-1e61,0\n", "z: z = -1e61 is not"),
        ("beta,d,y,z,T\n0.9,0.3,0.5,0.5,1e61\n", "T: T = 1e61 is not"),
        ("beta,d,y,z,T,x0\n0.9,0.3,0.5,0.5,0,1e61\n", "x0: x0 = 1e61 is not"),
    ];
    for (input, expected) in cases {
        let complaint = eval(input).complaint();
        let expected = format!("gamow: standard input:2: column {expected}");
        assert!(complaint.starts_with(&expected), "{complaint} does not start as {expected}");
    }
}

#[test]
fn rows_of_the_wrong_length_are_named() {
    assert_complaint(format!("{GOOD}0.9,0.3,0.5\n"), "3: column z has no value; the row has 3 of 5 fields");
    assert_complaint(
        format!("{GOOD}0.9,0.3,0.5,0.5,0,rider\n"),
        "3: \"rider\" belongs to no column; the row has 6 fields, and should have 5",
    );
    assert_complaint(format!("{GOOD}# a remark\n"), "3: column d has no value; the row has 1 of 5 fields");
}

#[test]
fn quotes_that_swallow_the_rest_of_the_file_are_named() {
    let good = "0.9,0.3,0.5,0.5,0";
    assert_complaint(
        format!("{GOOD}0.9,0.3,0.5,0.5,\"0\n{good}\n"),
        "3: the quote that opens \"0\\n0.9,0.3,0.5,0.5,0\" is never closed",
    );
    assert_complaint(
        format!("beta,d,y,z,T,note\r\n{good},\"a\r\n{good},b\r\n{good},\"\"\r\n"),
        "2: the quote that opens \"a\\r\\n0.9,0.3,0.5,0.5,0,b\\r\\n0.9,0.3,0.5,0.5,0,\\\"\" is never closed",
    );
    let long = format!("3: the quote that opens \"{}…\" is never closed", "x".repeat(60));
    assert_complaint(format!("beta,d,y,z,T,note\n{good},\n{good},\"{}\n", "x".repeat(5000)), &long);
    for note in ["\"two\nlines\"", "\"two\nlines\"\n", "\"ends in one\n\"\n", "\"says \"\"hi\"\"\n\"\"\"\r\n"]
    {
        eval(format!("beta,d,y,z,T,note\n{good},{note}")).text();
    }
}

#[test]
fn line_numbers_count_every_line_of_the_file() {
    let bad = "x,0.3,0.5,0.5,0";
    let problem = "column beta: \"x\" is not a number; it should be one such as 0.9 or 1e-3";
    let good = "0.9,0.3,0.5,0.5,0";
    for (file, line) in [
        (format!("beta,d,y,z,T\r\n{good}\r\n{bad}\r\n"), 3),
        (format!("beta,d,y,z,T\n{good}\n\n\r\n\n{bad}"), 6),
        (format!("\n\nbeta,d,y,z,T\n{bad}\n{good}\n"), 4),
        (format!("\u{feff}beta,d,y,z,T\n{bad}\n"), 2),
    ] {
        assert_complaint(file, &format!("{line}: {problem}"));
    }
    assert_complaint(
        "note,beta,d,y,z,T\n\"two\nlines\",0.9,0.3,0.5,0.5,0\n\"three\r\nmore\nlines\",x,0.3,0.5,0.5,0\n",
        &format!("4: {problem}"),
    );
}

#[test]
fn line_numbers_are_right_far_beyond_one_buffer() {
    let rows = "0.9,0.3,0.5,0.5,0\r\n".repeat(20_000);
    let complaint = eval(format!("beta,d,y,z,T\r\n{rows}2,0.3,0.5,0.5,0\r\n")).complaint();
    assert!(complaint.starts_with("gamow: standard input:20002: column beta: beta = 2 "), "{complaint}");
}

#[test]
fn overflowing_intensity_is_named_and_not_written() {
    let outcome = run(gamow().args(["eval", "--intensity-exponent", "1000"]), b"gamma,d,y,z,T\n9,0,1,1,-9\n");
    let header = String::from_utf8_lossy(&outcome.stdout).lines().count();
    assert_eq!(header, 1);
    assert_eq!(
        outcome.complaint(),
        "gamow: standard input:2: column intensity_left: intensity_left comes out as inf, which cannot be \
         written; less extreme values or a smaller --intensity-exponent are needed"
    );
}

#[test]
fn rows_before_a_bad_one_reach_standard_output() {
    let outcome = eval(format!("{GOOD}0.9,0.3,y,0.5,0\n"));
    assert_eq!(String::from_utf8_lossy(&outcome.stdout).lines().count(), 2);
    outcome.complaint();
}

#[test]
fn files_are_named_as_given() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    fs::write(folder.path().join("rows.csv"), "beta,d,y,z,T\n2,0,0,0,0\n").expect("it is writable");
    let complaint = run(gamow().args(["eval", "rows.csv"]).current_dir(folder.path()), b"").complaint();
    assert!(complaint.starts_with("gamow: rows.csv:2: column beta: beta = 2 "), "{complaint}");
    for missing in ["nowhere.csv", "."] {
        let complaint = run(gamow().args(["eval", missing]).current_dir(folder.path()), b"").complaint();
        assert!(complaint.starts_with(&format!("gamow: {missing}: ")), "{complaint}");
    }
}

#[test]
fn flags_out_of_range_are_named_and_nothing_is_written() {
    for (arguments, expected) in [
        ("curve --beta 1", "beta = 1 is out of range: it must be at least 0 and below 1"),
        ("curve --gamma -5", "gamma = -5 is out of range: it must be between 1 and 1e30"),
        ("curve --d -1", "d = -1.0 is out of range: it must be between 0 and 1e60"),
        ("curve --y 1e61", "y = 1e61 is not a number between -1e60 and 1e60"),
        ("curve --from 2 --to 1", "--from 2 must be below --to 1"),
        ("curve --beta 0", "a point at rest never passes; --from and --to are needed"),
    ] {
        let outcome = words(arguments);
        assert_eq!(outcome.stdout, b"", "{arguments}");
        assert_eq!(outcome.complaint(), format!("gamow: {expected}"));
    }
}

#[test]
fn flags_that_make_no_sense_are_refused() {
    for arguments in [
        "curve --beta 0.5 --gamma 2",
        "curve --beta nan",
        "curve --y inf",
        "curve --z tall",
        "curve --samples 1",
        "curve --samples -3",
        "curve --speed 3",
        "eval --model imagined",
        "eval --intensity-exponent nan",
        "evaluate",
    ] {
        let outcome = words(arguments);
        assert_eq!((outcome.status, outcome.stdout.len()), (Some(2), 0), "{arguments}");
        let line = outcome.complaint();
        assert!(line.starts_with("gamow: ") && line.ends_with(" --help` says more"), "{arguments}: {line}");
    }
}

#[test]
fn a_file_is_called_what_it_is() {
    let cases = [
        ("--screenshot x.jpg", "gamow: --screenshot x.jpg: it writes .png files only; x.png would be right"),
        ("--screenshot a/x", "gamow: --screenshot a/x: it writes .png files only; a/x.png would be right"),
    ];
    for (arguments, expected) in cases {
        assert_eq!(words(arguments).complaint(), expected);
    }
}

#[test]
fn files_without_an_end_are_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let write =
        |name: &str, bytes: &[u8]| fs::write(folder.path().join(name), bytes).expect("it is writable");
    let complaint =
        |arguments: &str| run(gamow().args(arguments.split(' ')).current_dir(folder.path()), b"").complaint();
    write("blanks.toml", &vec![b'\n'; 5 << 20]);
    let too_long = "it is longer than 4 MB, the limit for such a file";
    for arguments in ["render --scene ./blanks.toml", "render --state ./blanks.toml"] {
        assert!(
            complaint(arguments).starts_with("gamow: ./blanks.toml: ")
                && complaint(arguments).ends_with(too_long)
        );
    }
    let row = "1".repeat(2 << 20);
    write("eval.csv", format!("{GOOD}\r\n{row}\n").as_bytes());
    write("fit.csv", format!("T,dphi\n\n0,{row}").as_bytes());
    let too_long =
        |line: u8| format!("the row that starts in line {line} is longer than 1 MB, the limit for a row");
    assert_eq!(complaint("eval eval.csv --out x.csv"), format!("gamow: eval.csv: {}", too_long(4)));
    assert_eq!(complaint("fit fit.csv --d 1"), format!("gamow: fit.csv: {}", too_long(3)));
    // Blank lines are no row, however many.
    let blank = "\n".repeat(3 << 20);
    assert_eq!(eval(format!("{blank}{GOOD}{blank}")).text(), eval(GOOD).text());
}

#[test]
fn a_picture_that_claims_to_be_huge_is_refused_by_its_size() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 65_535, 65_535);
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_chunk(png::chunk::IDAT, b"none").expect("into memory");
    drop(writer);
    fs::write(folder.path().join("big.png"), &bytes).expect("it is writable");
    for arguments in [
        "measure big.png --marker ff0000 --times 0 --d 0.1 --fov 50 --gaze 90,0",
        "rectify big.png --beta 0.5 --fov 50 --gaze 90,0 --out x.png",
    ] {
        let arguments = arguments.split(' ');
        let complaint = run(gamow().args(arguments).current_dir(folder.path()), b"").complaint();
        let expected = "gamow: big.png: it has 65535x65535 pixels; the limit is 67108864, those of 8192x8192";
        assert_eq!(complaint, expected);
    }
    let complaint =
        run(gamow().args(["measure", ".", "--object", "x"]).current_dir(folder.path()), b"").complaint();
    assert_eq!(complaint, "gamow: .: there is no .exr file");
}

#[test]
fn a_state_whose_scene_is_no_name_is_refused_with_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    for value in ["5", "true", "[1, 2]"] {
        fs::write(folder.path().join("a.toml"), format!("time = 1\nscene = {value}\n"))
            .expect("it is written");
        let render = ["render", "--state", "a.toml", "--out", "a.png"];
        let complaint = run(gamow().args(render).current_dir(folder.path()), b"").complaint();
        let said = "gamow: a.toml:2: scene: must be the name of a scene or of its file, in double quotes";
        assert_eq!(complaint, said);
    }
    fs::write(folder.path().join("a.toml"), "time = 1\nscene = \"stret\"\n").expect("it is written");
    let render = ["render", "--state", "a.toml", "--out", "a.png"];
    let complaint = run(gamow().args(render).current_dir(folder.path()), b"").complaint();
    assert!(
        complaint.starts_with(
            "gamow: a.toml:2: no scene is called `stret` (did you mean `street`?): there are street, "
        ),
        "{complaint}"
    );
}

#[test]
fn a_scene_with_names_of_a_megabyte_is_refused_before_it_is_large() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = "n".repeat(1_000_000);
    let scene = format!(
        "name = \"x\"\n[[object]]\nname = \"{name}\"\nrepeat = 1000\nshape = \"sphere\"\ncentre = [0, 3, 2]\nradius = 1\n"
    );
    fs::write(folder.path().join("a.toml"), scene).expect("it is written");
    let render = ["render", "--scene", "a.toml", "--out", "a.png"];
    let complaint = run(gamow().args(render).current_dir(folder.path()), b"").complaint();
    assert!(complaint.starts_with("gamow: a.toml:3: name = \"nnnn") && complaint.len() < 150, "{complaint}");
    assert!(!folder.path().join("a.png").exists());
}
