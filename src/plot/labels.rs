//! Labels of marks: beside them, inside the axes, and not on top of each other.

/// About how wide a letter is and how high a line, pixels.
const LETTER: f64 = 7.0;
const LINE: f64 = 15.0;
/// From the middle of a mark to its name, pixels.
const BESIDE: f64 = 9.0;
/// From the bottom of a letter to that of its line.
const DESCENT: f64 = 4.0;

/// The names that are placed already.
pub struct PlacedNames {
    /// Left, right, top and bottom of the axes, pixels.
    frame: [f64; 4],
    taken: Vec<[f64; 4]>,
}

/// Start of the name, or its end with that `anchor`.
pub struct Label {
    pub anchor: &'static str,
    pub x: f64,
    pub y: f64,
}

impl PlacedNames {
    pub const fn new(frame: [f64; 4]) -> Self {
        Self { frame, taken: Vec::new() }
    }

    /// The place of the name `text` of a mark at (x, y): to its right or left, at its height or a line or more above or
    /// below, wherever it is free first; to the right where it is free nowhere.
    pub fn place(&mut self, [x, y]: [f64; 2], text: &str) -> Label {
        let width = LETTER * text.chars().count() as f64;
        let sides = [("start", x + BESIDE, x + BESIDE), ("end", x - BESIDE, x - BESIDE - width)];
        let heights = [0.0, -LINE, LINE, -2.0 * LINE, 2.0 * LINE, -3.0 * LINE, 3.0 * LINE];
        let candidates = heights.into_iter().flat_map(|height| {
            sides.map(|(anchor, at, left)| {
                let bottom = y + height + 0.5 * LINE;
                let label = Label { anchor, x: at, y: bottom - DESCENT };
                (label, [left, left + width, bottom - LINE, bottom])
            })
        });
        let mut candidates: Vec<_> = candidates.collect();
        let free = candidates.iter().position(|(_, area)| self.is_free(*area)).unwrap_or_default();
        let (label, area) = candidates.swap_remove(free);
        self.taken.push(area);
        label
    }

    fn is_free(&self, area: [f64; 4]) -> bool {
        let [left, right, top, bottom] = self.frame;
        let is_inside = area[0] > left && area[1] < right && area[2] > top && area[3] < bottom;
        is_inside && !self.taken.iter().any(|other| overlap(area, *other))
    }
}

fn overlap(a: [f64; 4], b: [f64; 4]) -> bool {
    a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_inside_the_axes_and_apart() {
        let frame = [70.0, 500.0, 40.0, 330.0];
        let mut labels = PlacedNames::new(frame);
        // In the corners, at the axes, and three in one place.
        let marks = [
            [75.0, 45.0],
            [495.0, 325.0],
            [75.0, 325.0],
            [300.0, 200.0],
            [302.0, 200.0],
            [301.0, 203.0],
            [290.0, 329.0],
        ];
        for mark in marks {
            labels.place(mark, "stable f64 (truth)");
        }
        let [left, right, top, bottom] = frame;
        for (index, area) in labels.taken.iter().enumerate() {
            assert!(area[0] > left && area[1] < right && area[2] > top && area[3] < bottom, "{area:?}");
            assert!(!labels.taken[..index].iter().any(|other| overlap(*area, *other)), "{area:?}");
        }
    }
}
