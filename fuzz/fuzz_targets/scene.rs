//! Scene files.
#![no_main]

use gamow::scene::Scene;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = Scene::parse(text, "fuzz.toml");
});
