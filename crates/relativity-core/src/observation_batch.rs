//! Many observations of points by two apertures, and the loop over them.

use std::ops::Range;

use crate::aperture::Aperture;
use crate::batch_error::{BatchError, check_common, check_lengths, first_outside};
use crate::cone_pair::ConePair;
use crate::real::Real;
use crate::source::SourcePoint;
use crate::speed::{Coefficients, Speed};

/// A number of each row of a batch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Column<'a, F> {
    /// A number that all rows share.
    Same(F),
    /// A number for each row.
    Each(&'a [F]),
}

/// The speed of each row of a batch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speeds<'a, F> {
    /// A speed that all rows share.
    Same(Speed),
    /// A beta in [0, 1) for each row.
    Betas(&'a [F]),
}

/// Observations of points by two apertures.
#[derive(Debug, Clone, Copy)]
pub struct ObservationColumns<'a, F> {
    /// Speeds of the points.
    pub speeds: Speeds<'a, F>,
    /// Objective x at t = 0.
    pub x0: Column<'a, F>,
    /// Depths y, ahead of the eyes.
    pub y: Column<'a, F>,
    /// Heights z, above the eyes.
    pub z: Column<'a, F>,
    /// Observation times T.
    pub times: Column<'a, F>,
    /// The primary and the secondary aperture.
    pub apertures: [Aperture; 2],
}

/// Columns that disparities are written to.
#[derive(Debug)]
pub struct DisparityColumns<'a, F> {
    /// Delta-phi, radians.
    pub dphi: &'a mut [F],
    /// Delta-theta, radians.
    pub dtheta: &'a mut [F],
}

impl<'a, F: Copy> Column<'a, F> {
    /// The number of a row.
    #[inline]
    #[must_use]
    pub const fn at(self, row: usize) -> F {
        match self {
            Self::Same(value) => value,
            Self::Each(values) => values[row],
        }
    }

    /// The column of these rows alone.
    #[must_use]
    pub fn rows(self, rows: Range<usize>) -> Self {
        match self {
            Self::Same(value) => Self::Same(value),
            Self::Each(values) => Self::Each(&values[rows]),
        }
    }

    /// The numbers of which there is one for each row.
    #[must_use]
    pub const fn each(self) -> Option<&'a [F]> {
        match self {
            Self::Same(_) => None,
            Self::Each(values) => Some(values),
        }
    }
}

impl<'a, F: Copy> Speeds<'a, F> {
    /// The betas of which there is one for each row.
    const fn betas(self) -> Option<&'a [F]> {
        match self {
            Self::Same(_) => None,
            Self::Betas(betas) => Some(betas),
        }
    }
}

impl<'a, F: Copy> ObservationColumns<'a, F> {
    /// The observations of these rows alone.
    pub(crate) fn rows(&self, rows: Range<usize>) -> Self {
        let part = |column: Column<'a, F>| column.rows(rows.clone());
        let speeds = match self.speeds {
            Speeds::Same(speed) => Speeds::Same(speed),
            Speeds::Betas(betas) => Speeds::Betas(&betas[rows.clone()]),
        };
        let Self { x0, y, z, times, apertures, .. } = *self;
        Self { speeds, x0: part(x0), y: part(y), z: part(z), times: part(times), apertures }
    }

    /// The columns that have a number for each row, with their names.
    fn each(&self) -> impl Iterator<Item = (&'static str, &'a [F])> {
        let betas = self.speeds.betas();
        let columns = [("x0", self.x0), ("y", self.y), ("z", self.z), ("T", self.times)];
        let each = columns.into_iter().filter_map(|(name, column)| Some((name, column.each()?)));
        betas.map(|betas| ("beta", betas)).into_iter().chain(each)
    }
}

impl<F: Real> ObservationColumns<'_, F> {
    /// An error unless each column has as many rows as those of the output, and what all rows share is inside
    /// the domain.
    pub(crate) fn check(&self, dphi: usize, dtheta: usize) -> Result<(), BatchError> {
        let lengths = self.each().map(|(name, values)| (name, values.len()));
        check_lengths(dphi, &lengths.chain([("dtheta", dtheta)]).collect::<Vec<_>>())?;
        let speed = match self.speeds {
            Speeds::Same(speed) => speed,
            Speeds::Betas(_) => Speed::REST,
        };
        let common = |column: Column<'_, F>| match column {
            Column::Same(value) => value.into(),
            Column::Each(_) => 0.0,
        };
        let point = SourcePoint { x0: common(self.x0), y: common(self.y), z: common(self.z) };
        check_common::<F>(&speed, point, &self.apertures, common(self.times))
    }

    /// The error of the first row with a value outside the domain.
    #[cold]
    pub(crate) fn first_outside(&self) -> Result<(), BatchError> {
        let no_speed = |(index, &beta): (usize, &F)| match Speed::from_beta(beta.into()) {
            Ok(speed) if speed.gamma() <= F::MAX_GAMMA => None,
            Ok(speed) => Some((index, BatchError::Single(speed.gamma()))),
            Err(error) => Some((index, BatchError::Speed { index, error })),
        };
        let betas = self.speeds.betas().unwrap_or_default();
        let outside = |rows: &Self| first_outside(&rows.each().collect::<Vec<_>>());
        match betas.iter().enumerate().find_map(no_speed) {
            Some((row, error)) => outside(&self.rows(0..row)).and(Err(error)),
            None => outside(self),
        }
    }

    /// Writes the disparities; whether the numbers of each row are inside the domain.
    pub(crate) fn fill(&self, out: DisparityColumns<'_, F>) -> bool {
        let Self { speeds, x0, y, z, times, apertures } = *self;
        // What all rows share is worked out once.
        if let (Speeds::Same(speed), Column::Same(x0), Column::Same(y), Column::Same(z)) = (speeds, x0, y, z)
        {
            let coefficients = speed.coefficients();
            return fill(apertures, out, |row| (coefficients, [x0, y, z], times.at(row)));
        }
        let place = |row| [x0.at(row), y.at(row), z.at(row)];
        match speeds {
            Speeds::Same(speed) => {
                let coefficients = speed.coefficients();
                fill(apertures, out, |row| (coefficients, place(row), times.at(row)))
            }
            Speeds::Betas(betas) => {
                let coefficients = |row: usize| Coefficients::of_beta(betas[row].into());
                fill(apertures, out, |row| (coefficients(row), place(row), times.at(row)))
            }
        }
    }
}

/// Writes the disparities of rows, each a speed, a place and a time; whether all are inside the domain.
#[inline(always)]
#[expect(clippy::inline_always, reason = "what all rows share is worked out once")]
fn fill<F: Real>(
    [primary, secondary]: [Aperture; 2],
    out: DisparityColumns<'_, F>,
    row: impl Fn(usize) -> (Coefficients<F>, [F; 3], F),
) -> bool {
    let limit = F::MAX_COORDINATE;
    let mut is_inside = true;
    for (index, (dphi, dtheta)) in out.dphi.iter_mut().zip(out.dtheta).enumerate() {
        let (coefficients, place, time) = row(index);
        // Not a number is not at most anything.
        is_inside &= coefficients.gamma.into() <= F::MAX_GAMMA;
        is_inside &= place.iter().chain([&time]).all(|number| number.abs() <= limit);
        let [x0, y, z] = place.map(Into::into);
        let cones = ConePair::new(&coefficients, SourcePoint { x0, y, z }, primary, secondary, time);
        (*dphi, *dtheta) = cones.wanted_angle_differences([true, true]);
    }
    is_inside
}
