//! A drawn curve as a link carries it: a byte for each place of its grid.

use serde::{Deserialize, Serialize};

/// Greatest number of equal parts of the grid.
const MOST_PARTS: usize = 240;
/// Greatest height, which the highest point of the curve has.
const TOP: u8 = 254;
/// The height where nothing is drawn.
const GAP: u8 = 255;

/// A curve on a grid of equal parts of T. Its heights are off by at most 1/508 of the difference between the
/// highest and the lowest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct DrawnCurve {
    /// First and last T, in the scene's unit.
    times: [f32; 2],
    /// Lowest and highest value, in the unit of the question.
    values: [f32; 2],
    /// Height of each place of the grid, of [`TOP`]; [`GAP`] where there is none.
    heights: Vec<u8>,
}

impl DrawnCurve {
    /// The curve through these `points` (T and value, T rising), which are finite; `None` of fewer than two.
    pub fn new(points: &[[f64; 2]]) -> Option<Self> {
        let ([first, ..], [.., last]) = (points, points) else { return None };
        let width = last[0] - first[0];
        let mut steps: Vec<f64> = points.windows(2).map(|pair| pair[1][0] - pair[0][0]).collect();
        steps.sort_by(f64::total_cmp);
        // Most neighbours are as far from each other as those of the grid on which the curve was drawn.
        let step = *steps.get(steps.len() / 2)?;
        let parts = ((width / step).round().max(1.0) as usize).min(MOST_PARTS);
        let lowest = points.iter().map(|point| point[1]).fold(f64::INFINITY, f64::min);
        let highest = points.iter().map(|point| point[1]).fold(f64::NEG_INFINITY, f64::max);
        let mut heights = vec![GAP; parts + 1];
        for [time, value] in points {
            let place = ((time - first[0]) / width * parts as f64).round() as usize;
            let share = if highest > lowest { (value - lowest) / (highest - lowest) } else { 0.0 };
            heights[place.min(parts)] = (share * f64::from(TOP)).round() as u8;
        }
        let [times, values] = [[first[0], last[0]], [lowest, highest]].map(|ends| ends.map(|end| end as f32));
        let curve = Self { times, values, heights };
        curve.is_sound().then_some(curve)
    }

    /// Whether the curve has two points at least, and can be drawn.
    pub fn is_sound(&self) -> bool {
        let [[first, last], [lowest, highest]] = [self.times, self.values];
        let drawn = self.heights.iter().filter(|height| **height != GAP).count();
        let is_finite = [first, last, lowest, highest].iter().all(|number| number.is_finite());
        is_finite && first < last && lowest <= highest && drawn >= 2 && self.heights.len() <= MOST_PARTS + 1
    }

    /// Returns the points of a sound curve: T and value, T rising.
    pub fn points(&self) -> Vec<[f64; 2]> {
        let [[first, last], [lowest, highest]] = [self.times, self.values].map(|ends| ends.map(f64::from));
        let parts = self.heights.len().saturating_sub(1).max(1) as f64;
        let drawn = self.heights.iter().enumerate().filter(|(_, height)| **height != GAP);
        let point = |(place, height): (usize, &u8)| {
            let [along, up] = [place as f64 / parts, f64::from(*height) / f64::from(TOP)];
            [first + along * (last - first), lowest + up * (highest - lowest)]
        };
        drawn.map(point).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::sketch;

    const TIMES: [f64; 2] = [-6.0, 6.0];
    const BOX: [[f64; 2]; 2] = [TIMES, [0.0, 3.0]];

    #[test]
    fn a_curve_comes_back_within_a_byte_of_its_height_with_its_gap() {
        let left = sketch::drawn(&[], BOX, [[-5.0, 0.2], [-3.0, 2.9]]);
        let both = sketch::drawn(&left, BOX, [[1.0, 1.0], [4.0, 0.5]]);
        let again = DrawnCurve::new(&both).expect("it has points").points();
        assert_eq!(again.len(), both.len());
        for ([time, value], [time_again, value_again]) in both.iter().zip(&again) {
            assert!((time - time_again).abs() < 1e-5, "{time}");
            assert!((value - value_again).abs() <= (2.9 - 0.2) / 507.0, "{value} {value_again}");
        }
        let pieces =
            |points: &[[f64; 2]]| sketch::pieces(points, TIMES).iter().map(Vec::len).collect::<Vec<_>>();
        assert_eq!(pieces(&again), pieces(&both));
    }

    #[test]
    fn a_level_curve_is_level_and_a_point_is_none() {
        let level = DrawnCurve::new(&[[0.0, 2.0], [0.1, 2.0], [0.2, 2.0]]).expect("three points").points();
        assert!(level.iter().all(|[_, value]| *value == 2.0));
        assert_eq!((DrawnCurve::new(&[]), DrawnCurve::new(&[[1.0, 1.0]])), (None, None));
    }

    #[test]
    fn a_curve_that_cannot_be_drawn_is_none() {
        let good = DrawnCurve { times: [0.0, 1.0], values: [0.0, 1.0], heights: vec![0, 254] };
        assert!(good.is_sound());
        let wrong = [
            DrawnCurve { times: [1.0, 1.0], ..good.clone() },
            DrawnCurve { times: [0.0, f32::INFINITY], ..good.clone() },
            DrawnCurve { values: [f32::NAN, 1.0], ..good.clone() },
            DrawnCurve { values: [2.0, 1.0], ..good.clone() },
            DrawnCurve { heights: vec![0, GAP, GAP], ..good.clone() },
            DrawnCurve { heights: vec![0; 1000], ..good.clone() },
        ];
        assert!(wrong.iter().all(|curve| !curve.is_sound()));
    }
}
