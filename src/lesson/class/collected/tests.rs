//! Answers are found in whatever they were handed in.

use super::*;
use crate::lesson::answer::{Answer, Outcome, Record};
use crate::lesson::class::pupil::StepAnswers;

fn pupil(lesson: &str, name: &str, choice: usize) -> PupilAnswers {
    let outcome = Some(Outcome::Made { answer: Answer::Choice(choice), confidence: None });
    let steps = vec![Some(StepAnswers { asked: 1, record: Record { outcome, observed: None } })];
    PupilAnswers { lesson: lesson.to_owned(), name: name.to_owned(), steps }
}

#[test]
fn links_are_found_in_messages_tables_pages_and_other_links() {
    let all = ["Ada", "Ben", "Cleo", "Dan", "Eve"].map(|name| pupil("rods", name, 1));
    let [a, b, c, d, e] = all.clone().map(|pupil| pupil.token());
    let text = format!(
        "Hello, here it is: https://example.org/gamow/#answers={a}. Ada\r\n\
         12:01,\"Ben\",\"gamow:?answers={b}\",7\r\n\
         12:02;Cleo;gamow:?answers={c};8\n\
         <p><code>gamow:?answers={d}</code></p>\n\
         https://example.org/leave?url=https%3A%2F%2Fg.org%2F%23answers%3D{e}&x=1\n\
         Their answers are above: answers, answers=?\n"
    );
    let collected = Collected::from_text(&text);
    assert_eq!((collected.answers.as_slice(), collected.unread.len()), (&all[..], 0));
}

#[test]
fn of_the_same_name_the_last_remains() {
    let [first, last] = [pupil("rods", "Ada", 0), pupil("rods", "ADA", 1)];
    let other = pupil("clocks", "Ada", 0);
    let [nobody, nobody_else] = [pupil("rods", "", 0), pupil("rods", "", 1)];
    let text: String = [&first, &other, &nobody, &nobody_else, &nobody, &last]
        .map(|pupil| format!("gamow:?answers={}\n", pupil.token()))
        .concat();
    let collected = Collected::from_text(&text);
    assert_eq!(collected.answers, [last, other, nobody, nobody_else]);
    assert_eq!(collected.replaced, 2, "Ada's first, and the same link twice");
    assert_eq!(collected.of("clocks").count(), 1);
}

#[test]
fn links_that_cannot_be_read_are_named_by_their_lines() {
    let token = pupil("rods", "Ada", 0).token();
    let text = format!("\nanswers={}\nanswers={token}\nanswers=A\n", &token[1..]);
    let mut collected = Collected::default();
    collected.add("list.csv", &text);
    let told: Vec<_> = collected.unread.iter().map(ToString::to_string).collect();
    let damaged = TokenError::Damaged.to_string();
    assert_eq!(told, [format!("list.csv:2: {damaged}"), format!("list.csv:4: {damaged}")]);
    assert_eq!(collected.answers.len(), 1);
}

#[test]
fn more_pupils_than_a_school_has_are_left_out() {
    let link = |number: usize| format!("answers={}\n", pupil("rods", &format!("P{number}"), 0).token());
    let text: String = (0..MOST + 7).map(link).collect();
    let collected = Collected::from_text(&text);
    assert_eq!((collected.answers.len(), collected.beyond), (MOST, 7));
}

#[test]
fn a_table_in_utf_16_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("answers.csv");
    let text = format!("\u{feff}name\tlink\nAda\tgamow:?answers={}\n", pupil("rods", "Ada", 0).token());
    let bytes: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    std::fs::write(&path, bytes).expect("it is written");
    let mut collected = Collected::default();
    collected.add_file(&path).expect("it is a file");
    assert_eq!(collected.answers, [pupil("rods", "Ada", 0)]);
    assert!(collected.add_file(&folder.path().join("none.csv")).is_err());
}
