//! Lessons 7 to 12.

use super::support::lesson;

#[test]
fn the_second_lessons_are_worked_out() {
    for name in ["clocks", "two-eyes", "depth", "red-below", "measure-speed", "parallax"] {
        let l = lesson(name);
        println!("==== {name}\n{}", l.introduction.markdown);
        for s in &l.steps {
            println!("## {}\n{}", s.title, s.text.markdown);
            if let Some(p) = &s.prediction {
                println!(
                    "PREDICT {} {:?}",
                    p.question.markdown,
                    match &p.kind {
                        gamow::lesson::Kind::Number(n) => format!("{:?}", n.truth),
                        _ => String::new(),
                    }
                );
            }
            if let Some(r) = &s.reveal {
                println!("REVEAL {}", r.text.markdown);
            }
            println!("EXPLAIN {}", s.explanation.markdown);
        }
        println!("SENT {}\nLAB {}", l.sentence.markdown, l.lab.map(|l| l.text.markdown).unwrap_or_default());
    }
}
