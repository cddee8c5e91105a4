//! The Python package `gamow`: the numbers and pictures of the commands, in NumPy arrays.
//!
//! Functions are called by keywords that have the names of the commands' columns and flags, and give what the
//! commands write: the same numbers, bit for bit. Whatever the commands refuse is a `ValueError` with the
//! same line. This is the module `gamow._core`; the functions in `python/gamow` give its keywords their
//! signatures, and take units, masks and labels off their values.
#![expect(
    clippy::doc_markdown,
    reason = "comments become texts of Python, where backticks mean something else"
)]
#![warn(clippy::disallowed_methods, clippy::disallowed_types, clippy::print_stdout, clippy::print_stderr)]

mod arrays;
mod drawing;
mod errors;
mod flags;
mod pictures;
mod points;
mod readings;
mod scene;
mod state;
mod tables;
mod threads;

use pyo3::prelude::*;

/// Special relativity as two eyes would see it: numbers in NumPy arrays, fits and pictures.
#[pymodule]
#[pyo3(name = "_core")]
mod python {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::pictures::measure;
    #[pymodule_export]
    use super::points::{curve, disparity, sightings, stereo};
    #[pymodule_export]
    use super::readings::fit;
    #[pymodule_export]
    use super::scene::{Scene, presets, scenes};
    #[pymodule_export]
    use super::state::State;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        super::threads::note_process();
        // The first use of NumPy, which panics where an interrupt breaks it off, is over when calls begin.
        module.py().import("numpy")?;
        numpy::PyArray1::<f64>::from_vec(module.py(), Vec::new());
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
