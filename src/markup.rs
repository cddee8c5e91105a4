//! Text in SVG and HTML.

/// Escapes `text` for an element or an attribute between double quotes. Characters that XML does not allow
/// become U+FFFD.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\t' | '\n' | '\r' => escaped.push(letter),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            letter if letter.is_control() => escaped.push('\u{fffd}'),
            letter => escaped.push(letter),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_ends_neither_its_element_nor_its_attribute() {
        let hostile = "</text><script>alert('1')</script>\" onload='x' &lt; \0\u{1b}\u{85}\u{ffff}\ta";
        let escaped = escaped(hostile);
        assert!(!escaped.contains(['<', '>', '"']), "{escaped}");
        assert!(!escaped.contains(|c: char| c.is_control() && c != '\t'), "{escaped:?}");
        assert!(escaped.contains("&amp;lt; \u{fffd}\u{fffd}\u{fffd}\u{fffd}\ta"), "{escaped}");
    }
}
