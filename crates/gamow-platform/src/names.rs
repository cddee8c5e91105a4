//! File names with a special meaning on Windows: a name alone can reach another computer, and wait for a
//! device.

/// Returns whether Windows takes `name` for a device, whatever its ending and its folder: `nul.toml`,
/// `C:\x\COM1 `.
#[must_use]
pub fn is_device(name: &str) -> bool {
    let name = name.rsplit(['\\', '/']).next().unwrap_or_default();
    let stem = name.split(['.', ':']).next().unwrap_or_default().trim_end_matches(' ').to_ascii_uppercase();
    let numbered = |stem: &str| {
        let number = stem.strip_prefix("COM").or_else(|| stem.strip_prefix("LPT"));
        number.is_some_and(|number| {
            let mut letters = number.chars();
            matches!(letters.next(), Some('1'..='9' | '¹' | '²' | '³')) && letters.next().is_none()
        })
    };
    matches!(stem.as_str(), "CON" | "PRN" | "AUX" | "NUL" | "CONIN$" | "CONOUT$") || numbered(&stem)
}

/// Returns whether Windows looks for `name` on another computer, which then knows the asker, or among the
/// devices. Of the names that begin with two separators only those of a drive do not lead there:
/// `\\?\C:\a.toml`.
#[must_use]
pub fn is_elsewhere(name: &str) -> bool {
    let name = name.replace('/', "\\");
    let Some(rest) = name.strip_prefix(r"\\").or_else(|| name.strip_prefix(r"\?")) else { return false };
    let drive = rest.strip_prefix(r"?\").map(str::as_bytes);
    !matches!(drive, Some([letter, b':', b'\\', ..]) if letter.is_ascii_alphabetic())
}

/// Returns the problem with `name`, on Windows, in a file that somebody else may have written.
#[must_use]
pub fn problem_in_a_file(name: &str) -> Option<&'static str> {
    if is_elsewhere(name) {
        return Some(
            "it leads to another computer or to a device; a file beside this one, or on a drive of this computer, would be right",
        );
    }
    is_device(name).then_some("it is the name of a device; that of an ordinary file would be right")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_are_known_by_any_of_their_names() {
        for name in [
            "CON",
            "nul",
            "nul.toml",
            "Aux.tar.gz",
            "prn ",
            "NUL .",
            "com1",
            "COM9.png",
            "LPT1:",
            "lpt3...",
            "COM¹",
            r"C:\rides\nul.toml",
            "rides/con",
            "CONIN$",
            "nul:a",
        ] {
            assert!(is_device(name), "{name}");
            assert!(problem_in_a_file(name).is_some_and(|problem| problem.contains("device")), "{name}");
        }
        for name in [
            "console.toml",
            "COM0",
            "com10.toml",
            "com",
            "LPT",
            "null.toml",
            "a.con",
            "con/ride.toml",
            "",
            "räder",
        ] {
            assert!(!is_device(name), "{name}");
            assert_eq!(problem_in_a_file(name), None, "{name}");
        }
    }

    #[test]
    fn names_that_leave_this_computer_are_known() {
        for name in [
            r"\\server\share\x.toml",
            "//server/share/x.toml",
            r"\/server\share",
            r"/\server/share",
            r"\\?\UNC\server\share\x",
            r"\\.\pipe\x",
            "//./pipe/x",
            r"\\.\C:\x.toml",
            r"\??\UNC\server\share",
            r"\\?\GLOBALROOT\Device\Mup\server\x",
            r"\\?\C:x",
            r"\\",
            r"\\localhost@80\x",
        ] {
            assert!(is_elsewhere(name), "{name}");
            assert!(
                problem_in_a_file(name).is_some_and(|problem| problem.contains("another computer")),
                "{name}"
            );
        }
        for name in [
            r"C:\x.toml",
            "c:/x.toml",
            r"\\?\C:\x.toml",
            "//?/d:/x",
            r"\x.toml",
            "/x/y.toml",
            r"..\x.toml",
            "x.toml",
            r"a\\b",
            "",
        ] {
            assert!(!is_elsewhere(name), "{name}");
            assert_eq!(problem_in_a_file(name), None, "{name}");
        }
    }
}
