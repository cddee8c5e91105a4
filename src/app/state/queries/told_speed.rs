//! The speed that is written large: the rider's own on a ride, else that of the bodies.

use relativity_render::{Motion, Velocity};

use crate::app::state::State;
use crate::flags::{SpeedParameter, SpeedSetting, StreetVelocity};
use crate::number_text;

/// A speed that is written large.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToldSpeed {
    /// Velocity along the line of the ride, or of the bodies along the street.
    pub velocity: Velocity,
    /// Whether it is the rider's own.
    pub is_own: bool,
}

impl ToldSpeed {
    /// Returns the speed as a number with its sign: `0.9`, or `−0.900` backwards. A rider reads it at a
    /// glance while it changes, and so with a steady number of digits.
    #[must_use]
    pub fn number(&self) -> String {
        let number = if self.is_own {
            number_text::short_beta(&self.velocity.speed)
        } else {
            number_text::trimmed_beta(&self.velocity.speed)
        };
        // Who has braked to rest has no direction.
        let is_backward = self.velocity.is_backward && number.contains(|digit| ('1'..='9').contains(&digit));
        if is_backward { format!("−{number}") } else { number }
    }
}

impl State {
    /// Returns the speed that is written large wherever one is.
    #[must_use]
    pub fn told_speed(&self) -> ToldSpeed {
        if self.document.settings.ride.is_on() {
            return ToldSpeed { velocity: self.rider().velocity, is_own: true };
        }
        ToldSpeed { velocity: Velocity::forward(self.speed()), is_own: false }
    }

    /// Returns that speed in words, in Gamow's town in its unit, too: "I ride at 0.900 c" on a ride, else
    /// "β = 0.9".
    #[must_use]
    pub fn told_speed_text(&self) -> String {
        let told = self.told_speed();
        let number = told.number();
        let text = if told.is_own { format!("I ride at {number}\u{a0}c") } else { format!("β = {number}") };
        match self.measures().speed(&told.velocity.speed) {
            Some(in_town) => format!("{text}   {in_town}"),
            None => text,
        }
    }

    /// Returns the speed of the bodies beside the rider's own, in words: "cyclist at 0.5 c"; `None` where
    /// nobody rides, and where no body moves.
    #[must_use]
    pub fn others_speed_text(&self) -> Option<String> {
        let is_ridden_past = self.document.settings.ride.is_on() && self.speed().beta() > 0.0;
        self.bodies_speed_text().filter(|_| is_ridden_past)
    }

    /// Returns the speed of the bodies that move at the one set for them, in words; `None` where none does.
    #[must_use]
    pub fn bodies_speed_text(&self) -> Option<String> {
        let scene = &self.document.scene;
        let moving = scene.groups.iter().position(|group| group.motion == Motion::Scene)?;
        let name = scene.name_of_group(moving)?;
        Some(format!("{name} at {}\u{a0}c", number_text::trimmed_beta(&self.speed())))
    }

    /// Returns the speed that a push now aims at: that at the end of the leg that is under way, else the
    /// rider's own.
    #[must_use]
    pub fn throttle(&self) -> SpeedSetting {
        let (settings, time) = (&self.document.settings, self.document.time);
        let end = settings.ride.turns().find(|end| *end > time).unwrap_or(time);
        let rapidity = settings.rider(end).velocity.rapidity().abs();
        SpeedSetting::new(SpeedParameter::Rapidity, rapidity).unwrap_or(SpeedSetting::REST)
    }

    /// Returns the velocity of a rider who sets the throttle to this `speed`: the way that the ride leads
    /// now.
    #[must_use]
    pub fn throttled(&self, speed: SpeedSetting) -> Option<StreetVelocity> {
        let (parameter, value) = speed.given();
        let value = if self.rider().velocity.is_backward { -value } else { value };
        StreetVelocity::new(parameter, value).ok()
    }
}
