//! The instruments' values, in words and numbers.

use relativity_core::Odometers;

use crate::app::state::State;
use crate::number_text;
use crate::settings::Rider;

/// The instruments of a rider at one moment, in words and numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Instruments {
    /// The rider's speed: "0.995 c".
    pub speed: String,
    /// Lorentz factor of the rider: "γ = 10.1".
    pub gamma: String,
    /// The rider's rapidity, without a direction.
    pub rapidity: f64,
    /// The rider's clock.
    pub clock: String,
    /// The street's clock beside the rider.
    pub street_clock: String,
    /// Street that was ridden, by the wheel and by the lamps, and the place on it; a line each.
    pub way: Vec<String>,
    /// Keys that belong to the ride, a line each.
    pub keys: &'static [&'static str],
}

impl Instruments {
    /// Returns all of it in a sentence, for assistive technology.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { speed, gamma, rapidity, clock, street_clock, way, keys } = self;
        let parts = [
            format!("my speed {speed}, {gamma}, η = {}", number_text::fixed(*rapidity, 3)),
            format!("my clock {clock}"),
            format!("clock of the street here {street_clock}"),
        ];
        let others = way.iter().cloned().chain(keys.iter().map(|line| (*line).to_owned()));
        parts.into_iter().chain(others).collect::<Vec<_>>().join("; ")
    }
}

impl State {
    /// Returns the instruments on the handlebar; `None` unless somebody rides. Outside of presentations the
    /// lines of `told`, on keys or thumbs, are among them.
    #[must_use]
    pub fn instruments(&self, told: &'static [&'static str]) -> Option<Instruments> {
        let ride = &self.document.settings.ride;
        if !ride.is_on() {
            return None;
        }
        let Rider { velocity, x, aside, street_time, .. } = self.rider();
        let measures = self.measures();
        let (length, time) = (measures.length, measures.time);
        let place = if ride.is_along_street() {
            format!("I am at x = {}", length.text(x, 2))
        } else {
            format!("I am at x, y = {}, {}", length.number(x, 2), length.text(aside[0], 2))
        };
        let odometers = ride.odometers(self.document.time).map(|Odometers { by_wheel, by_lamps, .. }| {
            let [by_wheel, by_lamps] = [by_wheel, by_lamps].map(|way| length.text(way, 2));
            format!("ridden: {by_wheel} by my wheel, {by_lamps} by the lamps")
        });
        Some(Instruments {
            speed: format!("{}\u{a0}c", self.told_speed().number()),
            gamma: format!("γ = {}", number_text::significant(velocity.speed.gamma(), 4)),
            rapidity: velocity.speed.rapidity(),
            clock: time.text(self.document.time, 2),
            street_clock: time.text(street_time, 2),
            way: odometers.into_iter().chain([place]).collect(),
            keys: if self.session.stage.is_presented() { &[] } else { told },
        })
    }
}
