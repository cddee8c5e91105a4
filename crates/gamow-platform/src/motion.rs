//! Motion that the system asks to leave out.

#[cfg(not(target_family = "wasm"))]
pub use desktop::{ask, is_reduced};

#[cfg(target_family = "wasm")]
pub use crate::web::page::is_motion_reduced as is_reduced;

#[cfg(not(target_family = "wasm"))]
mod desktop {
    use std::process::{Command, Stdio};
    use std::sync::atomic::{AtomicBool, Ordering};

    use crate::threads;

    /// The program that reads the desktop's settings, the setting, and the answer of a user who wants less
    /// motion: a library of the system would be called by unsafe code. Desktops that keep it elsewhere count
    /// as ones that do not ask.
    #[cfg(target_os = "macos")]
    const SETTING: (&str, &[&str], &str) =
        ("defaults", &["read", "com.apple.universalaccess", "reduceMotion"], "1");
    #[cfg(windows)]
    const SETTING: (&str, &[&str], &str) =
        ("reg", &["query", r"HKCU\Control Panel\Desktop\WindowMetrics", "/v", "MinAnimate"], "0");
    #[cfg(not(any(target_os = "macos", windows)))]
    const SETTING: (&str, &[&str], &str) =
        ("gsettings", &["get", "org.gnome.desktop.interface", "enable-animations"], "false");

    static IS_REDUCED: AtomicBool = AtomicBool::new(false);

    /// Asks the system in the background whether it wants less motion; until it answers, it does not.
    pub fn ask() {
        threads::spawn(|| {
            let (program, arguments, reduced) = SETTING;
            let mut asked = Command::new(program);
            asked.args(arguments).stdin(Stdio::null()).stderr(Stdio::null());
            without_console(&mut asked);
            let Ok(answer) = asked.output() else { return };
            IS_REDUCED.store(ends_with(&String::from_utf8_lossy(&answer.stdout), reduced), Ordering::Relaxed);
        });
    }

    /// Whether the system has answered that it wants less motion.
    #[must_use]
    pub fn is_reduced() -> bool {
        IS_REDUCED.load(Ordering::Relaxed)
    }

    /// Whether this is the last word of `answer`.
    fn ends_with(answer: &str, word: &str) -> bool {
        answer.split_whitespace().next_back() == Some(word)
    }

    /// Has no console open for a program of the command line.
    #[cfg(windows)]
    fn without_console(asked: &mut Command) {
        const CREATE_NO_WINDOW: u32 = 0x0800_0000;
        std::os::windows::process::CommandExt::creation_flags(asked, CREATE_NO_WINDOW);
    }

    #[cfg(not(windows))]
    const fn without_console(_: &mut Command) {}

    #[cfg(test)]
    mod tests {
        use super::ends_with;

        /// The answers are as `gsettings`, `defaults` and `reg` write them.
        #[test]
        fn the_answer_is_the_last_word() {
            let registry = "\r\nHKEY_CURRENT_USER\\Control Panel\\Desktop\\WindowMetrics\r\n    MinAnimate    REG_SZ    0\r\n\r\n";
            assert!(ends_with("false\n", "false") && ends_with("1\n", "1") && ends_with(registry, "0"));
            assert!(!ends_with("true\n", "false") && !ends_with("0\n", "1") && !ends_with("", "0"));
        }
    }
}
