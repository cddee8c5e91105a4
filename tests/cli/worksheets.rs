//! `gamow lesson`: worksheets.

use std::path::{Path, PathBuf};

use super::{Outcome, gamow, run};

const LESSON: &str = "---
title: One & two
concept: Length contraction
minutes: 5
---

Of $\\gamma = {gamma:.3}$.

## First

```state
scene = \"two-balls\"
time = 2
[motion]
beta = 0.6
```

Two balls.

### Predict

By what is it contracted?

```number
truth = \"contraction\"
unit = \"times\"
decimals = 3
```

### Reveal

```play
beta = 0.8
```

### Observe

What did you see?

- [ ] It grew.
- [x] It shrank.

### Explain

Because of $\\frac{1}{\\gamma}$.

## In a sentence

The end of it.

## Lab

```state
[fit]
fit-samples = 12
```

Find the speed of $v/c = {beta:.1}$.
";

struct Folder(tempfile::TempDir);

impl Folder {
    fn with_lesson(text: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("own.md"), text).expect("it is written");
        Self(folder)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn worksheet(&self, name: &str, more: &[&str]) -> Outcome {
        let mut command = gamow();
        command.arg("lesson").arg(self.path("own.md")).arg("--worksheet").arg(self.path(name)).args(more);
        run(&mut command, b"")
    }
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("it is text")
}

#[test]
fn a_worksheet_asks_and_holds_its_answers_back() {
    let folder = Folder::with_lesson(LESSON);
    assert_eq!(folder.worksheet("sheet.html", &[]).text(), "");
    assert_eq!(folder.worksheet("answers.html", &["--answers"]).text(), "");
    let [sheet, answers] = ["sheet.html", "answers.html"].map(|name| read(&folder.path(name)));
    for page in [&sheet, &answers] {
        for told in
            ["One &amp; two", "Length contraction. 5 minutes.", "By what is it contracted?", "It shrank."]
        {
            assert!(page.contains(told), "{told} is missing");
        }
        assert!(!["http:", "https:", "<script", "{gamma"].iter().any(|foreign| {
            // Names of SVG's own spaces are no addresses that are loaded.
            page.replace("http://www.w3.org/", "").contains(foreign)
        }));
        assert_eq!(page.matches("data:image/png;base64,iVBORw0KGgo").count(), 1);
    }
    // 1/gamma is 0.8 at 0.6 c and 0.6 at 0.8 c; gamma is 1.25.
    assert!(sheet.contains("1.250") && !sheet.contains("0.600 times") && answers.contains("0.600 times"));
    assert!(!sheet.contains("The end of it.") && answers.contains("The end of it."));
    assert!(!sheet.contains('☒') && answers.contains("☒ It shrank."));
    assert!(sheet.contains("class=\"answer-lines\"") && !answers.contains("class=\"answer-lines\""));
}

/// A pupil's sheet gives nothing of the reveal away: neither its numbers nor a picture.
#[test]
fn a_worksheet_can_be_read_ahead() {
    let revealed = LESSON.replace("### Observe", "It was {contraction:.4}.\n\n### Observe").replace(
        "## In a sentence",
        "## Second\n\nAgain.\n\n### Predict\n\nAnd now?\n\n- [x] so\n- [ ] not so\n\n### Reveal\n\nSo.\n\n## In a sentence",
    );
    let folder = Folder::with_lesson(&revealed);
    folder.worksheet("sheet.html", &[]).text();
    folder.worksheet("answers.html", &["--answers"]).text();
    let [sheet, answers] = ["sheet.html", "answers.html"].map(|name| read(&folder.path(name)));
    assert!(answers.contains("It was 0.6000.") && !sheet.contains("0.6000") && !sheet.contains("0.80"));
    // The second step begins as the first was revealed.
    assert_eq!([&sheet, &answers].map(|page| page.matches("data:image/png").count()), [1, 2]);
    for once in ["Reveal it in the window.", "And now?"] {
        assert_eq!(sheet.matches(once).count(), if once == "And now?" { 1 } else { 2 }, "{once}");
    }
}

#[test]
fn the_page_of_whoever_teaches_has_aim_minutes_answers_and_advice() {
    let advised = LESSON.replace("## In a sentence", "### Teach\n\nMind the gap.\n\n## In a sentence");
    let folder = Folder::with_lesson(&advised);
    let mut command = gamow();
    let (own, page) = (folder.path("own.md"), folder.path("teacher.html"));
    assert_eq!(run(command.arg("lesson").arg(own).arg("--teacher").arg(&page), b"").text(), "");
    let page = read(&page);
    let told = [
        "Aim.",
        "The end of it.",
        "5 in all",
        "What to say.",
        "Two balls.",
        "0.600 times",
        "It grew.",
        "Mind the gap.",
    ];
    for told in told {
        assert!(page.contains(told), "{told} is missing");
    }
    folder.worksheet("sheet.html", &[]).text();
    assert!(!read(&folder.path("sheet.html")).contains("Mind the gap."));
}

/// The data that a worksheet carries, as `gamow fit` reads them, tell the speed as well as the worksheet
/// says.
#[test]
fn the_lab_of_a_worksheet_has_data_that_can_be_fitted() {
    let folder = Folder::with_lesson(LESSON);
    let mut command = gamow();
    let (own, sheet) = (folder.path("own.md"), folder.path("sheet.html"));
    run(command.arg("lesson").arg(own).arg("--lab").arg(&sheet), b"").text();
    let page = read(&sheet);
    let data = page.split("data:text/csv;base64,").nth(1).expect("data").split('"').next().expect("an end");
    let csv = decoded(data);
    assert_eq!(csv.lines().count(), 13, "{csv}");
    let command = page.split("<code>gamow ").nth(1).expect("a command").split('<').next().expect("an end");
    std::fs::write(folder.path("own.csv"), csv).expect("it is written");
    let mut fit = gamow();
    let fit = run(fit.args(command.split(' ')).arg("--json").current_dir(folder.0.path()), b"").text();
    let fit: serde_json::Value = serde_json::from_str(&fit).expect("it is JSON");
    let beta = &fit["parameters"]["beta"];
    let [value, error] = ["value", "uncertainty"].map(|name| beta[name].as_f64().expect("a number"));
    // The step was revealed at 0.8 c.
    assert!((value - 0.8).abs() < 5.0 * error, "{value} {error}");
    let told = page.split("<li>beta ± ").nth(1).expect("an uncertainty").split('<').next().expect("an end");
    let told: f64 = told.parse().expect("a number");
    assert!((told / error - 1.0).abs() < 0.5, "{told} {error}");
}

/// In the lab at rest nothing changes, and at the least speed no more than noise does.
#[test]
fn a_lab_that_cannot_be_fitted_is_named_with_its_line() {
    let heading = LESSON.lines().position(|line| line == "## Lab").expect("a lab");
    for beta in ["-0.0", "5e-324"] {
        let state = format!("fit-samples = 12\n[motion]\nbeta = {beta}");
        let folder = Folder::with_lesson(&LESSON.replace("fit-samples = 12", &state));
        for sheet in ["--lab", "--teacher"] {
            let mut command = gamow();
            command.arg("lesson").arg("own.md").arg(sheet).arg("sheet.html").current_dir(folder.0.path());
            let complaint = run(&mut command, b"").complaint();
            let place = format!("gamow: own.md:{}: the lab: ", heading + 4);
            assert!(complaint.starts_with(&place), "{complaint} for {place}");
        }
    }
}

/// What is written in base 64 (RFC 4648).
fn decoded(text: &str) -> String {
    let digit = |c: char| match c {
        'A'..='Z' => c as u32 - 'A' as u32,
        'a'..='z' => c as u32 - 'a' as u32 + 26,
        '0'..='9' => c as u32 - '0' as u32 + 52,
        '+' => 62,
        _ => 63,
    };
    let digits: Vec<u32> = text.trim_end_matches('=').chars().map(digit).collect();
    let bytes = digits.chunks(4).flat_map(|four| {
        let bits = four.iter().fold(0, |bits, digit| bits << 6 | digit) << (6 * (4 - four.len()));
        bits.to_be_bytes()[1..four.len()].to_vec()
    });
    String::from_utf8(bytes.collect()).expect("it is text")
}

#[test]
fn what_is_wrong_with_a_lesson_is_one_line_with_its_place() {
    let cases = [
        ("\\frac{1}{\\gamma}", "\\fraction{1}", "own.md:45: the formula $\\fraction{1}$"),
        ("{gamma:.3}", "{gama:.3}", "own.md:7: no value is called `gama`"),
        ("beta = 0.6", "beta = 6", "own.md:15: beta = 6"),
        ("two-balls", "three-balls", "no scene"),
        ("Two balls.", "Two balls:\n![balls](balls.png)", "own.md:19: a lesson's pictures are"),
    ];
    for (from, to, expected) in cases {
        let folder = Folder::with_lesson(&LESSON.replace(from, to));
        let complaint = folder.worksheet("sheet.html", &[]).complaint();
        assert!(complaint.contains(expected), "{complaint}\ninstead of {expected}");
        assert!(complaint.contains("own.md"), "{complaint}");
        assert!(!folder.path("sheet.html").exists());
    }
    let folder = Folder::with_lesson(LESSON);
    assert!(folder.worksheet("sheet.pdf", &[]).complaint().contains(".html"));
    let unknown = run(gamow().args(["lesson", "rodds", "--worksheet", "a.html"]), b"").complaint();
    let said = "gamow: no lesson is called `rodds` (did you mean `rods`?): there are rods, ";
    assert!(unknown.starts_with(said), "{unknown}");
}

/// Every field of a lesson reaches the page as text, never as markup or script.
#[test]
fn a_hostile_lesson_makes_a_harmless_page() {
    const SCRIPT: &str = "</title></h1></p><script>alert(1)</script><img src=x onerror='alert(2)'>";
    const LINKS: &str =
        "[a](javascript:alert(3)) [b](data:text/html,c) <file:///etc/passwd> <b onclick=\"alert(4)\">d</b>";
    let folder = tempfile::tempdir().expect("a folder");
    let both = format!("{SCRIPT} {LINKS}");
    let lesson = format!(
        "---\ntitle: {SCRIPT}\nconcept: {SCRIPT}\n---\n\n{both}\n\n## {SCRIPT}\n\n{both}\n\n### Predict\n\n{both}\n\n\
         ```number\ntruth = \"gamma\"\nunit = \"{SCRIPT}\"\n```\n\n### Reveal\n\n{both}\n\n### Observe\n\n{both}\n\n\
         - [ ] {both}\n- [x] {both}\n\n### Explain\n\n{both}\n\n## In a sentence\n\n{both}\n\n## Lab\n\n{both}\n\n\
         ```state\n[fit]\nfit-samples = 12\n```\n"
    );
    let name = "-<script>'&$(x).md";
    std::fs::write(folder.path().join(name), lesson).expect("it is written");
    let pages =
        [&["--worksheet"][..], &["--answers", "--worksheet"], &["--lab"], &["--teacher"]].map(|sheet| {
            let path = folder.path().join("page.html");
            let mut command = gamow();
            command.args(["lesson", &format!("./{name}")]).args(sheet).arg(&path).current_dir(folder.path());
            run(&mut command, b"").text();
            read(&path)
        });
    for page in &pages {
        assert_is_harmless(page);
    }
}

fn assert_is_harmless(page: &str) {
    let tags: Vec<&str> = page.split('<').skip(1).filter_map(|tag| tag.split('>').next()).collect();
    for tag in tags {
        // What stands between quotes is a value.
        let names: String = tag.split('"').step_by(2).collect::<String>().to_lowercase();
        assert!(!names.starts_with("script") && !names.contains(" on"), "{tag:.200}");
        let is_data =
            tag.contains("href=\"data:text/csv;base64,") || tag.contains("src=\"data:image/png;base64,");
        assert!(!(tag.contains("href=") || tag.contains("src=")) || is_data, "{tag:.200}");
    }
    assert_eq!(page.matches("</title>").count(), 1);
    // The command of the fit takes the file for a file.
    let commands = page.matches("gamow fit ").count();
    assert_eq!(
        page.matches("gamow fit './-&lt;script&gt;'\\''&amp;$(x).csv'").count(),
        commands,
        "{page:.0}"
    );
}
