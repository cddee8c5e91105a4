//! A curve over T as somebody draws it: stroke by stroke, and what is drawn again takes the place of what was
//! there.

/// Number of equal parts in which a range of T is drawn.
const PARTS: u32 = 120;

/// The T at which a curve over `times` (first and last T) is sampled.
fn samples([from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..=PARTS).map(move |part| from + (to - from) * f64::from(part) / f64::from(PARTS))
}

/// The curve of these `points` (T and value, T rising) after a straight stroke from one place to another, in
/// a plot over `times` (first and last T) of these `values` (lowest and highest).
#[must_use]
pub fn drawn(
    points: &[[f64; 2]],
    [times, values]: [[f64; 2]; 2],
    [from, to]: [[f64; 2]; 2],
) -> Vec<[f64; 2]> {
    let is_forward = from[0] <= to[0];
    let [first, last] = if is_forward { [from, to] } else { [to, from] };
    let on_stroke = |time: f64| {
        let width = last[0] - first[0];
        let share = if width > 0.0 { (time - first[0]) / width } else { 1.0 };
        (first[1] + share * (last[1] - first[1])).clamp(values[0], values[1])
    };
    let is_covered = |time: f64| (first[0]..=last[0]).contains(&time);
    let kept = points.iter().copied().filter(|[time, _]| !is_covered(*time));
    let new = samples(times).filter(|time| is_covered(*time)).map(|time| [time, on_stroke(time)]);
    let mut all: Vec<[f64; 2]> = kept.chain(new).collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    all
}

/// Returns the connected pieces of a drawn curve: there are gaps where nothing was drawn.
#[must_use]
pub fn pieces(points: &[[f64; 2]], [from, to]: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let widest = 1.5 * (to - from) / f64::from(PARTS);
    points.chunk_by(|a, b| b[0] - a[0] < widest).map(<[_]>::to_vec).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIMES: [f64; 2] = [-6.0, 6.0];
    const BOX: [[f64; 2]; 2] = [TIMES, [0.0, 3.0]];

    #[test]
    fn a_stroke_is_recorded_where_it_is_and_nowhere_else() {
        for stroke in [[[-2.03, 1.0], [2.02, 2.0]], [[2.02, 2.0], [-2.03, 1.0]]] {
            let points = drawn(&[], BOX, stroke);
            assert_eq!(points.len(), 41, "a sample each tenth from -2 to 2");
            for [time, value] in points {
                assert!((value - (1.0 + (time + 2.03) / 4.05)).abs() < 1e-12 && time.abs() <= 2.0 + 1e-9);
            }
        }
    }

    #[test]
    fn what_is_drawn_again_takes_the_place_of_what_was_there() {
        let first = drawn(&[], BOX, [[-6.0, 1.0], [6.0, 1.0]]);
        let second = drawn(&first, BOX, [[3.05, 2.0], [1.05, 2.0]]);
        assert_eq!((first.len(), second.len()), (121, 121));
        for ([time, value], [before, _]) in second.iter().zip(&first) {
            assert_eq!(time, before);
            assert_eq!(*value, if (1.05..=3.05).contains(time) { 2.0 } else { 1.0 }, "{time}");
        }
    }

    #[test]
    fn strokes_beside_the_plot_stay_in_it() {
        let points = drawn(&[], BOX, [[-90.0, -5.0], [90.0, 9.0]]);
        assert_eq!(points.len(), 121);
        assert!(points.iter().all(|[time, value]| time.abs() <= 6.0 && (0.0..=3.0).contains(value)));
        assert!(drawn(&[], BOX, [[7.0, 1.0], [9.0, 1.0]]).is_empty());
        assert!(drawn(&[], BOX, [[0.05, 1.0], [0.05, 2.0]]).is_empty(), "upright between two samples");
    }

    #[test]
    fn a_gap_stays_a_gap() {
        let left = drawn(&[], BOX, [[-5.0, 1.0], [-3.0, 1.0]]);
        let both = drawn(&left, BOX, [[1.0, 1.0], [4.0, 1.0]]);
        let pieces = pieces(&both, TIMES);
        assert_eq!(pieces.iter().map(Vec::len).collect::<Vec<_>>(), [left.len(), both.len() - left.len()]);
    }
}
