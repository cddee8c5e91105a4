//! Many errors in three numbers.

use serde::{Deserialize, Serialize};

/// Median, 99th percentile and largest of many errors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Half of the errors are at most this.
    pub median: f64,
    /// 99 of 100 errors are at most this.
    pub p99: f64,
    /// Largest error.
    pub worst: f64,
    /// Number of errors.
    pub count: usize,
}

impl Spread {
    /// The spread of `errors`, `None` of none.
    #[must_use]
    pub fn from_errors(mut errors: Vec<f64>) -> Option<Self> {
        errors.sort_by(f64::total_cmp);
        let count = errors.len();
        let at_most = |percent: usize| errors[(count * percent).div_ceil(100).max(1) - 1];
        let &worst = errors.last()?;
        Some(Self { median: at_most(50), p99: at_most(99), worst, count })
    }

    /// The worse of two spreads, figure by figure.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        Self {
            median: self.median.max(other.median),
            p99: self.p99.max(other.p99),
            worst: self.worst.max(other.worst),
            count: self.count + other.count,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hundred_errors_have_the_99th_as_their_99th_percentile() {
        let errors = (1..=100).rev().map(f64::from).collect();
        assert_eq!(
            Spread::from_errors(errors),
            Some(Spread { median: 50.0, p99: 99.0, worst: 100.0, count: 100 })
        );
    }

    #[test]
    fn one_error_is_all_of_its_spread_and_none_has_no_spread() {
        assert_eq!(
            Spread::from_errors(vec![3.0]),
            Some(Spread { median: 3.0, p99: 3.0, worst: 3.0, count: 1 })
        );
        assert_eq!(Spread::from_errors(vec![]), None);
    }
}
