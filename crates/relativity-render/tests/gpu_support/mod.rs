//! Running GPU tests: ignored without an adapter, failed where `GAMOW_REQUIRE_GPU=1` asks for one.

pub mod scenes;

use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};
use relativity_render::{Gpu, Renderers};

/// A test's name, and what it does with renderers on the device that all share.
pub type Test = (&'static str, fn(&mut Renderers));

/// A test's name, and what it does with a device of its own: one that it may break, or that no other test
/// uses.
pub type OwnDeviceTest = (&'static str, fn());

/// The name of a file of tests, and those in it.
pub type File<T> = (&'static str, &'static [T]);

/// Runs the tests of `shared`, each with renderers of its own on one device, and those of `own`.
pub fn run(shared: &[File<Test>], own: &[File<OwnDeviceTest>]) -> ExitCode {
    let arguments = Arguments::from_args();
    // Made first and alone: what a driver sets up for the process is not raced for.
    let gpu = Gpu::headless();
    let is_required = std::env::var("GAMOW_REQUIRE_GPU").is_ok_and(|value| value == "1");
    let is_ignored = gpu.is_err() && !is_required;
    let on_shared = shared.iter().flat_map(|&(file, tests)| tests.iter().map(move |test| (file, test)));
    let on_shared = on_shared.map(|(file, &(name, test))| {
        let gpu = gpu.clone();
        Trial::test(format!("{file}::{name}"), move || {
            let gpu = gpu.map_err(|error| Failed::from(error.to_string()))?;
            test(&mut Renderers::new(Some(gpu)));
            Ok(())
        })
    });
    let on_own = own.iter().flat_map(|&(file, tests)| tests.iter().map(move |test| (file, test)));
    let on_own = on_own.map(|(file, &(name, test))| {
        Trial::test(format!("{file}::{name}"), move || {
            test();
            Ok(())
        })
    });
    let trials = on_shared.chain(on_own).map(|trial| trial.with_ignored_flag(is_ignored)).collect();
    libtest_mimic::run(&arguments, trials).exit_code()
}
