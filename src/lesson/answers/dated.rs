//! A value with the date when it was entered: of two the later one stays.

use serde::{Deserialize, Serialize};

/// A date, milliseconds since 1970 by the wall clock. No entry has an earlier one than those its window knew before, so that an
/// answer outlasts those that it replaces even where the clock was set back.
pub type Timestamp = u64;

/// The last date that is believed of a file, 2^53 ms: the year 287396.
pub const LAST: Timestamp = 1 << 53;

/// A value and when it was entered.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Dated<T> {
    /// Date of the change.
    pub at: Timestamp,
    /// Value at that date.
    pub value: T,
}

/// Returns the later one of two entries. Of two with one date it is the one whose text comes last, whichever is which.
pub fn merged<T: Clone + Serialize>(mine: Option<Dated<T>>, other: Option<&Dated<T>>) -> Option<Dated<T>> {
    let Some((own, other)) = mine.as_ref().zip(other) else { return mine.or_else(|| other.cloned()) };
    let text = |entry: &Dated<T>| serde_json::to_string(&entry.value).unwrap_or_default();
    let is_later = other.at > own.at || (other.at == own.at && text(other) > text(own));
    if is_later { Some(other.clone()) } else { mine }
}
