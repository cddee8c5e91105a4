//! Error statistics over many seeded cases.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::model::Parameter;

/// The number of cases that the documentation speaks of.
const DOCUMENTED_CASES: u64 = 15_000;

/// The first "median A, 99 % B, worst C" in the comments of `source`.
fn documented(source: &str) -> [f64; 3] {
    let comments = source.lines().filter_map(|line| line.trim_start().strip_prefix("//"));
    let words = comments.flat_map(|line| line.trim_start_matches(['/', '!']).split_whitespace());
    let text = words.collect::<Vec<_>>().join(" ");
    let (_, figures) = text.split_once("median ").expect("there are figures");
    ["", ", 99 % ", ", worst "].map(|before| {
        let (_, after) = figures.split_once(before).expect("there are three figures");
        let end = after.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(after.len());
        after[..end].trim_end_matches('.').parse().expect("a number")
    })
}

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

    /// Median, 99 % and worst of quantity `k`.
    fn figures(&self, k: usize) -> [f64; 3] {
        let sorted = self.sorted(k);
        let count = sorted.len();
        [sorted[count / 2], sorted[count * 99 / 100], sorted[count - 1]]
    }

    /// Prints median, 99 % and worst of each quantity, and fails where the worst exceeds `bound`.
    pub fn assert_within(&self, bound: f64) -> &Self {
        self.assert_each_within(|_| bound)
    }

    /// The same with a bound for each name.
    pub fn assert_each_within(&self, bound: impl Fn(&str) -> f64) -> &Self {
        let mut report = String::new();
        let count = self.cases.len();
        for (k, name) in self.names.iter().enumerate() {
            let [median, most, worst] = self.figures(k);
            println!("{name:>22}: {count} cases, median {median:.2}, 99 % {most:.2}, worst {worst:.2}");
            let bound = bound(name);
            if worst > bound {
                report += &["more than ", &bound.to_string(), " units: ", &self.worst(k)].concat();
            }
        }
        assert!(report.is_empty(), "{report}");
        self
    }

    /// Fails where one of `names` is less accurate than `source` documents, but for the rounding of its
    /// figures. Its cases begin with these; fewer do not tell where 99 % of them are.
    pub fn assert_as_documented(&self, source: &str, names: &[&str]) {
        let documented = documented(source);
        let is_whole = self.cases.len() as u64 >= DOCUMENTED_CASES;
        for (k, name) in self.names.iter().enumerate().filter(|(_, name)| names.contains(name)) {
            let measured = self.figures(k);
            for i in (0..3).filter(|&i| i != 1 || is_whole) {
                assert!(
                    measured[i] <= documented[i] + 0.05,
                    "{name}: {measured:?}, documented {documented:?}"
                );
            }
        }
    }

    fn worst(&self, k: usize) -> String {
        let by_error = |a: &&Case<N>, b: &&Case<N>| a.errors[k].total_cmp(&b.errors[k]);
        let case = self.cases.iter().max_by(by_error).expect("there are cases");
        format!("{}: {} at {:?} {:?}\n", self.names[k], case.errors[k], case.parameter, case.inputs)
    }
}
