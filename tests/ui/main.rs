//! Drives the real window as a user would: by the names of its widgets, the mouse and the keys, without
//! a display. Numbers on screen are held against `relativity_core`, called directly.
//!
//! Needs a graphics adapter (a software one will do) and reports itself ignored where there is none;
//! with `GAMOW_REQUIRE_GPU=1` that is a failure.

/// The tests of a file: its functions, each with its own name, which is a claim.
macro_rules! trials {
    ($($(#[$attribute:meta])* $test:ident),+ $(,)?) => {
        &[$($(#[$attribute])* (stringify!($test), $test)),+]
    };
}

mod automatic;
mod comparison;
mod controls;
mod device;
mod documented;
#[path = "../documents/mod.rs"]
mod documents;
mod faults;
mod files;
mod first_sight;
mod fit;
mod groups;
mod handed_in;
mod insane;
mod kept;
mod layouts;
mod lessons;
mod light;
mod manners;
mod map;
mod measuring;
mod named_parts;
mod own_data;
mod painting;
mod pairs;
mod phone;
mod picking;
mod plots;
mod predictions;
mod presenting;
mod quality;
mod random_user;
mod ready;
mod riding;
mod saving;
mod screens;
mod sequence;
mod slide;
mod spacetime;
mod start;
mod start_page;
mod stereo;
mod stereoscope;
mod support;
mod targets;
mod time;
mod times;
mod two_keys;
mod way_back;
mod wheels;
mod words;

use std::process::ExitCode;

use libtest_mimic::{Arguments, Trial};

/// A named test.
type Test = (&'static str, fn());

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let is_required = std::env::var_os("GAMOW_REQUIRE_GPU").is_some_and(|value| value == "1");
    let all = [
        automatic::TESTS,
        comparison::TESTS,
        controls::TESTS,
        documented::TESTS,
        faults::TESTS,
        files::TESTS,
        first_sight::TESTS,
        fit::TESTS,
        groups::TESTS,
        handed_in::TESTS,
        insane::TESTS,
        kept::TESTS,
        layouts::TESTS,
        lessons::TESTS,
        light::TESTS,
        manners::TESTS,
        map::TESTS,
        measuring::TESTS,
        named_parts::TESTS,
        own_data::TESTS,
        painting::TESTS,
        pairs::TESTS,
        phone::TESTS,
        picking::TESTS,
        plots::TESTS,
        predictions::TESTS,
        presenting::TESTS,
        quality::TESTS,
        random_user::TESTS,
        ready::TESTS,
        riding::TESTS,
        saving::TESTS,
        screens::TESTS,
        sequence::TESTS,
        slide::TESTS,
        spacetime::TESTS,
        start::TESTS,
        start_page::TESTS,
        stereo::TESTS,
        stereoscope::TESTS,
        time::TESTS,
        times::TESTS,
        targets::TESTS,
        two_keys::TESTS,
        way_back::TESTS,
        wheels::TESTS,
        words::TESTS,
    ]
    .concat();
    let trial = |(name, test): Test, is_ignored| {
        let run = move || {
            test();
            Ok(())
        };
        Trial::test(name, run).with_ignored_flag(is_ignored)
    };
    let is_ignored = device::share().is_err() && !is_required;
    let trials = all.into_iter().map(|test| trial(test, is_ignored)).collect();
    libtest_mimic::run(&arguments, trials).exit_code()
}
