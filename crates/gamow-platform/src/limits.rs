//! Limits that the system sets.

/// Has a file that grows beyond what the system allows (`ulimit -f`) fail to be written, as on a full disk,
/// in place of ending the program at once. To be called before there are threads, which take it over.
pub fn fail_beyond_file_size() {
    #[cfg(unix)]
    {
        use nix::sys::signal::{SigSet, Signal};
        let mut too_long = SigSet::empty();
        too_long.add(Signal::SIGXFSZ);
        // Where it cannot be blocked it ends the program as ever.
        let _ = too_long.thread_block();
    }
}
