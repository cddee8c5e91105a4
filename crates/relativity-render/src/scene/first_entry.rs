//! The first body of a group that a straight ray enters.

use fearless_simd::{Level, dispatch};
use glam::DVec3;

use super::prepared_scene::PreparedScene;
use crate::geometry::hierarchy::{Beam, BeamLine, Candidate, Hierarchy, RayBundle};
use crate::geometry::intersect::Entry;
use crate::geometry::ray::Ray;
use crate::simd::lanes::Simd;
use crate::view::cap::Cap;
use crate::view::group_view::GroupView;

/// The bodies of a group that rays may enter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CandidateBodies<'a> {
    /// The number of the group.
    pub group: usize,
    /// Bodies that turn, or all bodies; their numbers ascend.
    pub others: &'a [u32],
    /// Rays to search for bodies that keep their places, if these are searched at all.
    pub standing: Option<Within>,
}

/// The beam that contains the rays.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Within(Option<Beam>);

/// A body, and where a ray enters it.
pub(crate) type Found = (usize, Entry);

/// The nearest entry of a ray so far.
#[derive(Debug, Clone, Copy, Default)]
struct First {
    found: Option<Found>,
    /// Whether another was as near.
    is_tied: bool,
}

/// A search for the first entry of rays.
struct EntrySearch<'a> {
    scene: &'a PreparedScene,
    view: &'a GroupView,
    chosen: &'a CandidateBodies<'a>,
    tie: f64,
}

impl CandidateBodies<'_> {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.others.is_empty() && self.standing.is_none()
    }
}

impl PreparedScene {
    /// Returns the beam in which lines of sight within `cap` may meet the bodies of this `group` that keep
    /// their places.
    pub(crate) fn standing(&self, group: usize, view: &GroupView, cap: &Cap) -> Option<Within> {
        let hierarchy = self.hierarchy(group, view);
        if hierarchy.is_empty() || !view.has_straight_rays() {
            return None;
        }
        let beam = self.beam(group, view, cap);
        beam.is_none_or(|beam| hierarchy.is_met(&beam)).then_some(Within(beam))
    }

    /// The nearest entry of each of `rays`, which are counted from their points nearest to the middle of the
    /// group, among the bodies that are `chosen`; of equally near ones that of the lowest number. There are
    /// at most [`RayBundle::MOST`].
    pub(crate) fn first_entries(
        &self,
        chosen: &CandidateBodies<'_>,
        rays: &[Ray],
        view: &GroupView,
    ) -> Vec<Option<Found>> {
        let tie = self.groups()[chosen.group].tie();
        let search = EntrySearch { scene: self, view, chosen, tie };
        let mut firsts = vec![First::default(); rays.len()];
        for (first, ray) in firsts.iter_mut().zip(rays) {
            for &body in chosen.others {
                search.enter(first, ray, body);
            }
        }
        match &chosen.standing {
            None => {}
            Some(Within(Some(beam))) => search.along_all(beam, rays, &mut firsts),
            Some(Within(None)) => {
                for (first, ray) in firsts.iter_mut().zip(rays) {
                    search.along_one(ray, first);
                }
            }
        }
        let untied = |(first, ray): (&First, &Ray)| {
            if first.is_tied { search.first_in_order(ray) } else { first.found }
        };
        firsts.iter().zip(rays).map(untied).collect()
    }
}

/// Rays that look for them at once.
struct All<'a> {
    search: &'a EntrySearch<'a>,
    rays: &'a [Ray],
    lines: RayBundle,
    firsts: &'a mut [First],
    /// Distances beyond which nothing is seen, for each ray, and along none beyond `reach`.
    farthest: [f32; RayBundle::MOST],
    reach: f32,
}

impl All<'_> {
    /// Tests a candidate, and returns the distance up to which searching is worth while.
    #[inline(always)]
    fn visit<S: Simd>(&mut self, simd: S, candidate: &Candidate) -> f32 {
        let mut meeting = self.lines.meeting(simd, candidate.centre, candidate.half, &self.farthest);
        let mut has_less_reach = false;
        while meeting != 0 {
            let i = meeting.trailing_zeros() as usize;
            meeting &= meeting - 1;
            if self.search.enter(&mut self.firsts[i], &self.rays[i], candidate.body) {
                self.farthest[i] = self.firsts[i].farthest(self.search.tie);
                has_less_reach = true;
            }
        }
        if has_less_reach {
            self.reach = most(&self.farthest);
        }
        self.reach
    }
}

impl EntrySearch<'_> {
    /// Looks along `rays`, which are inside of `beam`, at once.
    fn along_all(&self, beam: &Beam, rays: &[Ray], firsts: &mut [First]) {
        let mut farthest = [f32::NEG_INFINITY; RayBundle::MOST];
        for (farthest, first) in farthest.iter_mut().zip(&*firsts) {
            *farthest = first.farthest(self.tie);
        }
        let (lines, reach) = (RayBundle::new(rays, self.middle()), most(&farthest));
        let mut all = All { search: self, rays, lines, firsts, farthest, reach };
        let hierarchy = self.hierarchy();
        let beam = &beam.around(rays, self.middle());
        dispatch!(Level::new(), simd => hierarchy.along_on(
            simd,
            beam,
            #[inline(always)]
            |candidate| all.visit(simd, &candidate),
        ));
    }

    fn along_one(&self, ray: &Ray, first: &mut First) {
        self.hierarchy().along(&BeamLine::new(ray, self.middle()), |candidate| {
            self.enter(first, ray, candidate.body);
            first.farthest(self.tie)
        });
    }

    /// Finds the first entry into bodies whose numbers ascend.
    fn first_in_order(&self, ray: &Ray) -> Option<Found> {
        let mut all = self.chosen.others.to_vec();
        if self.chosen.standing.is_some() {
            self.hierarchy().add_along(&BeamLine::new(ray, self.middle()), &mut all);
        }
        all.sort_unstable();
        all.dedup();
        let entries = all.iter().filter_map(|&body| self.entry(ray, body));
        entries.reduce(|first, next| if next.1.distance < first.1.distance - self.tie { next } else { first })
    }

    fn hierarchy(&self) -> &Hierarchy {
        self.scene.hierarchy(self.chosen.group, self.view)
    }

    fn middle(&self) -> DVec3 {
        self.scene.groups()[self.chosen.group].extent.middle
    }

    fn entry(&self, ray: &Ray, body: u32) -> Option<Found> {
        let number = body as usize;
        let entry = match self.scene.turning(number) {
            Some(turning) => self.scene.turning_entry(number, turning, ray, self.view, None).0,
            None => self.scene.standing_entry(number, ray),
        };
        Some((number, entry?))
    }

    /// Tests `ray` against a body, and updates the `first` hit.
    fn enter(&self, first: &mut First, ray: &Ray, body: u32) -> bool {
        if first.found.is_some_and(|(found, _)| found == body as usize) {
            return false;
        }
        let Some((number, entry)) = self.entry(ray, body) else { return false };
        let nearest = first.found.map(|(_, nearest)| nearest.distance);
        first.is_tied |= nearest.is_some_and(|nearest| (entry.distance - nearest).abs() <= 2.0 * self.tie);
        let is_nearer = nearest.is_none_or(|nearest| entry.distance < nearest);
        if is_nearer {
            first.found = Some((number, entry));
        }
        is_nearer
    }
}

impl First {
    /// Returns the distance beyond which nothing is seen.
    fn farthest(&self, tie: f64) -> f32 {
        let Some((_, Entry { distance, .. })) = self.found else { return f32::INFINITY };
        (distance + 3.0 * tie + 1e-6 * distance.abs()) as f32
    }
}

fn most(values: &[f32]) -> f32 {
    values.iter().fold(f32::NEG_INFINITY, |most, &value| if value > most { value } else { most })
}
