//! The first body of a group that a straight ray enters.

use crate::group_view::GroupView;
use crate::hierarchy::{Beam, Candidate, Line};
use crate::intersect::Entry;
use crate::ray::Ray;
use crate::scene::PreparedScene;

/// Of a tile more bodies than this are looked for along each of its rays.
const MOST_SHARED: usize = 24;

/// Which of the bodies of a group that keep their places a tile may show.
#[derive(Debug, Clone)]
pub(crate) enum Standing {
    /// These, the nearest first.
    Few(Vec<Candidate>),
    /// More than it is worth to keep.
    Many,
}

/// The bodies of a group that a ray may enter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chosen<'a> {
    /// The number of the group.
    pub group: usize,
    /// Of those that turn, or of all; their numbers ascend.
    pub others: &'a [u32],
    /// Of those that keep their places.
    pub standing: Option<&'a Standing>,
}

/// The nearest entry so far.
struct First<'a> {
    scene: &'a PreparedScene,
    ray: &'a Ray,
    view: &'a GroupView,
    tie: f64,
    found: Option<(usize, Entry)>,
    /// Whether another was as near.
    is_tied: bool,
}

impl Chosen<'_> {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.others.is_empty()
            && self.standing.is_none_or(|standing| matches!(standing, Standing::Few(few) if few.is_empty()))
    }
}

impl PreparedScene {
    /// Which bodies of this `group` that keep their places are met by `beam`, which is wider than a ray.
    pub(crate) fn standing(&self, group: usize, beam: &Beam) -> Standing {
        let mut few: Vec<Candidate> = Vec::new();
        let mut are_many = false;
        self.hierarchy(group).along(beam, |candidate| {
            let is_known = |known: &&mut Candidate| candidate.is_one_of_some && known.body == candidate.body;
            match few.iter_mut().find(is_known) {
                Some(known) => known.nearest = known.nearest.min(candidate.nearest),
                None => few.push(candidate),
            }
            are_many = few.len() > MOST_SHARED;
            if are_many { f32::NEG_INFINITY } else { f32::INFINITY }
        });
        if are_many {
            return Standing::Many;
        }
        few.sort_by(|a, b| a.nearest.total_cmp(&b.nearest));
        Standing::Few(few)
    }

    /// The nearest entry of `ray`, counted from its point nearest to the middle of the group, among the bodies that are
    /// `chosen`; of equally near ones that of the lowest number.
    pub(crate) fn first_entry(
        &self,
        chosen: &Chosen<'_>,
        ray: &Ray,
        view: &GroupView,
    ) -> Option<(usize, Entry)> {
        let prepared = &self.groups()[chosen.group];
        let mut first = First { scene: self, ray, view, tie: prepared.tie(), found: None, is_tied: false };
        for &body in chosen.others {
            first.enter(body);
        }
        let along = || Line::new(ray, prepared.extent.middle);
        match chosen.standing {
            None => {}
            Some(Standing::Few(candidates)) => {
                for candidate in candidates {
                    if candidate.nearest > first.farthest() {
                        break;
                    }
                    first.enter(candidate.body);
                }
            }
            Some(Standing::Many) => self.hierarchy(chosen.group).along(&along(), |candidate| {
                first.enter(candidate.body);
                first.farthest()
            }),
        }
        if !first.is_tied {
            return first.found;
        }
        let mut all = chosen.others.to_vec();
        match chosen.standing {
            None => {}
            Some(Standing::Few(candidates)) => all.extend(candidates.iter().map(|candidate| candidate.body)),
            Some(Standing::Many) => self.hierarchy(chosen.group).along(&along(), |candidate| {
                all.push(candidate.body);
                f32::INFINITY
            }),
        }
        all.sort_unstable();
        all.dedup();
        first.in_order(&all)
    }
}

impl First<'_> {
    fn entry(&self, body: u32) -> Option<(usize, Entry)> {
        let number = body as usize;
        let entry = match self.scene.turning(number) {
            Some(turning) => turning.entry(self.ray, self.view, None).0,
            None => self.scene.solid(number).entry(self.ray),
        };
        Some((number, entry?))
    }

    fn enter(&mut self, body: u32) {
        if self.found.is_some_and(|(found, _)| found == body as usize) {
            return;
        }
        let Some((number, entry)) = self.entry(body) else { return };
        let Some((_, nearest)) = self.found else {
            self.found = Some((number, entry));
            return;
        };
        self.is_tied |= (entry.distance - nearest.distance).abs() <= 2.0 * self.tie;
        if entry.distance < nearest.distance {
            self.found = Some((number, entry));
        }
    }

    /// What begins farther than this is not seen.
    fn farthest(&self) -> f32 {
        let Some((_, Entry { distance, .. })) = self.found else { return f32::INFINITY };
        (distance + 3.0 * self.tie + 1e-6 * distance.abs()) as f32
    }

    /// The same of bodies whose numbers ascend.
    fn in_order(&self, bodies: &[u32]) -> Option<(usize, Entry)> {
        let entries = bodies.iter().filter_map(|&body| self.entry(body));
        entries.reduce(|first, next| if next.1.distance < first.1.distance - self.tie { next } else { first })
    }
}
