//! The three times of what is seen, by the names they have everywhere in the window. Both eyes belong to one frame, the
//! ground's; they receive different events at one T.

use crate::units::Unit;

/// A time by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TimeName {
    /// Name of the time, with its symbol.
    pub name: &'static str,
    /// Full description, for a tooltip.
    pub tip: &'static str,
}

/// The time when light arrives.
pub const RECEIVED: TimeName = TimeName {
    name: "received T",
    tip: "When the light arrives at the eyes, on the ground's clocks: the present of whoever looks.",
};

/// The time when the light left.
pub const HAPPENED: TimeName = TimeName {
    name: "happened t",
    tip: "When what is seen happened: when the light left, on the ground's clocks. R is how far it came.\nt = T − R",
};

/// The proper time that the body's clock showed then.
pub const OWN_CLOCK: TimeName = TimeName {
    name: "proper time τ",
    tip: "What the clock at that point of the body showed when the light left it. All clocks of the body agree in its own \
        frame, and show 0 as its origin passes the eyes. An eye sees it run D times as fast as its own.\nτ = γ(t − βx)\n\
        Of a point that turns with a wheel it is the clock of the axle.",
};

/// The three times, in the order in which they are shown.
pub const TIMES: [TimeName; 3] = [RECEIVED, HAPPENED, OWN_CLOCK];

/// The observer's clock: the horizontal axis of all plots, and the time of every sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ObserverClock {
    /// Symbol of the clock's time.
    pub symbol: &'static str,
    /// Name of the time with its symbol.
    pub words: &'static str,
    /// Description for a tooltip.
    pub tip: &'static str,
    /// The three times of what is seen: received by this clock, happened, and by the body's own.
    pub times: [TimeName; 3],
}

/// The clock of eyes that rest: one of the ground's.
pub const RESTING: ObserverClock =
    ObserverClock { symbol: "T", words: "observation time T", tip: RECEIVED.tip, times: TIMES };

/// The clock on the handlebar of who rides.
pub const RIDING: ObserverClock = ObserverClock {
    symbol: "s",
    words: "my clock s",
    tip: "The proper time of whoever rides: what the clock on the handlebar shows when the light arrives. It shows 0 where the \
        ride starts, and so does the street's clock there.",
    times: [
        TimeName {
            name: "received s",
            tip: "When the light arrives at the eyes, on the clock on the handlebar. The street's clock beside me shows another time.",
        },
        TimeName {
            name: "happened t",
            tip: "When what is seen happened: when the light left, on the street's clock there.",
        },
        OWN_CLOCK,
    ],
};

impl ObserverClock {
    /// The clock of eyes that ride, or rest.
    #[must_use]
    pub const fn new(is_riding: bool) -> &'static Self {
        if is_riding { &RIDING } else { &RESTING }
    }

    /// When light is received, when it left, and what the own clock showed then, units of the scene, each by its name in this
    /// `unit` with as much as `decimals` are of the scene's.
    #[must_use]
    pub fn texts(&self, times: [f64; 3], unit: Unit, decimals: u8) -> [String; 3] {
        [0, 1, 2].map(|i| format!("{} = {}", self.times[i].name, unit.text(times[i], decimals)))
    }
}
