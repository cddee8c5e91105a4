//! Corrections of readings that were taken, or written down, in another way than a fit takes them.

use clap::Args;
use relativity_core::{Curves, FitError, Observations, Reading, Sample};

use super::data::{AssumedUnits, Kind, Unit};
use crate::flags::{COORDINATES, within};

/// Readings that were written down in another way.
#[derive(Debug, Clone, Copy, Default, PartialEq, Args)]
pub struct Correction {
    /// Unit of dphi, dtheta and their sigmas where the file does not say: rad, mrad, urad, deg, arcmin,
    /// arcsec.
    #[arg(long = "angle-unit", value_name = "UNIT", value_parser = angles)]
    pub angles: Option<Unit>,
    /// Unit of T, or of clock, where the file does not say: s, ms, us, ns, min. Lengths are then in
    /// light-seconds.
    #[arg(long = "time-unit", value_name = "UNIT", value_parser = times)]
    pub times: Option<Unit>,
    /// Readings with the other sign: right minus left, or down for up.
    #[arg(long, value_enum, value_name = "CURVES")]
    pub negate: Option<Curves>,
    /// Adds this to the times of dtheta, whose clock was another than that of dphi.
    #[arg(long, value_name = "TIME", value_parser = within(COORDINATES), allow_hyphen_values = true)]
    pub shift_dtheta: Option<f64>,
}

fn angles(text: &str) -> Result<Unit, String> {
    Kind::Angle.unit(text).ok_or_else(|| "must be rad, mrad, urad, deg, arcmin or arcsec".to_owned())
}

fn times(text: &str) -> Result<Unit, String> {
    Kind::Time.unit(text).ok_or_else(|| "must be s, ms, us, ns or min".to_owned())
}

impl Correction {
    /// The units that a file is read in where it says none.
    #[must_use]
    pub const fn units(&self) -> AssumedUnits {
        AssumedUnits { times: self.times, angles: self.angles }
    }

    /// The readings with the right signs and times; their units are those that they were read in.
    ///
    /// # Errors
    ///
    /// A time out of range.
    pub fn applied(&self, observations: Observations) -> Result<Observations, FitError> {
        if self.negate.is_none() && self.shift_dtheta.is_none() {
            return Ok(observations);
        }
        self.changed(&observations, [1.0; 2])
    }

    /// The readings as if their units had been read as these, too.
    ///
    /// # Errors
    ///
    /// Readings that are out of range then.
    pub(super) fn with_units(&self, observations: &Observations) -> Result<Observations, FitError> {
        self.changed(observations, [self.times, self.angles].map(|unit| unit.map_or(1.0, |unit| unit.factor)))
    }

    fn changed(
        &self,
        observations: &Observations,
        [times, angles]: [f64; 2],
    ) -> Result<Observations, FitError> {
        let [dphi, dtheta] = self.negate.map_or([false; 2], Curves::used);
        let changed = |reading: Option<Reading>, is_negated: bool| {
            let factor = if is_negated { -angles } else { angles };
            reading.map(|Reading { value, sigma }| Reading {
                value: factor * value,
                sigma: sigma.map(|sigma| angles * sigma),
            })
        };
        let samples = observations.samples().iter().map(|sample| Sample {
            time: times * sample.time,
            dphi: changed(sample.dphi, dphi),
            dtheta: changed(sample.dtheta, dtheta),
            ..*sample
        });
        let samples = match self.shift_dtheta {
            None => samples.collect(),
            Some(shift) => samples.flat_map(|sample| shifted(sample, shift)).collect(),
        };
        Observations::new(observations.pairs().to_vec(), samples)
    }

    /// The flags of `gamow fit` for it, a blank before each.
    #[must_use]
    pub fn flags(&self) -> String {
        let flag = |name: &str, value: Option<String>| {
            value.map_or_else(String::new, |value| format!(" --{name}{value}"))
        };
        let unit = |unit: Option<Unit>| unit.map(|unit| format!(" {}", unit.name));
        [
            flag("angle-unit", unit(self.angles)),
            flag("time-unit", unit(self.times)),
            flag("negate", self.negate.map(|curves| format!(" {}", curves.name()))),
            flag("shift-dtheta", self.shift_dtheta.map(|shift| format!("={shift}"))),
        ]
        .concat()
    }
}

/// `sample` with its reading of dtheta in a sample of its own, later by `shift`.
fn shifted(sample: Sample, shift: f64) -> impl Iterator<Item = Sample> {
    let of_dtheta = Sample { time: sample.time + shift, dphi: None, ..sample };
    let of_dphi = Sample { dtheta: None, ..sample };
    [of_dphi, of_dtheta].into_iter().filter(|sample| sample.dphi.is_some() || sample.dtheta.is_some())
}
