//! The three times of what is seen, by the names they have everywhere in the window. Both eyes belong to one frame, the
//! ground's; they receive different events at one T.

use crate::units::Unit;

/// A time by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TimeName {
    /// Name of the time, with its symbol.
    pub name: &'static str,
    /// Short description, for a table.
    pub short: &'static str,
    /// Full description, for a tooltip.
    pub tip: &'static str,
}

/// The time when light arrives.
pub const RECEIVED: TimeName = TimeName {
    name: "received T",
    short: "when the light arrives at the eyes",
    tip: "When the light arrives at the eyes, on the ground's clocks: the present of whoever looks.",
};

/// The time when the light left.
pub const HAPPENED: TimeName = TimeName {
    name: "happened t",
    short: "when the light left",
    tip: "When what is seen happened: when the light left, on the ground's clocks. R is how far it came.\nt = T − R",
};

/// The proper time that the body's clock showed then.
pub const OWN_CLOCK: TimeName = TimeName {
    name: "proper time τ",
    short: "what the body's clock showed then",
    tip: "What the clock at that point of the body showed when the light left it. All clocks of the body agree in its own \
        frame, and show 0 as its origin passes the eyes. An eye sees it run D times as fast as its own.\nτ = γ(t − βx)\n\
        Of a point that turns with a wheel it is the clock of the axle.",
};

/// The three times, in the order in which they are shown.
pub const TIMES: [TimeName; 3] = [RECEIVED, HAPPENED, OWN_CLOCK];

/// When light is received, when it left, and what the own clock showed then, units of the scene, each by its name in this
/// `unit` with as much as `decimals` are of the scene's.
#[must_use]
pub fn texts(times: [f64; 3], unit: Unit, decimals: u8) -> [String; 3] {
    [0, 1, 2].map(|i| format!("{} = {}", TIMES[i].name, unit.text(times[i], decimals)))
}
