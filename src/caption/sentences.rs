//! Texts that are cut where a sentence ends.

/// Marks at which a sentence may be cut where none of its ends does.
const INNER_ENDS: [&str; 3] = [": ", "; ", ", "];

/// Returns what `text` may be cut to at the ends of sentences: the first one, the first two, and so on up to
/// all of it.
#[must_use]
pub fn whole_sentences(text: &str) -> Vec<String> {
    let ends = text.match_indices(". ").map(|(at, _)| text[..=at].to_owned());
    ends.chain([text.to_owned()]).collect()
}

/// Returns what `text` may be cut to: its whole first sentence, the first two, and so on up to all of it;
/// before these the first sentence up to its last colon, semicolon or comma, if it has one, and so on down to
/// the first. No word is cut.
#[must_use]
pub fn beginnings(text: &str) -> Vec<String> {
    let whole = whole_sentences(text);
    let first = whole[0].as_str();
    let mut inner: Vec<usize> =
        INNER_ENDS.iter().flat_map(|end| first.match_indices(end)).map(|(at, _)| at).collect();
    inner.sort_unstable();
    let mut beginnings: Vec<String> = inner.into_iter().map(|at| format!("{}.", &first[..at])).collect();
    beginnings.extend(whole);
    beginnings
}
