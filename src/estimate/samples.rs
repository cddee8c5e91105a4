//! Samples to fit: simulated readings of the selected point, or measured ones from a file.

use std::sync::Arc;

use csv::ByteRecord;
use gamow_platform::shared;
use relativity_core::{
    Aperture, Baseline, Curves, FitOptions, Model, Observations, Parameter, Passage, Rolling, Simulation,
    Source, SourcePoint, Turning, WheelPoint,
};
use relativity_render::Velocity;
use serde::{Deserialize, Serialize};

use super::cause;
use super::command::command;
use super::data::{AssumedUnits, Data};
use super::data_file::DataFile;
use super::left_out;
use crate::columns::{ROLL, TURN, degrees};
use crate::files::csv_out::CsvWriter;
use crate::scene::{Scene, Track};
use crate::settings::{FitSettings, Settings, message};
use crate::time_range::time_within;

/// Everything that a fit depends on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FitKey {
    /// Readings of the disparities, simulated or from a file.
    pub samples: Samples,
    /// Settings of the simulation, if there is one, and of the fit.
    #[serde(with = "message::fit")]
    pub setup: FitSettings,
}

/// The source of samples.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Samples {
    /// From the selected point.
    Simulated(Simulated),
    /// Samples from a file, whose eyes are held like this where it does not say.
    Measured(#[serde(with = "shared")] Arc<DataFile>, Baseline),
}

/// The point of which samples are simulated, and how they are taken.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Simulated {
    /// True velocity, with which the fit is compared.
    pub velocity: Velocity,
    /// True worldline of the point.
    pub source: Source,
    /// The eyes, from the middle between them.
    pub pair: [Aperture; 2],
    /// Why eyes that ride measure nothing that a fit takes, if they do not.
    obstacle_of_ride: Option<ObstacleOfRide>,
    /// First and last T of the samples.
    pub range: [f64; 2],
    /// The model by which the samples are made.
    pub model: Model,
}

/// Why eyes that ride measure nothing that a fit takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
enum ObstacleOfRide {
    ChangingSpeed,
    Aslant,
    TurningPoint,
    EyesAcross,
}

impl ObstacleOfRide {
    const fn text(self) -> &'static str {
        match self {
            Self::ChangingSpeed => "the ride changes its speed, and a fit needs one that coasts",
            Self::Aslant => "a fit of a ride off the street needs one on the level, and a point at rest",
            Self::TurningPoint => "the point turns, and a fit of a ride needs one that does not",
            Self::EyesAcross => "a fit of a ride needs eyes that look where it leads: face ahead",
        }
    }
}

/// Simulates a measurement of the selected point of `scene` by both eyes, with `settings`.
///
/// # Errors
///
/// Why nothing is measured.
pub fn samples_of(settings: &Settings, scene: &Scene) -> Result<SamplesWithTruth, String> {
    let simulated = Simulated::new(settings, &settings.track(scene));
    let fittable = FitKey { samples: Samples::Simulated(simulated), setup: settings.fit }.fittable()?;
    Ok(SamplesWithTruth { fittable, simulated, baseline: settings.baseline() })
}

/// Samples of a point, and the truth.
#[derive(Debug, Clone)]
pub struct SamplesWithTruth {
    /// The samples, and how they are fitted.
    pub fittable: Fittable,
    /// The point that they are of.
    pub simulated: Simulated,
    /// From the left to the right eye.
    pub baseline: Baseline,
}

impl SamplesWithTruth {
    /// Returns the value of `parameter` that a fit should find.
    #[must_use]
    pub fn true_value(&self, parameter: Parameter) -> f64 {
        self.simulated.true_value(parameter, self.fittable.options.curves)
    }

    /// A row for each sample, as `gamow fit` reads it: T, the eyes, and the reading of each curve in radians.
    #[must_use]
    pub fn csv(&self) -> String {
        let columns = EyeColumns::for_eyes(self.baseline);
        let (names, eyes) = (columns.names(), columns.numbers(self.baseline));
        let mut rows = CsvWriter::new(Vec::new());
        // Into memory: writing does not fail.
        let _ = rows.write(&mut ["T"].iter().chain(names).chain(&["dphi", "dtheta"]).copied().collect(), &[]);
        for sample in self.fittable.observations.samples() {
            let curves = sample.readings().map(|read| read.map_or(f64::NAN, |read| read.value));
            let numbers = [&[sample.time], eyes.as_slice(), &curves].concat();
            let _ = rows.write(&mut ByteRecord::new(), &numbers);
        }
        rows.into_text()
    }
}

/// A ride off the street that coasts on the level, and a point at rest before it, turned about the vertical
/// where the ride starts: for the eyes it is a ride along the street. `None` of any other ride or point.
fn along_street(settings: &Settings, point: &Track) -> Option<(Settings, Track)> {
    let ride = &settings.ride;
    let is_level = ride.leaves_street() && ride.coasts() && ride.ride_elevation == 0.0;
    if !is_level || settings.velocity(point.motion).beta() != 0.0 {
        return None;
    }
    let ([along, across, _], [x, y, z]) = (ride.direction(), settings.rest_place(point.rest));
    let x = x - ride.ride_from;
    let mut turned = settings.clone();
    turned.motion.turn -= ride.ride_azimuth;
    turned.ride.ride_azimuth = 0.0;
    let [_, behind, below] = settings.rest_place([0.0; 3]);
    let rest = [ride.ride_from + along * x + across * y, along * y - across * x - behind, z - below];
    Some((turned, Track { rest, ..*point }))
}

/// The columns of a table that place the eyes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EyeColumns {
    /// The separation alone: the head is straight.
    Separation,
    /// The separation, and the head's roll and turn, in degrees.
    Head,
}

impl EyeColumns {
    /// Returns the columns for eyes that stay as they are.
    #[must_use]
    pub fn for_eyes(Baseline { roll, turn, .. }: Baseline) -> Self {
        if roll == 0.0 && turn == 0.0 { Self::Separation } else { Self::Head }
    }

    /// The names of the columns.
    #[must_use]
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Separation => &["d"],
            Self::Head => &["d", ROLL, TURN],
        }
    }

    /// The numbers of a row.
    #[must_use]
    pub fn numbers(self, Baseline { separation, roll, turn }: Baseline) -> Vec<f64> {
        match self {
            Self::Separation => vec![separation],
            Self::Head => vec![separation, degrees(roll), degrees(turn)],
        }
    }
}

/// Samples, and how they are fitted.
#[derive(Debug, Clone)]
pub struct Fittable {
    /// Readings, with the eyes that took them.
    pub observations: Observations,
    /// Model, curves and known parameters of the fit.
    pub options: FitOptions,
    /// Units that a file says its readings are in.
    pub said: AssumedUnits,
    /// The line of each sample in its file; none of simulated ones.
    pub lines: Vec<u64>,
}

impl Fittable {
    /// The command that fits the same samples in a file.
    #[must_use]
    pub fn command(&self, file: &str) -> String {
        command(file, &self.options)
    }
}

impl FitKey {
    /// The samples with as much noise as is set.
    ///
    /// # Errors
    ///
    /// Why there are none.
    pub fn fittable(&self) -> Result<Fittable, String> {
        let FitSettings { model, curves, fit_x0, noise_percent, .. } = self.setup;
        let options = |curves, known: f64, rolling| {
            let passage = if fit_x0 { Passage::Fitted } else { Passage::Known(known) };
            FitOptions { model, curves, passage, rolling, ..FitOptions::default() }
        };
        match &self.samples {
            Samples::Simulated(simulated) => Ok(Fittable {
                observations: simulated.observations(&self.setup, noise_percent)?,
                options: options(curves, simulated.source.place().x0, simulated.rolling()),
                said: AssumedUnits::default(),
                lines: Vec::new(),
            }),
            Samples::Measured(file, baseline) => {
                let data = file.data(*baseline).map_err(|error| format!("{error:#}"))?;
                let curves = data.curves(Some(curves).filter(|curves| *curves != Curves::Both));
                let Data { observations, said, lines, .. } = data;
                let observations = left_out::without(&observations, &file.left_out);
                Ok(Fittable { observations, options: options(curves, 0.0, None), said, lines })
            }
        }
    }

    /// Returns the sentence on what explains the `samples` of a file where a fit with this `rms`, radians,
    /// does not, with the command that uses it.
    #[must_use]
    pub fn cause(&self, samples: &Fittable, rms: f64) -> Option<String> {
        let file = self.file()?;
        let cause = cause::find(&samples.observations, &samples.options, Some(rms), samples.said)?;
        Some(cause.told(&file.name, ""))
    }

    /// The file that the samples are from, if there is one.
    #[must_use]
    pub fn file(&self) -> Option<&DataFile> {
        match &self.samples {
            Samples::Simulated(_) => None,
            Samples::Measured(file, _) => Some(file),
        }
    }

    /// The point that was simulated, if one was.
    #[must_use]
    pub const fn simulated(&self) -> Option<&Simulated> {
        match &self.samples {
            Samples::Simulated(simulated) => Some(simulated),
            Samples::Measured(..) => None,
        }
    }
}

impl Simulated {
    /// Simulates a measurement of `point` with `settings`.
    #[must_use]
    pub fn new(settings: &Settings, point: &Track) -> Self {
        match along_street(settings, point) {
            Some((settings, point)) => Self::along_street(&settings, &point),
            None => Self::along_street(settings, point),
        }
    }

    /// The same of eyes that rest or ride along the street.
    fn along_street(settings: &Settings, point: &Track) -> Self {
        // A ride that coasts has what passes it move evenly, as a rest of the eyes has.
        let passage = settings.passage(point).filter(|_| settings.ride.is_on());
        let (velocity, source) = passage.map_or_else(
            || (settings.velocity(point.motion), settings.source(point)),
            |(velocity, place)| (velocity, place.into()),
        );
        let pair = settings.pair();
        let is_across = pair.iter().all(|eye| eye.x == 0.0);
        let obstacle = match &settings.ride {
            ride if !ride.coasts() => Some(ObstacleOfRide::ChangingSpeed),
            ride if !ride.is_along_street() => Some(ObstacleOfRide::Aslant),
            _ if point.spin.is_some() => Some(ObstacleOfRide::TurningPoint),
            _ if !is_across && velocity.is_backward => Some(ObstacleOfRide::EyesAcross),
            _ => None,
        };
        // Turned or mirrored so that it passes towards +x in front of the eyes: those across the street
        // exchange their sides at most.
        let (velocity, source, pair) = match source {
            Source::Point(place) if settings.ride.is_on() => {
                let side = if place.y < 0.0 { -1.0 } else { 1.0 };
                let place = SourcePoint { y: side * place.y, ..place };
                let pair = pair.map(|eye| Aperture { y: side * eye.y, ..eye });
                (Velocity::forward(velocity.speed), place.into(), pair)
            }
            _ => (velocity, source, pair),
        };
        Self {
            velocity,
            source,
            pair,
            obstacle_of_ride: obstacle.filter(|_| settings.ride.is_on()),
            range: settings.fit.fit_range.0.unwrap_or_else(|| settings.time_range(point)),
            model: settings.fit.data_from.model().unwrap_or_else(|| settings.model()),
        }
    }

    /// Samples with this much noise.
    ///
    /// # Errors
    ///
    /// Why there are none.
    pub fn observations(&self, setup: &FitSettings, noise_percent: f64) -> Result<Observations, String> {
        if let Some(obstacle) = self.obstacle() {
            return Err(obstacle.to_owned());
        }
        let last = setup.fit_samples.max(2) - 1;
        let time = |index: usize| time_within(self.range, index as f64 / last as f64);
        let simulation = Simulation {
            speed: self.velocity.speed,
            point: self.source.place(),
            rolling: self.rolling(),
            pair: self.pair,
            model: self.model,
            times: (0..=last).map(time).collect(),
            noise: 0.01 * noise_percent,
            seed: setup.seed,
        };
        simulation.observations().map_err(|error| error.to_string())
    }

    /// Returns the place of the point on its wheel, if it is on one that rolls.
    #[must_use]
    pub const fn rolling(&self) -> Option<Rolling> {
        match self.source {
            Source::Wheel(WheelPoint { radius, rho, angle, turning: Turning::Rolling, .. }) => {
                Some(Rolling { radius, rho, angle })
            }
            Source::Wheel(_) | Source::Point(_) => None,
        }
    }

    /// Returns the value of `parameter` that a fit of these curves should find.
    #[must_use]
    pub fn true_value(&self, parameter: Parameter, curves: Curves) -> f64 {
        let place = self.source.place();
        match parameter {
            Parameter::Beta => self.velocity.speed.beta(),
            Parameter::Y => place.y,
            // Delta-phi alone does not tell above from below, unless the point turns.
            Parameter::Z if curves == Curves::Azimuth && self.rolling().is_none() => place.z.abs(),
            Parameter::Z => place.z,
            Parameter::X0 => place.x0,
        }
    }

    /// Why there is nothing to fit, whatever the noise.
    fn obstacle(&self) -> Option<&'static str> {
        if let Some(obstacle) = self.obstacle_of_ride {
            Some(obstacle.text())
        } else if self.pair[0] == self.pair[1] {
            Some("both eyes are in one place (d = 0) and see the same")
        } else if self.velocity.speed.beta() == 0.0 {
            Some("at rest (β = 0) no disparity changes with T")
        } else if self.velocity.is_backward {
            Some("the fit needs a point that moves towards +x, and this one moves the other way")
        } else if matches!(self.source, Source::Wheel(_)) && self.rolling().is_none() {
            Some("the fit knows only wheels that roll, and that of the point turns at a speed of its own")
        } else if self.source.place().y <= 0.0 {
            Some("the fit looks in front of the eyes, and the point is not there (y ≤ 0)")
        } else {
            None
        }
    }
}
