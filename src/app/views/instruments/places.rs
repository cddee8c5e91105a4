//! Places of the instruments in a picture: at its lower edge, in the middle, but where something is marked
//! there.

use eframe::egui::{Rect, Vec2, pos2, vec2};

/// Space between the instruments and the edge of the picture, points.
const MARGIN: f32 = 6.0;

/// Places of a dial and of the plates beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Places {
    /// The square around the dial.
    pub dial: Rect,
    /// The plates of the rider's clock and of the street's; none where they have no room.
    pub plates: Option<[Rect; 2]>,
}

impl Places {
    /// Returns the places in a picture at `rect` of a dial with this `radius` and of plates of these sizes,
    /// `gap` apart; `None` where not even the dial has room. Marks that are to stay in sight keep `free`.
    #[must_use]
    pub fn new(rect: Rect, radius: f32, plates: [Vec2; 2], gap: f32, free: &[Rect]) -> Option<Self> {
        let room = rect.shrink(MARGIN);
        let dial = Vec2::splat(2.0 * radius);
        // As wide on both sides, so that the dial stands in the middle.
        let beside = plates[0].x.max(plates[1].x) + gap;
        let sides = [[beside; 2], plates.map(|plate| plate.x + gap), [0.0; 2]];
        if dial.y > room.height() {
            return None;
        }
        let fits = |[left, right]: &[f32; 2]| left + dial.x + right <= room.width();
        let at = |[left, right]: [f32; 2]| {
            let width = left + dial.x + right;
            [room.center().x - 0.5 * width, room.min.x, room.max.x - width].map(|x| {
                let dial = Rect::from_min_size(pos2(x + left, room.max.y - dial.y), dial);
                let plates = (left > 0.0).then(|| {
                    let corner = [
                        dial.left_bottom() - vec2(gap + plates[0].x, plates[0].y),
                        dial.right_bottom() + vec2(gap, -plates[1].y),
                    ];
                    [0, 1].map(|side: usize| Rect::from_min_size(corner[side], plates[side]))
                });
                Self { dial, plates }
            })
        };
        let is_free = |places: &Self| {
            let all = places.all().expand(gap);
            !free.iter().any(|mark| all.intersects(*mark))
        };
        let places: Vec<_> = sides.into_iter().filter(fits).flat_map(at).collect();
        places.iter().copied().find(is_free).or_else(|| places.first().copied())
    }

    /// The dial, and the plates that have room.
    pub fn parts(&self) -> impl Iterator<Item = Rect> {
        std::iter::once(self.dial).chain(self.plates.into_iter().flatten())
    }

    /// The rectangle around all of it.
    #[must_use]
    pub fn all(&self) -> Rect {
        self.parts().fold(self.dial, Rect::union)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLATES: [Vec2; 2] = [vec2(70.0, 40.0), vec2(160.0, 40.0)];

    fn at(size: [f32; 2], free: &[Rect]) -> Option<Places> {
        Places::new(Rect::from_min_size(pos2(10.0, 20.0), size.into()), 45.0, PLATES, 8.0, free)
    }

    #[test]
    fn instruments_stand_in_the_middle_of_the_lower_edge_and_never_on_each_other() {
        for size in [[1260.0, 640.0], [500.0, 300.0], [348.0, 200.0], [336.0, 195.0], [120.0, 110.0]] {
            let rect = Rect::from_min_size(pos2(10.0, 20.0), size.into());
            let places = at(size, &[]).expect("there is room");
            let parts: Vec<_> = places.parts().collect();
            for (number, part) in parts.iter().enumerate() {
                assert!(rect.contains_rect(*part), "{size:?}: {part:?}");
                assert!(!parts[..number].iter().any(|other| other.intersects(*part)), "{size:?}");
            }
            assert!((places.all().max.y - rect.max.y).abs() < 10.0);
            assert_eq!(places.plates.is_some(), size[0] > 340.0, "{size:?}");
        }
        let middle = at([1260.0, 640.0], &[]).expect("there is room").dial.center().x;
        assert!((middle - 640.0).abs() < 0.5);
        assert_eq!(at([60.0, 400.0], &[]), None);
        assert_eq!(at([400.0, 60.0], &[]), None);
    }

    #[test]
    fn instruments_make_way_for_what_is_marked() {
        let mark = Rect::from_center_size(pos2(640.0, 620.0), Vec2::splat(20.0));
        let places = at([1260.0, 640.0], &[mark]).expect("there is room");
        assert!(!places.parts().any(|part| part.intersects(mark)));
    }
}
