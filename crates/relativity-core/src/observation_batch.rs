//! Many observations of points by two apertures, and the loop over them.

use std::borrow::Borrow;
use std::ops::Range;

use crate::aperture::Aperture;
use crate::cone_pair::ConePair;
use crate::math::Elementary;
use crate::source::SourcePoint;
use crate::speed::{Coefficients, Speed};

/// A number of each row of a batch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Column<'a, F, S = F> {
    /// A number that all rows share.
    Same(S),
    /// A number for each row.
    Each(&'a [F]),
}

/// The speed of each row of a batch: one that all rows share, or a beta in [0, 1) for each.
pub type Speeds<'a, F> = Column<'a, F, Speed>;

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
    /// Observation times T, when the light is received.
    pub times: Column<'a, F>,
    /// The primary and the secondary aperture.
    pub apertures: [Aperture; 2],
}

/// The largest numbers of a row: the magnitude of a coordinate or time, and gamma.
#[derive(Debug, Clone, Copy)]
pub struct Limits<F> {
    pub(crate) coordinate: F,
    pub(crate) gamma: f64,
}

/// Columns that disparities are written to.
#[derive(Debug)]
pub struct DisparityColumns<'a, F> {
    /// Disparities Delta-phi: azimuth, primary minus secondary, radians.
    pub dphi: &'a mut [F],
    /// Disparities Delta-theta: elevation, primary minus secondary, radians.
    pub dtheta: &'a mut [F],
}

impl<F: Copy> Column<'_, F> {
    /// The number of a row.
    #[inline]
    #[must_use]
    pub const fn at(self, row: usize) -> F {
        match self {
            Self::Same(value) => value,
            Self::Each(values) => values[row],
        }
    }
}

impl<'a, F: Copy, S: Copy> Column<'a, F, S> {
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

impl<'a, F: Copy> ObservationColumns<'a, F> {
    /// The observations of these rows alone.
    pub(crate) fn rows(&self, rows: Range<usize>) -> Self {
        let part = |column: Column<'a, F>| column.rows(rows.clone());
        let Self { speeds, x0, y, z, times, apertures } = *self;
        Self {
            speeds: speeds.rows(rows.clone()),
            x0: part(x0),
            y: part(y),
            z: part(z),
            times: part(times),
            apertures,
        }
    }

    /// The columns that have a number for each row, with their names.
    pub(crate) fn each(&self) -> impl Iterator<Item = (&'static str, &'a [F])> {
        let betas = self.speeds.each();
        let columns = [("x0", self.x0), ("y", self.y), ("z", self.z), ("T", self.times)];
        let each = columns.into_iter().filter_map(|(name, column)| Some((name, column.each()?)));
        betas.map(|betas| ("beta", betas)).into_iter().chain(each)
    }
}

impl<F: Elementary + Into<f64>> ObservationColumns<'_, F> {
    /// Writes the disparities; whether the numbers of each row are inside these `limits`, if those that all
    /// rows share are.
    pub(crate) fn fill(&self, limits: Limits<F>, out: DisparityColumns<'_, F>) -> bool {
        let Self { speeds, x0, y, z, times, apertures } = *self;
        let point = |row: usize| {
            let place = [x0.at(row), y.at(row), z.at(row)];
            let [x0, y, z] = place.map(Into::into);
            (SourcePoint { x0, y, z }, place.iter().all(|number| number.abs() <= limits.coordinate))
        };
        match (speeds, x0, y, z, times) {
            // What all rows share is worked out once.
            (Column::Same(speed), Column::Same(_), Column::Same(_), Column::Same(_), Column::Each(times)) => {
                let (coefficients, (point, _)) = (speed.coefficients(), point(0));
                let rows = times.iter().map(|&time| (&coefficients, (point, true), time));
                fill(apertures, rows, limits, out)
            }
            (Column::Same(speed), ..) => {
                let coefficients = speed.coefficients();
                fill(apertures, (0..).map(|row| (&coefficients, point(row), times.at(row))), limits, out)
            }
            (Column::Each(betas), ..) => {
                let rows = betas.iter().enumerate().map(|(row, &beta)| {
                    let coefficients = Coefficients::<F>::of_beta(beta.into());
                    let (point, is_inside) = point(row);
                    // Not a number is not at most anything.
                    let is_speed = coefficients.gamma.into() <= limits.gamma;
                    (coefficients, (point, is_inside & is_speed), times.at(row))
                });
                fill(apertures, rows, limits, out)
            }
        }
    }
}

/// Writes the disparities of rows: each a speed's coefficients, a point with whether both are inside the
/// `limits`, and a time. Whether all rows are inside.
#[inline(always)]
#[expect(clippy::inline_always, reason = "what all rows share is worked out once")]
fn fill<F: Elementary, C: Borrow<Coefficients<F>>>(
    [primary, secondary]: [Aperture; 2],
    rows: impl Iterator<Item = (C, (SourcePoint, bool), F)>,
    limits: Limits<F>,
    out: DisparityColumns<'_, F>,
) -> bool {
    let mut are_inside = true;
    // No row is asked for beyond those of the output.
    for ((dphi, dtheta), (coefficients, (point, is_inside), time)) in
        out.dphi.iter_mut().zip(out.dtheta).zip(rows)
    {
        are_inside &= is_inside & (time.abs() <= limits.coordinate);
        let cones = ConePair::new(coefficients.borrow(), point, primary, secondary, time);
        (*dphi, *dtheta) = cones.wanted_angle_differences([true, true]);
    }
    are_inside
}
