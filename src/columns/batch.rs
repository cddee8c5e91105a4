//! The columns of many observations at once, on all threads.

use gamow_platform::threads::prelude::*;
pub use relativity_core::batch::Column;
use relativity_core::batch::{DisparityColumns, ObservationColumns, Speeds, Threads, disparities};
use relativity_core::{Model, StereoError};
use thiserror::Error;

use super::header::{Header, InputError};
use super::model::ModelArgs;
use super::observation::{GivenInputs, Observation};
use crate::flags::SpeedParameter;

/// Number of observations that a task fills.
const CHUNK: usize = 4096;

/// The columns to fill.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WantedColumns {
    /// Every column of `gamow eval` with the same flags.
    All,
    /// The disparities dphi and dtheta.
    Disparity,
    /// The stereo columns: the place that two eyes take the point to be at.
    Stereo,
}

/// Observations, an input for each column of a header.
#[derive(Debug, Clone, Copy)]
pub struct Batch<'a> {
    /// Names of the inputs.
    pub header: &'a Header,
    /// The inputs in the order of the names, each of one length.
    pub inputs: &'a [Column<'a, f64>],
    /// Number of observations, a row each.
    pub rows: usize,
}

/// A row that cannot be filled.
#[derive(Debug, PartialEq, Error)]
#[error("{error}")]
pub struct BatchRowError {
    /// Index of the first such row.
    pub row: usize,
    /// Reason why the row cannot be filled.
    pub error: InputError,
}

impl WantedColumns {
    /// Returns the names of the columns.
    ///
    /// # Errors
    ///
    /// Stereo columns of a model that has none.
    pub fn columns(self, model: &ModelArgs, given: GivenInputs) -> Result<Vec<&'static str>, StereoError> {
        match self {
            Self::All => model.columns(given),
            Self::Disparity => Ok(vec!["dphi", "dtheta"]),
            Self::Stereo => {
                let all = ModelArgs { stereo: true, conformal: false, ..*model }.columns(given)?;
                Ok(all[all.len() - given.stereo()..].to_vec())
            }
        }
    }

    fn values(
        self,
        model: &ModelArgs,
        observation: &Observation,
        given: GivenInputs,
    ) -> Result<Vec<f64>, InputError> {
        Ok(match self {
            Self::All => model.values(observation, given)?,
            Self::Disparity => {
                let both = model.disparity(observation)?;
                vec![both.dphi, both.dtheta]
            }
            Self::Stereo => model.stereo_values(observation, given)?,
        })
    }
}

impl Batch<'_> {
    /// Fills the `wanted` columns into `out`, each of as many rows. The numbers are those of
    /// [`ModelArgs::values`], bit for bit.
    ///
    /// # Errors
    ///
    /// The first row with an input outside its domain. Columns are then partly written.
    pub fn fill(
        &self,
        wanted: WantedColumns,
        model: &ModelArgs,
        out: Vec<&mut [f64]>,
    ) -> Result<(), BatchRowError> {
        let mut out = out;
        if wanted == WantedColumns::Disparity
            && let [dphi, dtheta] = out.as_mut_slice()
            && self.is_filled_at_once(model, DisparityColumns { dphi, dtheta })
        {
            return Ok(());
        }
        let mut chunks: Vec<Vec<&mut [f64]>> = (0..self.rows.div_ceil(CHUNK)).map(|_| Vec::new()).collect();
        for column in out {
            chunks.iter_mut().zip(column.chunks_mut(CHUNK)).for_each(|(chunk, part)| chunk.push(part));
        }
        let fill = |(index, chunk)| self.fill_chunk(wanted, model, CHUNK * index, chunk);
        let faults: Vec<_> = match chunks.len() {
            0 | 1 => chunks.into_iter().enumerate().filter_map(fill).collect(),
            _ => chunks.into_par_iter().enumerate().filter_map(fill).collect(),
        };
        faults.into_iter().next().map_or(Ok(()), Err)
    }

    /// Fills the rows from `first` on; the first that cannot be filled.
    fn fill_chunk(
        &self,
        wanted: WantedColumns,
        model: &ModelArgs,
        first: usize,
        mut out: Vec<&mut [f64]>,
    ) -> Option<BatchRowError> {
        let given = self.header.given();
        for index in 0..out.first().map_or(0, |column| column.len()) {
            let row = first + index;
            let observation = self.observation(row);
            match observation.and_then(|observation| wanted.values(model, &observation, given)) {
                Ok(values) => out.iter_mut().zip(values).for_each(|(column, value)| column[index] = value),
                Err(error) => return Some(BatchRowError { row, error }),
            }
        }
        None
    }

    fn observation(&self, row: usize) -> Result<Observation, InputError> {
        self.header.observation_with(|place| self.inputs[place].at(row))
    }

    /// Fills the disparities by the batch form of the core; false where there is none, or where a row is out
    /// of range.
    fn is_filled_at_once(&self, model: &ModelArgs, out: DisparityColumns<'_, f64>) -> bool {
        let given = self.header.given();
        if model.model != Model::Exact || given.on_wheel || given.is_riding || self.rows == 0 {
            return false;
        }
        let places = self.header.places();
        let is_same = |place: usize| places.contains(&Some(place)) || self.inputs[place].each().is_none();
        let Ok(first) = self.observation(0) else { return false };
        if !(0..self.inputs.len()).all(is_same) || model.disparity(&first).is_err() {
            return false;
        }
        let [speed, x0, y, z, times] =
            places.map(|place| place.map_or(Column::Same(0.0), |place| self.inputs[place]));
        let speeds = match (speed.each(), self.header.speed_parameter) {
            (None, _) => Speeds::Same(first.speed),
            (Some(betas), SpeedParameter::Beta) => Speeds::Each(betas),
            (Some(_), _) => return false,
        };
        let apertures = first.baseline.apertures();
        let observations = ObservationColumns { speeds, x0, y, z, times, apertures };
        let threads = if self.rows > CHUNK { Threads::All } else { Threads::One };
        disparities(&observations, out, threads).is_ok()
    }
}

#[cfg(test)]
mod tests {
    use csv::ByteRecord;
    use relativity_core::Model;

    use super::*;

    const PLAIN: ModelArgs =
        ModelArgs { model: Model::Exact, intensity_exponent: 4.0, stereo: false, conformal: false };

    fn header(names: &[&str]) -> Header {
        Header::new(ByteRecord::from(names.to_vec()), |_| Ok(Vec::new())).expect("all are there")
    }

    fn disparities(
        header: &Header,
        inputs: &[Column<'_, f64>],
        rows: usize,
    ) -> Result<[Vec<f64>; 2], BatchRowError> {
        let (mut dphi, mut dtheta) = (vec![0.0; rows], vec![0.0; rows]);
        let batch = Batch { header, inputs, rows };
        batch.fill(WantedColumns::Disparity, &PLAIN, vec![&mut dphi, &mut dtheta])?;
        Ok([dphi, dtheta])
    }

    /// The batch form of the core, and one observation after the other, which a column of equal tilts leads
    /// to.
    #[test]
    fn both_ways_to_fill_have_the_same_bits() {
        let header = header(&["beta", "d", "y", "z", "T", "x0", "roll"]);
        let rows = 3 * CHUNK + 1;
        let times: Vec<f64> = (0..rows).map(|row| (row as f64 * 0.618_034).fract() * 40.0 - 20.0).collect();
        let same = [0.9, 0.1, 3.0, 2.0, 0.0, 0.3, 0.2].map(Column::Same);
        let betas: Vec<f64> = (0..rows).map(|row| (row as f64 * 0.755).fract()).collect();
        let tilts = vec![0.2; rows];
        let changed = |columns: &[(usize, &Vec<f64>)]| {
            let mut inputs = same;
            for &(place, values) in columns {
                inputs[place] = Column::Each(values.as_slice());
            }
            disparities(&header, &inputs, rows).expect("inside")
        };
        for columns in [
            &[(4, &times)][..],
            &[(0, &betas)],
            &[(0, &betas), (4, &times)],
            &[(2, &times), (3, &betas), (5, &times)],
        ] {
            let [fast, slow] = [changed(columns), changed(&[columns, &[(6, &tilts)]].concat())];
            assert!(fast[0].iter().any(|dphi| *dphi != fast[0][0]));
            for (fast, slow) in fast.iter().flatten().zip(slow.iter().flatten()) {
                assert_eq!(fast.to_bits(), slow.to_bits());
            }
        }
    }

    #[test]
    fn the_first_bad_row_is_named() {
        let header = header(&["T", "beta", "d", "y", "z"]);
        let mut times = vec![0.0; 3 * CHUNK];
        (times[CHUNK + 7], times[2 * CHUNK]) = (f64::NAN, 1e99);
        let inputs = [
            Column::Each(&times),
            Column::Same(0.5),
            Column::Same(0.1),
            Column::Same(1.0),
            Column::Same(1.0),
        ];
        let error = disparities(&header, &inputs, times.len()).expect_err("two rows are bad");
        assert_eq!(error.row, CHUNK + 7);
        assert!(error.to_string().starts_with("column T: \"NaN\" is not finite"), "{error}");
    }
}
