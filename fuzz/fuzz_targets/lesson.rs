//! Lessons.
#![no_main]

use gamow::lesson::Lesson;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = Lesson::read("fuzz", text, "fuzz.md");
});
