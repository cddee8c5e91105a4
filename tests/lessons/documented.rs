//! The example of the format's description is a lesson.

use gamow::lesson::{AnswerKind, Course, Lesson};

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
