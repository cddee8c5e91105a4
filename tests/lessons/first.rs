//! Lessons 1 to 6.

use super::support::lesson;

#[test]
fn the_first_lessons_are_worked_out() {
    for name in ["rods", "what-gamow-drew", "light-is-late", "turned", "colour", "headlight"] {
        assert!(!lesson(name).sentence.is_empty(), "{name} has no sentence");
    }
}
