//! Merging loses nothing, whatever two windows do and whenever they write.

use std::sync::LazyLock;

use proptest::prelude::*;
use relativity_render::Gaze;

use super::*;
use crate::lesson::{Answer, Lesson, Outcome, Record};

const LESSON: &str = "---\ntitle: T\n---\n\n## One\n\n### Predict\n\nWhich?\n\n- [ ] this\n- [x] that\n\n### Reveal\n\nSee.\n\n### Observe\n\nSeen?\n\n\
    - [x] yes\n- [ ] no\n\n### Explain\n\nSo.\n\n## Two\n\n### Predict\n\nWhich?\n\n- [ ] this\n- [x] that\n\n### Reveal\n\nSee.\n\n\
    ### Explain\n\nSo.\n\n\
    ## In a sentence\n\nThat.\n";

fn lesson(name: &str) -> Lesson {
    Lesson::read(name, LESSON, "test.md").expect("a lesson")
}

fn course(name: &str) -> Course {
    Course::new(&lesson(name)).expect("it can be worked out")
}

/// The beginnings of two lessons, which take longer to read than to go through.
static COURSES: LazyLock<[Course; 2]> = LazyLock::new(|| ["x", "y"].map(course));

/// `course` where this is being entered.
fn entering(course: &Course, answer: Answer) -> Course {
    let mut course = course.clone();
    course.draft = Some(answer);
    course
}

/// Something that somebody does in a window.
#[derive(Debug, Clone)]
enum Deed {
    /// Predict this in the present step.
    Predict(usize),
    /// Goes on without an answer.
    Skip,
    Observe(usize),
    Forward,
    Back,
    /// Begin to enter this.
    Enter(usize),
    Clear,
    /// Write, and read what others have written.
    Sync,
}

fn deed() -> impl Strategy<Value = Deed> {
    prop_oneof![
        4 => (0..2_usize).prop_map(Deed::Predict),
        1 => Just(Deed::Skip),
        2 => (0..2_usize).prop_map(Deed::Observe),
        4 => Just(Deed::Forward),
        2 => Just(Deed::Back),
        1 => (0..2_usize).prop_map(Deed::Enter),
        1 => Just(Deed::Clear),
        3 => Just(Deed::Sync),
    ]
}

/// A window: the lesson that is gone through there, and the answers it knows.
struct Window {
    course: Course,
    answers: Answers,
}

impl Window {
    fn new() -> Self {
        Self { course: COURSES[0].clone(), answers: Answers::default() }
    }

    fn does(&mut self, deed: &Deed, now: Timestamp, file: &mut Answers) {
        let before = self.course.clone();
        match deed {
            Deed::Predict(choice) => {
                self.course.draft = Some(Answer::Choice(*choice));
                self.course.predict();
            }
            Deed::Skip => self.course.skip(),
            Deed::Observe(answer) => {
                if self.course.step().is_some_and(|step| step.observation.is_some()) {
                    self.course.observe(*answer);
                }
            }
            Deed::Forward => self.course.forward(),
            Deed::Back => self.course.back(),
            Deed::Enter(choice) => self.course.draft = Some(Answer::Choice(*choice)),
            Deed::Clear => {
                self.course.begin_anew();
                self.answers.clear(self.course.lesson(), now);
            }
            Deed::Sync => {
                self.answers.merge(file);
                *file = self.answers.clone();
            }
        }
        self.answers.note(&before, &self.course, now);
    }
}

/// Answers of several lessons after these deeds in one window.
fn after(lesson: usize, deeds: &[Deed], begin: Timestamp) -> Answers {
    let mut window = Window { course: COURSES[lesson].clone(), answers: Answers::default() };
    for (passed, deed) in deeds.iter().enumerate() {
        window.does(deed, begin + passed as Timestamp, &mut Answers::default());
    }
    window.answers
}

fn merged(mut one: Answers, other: &Answers) -> Answers {
    one.merge(other);
    one
}

fn answers() -> impl Strategy<Value = Answers> {
    // Few dates, so that some are equal.
    let one = (0..2_usize, prop::collection::vec(deed(), 0..12), 1..6_u64);
    prop::collection::vec(one, 1..3).prop_map(|all| {
        let all = all.iter().map(|(lesson, deeds, begin)| after(*lesson, deeds, *begin));
        all.fold(Answers::default(), |sum, next| merged(sum, &next))
    })
}

proptest! {
    #[test]
    fn merging_is_commutative_associative_and_idempotent(a in answers(), b in answers(), c in answers()) {
        prop_assert_eq!(merged(a.clone(), &b), merged(b.clone(), &a));
        prop_assert_eq!(merged(merged(a.clone(), &b), &c), merged(a.clone(), &merged(b, &c)));
        prop_assert_eq!(merged(a.clone(), &a), a);
    }

    /// Deeds of two windows in turns, each 10 ms after the one before; they write when they like, and at their ends. Then the
    /// file holds, of each question, the answer given last in whichever window, unless the lesson was cleared after it.
    #[test]
    fn of_two_windows_no_answer_is_lost(deeds in prop::collection::vec((0..2_usize, deed()), 0..40)) {
        let (mut file, mut windows) = (Answers::default(), [Window::new(), Window::new()]);
        let mut expected = vec![Record::default(); 2];
        for (passed, (number, deed)) in deeds.iter().enumerate() {
            let window = &mut windows[*number];
            let before = window.course.records().to_vec();
            window.does(deed, 1000 + 10 * passed as Timestamp, &mut file);
            if matches!(deed, Deed::Clear) {
                expected.fill(Record::default());
                continue;
            }
            for (expected, (old, new)) in expected.iter_mut().zip(before.iter().zip(window.course.records())) {
                if new.outcome != old.outcome {
                    expected.outcome.clone_from(&new.outcome);
                }
                if new.observed != old.observed {
                    expected.observed = new.observed;
                }
            }
        }
        for window in &mut windows {
            window.does(&Deed::Sync, 9999, &mut file);
        }
        let lesson = COURSES[0].lesson();
        let kept = |number: usize| file.progress(lesson).map_or_else(Record::default, |way| way.record(lesson, number));
        prop_assert_eq!(vec![kept(0), kept(1)], expected);
        prop_assert_eq!(Answers::of_text(&file.to_text()), Ok(file));
    }
}

#[test]
fn an_old_window_does_not_bring_back_what_another_has_answered_since() {
    let (mut file, mut old, mut new) = (Answers::default(), Window::new(), Window::new());
    old.does(&Deed::Predict(0), 1, &mut file);
    old.does(&Deed::Sync, 2, &mut file);
    new.does(&Deed::Predict(1), 3, &mut file);
    new.does(&Deed::Sync, 4, &mut file);
    // It still shows its own answer to the first question, passes over what was seen, and answers the second.
    for deed in [Deed::Forward, Deed::Forward, Deed::Forward, Deed::Predict(0), Deed::Sync] {
        old.does(&deed, 5, &mut file);
    }
    let (lesson, made) =
        (lesson("x"), |choice| Some(Outcome::Made { answer: Answer::Choice(choice), confidence: None }));
    let way = file.progress(&lesson).expect("it was begun");
    assert_eq!([0, 1].map(|step| way.record(&lesson, step).outcome), [made(1), made(0)]);
}

#[test]
fn an_answer_is_later_than_all_that_is_known_even_where_the_clock_was_set_back() {
    let (mut file, mut window) = (Answers::default(), Window::new());
    window.does(&Deed::Observe(0), 1_000_000, &mut file);
    window.does(&Deed::Observe(1), 5, &mut file);
    window.does(&Deed::Sync, 6, &mut file);
    assert_eq!(file.progress(&lesson("x")).expect("it was begun").record(&lesson("x"), 0).observed, Some(1));
}

#[test]
fn numbers_come_back_to_the_last_digit_and_none_spoils_the_file() {
    let (before, mut answers) = (course("x"), Answers::default());
    let mut draft = |answer: Answer, now| {
        answers.note(&before, &entering(&before, answer), now);
        Answers::of_text(&answers.to_text()).expect("it can be read").0["x"]
            .draft
            .clone()
            .map(|draft| draft.value.answer)
    };
    for (now, number) in [0.1 + 0.2, 1e308, 5e-324, -1.797_693_134_862_315_7e308, 2.225_073_858_507_201e-308]
        .into_iter()
        .enumerate()
    {
        assert_eq!(draft(Answer::Number(number), now as Timestamp), Some(Some(Answer::Number(number))));
    }
    for answer in [
        Answer::Number(f64::NAN),
        Answer::Number(f64::INFINITY),
        Answer::Curve(vec![[0.0, f64::NAN]]),
        Answer::Direction(Gaze { azimuth: f64::NAN, elevation: 0.0 }),
    ] {
        assert_eq!(draft(answer, 100), Some(None));
    }
}

#[test]
fn a_file_of_many_long_ways_is_as_long_as_one_that_is_read_and_has_the_latest() {
    let answer = Answer::Curve(vec![[0.123_456_789, -9.876_543_21]; 3000]);
    let mut answers = Answers::default();
    for number in 0..70 {
        let before = course(&format!("lesson {number:03}"));
        answers.note(&before, &entering(&before, answer.clone()), number);
    }
    let text = answers.to_text();
    assert!(text.len() as u64 <= TEXT_BYTES && text.len() as u64 > TEXT_BYTES / 2, "{} bytes", text.len());
    let read = Answers::of_text(&text).expect("it can be read");
    assert!(read.0.contains_key("lesson 069") && !read.0.contains_key("lesson 000"));
    assert!(read.0.len() <= MOST_WAYS);
}

#[test]
fn a_file_that_cannot_be_is_refused() {
    let mut answers = after(0, &[Deed::Predict(0)], 7);
    let text = answers.to_text();
    assert!(Answers::of_text(&text).is_ok());
    for wrong in ["", "[]", "{", "{\"x\": 3}", "{\"x\": {\"place\": {\"at\": -1}}}", &text[..text.len() / 2]]
    {
        assert!(Answers::of_text(wrong).is_err(), "{wrong}");
    }
    assert!(Answers::of_text(&text.replace("\"at\":7", "\"at\":9007199254740992")).is_err());
    let way = answers.0.get_mut("x").expect("it was begun");
    way.steps.push(way.steps[0].clone());
    assert!(Answers::of_text(&answers.to_text()).is_err_and(|problem| problem.contains("two entries")));
}
