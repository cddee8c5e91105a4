//! Similar names, which error messages suggest.

use std::collections::BTreeSet;

use gamow_platform::{messages, sizes};

/// Number of similar names that an error message suggests.
pub(super) const NEAREST: usize = 3;

/// Returns the `known` names that are most similar to `sought`, in a list.
pub fn nearest<'a>(known: impl IntoIterator<Item = &'a str>, sought: &str) -> String {
    let sought: String = sought.to_lowercase().chars().take(sizes::NAME_LETTERS).collect();
    let known: BTreeSet<&str> = known.into_iter().collect();
    let off = |known: &str| {
        let known: String = known.to_lowercase().chars().take(sizes::NAME_LETTERS).collect();
        strsim::damerau_levenshtein(&known, &sought)
    };
    let mut nearest: Vec<_> = known.into_iter().map(|known| (off(known), known)).collect();
    nearest.sort_unstable();
    nearest.iter().take(NEAREST).map(|(_, known)| messages::excerpt(known)).collect::<Vec<_>>().join(", ")
}
