//! Command lines as text: how a shell is given words, and which words a POSIX shell would make of a line.

use gamow_platform::messages;

/// A shell that a command line is written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shell {
    /// `sh`, `bash` and `zsh`.
    Posix,
    /// The prompt of `cmd.exe`.
    Cmd,
}

impl Shell {
    /// The shell for which files record their command, wherever they are written.
    pub const RECORDED: Self = Self::Posix;

    /// The shell of this platform.
    #[must_use]
    pub const fn here() -> Self {
        if cfg!(windows) { Self::Cmd } else { Self::Posix }
    }

    /// `value` as one word, in which the shell finds nothing to obey. Control characters never stand in it as
    /// they are, so that it can be pasted into a terminal.
    #[must_use]
    pub fn quoted(self, value: &str) -> String {
        let plain = |c: char| c.is_alphanumeric() || "-+_.,/:".contains(c) || (self, c) == (Self::Cmd, '\\');
        if !value.is_empty() && value.chars().all(plain) {
            return value.to_owned();
        }
        match self {
            Self::Posix if messages::shown(value) == value => format!("'{}'", value.replace('\'', r"'\''")),
            Self::Posix => escaped(value),
            Self::Cmd => quoted_for_cmd(value),
        }
    }

    /// The name of a file as one word, which no program takes for a flag, for a protocol or for its standard
    /// input.
    #[must_use]
    pub fn file(self, name: &str) -> String {
        let is_drive = self == Self::Cmd && name.chars().nth(1) == Some(':');
        let is_odd = name.starts_with('-') || name.contains(':') && !name.starts_with('/') && !is_drive;
        if !is_odd {
            return self.quoted(name);
        }
        let here = if self == Self::Cmd { r".\" } else { "./" };
        self.quoted(&format!("{here}{name}"))
    }
}

/// `value` in the quotes of POSIX (since 2024) in which characters can be written as the octal numbers of
/// their bytes.
fn escaped(value: &str) -> String {
    let mut word = "$'".to_owned();
    for letter in value.chars() {
        let mut bytes = [0; 4];
        let text = letter.encode_utf8(&mut bytes);
        if matches!(letter, '\'' | '\\') || messages::shown(text) != *text {
            word.extend(text.bytes().map(|byte| format!("\\{byte:03o}")));
        } else {
            word.push(letter);
        }
    }
    word + "'"
}

/// `value` in the quotes of `cmd.exe`, as programs read them: there `&`, `|`, `<`, `>` and `^` are characters
/// like others. What `%` and a quote would do there is prevented outside of the quotes. Characters that no
/// prompt takes are replaced.
fn quoted_for_cmd(value: &str) -> String {
    let mut word = "\"".to_owned();
    // Programs take backslashes as they are, unless a quote follows.
    let mut backslashes = 0;
    for letter in value.chars().map(|letter| if letter.is_control() { '\u{fffd}' } else { letter }) {
        if letter == '\\' {
            backslashes += 1;
            word.push(letter);
            continue;
        }
        if matches!(letter, '%' | '"') {
            word.extend(std::iter::repeat_n('\\', backslashes));
            word.push_str(if letter == '%' { "\"^%\"" } else { "\"\\^\"\"" });
        } else {
            word.push(letter);
        }
        backslashes = 0;
    }
    word.extend(std::iter::repeat_n('\\', backslashes));
    word + "\""
}

/// The words of `line`: apart where there is space that is neither quoted nor escaped. What a shell would
/// expand stays as it is.
#[must_use]
pub fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match (quote, letter) {
            (Some(open), _) if letter == open => quote = None,
            (None, '$') if letters.next_if_eq(&'\'').is_some() => {
                let inside = letters.by_ref();
                word.get_or_insert_default().push_str(&unescaped(inside));
            }
            (None, '\'' | '"') => {
                quote = Some(letter);
                word.get_or_insert_default();
            }
            (None | Some('"'), '\\') => word.get_or_insert_default().extend(letters.next()),
            (None, _) if letter.is_whitespace() => words.extend(word.take()),
            _ => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    words
}

/// The text to the end of quotes in which bytes are written as octal numbers.
fn unescaped(letters: &mut impl Iterator<Item = char>) -> String {
    let mut bytes = Vec::new();
    while let Some(letter) = letters.next().filter(|letter| *letter != '\'') {
        if letter == '\\' {
            let digits = letters.take(3).filter_map(|digit| digit.to_digit(8));
            bytes.push(digits.fold(0, |number: u32, digit| 8 * number + digit) as u8);
        } else {
            bytes.extend(letter.encode_utf8(&mut [0; 4]).bytes());
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOSTILE: [&str; 16] = [
        "",
        "street",
        "it's mine.toml",
        "a\"b\\c $d",
        "two\nlines",
        "-0.5,3",
        "日本.toml",
        "$(rm -rf ~)`id`!!",
        "a; b & c | d > e < f # g",
        "\u{1b}[201~\nrm\r",
        "it's\u{7}\\'\u{85}\u{202e}",
        "100 %PATH% ^&",
        r"C:\new folder\",
        r#"\" & calc & ""#,
        "$'x'",
        "*?[a]{b,c}~",
    ];

    #[test]
    fn what_is_quoted_is_one_word_again() {
        for value in HOSTILE {
            let line = format!("gamow --scene={} --x", Shell::Posix.quoted(value));
            assert_eq!(words(&line)[1], format!("--scene={value}"));
            assert_eq!(messages::shown(&line), line, "it can be pasted");
        }
    }

    /// The words that a real shell makes of the line.
    #[cfg(unix)]
    #[test]
    fn a_shell_makes_the_same_word_of_it() {
        for shell in ["sh", "bash"] {
            for value in
                HOSTILE.into_iter().filter(|value| shell == "bash" || messages::shown(value) == **value)
            {
                let line = format!("printf %s {}", Shell::Posix.quoted(value));
                let run = std::process::Command::new(shell).args(["-c", &line]).output();
                let Ok(run) = run else { continue };
                assert_eq!(String::from_utf8_lossy(&run.stdout), value, "{shell}: {line}");
            }
        }
    }

    /// The line that `cmd.exe` passes to a program, given that no variable of an odd name is set: `%` of a
    /// pair is an error here, and so is what would end the command.
    fn handed_over_by_cmd(line: &str) -> String {
        let (mut handed, mut is_quoted) = (String::new(), false);
        let names: Vec<&str> = line.split('%').collect();
        for name in names.iter().take(names.len() - 1).skip(1) {
            assert!(name.contains(['"', '^']), "{name} could be a variable of {line}");
        }
        let mut letters = line.chars();
        while let Some(letter) = letters.next() {
            match letter {
                '^' if !is_quoted => handed.extend(letters.next()),
                '&' | '|' | '<' | '>' if !is_quoted => panic!("{letter} of {line} is obeyed"),
                _ => {
                    is_quoted ^= letter == '"';
                    handed.push(letter);
                }
            }
        }
        assert!(!is_quoted, "{line}");
        handed
    }

    /// The words that a program on Windows makes of its command line: backslashes count before quotes alone.
    fn words_of_windows(line: &str) -> Vec<String> {
        let (mut words, mut word, mut is_quoted, mut backslashes) = (Vec::new(), None::<String>, false, 0);
        for letter in line.chars().chain([' ']) {
            if letter == '\\' {
                backslashes += 1;
                word.get_or_insert_default();
                continue;
            }
            let kept = if letter == '"' { backslashes / 2 } else { backslashes };
            word.as_mut().into_iter().for_each(|word| word.extend(std::iter::repeat_n('\\', kept)));
            match letter {
                '"' if backslashes % 2 == 1 => word.get_or_insert_default().push('"'),
                '"' => {
                    word.get_or_insert_default();
                    is_quoted = !is_quoted;
                }
                ' ' if !is_quoted => words.extend(word.take()),
                letter => word.get_or_insert_default().push(letter),
            }
            backslashes = 0;
        }
        words
    }

    #[test]
    fn on_windows_it_is_one_word_again() {
        for value in HOSTILE {
            let line = format!("gamow --scene={} --x", Shell::Cmd.quoted(value));
            let expected: String =
                value.chars().map(|letter| if letter.is_control() { '\u{fffd}' } else { letter }).collect();
            let words = words_of_windows(&handed_over_by_cmd(&line));
            assert_eq!(words, ["gamow", &format!("--scene={expected}"), "--x"], "{line}");
            assert!(!line.contains(char::is_control), "{line:?}");
        }
        assert_eq!(Shell::Cmd.quoted(r"C:\rides\a & b.toml"), r#""C:\rides\a & b.toml""#);
        assert_eq!(Shell::Cmd.quoted(r"C:\rides\a.toml"), r"C:\rides\a.toml");
    }

    #[test]
    fn files_are_no_flags() {
        let names = ["-o.csv", "-", "a b.csv", "concat:a", "/x/-y:z", "a.csv"];
        let quoted = names.map(|name| Shell::Posix.file(name));
        assert_eq!(quoted, ["./-o.csv", "./-", "'a b.csv'", "./concat:a", "/x/-y:z", "a.csv"]);
        assert_eq!(["-o.csv", r"C:\a.csv"].map(|name| Shell::Cmd.file(name)), [r".\-o.csv", r"C:\a.csv"]);
    }

    #[test]
    fn words_end_at_any_space() {
        assert_eq!(words("  a  b\\ c \"d e\"\tf\n"), ["a", "b c", "d e", "f"]);
        assert_eq!(words("$'a\\012b' $'\\303\\244 $x' $y $'"), ["a\nb", "ä $x", "$y", ""]);
        assert!(words(" ").is_empty());
    }
}
