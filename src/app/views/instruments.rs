//! The instruments on the handlebar.

use relativity_core::Odometers;

use crate::app::commands::riding::keys;
use crate::app::state::State;
use crate::number_text;
use crate::settings::Rider;

impl State {
    /// The instruments on the handlebar, a line each; `None` of who does not ride.
    #[must_use]
    pub fn instruments(&self) -> Option<Vec<String>> {
        let ride = &self.document.settings.ride;
        if !ride.is_on() {
            return None;
        }
        let Rider { velocity, x, aside, street_time, .. } = self.rider();
        let measures = self.measures();
        let (length, time) = (measures.length, measures.time);
        let sign = if velocity.is_backward { "−" } else { "" };
        let [beta, gamma, rapidity] = [
            number_text::beta(&velocity.speed),
            number_text::significant(velocity.speed.gamma(), 4),
            number_text::fixed(velocity.rapidity(), 3),
        ];
        let keys = (!self.session.stage.is_presented()).then_some(keys::TOLD).into_iter().flatten();
        let place = if ride.is_along_street() {
            format!("at x = {}", length.text(x, 2))
        } else {
            format!("at x, y = {}, {}", length.number(x, 2), length.text(aside[0], 2))
        };
        let lines = [
            format!("β = {sign}{beta}   γ = {gamma}   η = {rapidity}"),
            format!("my clock {}", time.text(self.document.time, 2)),
            format!("street clock here {}", time.text(street_time, 2)),
            place,
        ];
        let odometers = ride.odometers(self.document.time).map(|Odometers { by_wheel, by_lamps, .. }| {
            let [by_wheel, by_lamps] = [by_wheel, by_lamps].map(|way| length.text(way, 2));
            format!("ridden: {by_wheel} by my wheel, {by_lamps} by the lamps")
        });
        Some(lines.into_iter().chain(odometers).chain(keys.map(|line| (*line).to_owned())).collect())
    }
}
