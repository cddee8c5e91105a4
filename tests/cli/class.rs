//! `gamow lesson --class`: the page of a class.

use gamow::lesson::class::PupilAnswers;
use gamow::lesson::{Answer, AnswerKind, Confidence, Lesson, Library, Outcome, Record};

use super::{gamow, run};

/// A link with the answers of somebody who takes the choice of this number, or this number.
fn link(lesson: &Lesson, name: &str, choice: usize) -> String {
    let lesson = lesson.worked_out().expect("it can be worked out");
    let record = |step: &gamow::lesson::Step| {
        let answer = match &step.prediction.as_ref()?.kind {
            AnswerKind::Choice(_) => Answer::Choice(choice),
            AnswerKind::Number(_) => Answer::Number(choice as f64),
            _ => return None,
        };
        Some(Outcome::Made { answer, confidence: Some(Confidence::Sure) })
    };
    let records: Vec<Record> =
        lesson.steps.iter().map(|step| Record { outcome: record(step), observed: None }).collect();
    format!("gamow:?answers={}", PupilAnswers::new(&lesson, &records, name).token())
}

#[test]
fn the_column_of_a_table_and_standard_input_make_a_page() {
    let lesson = Library::own().open("rods").expect("it is one of the program's own");
    let folder = tempfile::tempdir().expect("a folder");
    let [table, page] = ["answers.csv", "class.html"].map(|name| folder.path().join(name));
    let row = |number| {
        let name = format!("P{number}");
        format!("12:0{number},\"{name}\",\"{}\",yes\r\n", link(&lesson, &name, 0))
    };
    let rows = (0..12).map(row).collect::<Vec<_>>().concat();
    std::fs::write(&table, format!("time,name,link,done\r\n{rows}x,y,answers=AAAA,no\r\n"))
        .expect("it is written");
    let mut command = gamow();
    command.args(["lesson", "rods", "--class"]).arg(&page).arg("--from").arg(&table).arg("-");
    let outcome = run(&mut command, link(&lesson, "Ada <b>", 1).as_bytes());
    assert_eq!((outcome.status, outcome.stdout.as_slice()), (Some(0), &b""[..]));
    let remark = "gamow: answers.csv:14: this link is damaged or cut off";
    assert!(outcome.stderr.starts_with(remark), "{}", outcome.stderr);
    let page = std::fs::read_to_string(&page).expect("it is text");
    for told in [
        "<h1>Class: Rods at 0.7 c</h1>",
        "13 pupils.",
        "<td>Ada &lt;b&gt;</td>",
        "<td>P11</td>",
        "Not read: 1 link.",
    ] {
        assert!(page.contains(told), "{told}: {page}");
    }
    let foreign = page.replace("http://www.w3.org/", "");
    assert!(!["http:", "https:", "<script", "<b>"].iter().any(|part| foreign.contains(part)));
}

#[test]
fn answers_that_are_not_there_are_one_line_and_no_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = folder.path().join("class.html");
    let complaint = |more: &[&str], input: &str| {
        let mut command = gamow();
        run(command.args(["lesson", "rods", "--class"]).arg(&page).args(more), input.as_bytes()).complaint()
    };
    assert!(complaint(&["--from", "-"], "none").contains("no answers to the lesson `rods` were found"));
    assert!(complaint(&["--from", "nowhere.csv"], "").contains("nowhere.csv"));
    assert!(complaint(&[], "").contains("--from"));
    let clocks = link(&Library::own().open("clocks").expect("a lesson"), "Ada", 0);
    assert!(complaint(&["--from", "-"], &clocks).contains("Answers to other lessons: clocks (1)."));
    assert!(!page.exists());
}
