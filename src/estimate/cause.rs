//! The search for what is wrong where a fit cannot be right: which single change of what it is given would
//! explain the readings. Nothing is changed by itself.

use std::borrow::Cow;

use relativity_core::{Curves, FitOptions, Model, Observations, Parameter, Passage, fit, math};

use super::command::command;
use super::correction::Correction;
use super::data::{AssumedUnits, Kind};
use super::residuals;
use crate::number_text::significant;

/// What may be wrong with readings, and how they are fitted then.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    /// Correction of the readings.
    pub correction: Correction,
    /// Options of the fit.
    pub options: FitOptions,
}

/// What explains readings best of all that was tried.
#[derive(Debug, Clone)]
pub struct Cause {
    /// The change.
    pub candidate: Candidate,
    /// What it is and does, in words; a command follows after a colon where it explains the readings.
    pub sentence: String,
    /// Whether what it leaves is chance.
    pub explains: bool,
}

impl Cause {
    /// The sentence, with the command for a `file` where it explains the readings; `given` are further flags.
    #[must_use]
    pub fn told(&self, file: &str, given: &str) -> String {
        let Candidate { correction, options } = &self.candidate;
        let command = || format!("{}{given}{}", command(file, options), correction.flags());
        if self.explains { format!("{}: {}", self.sentence, command()) } else { self.sentence.clone() }
    }
}

/// Least fall of the sum of squares that is worth words.
const LEAST_FALL: f64 = 4.0;

/// Greatest number of samples with which all changes are tried, and of changes that are then tried with all
/// samples.
const MOST_SEARCHED: usize = 2000;
const MOST_IN_FULL: usize = 3;

/// A change that was tried.
struct Tried {
    candidate: Candidate,
    /// By how many times the sum of squares falls.
    fall: f64,
    is_chance: bool,
    /// Distance of the point that was found.
    distance: f64,
}

/// Looks for what explains `observations`, of which the file says the `said` units, if `options` do not: x0,
/// units, signs, the model, a shift between the curves, and two of these. `failed` is the fit by these
/// options, if there is one.
#[must_use]
pub fn find(
    observations: &Observations,
    options: &FitOptions,
    failed: Option<f64>,
    said: AssumedUnits,
) -> Option<Cause> {
    let before = failed.unwrap_or_else(|| scale(observations));
    let some = thinned(observations);
    let tried = |candidate: &Candidate| Tried::new(&some, *candidate, before);
    let singles = singles(&some, options, said);
    let mut all: Vec<Tried> = singles.iter().filter_map(tried).collect();
    if !all.iter().any(|tried| tried.is_chance) {
        all.extend(doubles(&singles).iter().filter_map(tried));
    }
    if let Cow::Owned(_) = some {
        all.sort_by(|a, b| b.is_chance.cmp(&a.is_chance).then(b.fall.total_cmp(&a.fall)));
        all.truncate(MOST_IN_FULL);
        let in_full = |tried: Tried| Tried::new(observations, tried.candidate, before);
        all = all.into_iter().filter_map(in_full).collect();
    }
    // Of those that explain the readings those that adapt no number to them, the nearest point first: far
    // away, a unit of angles does nearly what one of times does. Else the best.
    let mut explaining: Vec<&Tried> = all.iter().filter(|tried| tried.is_chance).collect();
    explaining.sort_by(|a, b| a.adapted().cmp(&b.adapted()).then(a.distance.total_cmp(&b.distance)));
    let best = || all.iter().max_by(|a, b| a.fall.total_cmp(&b.fall));
    let found = explaining.first().copied().or_else(best)?;
    let (what, falls) = (found.candidate.words(), times(found.fall));
    let others = explaining.iter().skip(1).filter(|other| other.adapted() == found.adapted());
    let others = others.fold(String::new(), |all, other| all + "; so does " + &other.candidate.words());
    let sentence = match (found.is_chance, failed) {
        (true, Some(_)) => {
            format!("{what} explains the readings (the sum of squares falls {falls}, to chance){others}")
        }
        (true, None) => format!("{what} explains the readings but for chance{others}"),
        (false, _) => format!(
            "none of x0, units, signs, a shift between the curves and the models explains the readings; {what} comes \
             closest, with a sum of squares that falls {falls}"
        ),
    };
    Some(Cause { candidate: found.candidate, sentence, explains: found.is_chance })
}

/// The readings, or as many of them as are searched, evenly.
fn thinned(observations: &Observations) -> Cow<'_, Observations> {
    // An odd step takes of all kinds where they alternate.
    let step = observations.samples().len().div_ceil(MOST_SEARCHED) | 1;
    if step == 1 {
        return Cow::Borrowed(observations);
    }
    let some = observations.samples().iter().step_by(step).copied().collect();
    Observations::new(observations.pairs().to_vec(), some).map_or(Cow::Borrowed(observations), Cow::Owned)
}

/// Root mean square of all readings, radians.
fn scale(observations: &Observations) -> f64 {
    let readings = observations.samples().iter().flat_map(relativity_core::Sample::readings).flatten();
    let (sum, count) =
        readings.fold((0.0, 0.0), |(sum, count), reading| (sum + reading.value.powi(2), count + 1.0));
    f64::sqrt(sum / f64::max(count, 1.0))
}

/// A number of times in words, with two digits.
fn times(fall: f64) -> String {
    let digits = significant(fall, 2);
    match digits.parse::<f64>() {
        Ok(fall) if (1e3..1e9).contains(&fall) => {
            let (thousands, rest) = (fall as u64 / 1000, fall as u64 % 1000);
            let (millions, thousands) = (thousands / 1000, thousands % 1000);
            if millions > 0 {
                format!("{millions},{thousands:03},{rest:03} times")
            } else {
                format!("{thousands},{rest:03} times")
            }
        }
        _ => format!("{digits} times"),
    }
}

impl Tried {
    fn new(observations: &Observations, candidate: Candidate, before: f64) -> Option<Self> {
        let corrected = candidate.correction.with_units(observations).ok()?;
        let found = fit(&corrected, &candidate.options).ok()?;
        // In the unit that the readings had before.
        let factor = candidate.correction.angles.map_or(1.0, |unit| unit.factor);
        let fall = (factor * before / found.rms).powi(2);
        let distance = math::hypot(found.value(Parameter::Y), found.value(Parameter::Z));
        let is_chance = residuals::are_chance(&found);
        (fall > LEAST_FALL).then_some(Self { candidate, fall, is_chance, distance })
    }

    /// How many numbers are adapted to the readings.
    fn adapted(&self) -> usize {
        let Candidate { correction, options } = &self.candidate;
        usize::from(options.passage == Passage::Fitted) + usize::from(correction.shift_dtheta.is_some())
    }
}

/// Single changes, those that adapt no number to the readings first.
fn singles(observations: &Observations, options: &FitOptions, said: AssumedUnits) -> Vec<Candidate> {
    let plain = Candidate { correction: Correction::default(), options: *options };
    let corrected = |correction| Candidate { correction, ..plain };
    let mut all = Vec::new();
    if said.angles.is_none() {
        let units = ["deg", "mrad", "arcmin", "arcsec", "urad"].map(|name| Kind::Angle.unit(name));
        all.extend(units.map(|angles| corrected(Correction { angles, ..Correction::default() })));
    }
    if said.times.is_none() {
        let units = ["ms", "us", "ns", "min"].map(|name| Kind::Time.unit(name));
        all.extend(units.map(|times| corrected(Correction { times, ..Correction::default() })));
    }
    let signs = [Curves::Azimuth, Curves::Polar, Curves::Both];
    all.extend(signs.map(|curves| corrected(Correction { negate: Some(curves), ..Correction::default() })));
    let models = Model::ALL.into_iter().filter(|model| *model != options.model);
    all.extend(models.map(|model| Candidate { options: FitOptions { model, ..*options }, ..plain }));
    if options.passage != Passage::Fitted {
        all.push(Candidate { options: FitOptions { passage: Passage::Fitted, ..*options }, ..plain });
    }
    if options.curves == Curves::Both {
        let shift_dtheta = shift(observations, options);
        let correction = Correction { shift_dtheta, ..Correction::default() };
        all.extend(shift_dtheta.map(|_| corrected(correction)));
    }
    all
}

/// By how much later dtheta would have to be read to show the passage when dphi does.
fn shift(observations: &Observations, options: &FitOptions) -> Option<f64> {
    let passage = |curves| {
        let found = fit(observations, &FitOptions { curves, passage: Passage::Fitted, ..*options }).ok()?;
        let beta = found.value(Parameter::Beta);
        Some((-found.value(Parameter::X0) / beta, found.standard_error(Parameter::X0) / beta))
    };
    let ((of_dphi, error), (of_dtheta, other)) = (passage(Curves::Azimuth)?, passage(Curves::Polar)?);
    let shift = of_dphi - of_dtheta;
    // As many digits as it has.
    significant(shift, significant_digits(shift, error.max(other))).parse().ok()
}

fn significant_digits(value: f64, error: f64) -> usize {
    let ratio = math::log10((value / error).abs().max(1.0));
    (ratio.floor() as usize + 3).min(12)
}

/// Pairs of changes: x0 with a unit or a sign, and a unit of angles with one of times.
fn doubles(singles: &[Candidate]) -> Vec<Candidate> {
    let mut all = Vec::new();
    for single in singles.iter().filter(|single| single.correction != Correction::default()) {
        let passage = Passage::Fitted;
        all.push(Candidate { options: FitOptions { passage, ..single.options }, ..*single });
        if single.correction.angles.is_none() {
            continue;
        }
        let times = singles.iter().filter(|other| other.correction.times.is_some());
        all.extend(times.map(|other| {
            let correction = Correction { times: other.correction.times, ..single.correction };
            Candidate { correction, ..*single }
        }));
    }
    all
}

impl Candidate {
    /// What it supposes, in words.
    fn words(&self) -> String {
        let Correction { angles, times, negate, shift_dtheta } = self.correction;
        let words = [
            angles.map(|unit| format!("dphi and dtheta in {}", unit.name)),
            times.map(|unit| format!("times in {}", unit.name)),
            negate.map(|curves| match curves {
                Curves::Both => "the other sign of both curves".to_owned(),
                curves => format!("the other sign of {}", curves.name()),
            }),
            shift_dtheta.map(|shift| format!("dtheta later by {shift}")),
            (self.options.passage == Passage::Fitted).then(|| "x0 free".to_owned()),
        ];
        let words: Vec<String> = words.into_iter().flatten().collect();
        if words.is_empty() {
            format!("the model {}", self.options.model.name())
        } else {
            words.join(" with ")
        }
    }
}
