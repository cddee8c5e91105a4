//! What is stored of a way through a lesson is taken up again.

use relativity_render::Gaze;

use super::*;
use crate::lesson::{Answer, Lesson, Record};

const LESSON: &str = "---\ntitle: T\n---\n\n## One\n\n### Predict\n\nWhich?\n\n- [ ] this\n- [x] that\n\n### Reveal\n\nSee.\n\n### Observe\n\nSeen?\n\n\
    - [x] yes\n- [ ] no\n\n### Explain\n\nSo.\n\n## Two\n\n### Predict\n\nWhich?\n\n- [ ] this\n- [x] that\n\n### Reveal\n\nSee.\n\n\
    ### Explain\n\nSo.\n\n\
    ## In a sentence\n\nThat.\n";

fn course(text: &str) -> Course {
    Course::new(&Lesson::read("x", text, "test.md").expect("a lesson")).expect("it can be worked out")
}

/// The way of `course` as a file gives it back.
fn read_again(before: &Course, course: &Course) -> LessonProgress {
    let mut answers = Answers::default();
    answers.note(before, course);
    let text = serde_json::to_string(answers.of("x").expect("it was begun")).expect("it can be written");
    serde_json::from_str(&text).expect("it can be read")
}

#[test]
fn a_way_is_taken_up_where_the_questions_are_still_the_same() {
    let (before, mut course) = (course(LESSON), course(LESSON));
    course.draft = Some(Answer::Choice(1));
    course.predict();
    course.observe(0);
    course.forward();
    course.draft = Some(Answer::Choice(0));
    let way = read_again(&before, &course);
    let mut again = before.clone();
    again.take_up(&way);
    assert_eq!(
        (again.records(), again.place(), &again.draft),
        (course.records(), course.place(), &course.draft)
    );
    let mut rewritten = self::course(&LESSON.replace("Seen?", "Seen now?"));
    rewritten.take_up(&way);
    assert_eq!(rewritten.records(), [Record::default(), Record::default()]);
}

#[test]
fn numbers_come_back_to_the_last_digit_and_none_spoils_the_file() {
    let before = course(LESSON);
    let numbers = [0.1 + 0.2, 1e308, 5e-324, -1.797_693_134_862_315_7e308, 2.225_073_858_507_201e-308];
    let stored = |answer: Answer| {
        let mut entering = before.clone();
        entering.draft = Some(answer);
        let text = serde_json::to_value(read_again(&before, &entering)).expect("it can be written");
        serde_json::from_value::<Option<Answer>>(text["draft"].clone()).expect("it can be read")
    };
    for number in numbers {
        assert_eq!(stored(Answer::Number(number)), Some(Answer::Number(number)));
    }
    for answer in [
        Answer::Number(f64::NAN),
        Answer::Number(f64::INFINITY),
        Answer::Curve(vec![[0.0, f64::NAN]]),
        Answer::Direction(Gaze { azimuth: f64::NAN, elevation: 0.0 }),
    ] {
        assert_eq!(stored(answer), None);
    }
}

#[test]
fn a_file_that_cannot_be_is_refused() {
    let (before, mut course) = (course(LESSON), course(LESSON));
    course.skip();
    let text = serde_json::to_string(&read_again(&before, &course)).expect("it can be written");
    for wrong in ["", "[]", "{", "{\"lesson\": 3}", "{\"lesson\": \"x\"}", &text[..text.len() / 2]] {
        assert!(serde_json::from_str::<LessonProgress>(wrong).is_err(), "{wrong}");
    }
}
