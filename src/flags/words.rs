//! Command lines as text: the words that a POSIX shell would make of them.

/// `value` as one word for a POSIX shell.
#[must_use]
pub fn quoted(value: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-+_.,/:".contains(c);
    if !value.is_empty() && value.chars().all(plain) {
        return value.to_owned();
    }
    format!("'{}'", value.replace('\'', r"'\''"))
}

/// The words of `line`: apart where there is space that is neither quoted nor escaped. What a shell would expand stays
/// as it is.
#[must_use]
pub fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    let mut letters = line.chars();
    while let Some(letter) = letters.next() {
        match (quote, letter) {
            (Some(open), _) if letter == open => quote = None,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_quoted_is_one_word_again() {
        for value in ["", "street", "it's mine.toml", "a\"b\\c $d", "two\nlines", "-0.5,3", "日本.toml"] {
            assert_eq!(words(&format!("gamow --scene={} --x", quoted(value)))[1], format!("--scene={value}"));
        }
    }

    #[test]
    fn words_end_at_any_space() {
        assert_eq!(words("  a  b\\ c \"d e\"\tf\n"), ["a", "b c", "d e", "f"]);
        assert!(words(" ").is_empty());
    }
}
