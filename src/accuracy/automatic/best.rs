//! The best of some methods, for a goal.

use relativity_render::Method;

use crate::flags::Goal;

/// Share of the present method's time below which another takes its place: for a gain of less than a fifth
/// nothing changes.
pub const GAIN: f64 = 0.8;

/// A method, its error and its cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Offer {
    /// Method that is rated.
    pub method: Method,
    /// No point is drawn further from where it is seen, pixels.
    pub error_px: f64,
    /// Time for a frame's pictures, milliseconds.
    pub ms: f64,
}

/// The best of `offers`, of which the one that was `kept` stays where another gains little; `None` of none.
///
/// Of an error it is the cheapest that is no further off, of equally cheap ones the most accurate; where none
/// is as near, the most accurate of all. Of a budget it is the most accurate that keeps it, of equally
/// accurate ones the cheapest; where none does, the cheapest of all.
#[must_use]
pub fn best(goal: Goal, offers: &[Offer], kept: Option<Method>) -> Option<Offer> {
    let kept = offers.iter().copied().find(|offer| Some(offer.method) == kept);
    match goal {
        Goal::Error(px) => {
            let near = |offer: &Offer| offer.error_px <= px;
            let found = cheapest(offers.iter().copied().filter(near), kept.filter(near));
            found.or_else(|| most_accurate(offers.iter().copied(), kept))
        }
        Goal::Budget(budget) => {
            let is_kept = |offer: &Offer| kept.is_some_and(|kept| kept.method == offer.method);
            // What draws within the budget gives way only to what does so with room to spare.
            let spare = if kept.is_some_and(|kept| kept.ms <= budget) { GAIN } else { 1.0 };
            let keeps = |offer: &Offer| offer.ms <= if is_kept(offer) { budget } else { spare * budget };
            let found = most_accurate(offers.iter().copied().filter(keeps), kept.filter(keeps));
            found.or_else(|| cheapest(offers.iter().copied(), kept))
        }
    }
}

/// The cheapest, or what was `kept` if it takes hardly longer.
fn cheapest(offers: impl Iterator<Item = Offer>, kept: Option<Offer>) -> Option<Offer> {
    let order = |a: &Offer, b: &Offer| a.ms.total_cmp(&b.ms).then(a.error_px.total_cmp(&b.error_px));
    let found = offers.min_by(order)?;
    Some(kept.filter(|kept| found.ms > GAIN * kept.ms).unwrap_or(found))
}

/// The most accurate, of equally accurate ones the cheapest, or what was `kept` if it takes hardly longer.
fn most_accurate(offers: impl Iterator<Item = Offer>, kept: Option<Offer>) -> Option<Offer> {
    let order = |a: &Offer, b: &Offer| a.error_px.total_cmp(&b.error_px).then(a.ms.total_cmp(&b.ms));
    let found = offers.min_by(order)?;
    let is_as_good = |kept: &Offer| kept.error_px == found.error_px && found.ms > GAIN * kept.ms;
    Some(kept.filter(is_as_good).unwrap_or(found))
}
