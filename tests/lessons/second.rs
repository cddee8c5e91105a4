//! Lessons 7 to 12.

use super::support::lesson;

#[test]
fn the_second_lessons_are_worked_out() {
    for name in ["clocks", "two-eyes", "depth", "red-below", "measure-speed", "parallax"] {
        assert!(!lesson(name).sentence.is_empty(), "{name} has no sentence");
    }
}
