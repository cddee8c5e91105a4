//! The points of the scene that are followed: where they are at rest, and what they are called.

use crate::flags::{Followed, FollowedPoint};
use crate::scene::{Scene, Track};

/// A followed point, with its number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Number shown to the user, from 1; kept when others are removed.
    pub number: usize,
    /// Track of the point in the scene.
    pub track: Track,
    /// The body it was picked on; `None` for the scene's own tracked point, and one that is given by its
    /// place.
    pub body: Option<usize>,
}

impl Point {
    /// Returns the name of the body that the point is on.
    #[must_use]
    pub fn what<'a>(&self, scene: &'a Scene) -> &'a str {
        let nameless = if self.is_tracked() { "tracked point" } else { "point" };
        self.body_in(scene).map_or(nameless, |body| scene.name_of(body))
    }

    /// Returns the number of the body that it is on in `scene`: the one it was picked on, or the one at its
    /// place.
    #[must_use]
    pub fn body_in(&self, scene: &Scene) -> Option<usize> {
        self.body.or_else(|| scene.body_at(self.track.rest))
    }

    /// Returns the name of the point in a sentence; one with a number has no article: lamp 9.
    #[must_use]
    pub fn noun(&self, scene: &Scene) -> String {
        let what = self.what(scene);
        if what.ends_with(|last: char| last.is_ascii_digit()) {
            what.to_owned()
        } else {
            format!("the {what}")
        }
    }

    /// Returns the point in `scene`: on its body, if there is one of that number, with which it may turn.
    fn in_scene(self, scene: &Scene) -> Option<Self> {
        let rest = self.track.rest;
        let track =
            self.body.map_or_else(|| Some(scene.track(Some(rest))), |body| scene.track_at(rest, body))?;
        Some(Self { track, ..self })
    }

    /// Whether the point is the scene's own.
    const fn is_tracked(&self) -> bool {
        self.number == FIRST
    }
}

/// The followed points, one of them selected. The first is the scene's own tracked point, which always is one
/// of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    all: Vec<Point>,
    selected: usize,
    last_number: usize,
}

/// Greatest number of points that can be compared: as many as there are colours to distinguish them.
pub const MAX_POINTS: usize = 5;

/// Place of the scene's own tracked point among all.
const TRACKED: usize = 0;
/// Number of the scene's own point.
const FIRST: usize = 1;

impl Points {
    /// Only the scene's own tracked point.
    #[must_use]
    pub fn tracked(track: Track) -> Self {
        Self { all: vec![Point { number: FIRST, track, body: None }], selected: TRACKED, last_number: FIRST }
    }

    /// With these beside it, those that are there in `scene`.
    #[must_use]
    pub fn with_followed(mut self, scene: &Scene, followed: Option<Followed>) -> Self {
        for FollowedPoint { place, body } in followed.into_iter().flat_map(|followed| followed.0) {
            if let Some(track) = scene.track_at(place, body) {
                self.choose(track, body, true);
            }
        }
        self
    }

    /// With the one at `track` selected; if it is not there, beside the others.
    #[must_use]
    pub fn with_selected(mut self, track: Track) -> Self {
        self.selected = self.all.iter().position(|point| point.track == track).unwrap_or_else(|| {
            self.last_number += 1;
            self.all.truncate(MAX_POINTS - 1);
            self.all.push(Point { number: self.last_number, track, body: None });
            self.all.len() - 1
        });
        self
    }

    /// Returns the points beside the scene's own, as settings; for one that is given by its place no body is
    /// known.
    #[must_use]
    pub fn followed(&self) -> Option<Followed> {
        let on_body = |point: &Point| Some(FollowedPoint { place: point.track.rest, body: point.body? });
        let followed: Vec<_> = self.all.iter().filter_map(on_body).collect();
        (!followed.is_empty()).then_some(Followed(followed))
    }

    /// Returns all points: the scene's own tracked point, then the others in the order they were added.
    #[must_use]
    pub fn all(&self) -> &[Point] {
        &self.all
    }

    /// Place of the selected one in [`Self::all`].
    #[must_use]
    pub const fn selected_index(&self) -> usize {
        self.selected
    }

    /// Returns the selected point.
    #[must_use]
    pub fn selected(&self) -> &Point {
        &self.all[self.selected]
    }

    /// Whether the one at `index` can be removed: the scene's own tracked point cannot.
    #[must_use]
    pub const fn is_removable(&self, index: usize) -> bool {
        index != TRACKED
    }

    /// Selects the one at `index`, if there is one.
    pub fn select(&mut self, index: usize) {
        if index < self.all.len() {
            self.selected = index;
        }
    }

    /// Selects the point at `track` on `body`: in place of the selected one, or beside the others if it is to
    /// be added or if the selected one is the scene's own.
    pub fn choose(&mut self, track: Track, body: usize, add: bool) {
        let place = if self.selected == TRACKED { self.all.len() - 1 } else { self.selected };
        if (add || self.selected == TRACKED) && self.all.len() < MAX_POINTS {
            self.last_number += 1;
            self.all.push(Point { number: self.last_number, track, body: Some(body) });
            self.selected = self.all.len() - 1;
        } else {
            self.selected = place;
            let number = self.selected().number;
            self.all[self.selected] = Point { number, track, body: Some(body) };
        }
    }

    /// Removes the one at `index`, if it can be removed.
    pub fn remove(&mut self, index: usize) {
        if !self.is_removable(index) || index >= self.all.len() {
            return;
        }
        self.all.remove(index);
        if self.selected >= index {
            self.selected -= 1;
        }
    }

    /// Returns the points that exist in `scene`, which may have been read again since they were chosen.
    #[must_use]
    pub fn in_scene(mut self, scene: &Scene) -> Self {
        self.all[TRACKED].track = scene.track(None);
        for index in (TRACKED + 1..self.all.len()).rev() {
            match self.all[index].in_scene(scene) {
                Some(point) => self.all[index] = point,
                None => self.remove(index),
            }
        }
        self
    }

    /// Returns the points that still exist in `new`, another version of the scene `old`: on a body of the
    /// same name that moves alike.
    #[must_use]
    pub fn carried(&self, old: &Scene, new: &Scene) -> Self {
        let mut carried = Self { last_number: self.last_number, ..Self::tracked(new.track(None)) };
        for (index, point) in self.all.iter().enumerate().skip(TRACKED + 1) {
            let body = point.body.map(|body| new.counterpart(old, body));
            if body == Some(None) {
                continue;
            }
            carried.all.extend(Point { body: body.flatten(), ..*point }.in_scene(new));
            if index == self.selected {
                carried.selected = carried.all.len() - 1;
            }
        }
        carried
    }
}

#[cfg(test)]
mod tests {
    use relativity_render::Motion;

    use super::*;

    const fn at(rest: [f64; 3]) -> Track {
        Track { rest, motion: Motion::Scene, spin: None }
    }

    #[test]
    fn the_scene_s_own_point_stays_and_one_is_always_selected() {
        let mut points = Points::tracked(at([0.0, 3.0, 2.0]));
        points.remove(0);
        assert_eq!(points.all().len(), 1);
        // Beside the scene's own, then in place of the one that was picked.
        points.choose(at([1.0, 3.0, 2.0]), 4, false);
        points.choose(at([1.5, 3.0, 2.0]), 6, false);
        assert_eq!((points.all().len(), points.selected().number, points.selected().body), (2, 2, Some(6)));
        points.choose(at([2.0, 3.0, 2.0]), 5, true);
        assert_eq!(points.selected().number, 3);
        points.remove(1);
        assert_eq!((points.selected().number, points.selected_index()), (3, 1));
        points.remove(1);
        assert_eq!((points.selected().body, points.selected_index()), (None, 0));
    }

    #[test]
    fn no_more_points_than_colours() {
        let mut points = Points::tracked(at([0.0; 3]));
        for body in 0..10 {
            points.choose(at([0.0; 3]), body, true);
        }
        assert_eq!(points.all().len(), MAX_POINTS);
        assert_eq!(points.selected().body, Some(9));
        // The scene's own gives way to none.
        points.select(0);
        points.choose(at([0.0; 3]), 11, false);
        assert_eq!(
            (points.all().len(), points.all()[0].body, points.selected().body),
            (MAX_POINTS, None, Some(11))
        );
    }

    #[test]
    fn points_are_carried_over_to_another_version_of_their_scene() {
        let street = Scene::preset("street").expect("a preset");
        let bare = street.clone().without_surroundings();
        let number = |scene: &Scene, name: &str| scene.names.iter().position(|own| own == name);
        let tyre = number(&street, "rear tyre").expect("a bicycle has one");
        let house = (0..street.bodies.len())
            .find(|&body| bare.counterpart(&street, body).is_none())
            .expect("a street has houses");
        let mut points = Points::tracked(street.track(None));
        points.choose(at([1.0, 3.0, 2.0]), house, true);
        points.choose(at([-1.0, 3.0, 2.0]), tyre, true);
        let carried = points.carried(&street, &bare);
        assert_eq!(carried.all().len(), 2);
        assert_eq!((carried.selected().body, carried.selected().number), (number(&bare, "rear tyre"), 3));
    }
}
