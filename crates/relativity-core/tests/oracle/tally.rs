//! Error statistics over many seeded cases.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::model::Parameter;

/// Errors of `N` quantities in one case, and the inputs that led to them.
pub struct Case<const N: usize> {
    pub errors: [f64; N],
    pub parameter: Parameter,
    pub inputs: Vec<f64>,
}

/// The cases of a run, case `i` drawn with a generator of its own: the result does not depend on threads.
pub struct Tally<const N: usize> {
    names: [&'static str; N],
    cases: Vec<Case<N>>,
}

impl<const N: usize> Tally<N> {
    pub fn new(
        names: [&'static str; N],
        count: u64,
        case: impl Fn(&mut ChaCha8Rng) -> Case<N> + Sync,
    ) -> Self {
        let cases =
            (0..count).into_par_iter().map(|i| case(&mut ChaCha8Rng::seed_from_u64(i))).collect::<Vec<_>>();
        Self { names, cases }
    }

    /// Sorted errors of quantity `k`.
    pub fn sorted(&self, k: usize) -> Vec<f64> {
        let mut errors: Vec<f64> = self.cases.iter().map(|case| case.errors[k]).collect();
        errors.sort_by(f64::total_cmp);
        errors
    }

    /// Prints median, 99 % and worst of each quantity, and fails where the worst exceeds `bound`.
    pub fn assert_within(&self, bound: f64) {
        let mut report = String::new();
        for (k, name) in self.names.iter().enumerate() {
            let sorted = self.sorted(k);
            let count = sorted.len();
            let (median, most, worst) = (sorted[count / 2], sorted[count * 99 / 100], sorted[count - 1]);
            println!("{name:>22}: {count} cases, median {median:.2}, 99 % {most:.2}, worst {worst:.2}");
            if worst > bound {
                report += &self.worst(k);
            }
        }
        assert!(report.is_empty(), "more than {bound} units:\n{report}");
    }

    fn worst(&self, k: usize) -> String {
        let by_error = |a: &&Case<N>, b: &&Case<N>| a.errors[k].total_cmp(&b.errors[k]);
        let case = self.cases.iter().max_by(by_error).expect("there are cases");
        format!("{}: {} at {:?} {:?}\n", self.names[k], case.errors[k], case.parameter, case.inputs)
    }
}
