//! Similar names, which error messages suggest.

use std::collections::BTreeSet;

use gamow_platform::{messages, sizes};

/// Number of similar names that an error message suggests.
pub const NEAREST: usize = 3;

/// Returns the `known` names that are most similar to `sought`, in a list.
pub fn nearest<'a>(known: impl IntoIterator<Item = &'a str>, sought: &str) -> String {
    let nearest = by_distance(known, sought);
    nearest.iter().take(NEAREST).map(|(_, known)| messages::excerpt(known)).collect::<Vec<_>>().join(", ")
}

/// Returns a question for the one of the `known` names that is nearly `sought`, in brackets and with a space
/// before it; nothing where none is.
pub fn did_you_mean<'a>(known: impl IntoIterator<Item = &'a str>, sought: &str) -> String {
    let nearest = by_distance(known, sought).into_iter().next();
    // Few slips of the keyboard are at most one in three letters.
    let near = nearest.filter(|(slips, name)| 3 * slips <= name.chars().count());
    near.map_or_else(String::new, |(_, name)| format!(" (did you mean `{}`?)", messages::excerpt(name)))
}

/// The `known` names with the number of slips from each to `sought`, the nearest first.
fn by_distance<'a>(known: impl IntoIterator<Item = &'a str>, sought: &str) -> Vec<(usize, &'a str)> {
    let letters = |name: &str| name.to_lowercase().chars().take(sizes::NAME_LETTERS).collect::<String>();
    let sought = letters(sought);
    let known: BTreeSet<&str> = known.into_iter().collect();
    let mut nearest: Vec<_> = known
        .into_iter()
        .map(|known| (strsim::damerau_levenshtein(&letters(known), &sought), known))
        .collect();
    nearest.sort_unstable();
    nearest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_proposed_for_a_slip_of_the_keyboard() {
        let known = ["street", "cyclist", "d", "beta"];
        for (sought, proposed) in
            [("stret", "street"), ("Cyclizt", "cyclist"), ("bta", "beta"), ("BETA", "beta")]
        {
            assert_eq!(did_you_mean(known, sought), format!(" (did you mean `{proposed}`?)"));
        }
        for other in ["", "x", "moon", "cathedral"] {
            assert_eq!(did_you_mean(known, other), "", "{other}");
        }
        assert!(did_you_mean(known, &"x".repeat(1_000_000)).is_empty());
    }
}
