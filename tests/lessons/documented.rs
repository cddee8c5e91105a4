//! The example of the format's description is a lesson.

use gamow::lesson::{Course, Kind, Lesson};

const DESCRIPTION: &str = include_str!("../../assets/lessons/README.md");

#[test]
fn the_example_of_the_description_can_be_gone_through() {
    let fences = DESCRIPTION.split("````markdown\n").nth(1).and_then(|rest| rest.split("````").next());
    let lesson = Lesson::read("example", fences.expect("an example"), "example.md").expect("a lesson");
    assert_eq!(lesson.steps.len(), 1);
    assert!(matches!(lesson.steps[0].prediction.as_ref().expect("a prediction").kind, Kind::Choice(_)));
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
