//! The format's description: its examples are lessons, and its table of values is the program's.

use gamow::lesson::{AnswerKind, Course, Lesson, Library, values};

const DESCRIPTION: &str = include_str!("../../assets/lessons/README.md");

#[test]
fn the_examples_of_predictions_can_be_made() {
    let examples: Vec<&str> =
        DESCRIPTION.split("````markdown\n").skip(2).filter_map(|rest| rest.split("````").next()).collect();
    let mut names = Vec::new();
    for example in &examples {
        let step = "---\ntitle: Example\n---\n\n## One\n\n```state\nscene = \"rods\"\n```\n\n";
        let text = format!("{step}{example}\n### Reveal\n\nLook.\n");
        let lesson = Lesson::read("example", &text, "example.md").expect("a lesson");
        let course = Course::new(&lesson).expect("its values and its bodies are there");
        names.push(match &course.lesson().steps[0].prediction.as_ref().expect("a prediction").kind {
            AnswerKind::Choice(_) => "choice",
            AnswerKind::Number(_) => "number",
            AnswerKind::Point(_) => "point",
            AnswerKind::Curve(_) => "curve",
        });
    }
    assert_eq!(names, ["number", "point", "curve"]);
}

#[test]
fn the_example_of_the_description_can_be_gone_through() {
    let fences = DESCRIPTION.split("````markdown\n").nth(1).and_then(|rest| rest.split("````").next());
    let lesson = Lesson::read("example", fences.expect("an example"), "example.md").expect("a lesson");
    assert_eq!(lesson.steps.len(), 1);
    assert!(matches!(lesson.steps[0].prediction.as_ref().expect("a prediction").kind, AnswerKind::Choice(_)));
    let mut course = Course::new(&lesson).expect("its values and formulas are right");
    while course.can_go()[1] {
        course.forward();
    }
    assert_eq!(course.step(), None);
    assert_eq!(
        lesson.lab_settings(&gamow::settings::Settings::default()).expect("settings").fit.fit_samples,
        24
    );
}

/// `UPDATE_SNAPSHOTS=1` writes the table.
#[test]
fn the_table_of_values_is_that_of_the_program() {
    let head = "| value | |\n|---|---|\n";
    let (before, rest) = DESCRIPTION.split_once(head).expect("a table");
    let written: String = rest.split_inclusive('\n').take_while(|row| row.starts_with('|')).collect();
    let rows = values::all().map(|value| ["| `", value.name, "` | ", value.what, " |\n"].concat());
    let rows = rows.collect::<Vec<_>>().concat();
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/lessons/README.md");
        let after = &rest[written.len()..];
        std::fs::write(path, [before, head, &rows, after].concat()).expect("it is written");
    } else {
        assert_eq!(
            written, rows,
            "`UPDATE_SNAPSHOTS=1 cargo test --test program the_table_of_values` writes it"
        );
    }
}

/// The rows of a table: its cells, without their marks.
fn cells(page: &str) -> Vec<Vec<&str>> {
    let rows = page.lines().filter(|line| line.starts_with("| ")).map(|row| {
        let cells = row.trim_matches('|').split('|');
        cells.map(|cell| cell.trim().trim_matches('`')).collect::<Vec<_>>()
    });
    rows.filter(|cells| cells[0].parse::<u32>().is_ok()).collect()
}

#[test]
fn the_tables_of_lessons_are_those_of_the_program() {
    let library = Library::own();
    let lessons: Vec<_> = library.all().iter().filter(|lesson| !lesson.is_a_preset()).collect();
    let lists = cells(include_str!("../../docs/lessons.md"));
    let teachers = cells(include_str!("../../docs/for-teachers.md"));
    assert_eq!([lists.len(), teachers.len()], [lessons.len(); 2]);
    for ((lesson, list), teacher) in lessons.into_iter().zip(&lists).zip(&teachers) {
        let [order, minutes] = [lesson.order, lesson.minutes].map(|number| number.to_string());
        assert_eq!(list[..3], [&order, &lesson.title, &minutes]);
        assert_eq!([teacher[0], teacher[1], teacher[4]], [&order, &lesson.name, &minutes]);
    }
}
