//! Lines cut off at the edges of a chart, so that the longest has no coordinate that a screen could not hold.

use super::chart::Chart;

impl Chart {
    /// The parts of the line through `places` of the world that come within `margin` points of the chart, on
    /// screen: `draw` is called with each.
    pub fn clipped(
        &self,
        places: impl IntoIterator<Item = [f64; 2]>,
        margin: f64,
        mut draw: impl FnMut(&[[f64; 2]]),
    ) {
        let mut run: Vec<[f64; 2]> = Vec::new();
        let mut last = None;
        for place in places {
            let next = self.screen(place);
            if let Some([from, to]) = last.and_then(|last| self.inside([last, next], margin)) {
                if run.last() != Some(&from) {
                    flush(&mut run, &mut draw);
                    run.push(from);
                }
                run.push(to);
            }
            last = Some(next);
        }
        flush(&mut run, &mut draw);
    }

    /// The part of the line between two places on screen that is within `margin` of the chart (Liang and
    /// Barsky 1984).
    fn inside(&self, [a, b]: [[f64; 2]; 2], margin: f64) -> Option<[[f64; 2]; 2]> {
        let (mut first, mut last) = (0.0f64, 1.0f64);
        for axis in 0..2 {
            let reach = self.half[axis] + margin;
            let [low, high] = [self.middle[axis] - reach, self.middle[axis] + reach];
            let along = b[axis] - a[axis];
            if !along.is_finite() {
                return None;
            }
            if along == 0.0 {
                if !(low..=high).contains(&a[axis]) {
                    return None;
                }
                continue;
            }
            let [enters, leaves] = [(low - a[axis]) / along, (high - a[axis]) / along];
            first = first.max(enters.min(leaves));
            last = last.min(enters.max(leaves));
        }
        let at = |s: f64| match s {
            0.0 => a,
            1.0 => b,
            s => [0, 1].map(|axis| a[axis] + s * (b[axis] - a[axis])),
        };
        (first <= last).then(|| [at(first), at(last)])
    }
}

fn flush(run: &mut Vec<[f64; 2]>, draw: &mut impl FnMut(&[[f64; 2]])) {
    if run.len() > 1 {
        draw(run);
    }
    run.clear();
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHART: Chart = Chart { middle: [50.0, 50.0], half: [50.0, 50.0], centre: [0.0, 0.0], scale: 10.0 };

    fn runs(places: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
        let mut runs = Vec::new();
        CHART.clipped(places.iter().copied(), 0.0, |run| runs.push(run.to_vec()));
        runs
    }

    #[test]
    fn a_line_inside_stays_whole() {
        assert_eq!(runs(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]]), [[[50.0, 50.0], [60.0, 50.0], [60.0, 30.0]]]);
    }

    #[test]
    fn a_line_is_cut_at_the_edges_and_comes_back_as_another() {
        let cut = runs(&[[0.0, 0.0], [10.0, 0.0], [10.0, 3.0], [0.0, 3.0]]);
        assert_eq!(cut, [[[50.0, 50.0], [100.0, 50.0]], [[100.0, 20.0], [50.0, 20.0]]]);
        assert_eq!(runs(&[[-1e12, 1.0], [1e12, 1.0]]), [[[0.0, 40.0], [100.0, 40.0]]]);
    }

    #[test]
    fn what_is_nowhere_near_is_not_drawn() {
        assert!(runs(&[[20.0, 20.0], [30.0, -20.0]]).is_empty());
        assert!(runs(&[[f64::NAN, 0.0], [1.0, 1.0]]).is_empty());
    }
}
