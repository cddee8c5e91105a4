//! Labels in a row, each as near to its place as the others let it be.

use eframe::egui::Rangef;

/// A label that belongs to a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// The place that the span's middle should be at.
    pub middle: f32,
    /// Width of the span.
    pub width: f32,
}

/// The left edges of `spans` inside `room`, at least `between` apart, in the order of their places. Where
/// there is not room enough they run out of it to the right.
#[must_use]
pub fn apart(spans: &[Span], room: Rangef, between: f32) -> Vec<f32> {
    let mut order: Vec<usize> = (0..spans.len()).collect();
    order.sort_by(|&a, &b| spans[a].middle.total_cmp(&spans[b].middle));
    let mut lefts: Vec<f32> = spans.iter().map(|span| span.middle - span.width / 2.0).collect();
    // Neighbours that are too near make way by halves; a few rounds settle rows as short as these.
    for _ in 0..4 * spans.len() {
        for pair in order.windows(2) {
            let lacking = lefts[pair[0]] + spans[pair[0]].width + between - lefts[pair[1]];
            if lacking > 0.0 {
                lefts[pair[0]] -= lacking / 2.0;
                lefts[pair[1]] += lacking / 2.0;
            }
        }
    }
    push_inside(&mut lefts, &order, spans, room, between);
    lefts
}

/// Moves spans that reach out of `room` inside, and those in their way.
fn push_inside(lefts: &mut [f32], order: &[usize], spans: &[Span], room: Rangef, between: f32) {
    let mut end = room.max;
    for &i in order.iter().rev() {
        lefts[i] = lefts[i].min(end - spans[i].width);
        end = lefts[i] - between;
    }
    let mut start = room.min;
    for &i in order {
        lefts[i] = lefts[i].max(start);
        start = lefts[i] + spans[i].width + between;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOM: Rangef = Rangef { min: 0.0, max: 100.0 };

    fn span(middle: f32) -> Span {
        Span { middle, width: 20.0 }
    }

    #[test]
    fn labels_stand_at_their_places_where_they_can() {
        assert_eq!(apart(&[span(70.0), span(20.0)], ROOM, 5.0), [60.0, 10.0]);
        assert_eq!(apart(&[span(-50.0), span(500.0)], ROOM, 5.0), [0.0, 80.0]);
    }

    #[test]
    fn no_label_covers_another_nor_leaves_the_room() {
        for middles in
            [[50.0, 50.0, 50.0], [0.0, 1.0, 2.0], [99.0, 98.0, 99.0], [30.0, 52.0, -9.0], [0.0, 0.0, 200.0]]
        {
            let spans = middles.map(span);
            let lefts = apart(&spans, ROOM, 5.0);
            let mut sorted = lefts.clone();
            sorted.sort_by(f32::total_cmp);
            assert!(sorted.windows(2).all(|pair| pair[1] - pair[0] >= 25.0 - 1e-3), "{middles:?}: {lefts:?}");
            assert!(sorted[0] >= 0.0 && sorted[2] <= 80.0, "{middles:?}: {lefts:?}");
        }
    }
}
