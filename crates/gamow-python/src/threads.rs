//! Threads of this process. A `fork`, by which multiprocessing starts its workers on Linux before Python
//! 3.14, takes no thread along but the one that calls it: a child has to start its own, or it would wait for
//! ever.

use std::ffi::CString;
use std::process;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::Duration;

use gamow_platform::messages;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use relativity_core::threads::{ThreadPool, ThreadPoolBuilder, Watch, watched};

/// The process that loaded the package, whose threads are the usual ones.
static LOADED_BY: OnceLock<u32> = OnceLock::new();
/// The threads of a child, and its number.
static OF_CHILD: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Notes that this process has loaded the package, whose remarks become warnings.
pub fn note_process() {
    LOADED_BY.get_or_init(process::id);
    messages::hold();
}

/// Does `work` on threads of this process, while other threads of Python go on.
///
/// # Errors
///
/// A child for which the system starts no threads, in a line.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    py.detach(|| {
        Ok(match pool_of_child()? {
            Some(pool) => pool.install(work),
            None => work(),
        })
    })
}

/// The time between two looks for signals.
const PERIOD: Duration = Duration::from_millis(50);

/// Does `work` that may take long, as [`detached`] does. An interrupt (Ctrl-C) has it given up at the next
/// place where it looks at `threads::goes_on`.
///
/// # Errors
///
/// The exception of a signal's handler: a KeyboardInterrupt, usually.
pub fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let (watch, mut interrupt) = (Arc::new(Watch::default()), None);
    let look = || {
        if interrupt.is_none() {
            interrupt = Python::attach(|py| py.check_signals().err());
            if interrupt.is_some() {
                watch.stop();
            }
        }
    };
    let result = py.detach(|| {
        let pool = pool_of_child()?;
        let work = || watched(&watch, work);
        Ok(gamow_platform::threads::beside(
            || match pool {
                Some(pool) => pool.install(work),
                None => work(),
            },
            PERIOD,
            look,
        ))
    });
    interrupt.map_or(Ok(()), Err)?;
    warn_of_remarks(py)?;
    result
}

/// Issues what the work remarked on as warnings.
fn warn_of_remarks(py: Python<'_>) -> PyResult<()> {
    for remark in messages::take_held() {
        let kind = py.import("gamow._remarks")?.getattr("GamowWarning")?;
        let remark = remark.strip_prefix("gamow: ").unwrap_or(&remark).replace('\0', " ");
        PyErr::warn(py, &kind, &CString::new(remark)?, 1)?;
    }
    Ok(())
}

/// Returns the threads of this process if it is a child of the one that loaded the package.
fn pool_of_child() -> PyResult<Option<Arc<ThreadPool>>> {
    let process = process::id();
    if LOADED_BY.get().is_none_or(|loaded_by| *loaded_by == process) {
        return Ok(None);
    }
    let mut kept = OF_CHILD.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, pool)) = kept.as_ref().filter(|(owner, _)| *owner == process) {
        return Ok(Some(Arc::clone(pool)));
    }
    let pool = ThreadPoolBuilder::new()
        .build()
        .map_err(|error| PyOSError::new_err(format!("no threads could be started after a fork: {error}")))?;
    let pool = Arc::new(pool);
    // Dropping the threads of a parent would wait for them.
    if let Some(others) = kept.replace((process, Arc::clone(&pool))) {
        std::mem::forget(others);
    }
    Ok(Some(pool))
}
