//! The wishes that a system's user has of all programs: less motion, more contrast.

#[cfg(not(target_family = "wasm"))]
pub use desktop::{ask, less_motion, more_contrast};

#[cfg(target_family = "wasm")]
pub use crate::web::page::{less_motion, more_contrast};

#[cfg(not(target_family = "wasm"))]
mod desktop {
    use std::process::{Command, Stdio};
    use std::sync::atomic::{AtomicBool, Ordering};

    use crate::threads;

    /// A wish, and whether it has been heard.
    struct Wish {
        /// The program that reads the desktop's settings, and its arguments: a library of the system would be
        /// called by unsafe code. Desktops that keep the setting elsewhere count as ones that do not ask.
        program: &'static str,
        arguments: &'static [&'static str],
        /// Whether the last word of its answer is a yes.
        is_yes: fn(&str) -> bool,
        is_heard: AtomicBool,
    }

    #[cfg(target_os = "macos")]
    static WISHES: [Wish; 2] = {
        const PROGRAM: &str = "defaults";
        const ONE: fn(&str) -> bool = |word| word == "1";
        [
            Wish::new(PROGRAM, &["read", "com.apple.universalaccess", "reduceMotion"], ONE),
            Wish::new(PROGRAM, &["read", "com.apple.universalaccess", "increaseContrast"], ONE),
        ]
    };
    #[cfg(windows)]
    static WISHES: [Wish; 2] = {
        const MOTION: &[&str] = &["query", r"HKCU\Control Panel\Desktop\WindowMetrics", "/v", "MinAnimate"];
        const CONTRAST: &[&str] = &["query", r"HKCU\Control Panel\Accessibility\HighContrast", "/v", "Flags"];
        [Wish::new("reg", MOTION, |word| word == "0"), Wish::new("reg", CONTRAST, is_odd)]
    };
    #[cfg(not(any(target_os = "macos", windows)))]
    static WISHES: [Wish; 2] = {
        const PROGRAM: &str = "gsettings";
        const MOTION: &[&str] = &["get", "org.gnome.desktop.interface", "enable-animations"];
        const CONTRAST: &[&str] = &["get", "org.gnome.desktop.a11y.interface", "high-contrast"];
        [
            Wish::new(PROGRAM, MOTION, |word| word == "false"),
            Wish::new(PROGRAM, CONTRAST, |word| word == "true"),
        ]
    };

    impl Wish {
        const fn new(
            program: &'static str,
            arguments: &'static [&'static str],
            is_yes: fn(&str) -> bool,
        ) -> Self {
            Self { program, arguments, is_yes, is_heard: AtomicBool::new(false) }
        }

        fn ask(&self) {
            let mut asked = Command::new(self.program);
            asked.args(self.arguments).stdin(Stdio::null()).stderr(Stdio::null());
            without_console(&mut asked);
            let Ok(answer) = asked.output() else { return };
            let is_heard = last_word(&String::from_utf8_lossy(&answer.stdout)).is_some_and(self.is_yes);
            self.is_heard.store(is_heard, Ordering::Relaxed);
        }
    }

    /// Asks the system in the background what its user wishes; until it answers, nothing.
    pub fn ask() {
        threads::spawn(|| WISHES.iter().for_each(Wish::ask));
    }

    /// Whether the system has answered that its user wants less motion.
    #[must_use]
    pub fn less_motion() -> bool {
        let [motion, _] = &WISHES;
        motion.is_heard.load(Ordering::Relaxed)
    }

    /// Whether the system has answered that its user wants more contrast.
    #[must_use]
    pub fn more_contrast() -> bool {
        let [_, contrast] = &WISHES;
        contrast.is_heard.load(Ordering::Relaxed)
    }

    fn last_word(answer: &str) -> Option<&str> {
        answer.split_whitespace().next_back()
    }

    /// Whether this is an odd number: the flag of a wish for more contrast is the first of several.
    #[cfg(any(windows, test))]
    fn is_odd(word: &str) -> bool {
        word.parse::<u32>().is_ok_and(|flags| flags % 2 == 1)
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
        use super::{is_odd, last_word};

        #[cfg(target_os = "linux")]
        #[test]
        fn a_wish_is_heard_and_nothing_else() {
            let heard = |answer: &str| super::WISHES.each_ref().map(|wish| (wish.is_yes)(answer));
            assert_eq!(
                ["false", "true", "0", "1"].map(heard),
                [[true, false], [false, true], [false; 2], [false; 2]]
            );
        }

        /// The answers are as `gsettings`, `defaults` and `reg` write them.
        #[test]
        fn the_answer_is_the_last_word() {
            let registry = |name: &str, text: &str| {
                format!("\r\nHKEY_CURRENT_USER\\Control Panel\r\n    {name}    REG_SZ    {text}\r\n\r\n")
            };
            assert_eq!(last_word("false\n"), Some("false"));
            assert_eq!(last_word(&registry("MinAnimate", "0")), Some("0"));
            assert_eq!(last_word(""), None);
            for (flags, is_on) in [("127", true), ("126", false), ("no", false)] {
                assert_eq!(last_word(&registry("Flags", flags)).is_some_and(is_odd), is_on, "{flags}");
            }
        }
    }
}
