use proptest::prelude::*;

use super::*;
use crate::formula::markdown::Markdown;

const LESSON: &str = "\
---
title: Rods
order: 1
concept: Length contraction
minutes: 8
---

About rods: $1/\\gamma = {contraction:.2}$.

## Coming

```state
scene = \"rods\"
time = 3
[motion]
beta = 0.7
```

A rod comes.

### Predict

How long does it look?

- [ ] shorter
- [x] longer,
  by far
- [ ] as long

### Reveal

```play
time = 5
seconds = 2
```

### Observe

What did you see?

- [x] longer
- [ ] shorter

### Explain

Its rear is seen *earlier*.

## How fast

### Predict

```number
truth = \"contraction\"
unit = \"times\"
```

### Reveal

```state
motion.beta = 0.9
```

## In a sentence

Light is late.

## Lab

Measure.
";

fn read(text: &str) -> Result<Lesson, LessonError> {
    Lesson::read("rods", text, "rods.md")
}

#[test]
fn a_lesson_has_what_its_file_says() {
    let lesson = read(LESSON).expect("a lesson");
    assert_eq!((lesson.title.as_str(), lesson.order, lesson.minutes), ("Rods", 1, 8));
    assert_eq!(lesson.introduction.line, 8);
    let [coming, fast] = &lesson.steps[..] else { panic!("two steps") };
    assert_eq!(coming.text, Text { markdown: Markdown::new("A rod comes."), line: 19 });
    let Some(Prediction { question, kind: AnswerKind::Choice(options) }) = &coming.prediction else {
        panic!("a choice")
    };
    assert_eq!((question.markdown.source(), question.line), ("How long does it look?", 23));
    assert_eq!(options.right, 1);
    assert_eq!(options.texts[1].markdown.source(), "longer,\nby far");
    let reveal = coming.reveal.as_ref().expect("a reveal");
    assert_eq!(reveal.animation, Some(Animation { to: Animated::Time(5.0), seconds: 2.0 }));
    assert_eq!(coming.observation.as_ref().map(|asked| asked.options.right), Some(0));
    assert!(matches!(&fast.prediction, Some(Prediction { kind: AnswerKind::Number(_), .. })));
    assert_eq!(lesson.sentence.markdown.source(), "Light is late.");
    assert!(lesson.lab.is_some());
    let advice = LESSON.replace("## How fast", "### Teach\n\nShort?\n\n## How fast");
    assert_eq!(read(&advice).expect("a lesson").steps[0].teaching.markdown.source(), "Short?");
}

#[test]
fn a_lesson_is_read_as_other_editors_write_it() {
    let own = read(LESSON).expect("a lesson");
    let stars = LESSON.replace("- [", "* [").replace("[x]", "[X]");
    let tabs = LESSON.replace("- [", "-\t[").replace("  by far", "\tby far");
    for text in [format!("\u{feff}{LESSON}"), LESSON.replace('\n', "\r\n"), stars, tabs] {
        assert_eq!(read(&text), Ok(own.clone()));
    }
    // As Markdown permits it: other fences, indented ones, a choice whose next line is not indented.
    let waves = LESSON.replacen("```state", "~~~~state", 1).replace("beta = 0.7\n```", "beta = 0.7\n~~~~");
    let indented = LESSON.replace("```number", " ```number").replace("\"times\"\n```", "\"times\"\n ```");
    for text in [waves, indented, LESSON.replace("  by far", "by far")] {
        assert_eq!(read(&text), Ok(own.clone()), "{text}");
    }
}

#[test]
fn a_step_differs_from_the_last_one_as_it_was_revealed() {
    let lesson = read(&LESSON.replace("motion.beta = 0.9", "[motion]\nbeta = 0.9")).expect("a lesson");
    let default = crate::settings::Settings::default();
    let settings = |step, is_revealed| lesson.settings(step, is_revealed, &default).expect("settings");
    assert_eq!((settings(0, false).time, settings(0, true).time), (Some(3.0), Some(5.0)));
    assert_eq!((settings(1, false).time, settings(1, false).scene.as_str()), (Some(5.0), "rods"));
    assert_eq!([false, true].map(|shown| settings(1, shown).speed().beta()), [0.7, 0.9]);
}

#[test]
fn what_is_wrong_is_named_with_its_line() {
    let cases = [
        ("title: Rods\n", "", "rods.md:5: a lesson needs a title"),
        ("order: 1", "oder: 1", "rods.md:3: unknown key `oder`"),
        ("order: 1", "card: rod", "rods.md:3: card = rod: must be the name of a preset, or `step 3`"),
        ("order: 1", "card: step 3", "rods.md:1: card = step 3: there are 2 steps"),
        ("minutes: 8", "minutes: soon", "rods.md:5: minutes = soon: must be a whole number"),
        ("### Explain", "### Because", "rods.md:44: unknown part `Because`"),
        ("- [x] longer,", "- [ ] longer,", "rods.md:21: a list of choices has at least two"),
        ("seconds = 2", "second = 2", "rods.md:34: unknown field `second`"),
        ("time = 5\n", "time = 5\nbeta = 0.5\n", "rods.md:33: a block ```play sets one of"),
        ("time = 5\n", "time = -1e308\n", "rods.md:33: time = -1e308: must be between -1e12 and 1e12"),
        ("\"contraction\"", "\"contractions\"", "rods.md:53: no value is called `contractions`"),
        ("A rod comes.", "```play\ntime = 1\n```", "rods.md:19: a block ```play cannot stand here"),
        ("### Observe", "### Observed", "rods.md:37: unknown part"),
        ("### Observe", "### Reveal", "rods.md:37: a second `Reveal` in this step: the first is in line 30"),
    ];
    let more = [
        (
            "beta = 0.7\n```",
            "beta = 0.7",
            "rods.md:12: the block ```state has no end: a line ``` before line 31",
        ),
        (
            "\"times\"\n```",
            "\"times\"",
            "rods.md:52: the block ```number has no end: a line ``` before line 58",
        ),
        ("beta = 0.9\n```", "beta = 0.9", "rods.md:59: the block ```state has no end: a line ```"),
        (
            "truth = \"contraction\"",
            "truth = 3",
            "rods.md:53: invalid type: integer `3`, expected a string; such a block says `truth = \"gain\"`",
        ),
        (
            "time = 5",
            "time = \"5\"",
            "rods.md:33: invalid type: string \"5\", expected f64; such a block says `time = 5`",
        ),
    ];
    for (from, to, expected) in cases.into_iter().chain(more) {
        let text = LESSON.replacen(from, to, 1);
        assert_ne!(text, LESSON, "{from}");
        let error = read(&text).expect_err(from).to_string();
        assert!(error.starts_with(expected), "{error}\ninstead of {expected}");
        assert!(!error.contains('\n'), "{error}");
    }
    let wrong = read(&LESSON.replacen("beta = 0.7", "beta = 1.7", 1)).expect("it is read");
    let error = wrong.settings(0, false, &crate::settings::Settings::default()).expect_err("no speed");
    assert!(error.to_string().starts_with("rods.md:16: "), "{error}");
}

#[test]
fn what_cannot_be_worked_out_is_named_with_its_line() {
    let cases = [
        ("A rod comes.", "At {beta}.", "rods.md:19: `{beta}` is no place for a value: `{beta:.2}` is one"),
        (
            "A rod comes.",
            "At {gamma:3f}.",
            "rods.md:19: `{gamma:3f}` is no place for a value: `{gamma:.2}` is one",
        ),
        ("A rod comes.", "At $\\gamma = {gamma:3f}$.", "rods.md:19: `{gamma:3f}` is no place for a value"),
        ("A rod comes.", "At {gama}.", "rods.md:19: `{gama}` is no place for a value"),
        (
            "A rod comes.",
            "At {gama:.2}.",
            "rods.md:19: no value is called `gama`: there are 73; the nearest are gamma, gain",
        ),
        ("A rod comes.", "At {t of sphere:.2}.", "rods.md:19: Rods has no body called `sphere`: there are "),
        ("A rod comes.", "Its $\\frac{1}{2$ comes.", "rods.md:19: "),
        ("A rod comes.", "One,\nits $\\gamma comes.", "rods.md:20: a `$` without another one"),
        ("scene = \"rods\"", "scene = \"rod\"", "rods.md:13: "),
        ("scene = \"rods\"", "scene = \"rod.toml\"", "rods.md:13: "),
        ("motion.beta = 0.9", "scene = \"rod.toml\"", "rods.md:60: "),
        (
            "```number\ntruth = \"contraction\"\nunit = \"times\"",
            "```point\nbody = \"sphere\"",
            "rods.md:53: Rods has no body called `sphere`: there are ",
        ),
    ];
    for (from, to, expected) in cases {
        let text = LESSON.replacen(from, to, 1);
        assert_ne!(text, LESSON, "{from}");
        let error = read(&text).and_then(|lesson| lesson.worked_out()).expect_err(to).to_string();
        assert!(error.starts_with(expected), "{error}\ninstead of {expected}");
        assert!(!error.contains('\n'), "{error}");
    }
    for right in [r"It costs 3 \$.", r"A set \{beta}.", "`{beta}`", r"$x^{t} + \frac{T}{d}$"] {
        let text = LESSON.replacen("A rod comes.", right, 1);
        let lesson = read(&text).and_then(|lesson| lesson.worked_out());
        assert!(lesson.is_ok(), "{right}: {lesson:?}");
    }
}

#[test]
fn a_lesson_that_is_no_text_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let told = |name: &str| Lesson::load(&folder.path().join(name)).expect_err(name).to_string();
    gamow_platform::files::create_folder(&folder.path().join("folder.md")).expect("a folder");
    assert!(
        told("folder.md").ends_with("it is a folder; a lesson is a file of Markdown (.md)"),
        "{}",
        told("folder.md")
    );
    let path = folder.path().join("latin.md");
    std::fs::write(&path, b"---\ntitle: L\xe4nge\n---\n").expect("it is written");
    assert!(
        told("latin.md").ends_with("it is not text in UTF-8, as a lesson must be"),
        "{}",
        told("latin.md")
    );
}

proptest! {
    /// Broken files give either a lesson or one line with the error, whatever an editor leaves.
    #[test]
    fn a_broken_lesson_is_told_in_a_line(
        cut in any::<proptest::sample::Index>(),
        kept in any::<proptest::sample::Index>(),
        swapped in any::<[proptest::sample::Index; 2]>(),
        inserted in "(```|---|## |### Predict|- \\[x\\] |\\$|\\{D:.2\\}|é|\\PC{0,5})",
    ) {
        let mut lines: Vec<&str> = LESSON.lines().collect();
        let [a, b] = swapped.map(|index| index.index(lines.len()));
        lines.swap(a, b);
        let text = lines.join("\n");
        let place = |index: &proptest::sample::Index| {
            let place = index.index(text.len());
            (place..=text.len()).find(|place| text.is_char_boundary(*place)).unwrap_or(text.len())
        };
        let (from, to) = (place(&cut).min(place(&kept)), place(&cut).max(place(&kept)));
        for text in [format!("{}{inserted}{}", &text[..from], &text[to..]), format!("{}{inserted}", &text[..to])] {
            match read(&text).and_then(|lesson| lesson.worked_out()) {
                Ok(lesson) => prop_assert!(!lesson.steps.is_empty()),
                Err(error) => {
                    let told = error.to_string();
                    prop_assert!(told.starts_with("rods.md:") && !told.contains('\n'), "{}", told);
                }
            }
        }
    }
}

/// The error of the lesson with `with` in the place of `what`, once it is worked out.
fn refusal(what: &str, with: &str) -> String {
    let read = read(&LESSON.replacen(what, with, 1)).and_then(|lesson| lesson.worked_out());
    read.expect_err("it is too much").to_string()
}

#[test]
fn what_is_nested_too_deeply_is_refused_with_its_line() {
    let expected = "rods.md:19: quotes, lists and emphasis may be nested at most 16 deep";
    let nested = |begin: &str, end: &str, depth: usize| begin.repeat(depth) + "x" + &end.repeat(depth);
    for (begin, end) in [(">", ""), ("- ", ""), ("1. ", ""), ("> - ", ""), ("*a **b ", " c** d*")] {
        let text = nested(begin, end, 400);
        assert_eq!(refusal("A rod comes.", &text), expected, "{begin}");
        assert!(
            read(&LESSON.replace("A rod comes.", &nested(begin, end, 8)))
                .and_then(|lesson| lesson.worked_out())
                .is_ok()
        );
    }
}

#[test]
fn what_is_too_long_is_refused_with_its_line() {
    let long = "long ".repeat(2000);
    let expected = "rods.md:19: a text that is shown at once has at most 8 kB";
    assert_eq!(refusal("A rod comes.", &long), expected);
    assert_eq!(refusal("A rod comes.", &"long ".repeat(20_000)), "rods.md:1: a lesson has at most 64 kB");
    let expected = "rods.md:19: a text has at most 100 formulas";
    assert_eq!(refusal("A rod comes.", &"$x$ ".repeat(101)), expected);
    let formula = refusal("A rod comes.", &format!("${}$", "x".repeat(5000)));
    assert!(
        formula.starts_with("rods.md:19: the formula $xxx") && formula.ends_with("longer than 1024 bytes")
    );
    assert!(formula.len() < 200, "{formula}");
    let title = format!("## {}", "C".repeat(200));
    assert_eq!(refusal("## Coming", &title), "rods.md:10: a title has at most 100 letters");
    assert!(refusal("title: Rods", &format!("title: {long}")).starts_with("rods.md:2: title = long long"));
    let unit = refusal("\"times\"", &format!("\"{long}\""));
    assert!(unit.starts_with("rods.md:54: unit = long") && unit.ends_with("at most 100 letters"), "{unit}");
    let choice = refusal("- [ ] shorter", &"- [ ] shorter\n".repeat(21));
    assert_eq!(choice, "rods.md:45: a question has at most 20 choices");
    let step = refusal("## Lab", &("## More\n\nLook.\n\n".repeat(100) + "## Lab"));
    assert!(step.ends_with(": a lesson has at most 100 steps"), "{step}");
    let asked = format!("What?\n\n- [ ] {long}\n- [x] b\n\n### Reveal\n\n### Explain\n\n");
    let asked = refusal(
        "## Lab",
        &(format!("## More\n\n### Predict\n\n{}", asked.replace("long ", "long")).repeat(2) + "## Lab"),
    );
    assert!(
        asked.ends_with(": all questions and choices of a lesson have at most 12 kB together"),
        "{asked}"
    );
}

#[test]
fn errors_quote_little_of_a_file() {
    let long = "k".repeat(50_000);
    for (what, with) in [
        ("order: 1", format!("{long}: 1")),
        ("order: 1", long.clone()),
        ("### Explain", format!("### {long}")),
        ("{contraction:.2}", format!("{{{long}:.2}}")),
        ("{contraction:.2}", format!("{{contraction of {long}:.2}}")),
        ("\"contraction\"", format!("\"{long}\"")),
        ("unit =", format!("{long} =")),
        ("time = 5", format!("{long} = 5")),
        ("[motion]", format!("[{long}]")),
        ("beta = 0.7", format!("{long} = 0.7")),
        ("beta = 0.7", format!("beta = \"{long}\"")),
        ("scene = \"rods\"", format!("scene = \"{long}\"")),
    ] {
        let text = LESSON.replacen(what, &with, 1);
        // The paragraph of the value is longer than a text may be.
        let told = read(&text).and_then(|lesson| lesson.worked_out()).expect_err("it is wrong").to_string();
        assert!(
            told.starts_with("rods.md:") && told.len() < 1000,
            "{what}: {} letters: {told:.300}",
            told.len()
        );
    }
}

/// Slips that Markdown takes for text: each is named, with its line.
#[test]
fn slips_of_headings_and_blocks_are_named_with_their_line() {
    let slips = [
        ("```play\n", "```plaay\n", "unknown block ```plaay: there are ```state, "),
        ("## In a sentence", "## In a Sentence", "write `## In a sentence`"),
        ("## In a sentence", "## In a sentense", "write `## In a sentence`"),
        ("## Lab", "## lab", "write `## Lab`"),
        ("### Observe", "###Observe", "has a space behind its marks: `### Observe`"),
        ("### Observe", " ### Observe", "a heading begins its line"),
        ("### Observe", "#### Observe", "a heading begins its line"),
        ("## How fast", "##How fast", "has a space behind its marks: `## How fast`"),
    ];
    for (right, slip, expected) in slips {
        let text = LESSON.replacen(right, slip, 1);
        let line = text.lines().position(|line| line == slip.trim_end()).expect("it is there") + 1;
        let error = read(&text).expect_err(slip).to_string();
        assert!(error.starts_with(&format!("rods.md:{line}: ")) && error.contains(expected), "{error}");
        assert_eq!(error.lines().count(), 1);
    }
    for (slip, expected) in [
        ("One,\ntwo.\n---", "19: `One,`: a line of `-` or `=` below makes it a heading"),
        ("<div>\n## A step", "20: `## A step`: in HTML there is no heading"),
        (
            "- One\n  ```state\n  beta = 0.5\n  ```",
            "20: a block ```state stands by itself, not in a list or a quote",
        ),
        ("> ```number\n> truth = \"gain\"\n> ```", "19: a block ```number stands by itself"),
        ("<div>\n```state\nbeta = 0.5\n```", "20: a block ```state cannot stand in HTML"),
        ("One.\n\n    ```play", "21: a block ```play cannot stand in HTML or behind four spaces"),
        ("~~~\nText.", "19: the block ~~~ has no end: a line ~~~"),
        ("````state\n````no", "19: the block ````state has no end: a line ```` before line 20"),
    ] {
        let error = read(&LESSON.replacen("A rod comes.", slip, 1)).expect_err(slip).to_string();
        assert!(error.starts_with(&format!("rods.md:{expected}")), "{error}");
    }
    let fences = ["~~~\n## In a Sentence\n~~~", "````\n```state\n## A\n```\n````", "- a\n  ```\n  #b\n  ```"];
    for fine in ["```\n## In a Sentence\n```", "Number #7 of them.", "- # of turns"].into_iter().chain(fences)
    {
        read(&LESSON.replace("A rod comes.", fine)).expect(fine);
    }
    let closed = LESSON.replacen("## Lab", "## Lab ##", 1);
    assert_eq!(
        read(&closed).expect("marks behind a heading are none of it"),
        read(LESSON).expect("a lesson")
    );
}

/// Errors in the text below a block name the text's own line, and dollar signs in code begin no formula.
#[test]
fn text_around_blocks_keeps_its_lines() {
    let text = LESSON.replacen("```state", "Look.\n\n```state", 1);
    let told =
        |text: &str| read(text).and_then(|lesson| lesson.worked_out()).expect_err("it is wrong").to_string();
    let error = told(&text.replace("A rod comes.", "A $ rod."));
    assert!(error.starts_with("rods.md:21: a `$` without another one"), "{error}");
    let shell = text.replace("A rod comes.", "```\n$ gamow {beta}\n```");
    assert!(read(&shell).and_then(|lesson| lesson.worked_out()).is_ok());
}
