//! The three times of what is seen, by the names they have everywhere in the window. Both eyes belong to one
//! frame, the ground's; they receive different events at one T.

use crate::quantity::Quantity;
use crate::units::Unit;

/// A time by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TimeName {
    /// Name of the time, with its symbol.
    pub name: &'static str,
    /// Full description, for a tooltip.
    pub tip: &'static str,
}

/// The observer's clock: the horizontal axis of all plots, and the time of every sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ObserverClock {
    /// Symbol of the clock's time.
    pub symbol: &'static str,
    /// Name of the time with its symbol.
    pub words: &'static str,
    /// The time by this clock when light arrives.
    pub received: TimeName,
}

/// The clock of eyes that rest: one of the ground's.
pub const RESTING: ObserverClock = ObserverClock {
    symbol: "T",
    words: "observation time T",
    received: TimeName {
        name: "received T",
        tip: "When the light arrives at the eyes, on the ground's clocks: the present of whoever looks.",
    },
};

/// The clock on the handlebar of who rides.
pub const RIDING: ObserverClock = ObserverClock {
    symbol: "s",
    words: "my clock s",
    received: TimeName {
        name: "received s",
        tip: "The proper time of whoever rides: what the clock on the handlebar shows when the light arrives. It shows 0 where the \
            ride starts, and so does the street's clock there. The street's clock beside me shows another time.",
    },
};

impl ObserverClock {
    /// The clock of eyes that ride, or rest.
    #[must_use]
    pub const fn new(is_riding: bool) -> &'static Self {
        if is_riding { &RIDING } else { &RESTING }
    }

    /// The names of the times when light is received, when it left, and of what the own clock showed then.
    #[must_use]
    pub const fn names(&self) -> [&'static str; 3] {
        [self.received.name, Quantity::EmissionTime.row().name, Quantity::ProperTime.row().name]
    }

    /// When light is received, when it left, and what the own clock showed then, units of the scene, each by
    /// its name in this `unit` with as much as `decimals` are of the scene's.
    #[must_use]
    pub fn texts(&self, times: [f64; 3], unit: Unit, decimals: u8) -> [String; 3] {
        let names = self.names();
        [0, 1, 2].map(|i| format!("{} = {}", names[i], unit.text(times[i], decimals)))
    }
}
