//! The moment in words: what arrives of one point at one T, as a sentence, as marks on a wavelength scale,
//! and as the reason why a part of a picture is dark.
//!
//! Two rules hold for every sentence. What no eye receives is not said to be seen: a contracted picture is
//! *measured*. And three times are kept apart by name ([`times`]): T, when light is received; t, when what is
//! seen happened; τ, what its own clock showed then.

mod light;
mod numbers;
mod sentences;
#[cfg(test)]
mod tests;
pub mod times;
mod unseen;

use relativity_core::Sighting;
use relativity_core::doppler::received_wavelength;
use relativity_render::{Colour, Emission, Geometry, View};

pub use self::light::{RestLight, in_words};
pub use self::numbers::decimal;
use self::numbers::distinct_texts;
pub use self::sentences::{beginnings, whole_sentences};
use self::times::ObserverClock;
pub use self::unseen::notice;
use crate::scene::Track;
use crate::settings::{LightSettings, Settings};
use crate::units::{Measures, Unit};

/// Decimals of a time or a place, at least.
const DECIMALS: u8 = 2;

/// The moment: one point as it is shown at one T.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// Name of the point, with its article.
    pub name: String,
    /// Light of the point at rest.
    pub source: RestLight,
    /// Observation time T, or the clock of who rides.
    pub time: f64,
    /// Whether the eyes ride.
    is_riding: bool,
    /// Units of lengths and times.
    measures: Measures,
    /// Remark on colours that are not drawn as they are received.
    drawn: &'static str,
    shown: ShownPoint,
}

/// What the views show of the point in the geometry that is set.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ShownPoint {
    /// Light at each eye; at both in one place the same.
    Received([Sighting; 2], EyePlaces, Clock),
    /// Light at the middle between the eyes, as if both received it.
    OneCone(Sighting, Clock),
    /// Light at the left eye, and the light that the published model gives to the right eye.
    Published([Sighting; 2]),
    /// Place at T: this x from between the eyes.
    Contracted(f64),
    /// Doppler factors at cameras that ride along.
    RidingAlong([f64; 2]),
    /// Nothing: it is outside the domain of the core.
    Unknown,
}

/// The clock that τ is read from: the point's, unless that goes like those on the ground, or turns about an
/// axle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Clock {
    Own,
    Axle,
    Ground,
}

impl Clock {
    /// Returns the clock of the point at `track`.
    fn from_settings(settings: &Settings, track: &Track) -> Self {
        let velocity = settings.velocity(track.motion);
        match track.spin {
            Some(spin) if spin.omega(velocity.beta()) != 0.0 => Self::Axle,
            _ if velocity.beta() == 0.0 => Self::Ground,
            _ => Self::Own,
        }
    }
}

/// Whether the eyes are in one place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum EyePlaces {
    Apart,
    Together,
}

impl Moment {
    /// Returns the moment of the point at `track`, called `name`, at `time` with these `settings`. Its
    /// sentence has the scene's own units.
    #[must_use]
    pub fn new(settings: &Settings, track: &Track, name: String, emission: Emission, time: f64) -> Self {
        let shown = ShownPoint::new(settings, track, time).unwrap_or(ShownPoint::Unknown);
        Self {
            name,
            source: RestLight::new(emission, &settings.light),
            time,
            is_riding: settings.ride.is_on(),
            measures: Measures::OWN,
            drawn: drawn(&settings.light),
            shown,
        }
    }

    /// Returns the moment with lengths and times in these units.
    #[must_use]
    pub fn with_measures(self, measures: Measures) -> Self {
        Self { measures, ..self }
    }

    /// Doppler factors of the light that arrives at the left and the right eye, or at cameras in their
    /// places, in the picture that is shown; none where it shows no light that arrives.
    #[must_use]
    pub fn doppler_factors(&self) -> [Option<f64>; 2] {
        match self.shown {
            ShownPoint::Received(seen, ..) | ShownPoint::Published(seen) => {
                seen.map(|seen| Some(seen.doppler_factor))
            }
            ShownPoint::OneCone(seen, _) => [Some(seen.doppler_factor); 2],
            ShownPoint::RidingAlong(factors) => factors.map(Some),
            ShownPoint::Contracted(_) | ShownPoint::Unknown => [None; 2],
        }
    }

    /// Wavelengths of that light, nm; none for light of many.
    #[must_use]
    pub fn wavelengths_nm(&self) -> [Option<f64>; 2] {
        let RestLight::Line(at_rest) = self.source else { return [None; 2] };
        let received = |factor| Some(received_wavelength(at_rest, factor)).filter(|nm| nm.is_finite());
        self.doppler_factors().map(|factor| factor.and_then(received))
    }

    /// Describes the light in words; `None` where no light is shown that arrives.
    #[must_use]
    pub fn light(&self) -> Option<String> {
        self.source.described(&self.doppler_factors().into_iter().flatten().collect::<Vec<_>>())
    }

    /// Describes without a number what the light looks like to each eye; `None` where no light is shown that
    /// arrives.
    #[must_use]
    pub fn looks(&self) -> Option<String> {
        let [left, right] = self.doppler_factors();
        self.source.looks([left?, right?])
    }

    /// Describes how fast the point's time is seen to pass: `its clock looks fast: D = 1.17 and 1.23`; `None`
    /// where no light is shown that arrives.
    #[must_use]
    pub fn pace(&self) -> Option<String> {
        let [left, right] = self.doppler_factors();
        let factors = [left?, right?];
        let word = match factors {
            [left, right] if left > 1.0 && right > 1.0 => "its clock looks fast: ",
            [left, right] if left < 1.0 && right < 1.0 => "its clock looks slow: ",
            _ => "",
        };
        Some(format!("{word}D\u{a0}=\u{a0}{}", distinct_texts(&factors, DECIMALS).join(" and\u{a0}")))
    }

    /// The moment in a sentence or two.
    #[must_use]
    pub fn sentence(&self) -> String {
        let Measures { length, time: unit, .. } = self.measures;
        let (name, now) = (&self.name, value_text(unit, self.time));
        let clock_now = format!("{} = {now}", ObserverClock::new(self.is_riding).symbol);
        match self.shown {
            ShownPoint::Received(seen, eyes, clock) => {
                let left = departure(&seen, eyes, unit, self.is_riding);
                let shown = proper_time(clock, &seen, unit);
                self.with_light(&format!(
                    "The light reaching you now ({clock_now}) left {name} {left}{shown}"
                ))
            }
            ShownPoint::OneCone(seen, clock) => {
                let both = [seen, seen];
                let left = departure(&both, EyePlaces::Together, unit, self.is_riding)
                    + &proper_time(clock, &both, unit);
                let start = "As if both eyes received the same events: the light reaching you midway between them now";
                self.with_light(&format!("{start} ({clock_now}) left {name} {left}"))
            }
            ShownPoint::Published(seen) => {
                let [left, right] = seen.map(|seen| value_text(unit, seen.retarded_time));
                let start = format!(
                    "The light reaching you now (T = {now}) left {name} at t = {left} for the left eye and, as published, at \
                     t = {right} for the right eye"
                );
                let model = "The right view is the paper's model: the left eye's picture at T − ΔT.";
                format!("{} {model}", self.with_light(&start))
            }
            ShownPoint::Contracted(x) => {
                let (where_measured, symbol) =
                    if self.is_riding { ("in my own frame", "s") } else { ("on the ground", "t") };
                format!(
                    "{} is drawn where it is now ({symbol} = {now}, x = {}), as measured {where_measured}: nobody sees this.",
                    capitalised(name),
                    value_text(length, x)
                )
            }
            ShownPoint::RidingAlong(_) => {
                let start =
                    format!("Cameras riding along, as they pass the eyes ({clock_now}), receive from {name}");
                self.with_light(&start)
            }
            ShownPoint::Unknown => format!("Nothing can be computed for {name} at {clock_now}."),
        }
    }

    /// Returns a sentence of `start` and the light that it speaks of, if there is any.
    fn with_light(&self, start: &str) -> String {
        match self.light() {
            Some(light) => format!("{start}: {light}.{}", self.drawn),
            None => format!("{start}."),
        }
    }
}

/// `value`, which is in units of the scene, in this unit.
fn value_text(unit: Unit, value: f64) -> String {
    decimal(unit.shown(value), unit.decimals(DECIMALS)) + &tied(unit)
}

/// Returns the unit behind a number, tied to it by a space that does not break.
fn tied(unit: Unit) -> String {
    unit.suffix().replace(' ', "\u{a0}")
}

/// Returns the distinct texts of `values` in this unit, or the one that both share.
fn both_texts(unit: Unit, values: [f64; 2]) -> Vec<String> {
    let texts = distinct_texts(&values.map(|value| unit.shown(value)), unit.decimals(DECIMALS));
    texts.into_iter().map(|text| text + &tied(unit)).collect()
}

/// When the light left that is received by the eyes.
fn departure(seen: &[Sighting; 2], eyes: EyePlaces, unit: Unit, is_riding: bool) -> String {
    let whose = if is_riding { ", by the street's clocks," } else { "" };
    let times = both_texts(unit, seen.map(|seen| seen.retarded_time));
    match (&times[..], eyes) {
        ([left, right], EyePlaces::Apart) => {
            format!("at t = {left}{whose} for the left eye, {right} for the right")
        }
        (_, EyePlaces::Apart) => format!("at t = {}{whose} for both eyes", times[0]),
        (_, EyePlaces::Together) => format!("at t = {}{}", times[0], whose.trim_end_matches(',')),
    }
}

/// Returns the time that `clock` showed then: nothing for those on the ground, whose time is in the sentence
/// already.
fn proper_time(clock: Clock, seen: &[Sighting; 2], unit: Unit) -> String {
    let whose = match clock {
        Clock::Own => "own",
        Clock::Axle => "axle's",
        Clock::Ground => return String::new(),
    };
    let times = both_texts(unit, seen.map(|seen| seen.proper_time)).join(" and ");
    format!(", when its {whose} clock read τ = {times}")
}

/// Returns the remark on colours that `light` does not draw as they are received.
const fn drawn(light: &LightSettings) -> &'static str {
    match light.colour {
        Colour::False => " The colours drawn are false ones, which tell D.",
        _ if light.doppler_shift => "",
        _ => " Its colour is drawn as at rest.",
    }
}

impl ShownPoint {
    /// Returns the point at `track` at `time` as `settings` show it; `None` outside the domain of the core.
    fn new(settings: &Settings, track: &Track, time: f64) -> Option<Self> {
        let clock = Clock::from_settings(settings, track);
        let is_moving = clock != Clock::Ground || settings.ride.is_on();
        let seen = || settings.disparity(track, time).ok();
        match settings.geometry() {
            Geometry::Rest if settings.speed().beta() != 0.0 => Self::riding_along(settings, track, time),
            Geometry::Contracted if is_moving => {
                Some(Self::Contracted(settings.measured_place(track, time)[0]))
            }
            Geometry::OneCone if is_moving && settings.motion.d != 0.0 => {
                Some(Self::OneCone(seen()?.primary, clock))
            }
            Geometry::Published if is_moving => {
                let both = settings.shown_disparity(track, time).ok()?;
                Some(Self::Published([both.primary, both.secondary]))
            }
            // Where nothing moves all geometries are alike.
            _ => {
                let eyes = if settings.motion.d == 0.0 { EyePlaces::Together } else { EyePlaces::Apart };
                seen().map(|both| Self::Received([both.primary, both.secondary], eyes, clock))
            }
        }
    }

    /// Returns the light at cameras that ride along, in the places of the eyes.
    fn riding_along(settings: &Settings, track: &Track, time: f64) -> Option<Self> {
        let doppler_factor = |view: View| {
            let seen = view.of_group(track.motion);
            let line_of_sight = seen.apparent_position(track.point())?.try_normalize()?;
            let place = seen.place_when_shown(track.point());
            let own = track.spin.map_or(1.0, |spin| seen.own_doppler(&spin, place));
            Some(seen.rest_ray(line_of_sight).doppler_factor * own)
        };
        let [left, right] = settings.views_ahead(time).map(doppler_factor);
        Some(Self::RidingAlong([left?, right?]))
    }
}

/// `text`, to begin a sentence.
/// `text` with a capital letter.
#[must_use]
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
