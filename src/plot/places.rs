//! Places of labels: rectangles that cover neither each other nor marks, and as little as can be of what else
//! is drawn.
//!
//! Lengths are pixels or points, y points down.

/// Space between a mark and its label.
const GAP: f32 = 3.0;
/// From one to the next of the places at which a line is noted.
const STEP: f32 = 4.0;
/// More places of one line than this are not noted.
const MOST_STEPS: f32 = 1000.0;
/// Costs that differ by less count as alike, so that a label holds still while things move.
const ALIKE: f32 = 2.0;
/// Cost of leaving the room, and of covering something that must stay free.
const OUTSIDE: f32 = 1e6;
const TAKEN: f32 = 1e4;
/// The sides of a mark at which its label may stand, the first preferred: where its middle lies from there.
const SIDES: [[f32; 2]; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.0, -1.0], [0.0, 1.0]];

/// A rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Area {
    /// Left and top.
    pub min: [f32; 2],
    /// Right and bottom.
    pub max: [f32; 2],
}

impl Area {
    /// The rectangle of this `size` around a `middle`.
    fn around(middle: [f32; 2], size: [f32; 2]) -> Self {
        let corner = |sign: f32| [0, 1].map(|axis| middle[axis] + 0.5 * sign * size[axis]);
        Self { min: corner(-1.0), max: corner(1.0) }
    }

    /// The places for a label of this `size` beside a mark of this `radius`, the first preferred.
    pub fn beside(place: impl Into<[f32; 2]>, radius: f32, size: impl Into<[f32; 2]>) -> [Self; 8] {
        let (place, size) = (place.into(), size.into());
        SIDES.map(|side| {
            let is_diagonal = side[0] * side[1] != 0.0;
            let distance = if is_diagonal { 0.6 } else { 1.0 } * (radius + GAP);
            let middle = [0, 1].map(|axis| place[axis] + side[axis] * (0.5 * size[axis] + distance));
            Self::around(middle, size)
        })
    }

    /// The same, and after them those a line or two higher or lower.
    pub fn near(
        place: impl Into<[f32; 2]>,
        radius: f32,
        size: impl Into<[f32; 2]>,
    ) -> impl Iterator<Item = Self> {
        let (place, size) = (place.into(), size.into());
        [0.0, 1.0, 2.0].into_iter().flat_map(move |rows| {
            SIDES.into_iter().zip(Self::beside(place, radius, size)).map(move |(side, area)| {
                let moved = |[x, y]: [f32; 2]| [x, y + side[1] * rows * (size[1] + 1.0)];
                Self { min: moved(area.min), max: moved(area.max) }
            })
        })
    }

    /// The places for something of this `size` along the edges inside: the upper and the lower corners, and
    /// the middles.
    pub fn along_edges(self, size: impl Into<[f32; 2]>) -> [Self; 8] {
        let size = size.into();
        let mut sides = SIDES;
        sides.rotate_left(2);
        sides.map(|side| {
            let min = [0, 1].map(|axis| {
                let free = (self.max[axis] - self.min[axis] - size[axis]).max(0.0);
                self.min[axis] + 0.5 * (1.0 + side[axis]) * free
            });
            Self { min, max: [0, 1].map(|axis| min[axis] + size[axis]) }
        })
    }

    /// Whether the two have a part in common.
    fn intersects(self, other: Self) -> bool {
        (0..2).all(|axis| self.min[axis] <= other.max[axis] && other.min[axis] <= self.max[axis])
    }

    /// Whether all of the other is inside.
    fn holds(self, other: Self) -> bool {
        (0..2).all(|axis| self.min[axis] <= other.min[axis] && other.max[axis] <= self.max[axis])
    }

    /// The distance of a place; 0 inside.
    fn distance(self, place: [f32; 2]) -> f32 {
        let off = |axis: usize| (self.min[axis] - place[axis]).max(place[axis] - self.max[axis]).max(0.0);
        length([off(0), off(1)])
    }
}

fn length([x, y]: [f32; 2]) -> f32 {
    (x * x + y * y).sqrt()
}

/// The places of labels, and what they should avoid.
#[derive(Debug, Clone)]
pub struct LabelPlaces {
    room: Area,
    between: f32,
    taken: Vec<Area>,
    marks: Vec<([f32; 2], f32)>,
    lines: Vec<([f32; 2], f32)>,
}

impl LabelPlaces {
    /// Nothing yet in `room`, which no label leaves; so much is left free `between` labels, and around them.
    pub fn new(room: impl Into<Area>, between: f32) -> Self {
        Self { room: room.into(), between, taken: Vec::new(), marks: Vec::new(), lines: Vec::new() }
    }

    /// No label covers `area`.
    pub fn keep_free(&mut self, area: impl Into<Area>) {
        self.taken.push(area.into());
    }

    /// No label covers a mark of this `radius`.
    pub fn keep_clear_of(&mut self, place: impl Into<[f32; 2]>, radius: f32) {
        self.marks.push((place.into(), radius));
    }

    /// Labels stand beside the line through `places`, or a single place, where they can; that of the greatest
    /// `weight` is covered last.
    pub fn avoid(&mut self, places: impl IntoIterator<Item: Into<[f32; 2]>>, weight: f32) {
        let mut before: Option<[f32; 2]> = None;
        for to in places.into_iter().map(Into::into) {
            let from = before.unwrap_or(to);
            let way = [to[0] - from[0], to[1] - from[1]];
            let length = length(way);
            // Of a line that is densely sampled not each place is noted.
            if before.is_some() && length < STEP {
                continue;
            }
            before = Some(to);
            let [min, max] = [f32::min, f32::max].map(|end| [end(from[0], to[0]), end(from[1], to[1])]);
            if self.room.intersects(Area { min, max }) {
                let pieces = (length / STEP).clamp(1.0, MOST_STEPS).ceil();
                let place = |piece: u32| [0, 1].map(|axis| from[axis] + way[axis] * piece as f32 / pieces);
                self.lines.extend((0..pieces as u32).map(|piece| (place(piece), weight)));
            }
        }
    }

    /// The cost of covering `area`.
    fn cost(&self, area: Area) -> f32 {
        let by = self.between;
        let wide = Area { min: area.min.map(|end| end - by), max: area.max.map(|end| end + by) };
        let taken = self.taken.iter().filter(|taken| taken.intersects(wide)).count();
        let marks = self.marks.iter().filter(|(place, radius)| area.distance(*place) < *radius).count();
        let covered = self.lines.iter().filter(|(place, _)| wide.distance(*place) == 0.0);
        let lines = covered.map(|(_, weight)| weight / ALIKE).sum::<f32>().floor();
        let outside = if self.room.holds(area) { 0.0 } else { OUTSIDE };
        outside + TAKEN * (taken + marks) as f32 + lines.min(TAKEN - 1.0)
    }

    /// Takes the first of the `candidates` that covers least; `None` where none of them is free.
    pub fn take_free(&mut self, candidates: impl IntoIterator<Item: Into<Area>>) -> Option<Area> {
        self.take_below(TAKEN, candidates)
    }

    /// Takes the first of the `candidates` that covers least, even where none of them is free.
    pub fn take(&mut self, candidates: impl IntoIterator<Item: Into<Area>>) -> Option<Area> {
        self.take_below(f32::INFINITY, candidates)
    }

    fn take_below(&mut self, most: f32, areas: impl IntoIterator<Item: Into<Area>>) -> Option<Area> {
        let costs = areas.into_iter().map(Into::into).map(|area| (self.cost(area), area));
        let (_, area) = costs.filter(|(cost, _)| *cost < most).min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        self.taken.push(area);
        Some(area)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [f32; 2] = [60.0, 14.0];
    const ROOM: Area = Area { min: [0.0; 2], max: [300.0, 200.0] };

    #[test]
    fn a_label_stands_beside_its_mark_away_from_lines() {
        let mut labels = LabelPlaces::new(ROOM, 0.0);
        let mark = [150.0, 100.0];
        let first = labels.clone().take_free(Area::beside(mark, 4.0, SIZE)).expect("there is room");
        assert!(first.min[0] > mark[0] + 4.0 && first.min[1] + first.max[1] == 2.0 * mark[1], "{first:?}");
        labels.avoid([mark, [300.0, 100.0]], 1.0);
        let second = labels.take_free(Area::beside(mark, 4.0, SIZE)).expect("there is room");
        assert!(!second.intersects(first) && second.distance(mark) >= 4.0, "{second:?}");
    }

    #[test]
    fn labels_cover_neither_marks_nor_each_other_and_stay_in_the_room() {
        let mut labels = LabelPlaces::new(ROOM, 0.0);
        let marks: Vec<[f32; 2]> = (0..30).map(|i| [10.0 * i as f32, (37 * i % 200) as f32]).collect();
        for mark in &marks {
            labels.keep_clear_of(*mark, 4.0);
        }
        let mut taken: Vec<Area> = Vec::new();
        for mark in &marks {
            let Some(area) = labels.take_free(Area::beside(*mark, 4.0, SIZE)) else { continue };
            assert!(ROOM.holds(area) && taken.iter().all(|other| !other.intersects(area)));
            assert!(marks.iter().all(|mark| area.distance(*mark) >= 4.0), "{area:?}");
            taken.push(area);
        }
        assert!(taken.len() > 10, "{}", taken.len());
    }

    #[test]
    fn a_mark_outside_or_nowhere_has_no_label() {
        for mark in [[-500.0, 10.0], [f32::NAN, 10.0], [f32::INFINITY, 10.0]] {
            assert_eq!(LabelPlaces::new(ROOM, 0.0).take_free(Area::beside(mark, 4.0, SIZE)), None);
        }
    }

    #[test]
    fn along_the_edges_the_corner_that_covers_least_is_first() {
        let mut labels = LabelPlaces::new(ROOM, 0.0);
        let at = |labels: &LabelPlaces| labels.clone().take(ROOM.along_edges(SIZE)).map(|area| area.min);
        assert_eq!(at(&labels), Some([240.0, 0.0]));
        labels.avoid([[0.0, 0.0], [300.0, 0.0]], 1.0);
        assert_eq!(at(&labels), Some([240.0, 186.0]));
        labels.keep_free(Area::around([270.0, 190.0], [10.0; 2]));
        assert_eq!(at(&labels), Some([0.0, 186.0]));
    }

    /// A line of very many samples costs as much as one of few.
    #[test]
    fn the_cost_of_a_line_is_its_length() {
        let cost = |pieces: u16| {
            let mut labels = LabelPlaces::new(ROOM, 0.0);
            labels.avoid((0..=pieces).map(|i| [300.0 * f32::from(i) / f32::from(pieces), 100.0]), 1.0);
            labels.cost(Area { min: [0.0, 90.0], max: [200.0, 110.0] })
        };
        assert!((cost(1) - cost(3000)).abs() <= 2.0, "{} {}", cost(1), cost(3000));
    }

    #[test]
    fn names_of_marks_in_one_row_stand_above_each_other() {
        let mut labels = LabelPlaces::new(ROOM, 0.0);
        let marks = [120.0, 150.0, 180.0].map(|x| [x, 190.0]);
        for mark in marks {
            labels.keep_clear_of(mark, 5.0);
        }
        for mark in marks {
            assert!(labels.take_free(Area::near(mark, 5.0, [90.0, 14.0])).is_some(), "{mark:?}");
        }
    }
}
