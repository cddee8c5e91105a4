//! The page counts what was made by hand.

use relativity_render::Gaze;

use super::*;
use crate::lesson::answer::{Answer, Confidence, Outcome};
use crate::lesson::{Library, Sight};

const LESSON: &str = r#"---
title: One & two
---

## Which

```state
scene = "cyclist"
time = -4
```

### Predict

Which?

- [ ] this
- [x] that $x$
- [ ] none

### Reveal

Look.

### Observe

Seen?

- [x] yes
- [ ] no

## How much

### Predict

By what?

```number
truth = "gamma"
unit = "times"
decimals = 2
within = 0.1
```

### Reveal

Look.

## Where

### Predict

Where is its front tyre seen?

```point
body = "front tyre"
```

### Reveal

```state
time = 3
```

## A curve

### Predict

How does it go?

```curve
of = "doppler"
from = 0
to = 3
```

### Reveal

Look.

## In a sentence

That.
"#;

fn lesson() -> Lesson {
    Lesson::read("own", LESSON, "own.md").expect("it is a lesson")
}

fn made(answer: Answer, confidence: Option<Confidence>) -> Record {
    Record { outcome: Some(Outcome::Made { answer, confidence }), observed: None }
}

/// The direction in which the tyre is seen after its reveal.
fn tyre(lesson: &Lesson) -> Gaze {
    let settings = lesson.settings(2, true, &Settings::default()).expect("it can be had");
    with_sight(&settings, |sight: &Sight<'_>| sight.direction("front tyre")).expect("it is in sight")
}

/// Five sets of answers: of three pupils who choose, of one who skips, and the raised hands of a class.
fn class(lesson: &Lesson) -> Collected {
    let worked_out = lesson.worked_out().expect("it can be worked out");
    let AnswerKind::Number(asked) = &worked_out.steps[1].prediction.as_ref().expect("it asks").kind else {
        panic!("a number")
    };
    let gamma = asked.truth.expect("it is worked out");
    let seen = tyre(&worked_out);
    let aside = Gaze { azimuth: seen.azimuth + 0.5, ..seen };
    let curve =
        |value: f64| Answer::Curve((0..=50).map(|part| [f64::from(part) * 0.1 - 2.0, value]).collect());
    let choice =
        |choice, confidence, observed| Record { observed, ..made(Answer::Choice(choice), confidence) };
    let skipped = Record { outcome: Some(Outcome::Skipped), observed: Some(1) };
    let pupils = [
        (
            "Ada",
            vec![
                choice(1, Some(Confidence::Sure), Some(0)),
                made(Answer::Number(gamma), None),
                made(Answer::Direction(seen), None),
                made(curve(1.0), None),
            ],
        ),
        (
            "Ben & Co",
            vec![
                choice(0, Some(Confidence::Sure), Some(1)),
                made(Answer::Number(2.0 * gamma), None),
                made(Answer::Direction(aside), None),
                made(curve(2.0), None),
            ],
        ),
        ("", vec![choice(1, Some(Confidence::Guess), None)]),
        ("Cleo", vec![skipped]),
        ("Class 9", vec![made(Answer::Votes(vec![4, 3, 2]), None)]),
    ];
    let links = pupils.map(|(name, mut records)| {
        records.resize(4, Record::default());
        format!("answers={}\n", PupilAnswers::new(&worked_out, &records, name).token())
    });
    Collected::from_text(&links.concat())
}

#[test]
fn answers_that_were_made_by_hand_are_counted() {
    let lesson = lesson();
    let page = page(&[&lesson], &class(&lesson), || {}).expect("it is a page");
    for told in [
        "<h1>Class: One &amp; two</h1>",
        "<p>5 pupils. Predictions: 4 of 7 right: 1 of 2 who were sure, 1 of 1 who guessed. Skipped: 1.</p>",
        "<p>2 of 3 right: 1 of 2 who were sure, 1 of 1 who guessed. Skipped: 1.</p>",
        "<p>1 of 2 right.</p>",
        "<tr><td>Ada</td><td>✓</td><td>✓</td><td>✓</td><td>·</td><td>3</td></tr>",
        "<tr><td>Ben &amp; Co</td><td>✗</td><td>✗</td><td>✗</td><td>·</td><td>0</td></tr>",
        "<tr><td>Class 9</td><td>·</td><td></td><td></td><td></td><td>0</td></tr>",
        "<tr><td>Cleo</td><td>–</td><td></td><td></td><td></td><td>0</td></tr>",
        "<tr><td>no name</td><td>✓</td>",
        "drawn curves</text>",
        "true curve</text>",
        "a pupil’s place</text>",
    ] {
        assert!(page.contains(told), "{told}: {page}");
    }
    // Of the choices: 1 and 4 hands, 2 and 3, none and 2; of what was seen one each.
    let counts: Vec<&str> =
        page.split("class=\"count\">").skip(1).filter_map(|rest| rest.split('<').next()).collect();
    assert_eq!(counts, ["5", "5", "2", "1", "2"]);
}

#[test]
fn answers_to_questions_that_were_rewritten_are_left_out() {
    let rewritten = Lesson::read("own", &LESSON.replace("Which?", "Which one?"), "own.md").expect("a lesson");
    let page = page(&[&rewritten], &class(&lesson()), || {}).expect("it is a page");
    assert!(
        page.contains("<p>Left out: 5 answers to questions that the lesson asks otherwise now.</p>"),
        "{page}"
    );
    assert!(page.contains("5 pupils. Predictions: 2 of 4 right."), "{page}");
}

#[test]
fn a_page_without_answers_is_none_and_why_is_told() {
    let lesson = lesson();
    let error = |text: &str| {
        page(&[&lesson], &Collected::from_text(text), || {}).expect_err("there are none").to_string()
    };
    assert_eq!(error(""), "no answers to the lesson `own` were found: links with answers contain answers=");
    assert!(
        error("answers=AAAA")
            .ends_with("; line 1: this link is damaged or cut off: ask for it again, or for the report")
    );
    let other = PupilAnswers { lesson: "clocks".to_owned(), name: String::new(), steps: Vec::new() };
    let other = format!("answers={}", other.token());
    assert_eq!(
        error(&other),
        "no answers to the lesson `own` were found. Answers to other lessons: clocks (1)."
    );
}

#[test]
fn one_pupils_answers_are_summed_up() {
    let lesson = lesson();
    let collected = class(&lesson);
    let right = |name: &str| {
        let pupil = collected.answers.iter().find(|pupil| pupil.name == name).expect("a pupil");
        right_of(&lesson, pupil).expect("it is a lesson")
    };
    assert_eq!((right("Ada"), right("Ben & Co"), right("Cleo")), ([3, 3], [0, 3], [0, 1]));
}

/// A link for each lesson of the program with all questions answered: short enough for a code.
#[test]
fn the_answers_to_every_lesson_fit_into_a_code() {
    for lesson in Library::own().all().iter().filter(|lesson| !lesson.is_a_preset()) {
        let lesson = lesson.worked_out().expect("it can be worked out");
        let records: Vec<Record> = lesson.steps.iter().map(answered).collect();
        let pupil = PupilAnswers::new(&lesson, &records, "Ada Lovelace");
        let token = pupil.token();
        let read = PupilAnswers::from_token(&token).expect("it was just written").records(&lesson);
        assert!(read.iter().zip(&records).all(|(read, record)| is_close(read, record)), "{}", lesson.name);
        let link = format!("https://example.org/gamow/#answers={token}");
        assert!(crate::lesson::class::QrCode::new(&link).is_some(), "{}: {}", lesson.name, token.len());
    }
}

/// A record with every question of `step` answered.
fn answered(step: &Step) -> Record {
    let answer = step.prediction.as_ref().map(|asked| match &asked.kind {
        AnswerKind::Choice(options) => Answer::Choice(options.texts.len() - 1),
        AnswerKind::Number(_) => Answer::Number(2.5),
        AnswerKind::Point(_) => Answer::Direction(Gaze { azimuth: 1.5, elevation: 0.1 }),
        AnswerKind::Curve(curve) => {
            let [low, high] = curve.range;
            let point = |part: i32| {
                let along = f64::from(part) / 120.0;
                [along * 12.0 - 6.0, low + (high - low) * along * along]
            };
            Answer::Curve((0..=120).map(point).collect())
        }
    });
    let made = |answer| Outcome::Made { answer, confidence: Some(Confidence::FairlySure) };
    Record { outcome: answer.map(made), observed: step.observation.as_ref().map(|asked| asked.options.right) }
}

/// Whether two records are the same, but for the heights of a curve.
fn is_close(a: &Record, b: &Record) -> bool {
    match (a.answer(), b.answer()) {
        (Some(Answer::Curve(a)), Some(Answer::Curve(b))) => {
            let highest = a.iter().fold(0.0, |most: f64, point| most.max(point[1].abs()));
            let near = |(a, b): (&[f64; 2], &[f64; 2])| {
                (a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 0.005 * highest
            };
            a.len() == b.len() && a.iter().zip(b).all(near)
        }
        _ => a == b,
    }
}
