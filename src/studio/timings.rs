//! Times of the stages of a picture.

use std::fmt;

use gamow_platform::clock::Instant;

/// Durations of stages, in the order in which they first ran.
#[derive(Debug, Default)]
pub struct Timings {
    stages: Vec<(&'static str, Vec<f64>)>,
}

impl Timings {
    /// Runs `work` and notes how long it took under `stage`.
    pub fn timed<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        let milliseconds = start.elapsed_ms();
        match self.stages.iter_mut().find(|(name, _)| *name == stage) {
            Some((_, durations)) => durations.push(milliseconds),
            None => self.stages.push((stage, vec![milliseconds])),
        }
        result
    }
}

impl fmt::Display for Timings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:12} {:>5} {:>10} {:>10} {:>10}", "stage", "runs", "min ms", "median ms", "max ms")?;
        for (stage, durations) in &self.stages {
            let mut sorted = durations.clone();
            sorted.sort_by(f64::total_cmp);
            let [min, median, max] = [sorted[0], sorted[sorted.len() / 2], sorted[sorted.len() - 1]];
            write!(f, "\n{stage:12} {:5} {min:10.2} {median:10.2} {max:10.2}", sorted.len())?;
        }
        Ok(())
    }
}
