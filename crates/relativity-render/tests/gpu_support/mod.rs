//! Running GPU tests: ignored without an adapter, failed where `GAMOW_REQUIRE_GPU=1` asks for one.

pub mod scenes;

use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};
use relativity_render::{Gpu, Renderers};

/// A test's name, and what it does with renderers on the device.
pub type Test = (&'static str, fn(&mut Renderers));

/// Runs `tests`, each with renderers of its own.
pub fn run(tests: &[Test]) -> ExitCode {
    let arguments = Arguments::from_args();
    let gpu = Gpu::headless();
    let is_required = std::env::var("GAMOW_REQUIRE_GPU").is_ok_and(|value| value == "1");
    let trial = |&(name, test): &Test| {
        let gpu = gpu.clone();
        let is_ignored = gpu.is_err() && !is_required;
        let run = move || {
            let gpu = gpu.map_err(|error| Failed::from(error.to_string()))?;
            test(&mut Renderers::new(Some(gpu)));
            Ok(())
        };
        Trial::test(name, run).with_ignored_flag(is_ignored)
    };
    libtest_mimic::run(&arguments, tests.iter().map(trial).collect()).exit_code()
}
