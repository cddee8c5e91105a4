//! The points of the scene that are followed: where they are at rest, and what they are called.

use crate::scene::{Scene, Track};

/// A followed point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Number shown to the user, from 1; kept when others are removed.
    pub number: usize,
    /// Where it is in the scene.
    pub track: Track,
    /// The body it was picked on; `None` for the scene's own tracked point.
    pub body: Option<usize>,
}

impl Point {
    /// What it is on, in words.
    #[must_use]
    pub fn what<'a>(&self, scene: &'a Scene) -> &'a str {
        self.body.or(scene.tracked_body()).map_or("tracked point", |body| scene.name_of(body))
    }

    /// What it is called in a sentence.
    #[must_use]
    pub fn noun(&self, scene: &Scene) -> String {
        format!("the {}", self.what(scene))
    }
}

/// The followed points, one of them selected. Never empty.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    all: Vec<Point>,
    selected: usize,
    last_number: usize,
}

/// Most points that can be compared at once: as many as there are colours to tell them apart.
pub const MAX_POINTS: usize = 5;

impl Points {
    /// Only the scene's own tracked point.
    #[must_use]
    pub fn tracked(track: Track) -> Self {
        Self { all: vec![Point { number: 1, track, body: None }], selected: 0, last_number: 1 }
    }

    /// All of them, in the order they were added.
    #[must_use]
    pub fn all(&self) -> &[Point] {
        &self.all
    }

    /// Place of the selected one in [`Self::all`].
    #[must_use]
    pub const fn selected_index(&self) -> usize {
        self.selected
    }

    /// The selected one.
    #[must_use]
    pub fn selected(&self) -> &Point {
        &self.all[self.selected]
    }

    /// Selects the one at `index`, if there is one.
    pub fn select(&mut self, index: usize) {
        if index < self.all.len() {
            self.selected = index;
        }
    }

    /// Replaces the selected one by the point at `track` on `body`.
    pub fn replace_selected(&mut self, track: Track, body: usize) {
        let number = self.selected().number;
        self.all[self.selected] = Point { number, track, body: Some(body) };
    }

    /// Selects the point at `track` on `body`: beside the others if it is to be added, else in place of the selected one.
    pub fn choose(&mut self, track: Track, body: usize, add: bool) {
        if add {
            self.add(track, body);
        } else {
            self.replace_selected(track, body);
        }
    }

    /// Adds and selects the point at `track` on `body`; once there are [`MAX_POINTS`] the selected one
    /// is replaced instead.
    pub fn add(&mut self, track: Track, body: usize) {
        if self.all.len() == MAX_POINTS {
            return self.replace_selected(track, body);
        }
        self.last_number += 1;
        self.all.push(Point { number: self.last_number, track, body: Some(body) });
        self.selected = self.all.len() - 1;
    }

    /// Removes the one at `index`, unless it is the last.
    pub fn remove(&mut self, index: usize) {
        if self.all.len() == 1 || index >= self.all.len() {
            return;
        }
        self.all.remove(index);
        if self.selected > index || self.selected == self.all.len() {
            self.selected -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use relativity_render::Motion;

    use super::*;

    const fn at(rest: [f64; 3]) -> Track {
        Track { rest, motion: Motion::Scene }
    }

    #[test]
    fn one_point_always_stays_selected() {
        let mut points = Points::tracked(at([0.0, 3.0, 2.0]));
        points.remove(0);
        assert_eq!(points.all().len(), 1);
        points.add(at([1.0, 3.0, 2.0]), 4);
        points.add(at([2.0, 3.0, 2.0]), 5);
        assert_eq!(points.selected().number, 3);
        points.remove(0);
        assert_eq!((points.selected().number, points.selected_index()), (3, 1));
        points.remove(1);
        assert_eq!(points.selected().body, Some(4));
    }

    #[test]
    fn no_more_points_than_colours() {
        let mut points = Points::tracked(at([0.0; 3]));
        for body in 0..10 {
            points.add(at([0.0; 3]), body);
        }
        assert_eq!(points.all().len(), MAX_POINTS);
        assert_eq!(points.selected().body, Some(9));
    }
}
