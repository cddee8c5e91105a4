//! Readings that somebody leaves out of a fit.

use relativity_core::{Observations, Sample};
use serde::{Deserialize, Serialize};

use super::data::Data;
use super::outliers::reading_name;

/// A reading that is left out.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Number of the reading's sample, from 0.
    pub sample: usize,
    /// Number of the reading's curve: 0 for dphi, 1 for dtheta.
    pub curve: usize,
    /// Number of the line in the file of readings, if there is one.
    line: Option<u64>,
    /// When it was taken.
    pub time: f64,
    /// The angle that was read, radians.
    pub value: f64,
}

impl LeftOut {
    /// The reading of this sample and curve in `data`, if there is one.
    #[must_use]
    pub fn new(data: &Data, sample: usize, curve: usize) -> Option<Self> {
        let taken = data.observations.samples().get(sample)?;
        let value = taken.readings()[curve]?.value;
        Some(Self { sample, curve, line: data.lines.get(sample).copied(), time: taken.time, value })
    }
}

/// The `observations` without these readings.
#[must_use]
pub fn without(observations: &Observations, left_out: &[LeftOut]) -> Observations {
    let mut samples: Vec<Sample> = observations.samples().to_vec();
    for LeftOut { sample, curve, .. } in left_out {
        if let Some(sample) = samples.get_mut(*sample) {
            *(if *curve == 0 { &mut sample.dphi } else { &mut sample.dtheta }) = None;
        }
    }
    // They were checked with more readings in them.
    Observations::new(observations.pairs().to_vec(), samples).unwrap_or_else(|_| observations.clone())
}

/// Says which readings are left out; `None` if none is.
#[must_use]
pub fn remark(left_out: &[LeftOut]) -> Option<String> {
    let names: Vec<String> =
        left_out.iter().map(|&LeftOut { curve, line, time, .. }| reading_name(curve, line, time)).collect();
    (!names.is_empty()).then(|| format!("left out by hand: {}", names.join(", ")))
}
