//! The f64 renderer on the CPU: the truth the other renderers are held against.
//!
//! Each ray is boosted into the rest frame of each group of bodies, where it is straight (see
//! `GroupView::rest_ray`), and the nearest entry into a body, by light travel, is what the aperture sees.
//! [`Method::Reference`](crate::Method::Reference) says how accurate that is.

use glam::DVec3;

use crate::camera::lines_of_sight::LinesOfSight;
use crate::geometry::hierarchy::RayBundle;
use crate::geometry::intersect::Entry;
use crate::geometry::ray::Ray;
use crate::light::daylight::Facing;
use crate::light::hatch::Hatch;
use crate::light::shade::{Received, surface_colour};
use crate::picture::candidates::BAND;
use crate::picture::hit::{Hit, HitImage, Turned};
use crate::picture::pixels::{Picture, encoded, sample_grid};
use crate::picture::tiles::TILE_SIDE;
use crate::scene::first_entry::{CandidateBodies, Found};
use crate::scene::pattern::{Marking, SampleShifts};
use crate::scene::prepared_scene::PreparedScene;
use crate::street::backdrop::Backdrop;
use crate::street::contact::Contacts;
use crate::view::cap::Cap;
use crate::view::group_view::{GroupView, RestRay};
use crate::view::{Appearance, Geometry, View};

impl PreparedScene {
    /// Returns the hit along `line_of_sight` (unit vector, the camera's frame).
    ///
    /// Tests every body: meant for single rays. [`Self::hit_image`] is much faster per ray.
    #[must_use]
    pub fn first_hit(&self, view: &View, line_of_sight: DVec3) -> Option<Hit> {
        let groups: Vec<u32> = (0..self.groups().len() as u32).collect();
        let all = TileBodies { groups: &groups, others: self.numbers(), standing: None };
        self.first_hits_among(&all, view, &self.group_views(view), &[line_of_sight]).pop()?
    }

    /// Returns the hits among `bodies` along each of these lines of sight, at most [`RayBundle::MOST`]: of
    /// each group the first, of those the nearest by light travel.
    fn first_hits_among(
        &self,
        bodies: &TileBodies<'_>,
        view: &View,
        group_views: &[GroupView],
        lines_of_sight: &[DVec3],
    ) -> Vec<Option<Hit>> {
        let mut nearest: Vec<Option<Hit>> = vec![None; lines_of_sight.len()];
        let mut others = bodies.others;
        for group in bodies.groups.iter().map(|&group| group as usize) {
            let group_view = &group_views[group];
            let own;
            (own, others) = self.split(others, group);
            let within = |cap: &Cap| self.standing(group, group_view, cap);
            let standing = bodies.standing.as_ref().and_then(within);
            let chosen = CandidateBodies { group, others: own, standing };
            if chosen.is_empty() {
                continue;
            }
            for (nearest, hit) in
                nearest.iter_mut().zip(self.first_hits_in(&chosen, view, group_view, lines_of_sight))
            {
                *nearest = match (*nearest, hit) {
                    (Some(near), Some(hit)) if hit.distance < near.distance => Some(hit),
                    (near, hit) => near.or(hit),
                };
            }
        }
        nearest
    }

    /// Splits `bodies`, whose numbers ascend from this group's on, into those of the group and the others.
    /// The last group, often the only one, has them all without a search.
    fn split<'a>(&self, bodies: &'a [u32], group: usize) -> (&'a [u32], &'a [u32]) {
        let is_last = group + 1 == self.groups().len();
        let end = self.groups()[group].bodies.end;
        let count =
            if is_last { bodies.len() } else { bodies.partition_point(|&body| (body as usize) < end) };
        bodies.split_at(count)
    }

    /// Returns the hits among the `chosen` bodies of a group.
    fn first_hits_in(
        &self,
        chosen: &CandidateBodies<'_>,
        view: &View,
        group_view: &GroupView,
        lines_of_sight: &[DVec3],
    ) -> Vec<Option<Hit>> {
        let prepared = &self.groups()[chosen.group];
        let hit = |line_of_sight, (body, entry): Found, distance, ray: &RestRay| {
            let Entry { position, normal, triangle, .. } = entry;
            let Turned { proper_time, turn, material_position, own_doppler } =
                Turned::new(self.spin(body), group_view, position);
            Hit {
                body,
                rest_position: position,
                rest_normal: normal,
                distance,
                emission_time: view.emission_time(line_of_sight, distance),
                proper_time,
                turn,
                material_position,
                doppler_factor: ray.doppler_factor * own_doppler,
                triangle,
            }
        };
        if group_view.geometry == Geometry::OneCone {
            let one = |&line_of_sight: &DVec3| {
                let (found, distance, ray) =
                    self.first_entry_in_one_cone(prepared, chosen.others, group_view, line_of_sight)?;
                Some(hit(line_of_sight, found, distance, &ray))
            };
            return lines_of_sight.iter().map(one).collect();
        }
        let rays: Vec<_> = lines_of_sight.iter().map(|&sight| group_view.rest_ray(sight)).collect();
        let near = |ray: &RestRay| Ray::new(ray.origin, ray.direction).counted_from(prepared.extent.middle);
        let near: Vec<_> = rays.iter().map(near).collect();
        let entries = self.first_entries(chosen, &near, group_view);
        let one = |(i, found): (usize, Option<Found>)| {
            let (body, entry) = found?;
            let distance = (near[i].from_camera + entry.distance) * rays[i].ground_per_rest;
            Some(hit(lines_of_sight[i], (body, entry), distance, &rays[i]))
        };
        entries.into_iter().enumerate().map(one).collect()
    }

    /// Returns the hits at the centre of every pixel of `view`.
    #[must_use]
    pub fn hit_image(&self, view: &View) -> HitImage {
        let lines_of_sight = view.camera.lines_of_sight();
        let group_views = self.group_views(view);
        let hits = self.pixels(view, &group_views, &lines_of_sight, 1, &|_| true, |met| met.hits[0]);
        HitImage { size: view.camera.size, hits }
    }

    /// The picture `view` shows, sRGB-encoded, with `samples` times `samples` rays per pixel
    /// (1 or more).
    ///
    /// Samples go through the shoulder one by one, so that a bright body does not bleed over its outline, and
    /// are averaged in linear light.
    #[must_use]
    pub fn picture(&self, view: &View, appearance: &Appearance, samples: u32) -> Picture {
        let rgba = self.picture_rows(view, appearance, samples, &|_| true);
        Picture { size: view.camera.size, rgba }
    }

    /// Draws the same picture while `goes_on` is true, which is checked every few rows; `None` once it is
    /// false.
    #[must_use]
    pub fn picture_while(
        &self,
        view: &View,
        appearance: &Appearance,
        samples: u32,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Option<Picture> {
        let rgba = self.picture_rows(view, appearance, samples, &|_| goes_on());
        goes_on().then_some(Picture { size: view.camera.size, rgba })
    }

    /// Draws the band of 16 rows of the same picture, or of fewer at its end, that begins with the row
    /// `first`, a multiple of 16: nothing where it has no such rows. All bands one after the other are the
    /// picture.
    #[must_use]
    pub fn picture_band(
        &self,
        view: &View,
        appearance: &Appearance,
        samples: u32,
        first: u32,
    ) -> Vec<[u8; 4]> {
        let mut rgba = self.picture_rows(view, appearance, samples, &|top| top == first);
        let [width, height] = view.camera.size;
        let place = |row: u32| row.min(height) as usize * width as usize;
        rgba.truncate(place(first.saturating_add(BAND)));
        rgba.split_off(place(first))
    }

    /// The pixels of a picture, without those bands of rows that are not `wanted`, by their first row, when
    /// they would begin.
    fn picture_rows(
        &self,
        view: &View,
        appearance: &Appearance,
        samples: u32,
        wanted: &(dyn Fn(u32) -> bool + Sync),
    ) -> Vec<[u8; 4]> {
        let lines_of_sight = view.camera.lines_of_sight();
        let hatch = Hatch::new(view.camera.size, appearance.light);
        let group_views = self.group_views(view);
        let contacts = Contacts::new(self, &group_views, appearance);
        let backdrop = Backdrop::new(&view.camera, view.geometry, appearance).with_contacts(&contacts);
        self.pixels(view, &group_views, &lines_of_sight, samples, wanted, |met| {
            let rays = met.places.iter().zip(met.sights).zip(met.hits);
            let sum = rays.fold([0.0; 3], |sum: [f64; 3], ((&place, &line_of_sight), &hit)| {
                let covered = |hit: &Hit| {
                    let turns = lines_of_sight.turns(place).map(|turn| turn / f64::from(samples));
                    self.covered(hit, &group_views, line_of_sight, turns)
                };
                let mark = |hit: &Hit| self.mark(hit, covered(hit));
                let surface = |hit: &Hit| {
                    let facing = self.facing(appearance, &group_views, hit);
                    let Hit { rest_normal, doppler_factor, .. } = *hit;
                    let paint = self.paint_at(hit, || covered(hit));
                    let received = Received { rest_normal, doppler_factor, facing, paint, place };
                    surface_colour(appearance, &self.bodies()[hit.body], received, &hatch)
                };
                let colour = self.colour(&backdrop, line_of_sight, hit, mark, surface);
                std::array::from_fn(|i| sum[i] + colour[i])
            });
            encoded(sum.map(|part| part / f64::from(samples * samples)))
        })
    }

    /// The mark of the pattern at `hit`, on average over what is `covered`: the factor of its light.
    pub(crate) fn mark(&self, hit: &Hit, covered: SampleShifts) -> f64 {
        let body = &self.bodies()[hit.body];
        let place = hit.material_position - self.solid(hit.body).centre();
        let mark =
            |marking: &Marking| marking.mark(place, hit.material_normal(), covered.turned_back(hit.turn));
        body.marking.as_deref().map_or(1.0, mark)
    }

    /// Returns the motion of the surface at `hit` through the street's daylight, if that lights it.
    fn facing(&self, appearance: &Appearance, group_views: &[GroupView], hit: &Hit) -> Option<Facing> {
        let view = &group_views[self.group_of(hit.body)];
        let facing = || Facing::new(view, self.spin(hit.body).as_ref(), hit.rest_position, hit.rest_normal);
        view.is_lit_by_the_street(appearance).then(facing)
    }

    /// Returns the part of the surface at `hit` that a sample covers, given the turns of `line_of_sight` to
    /// those beside and below it.
    fn covered(
        &self,
        hit: &Hit,
        group_views: &[GroupView],
        line_of_sight: DVec3,
        turns: [DVec3; 2],
    ) -> SampleShifts {
        let group_view = &group_views[self.group_of(hit.body)];
        let ray = group_view.rest_ray_at(line_of_sight, hit.distance);
        let shifts = turns.map(|turn| group_view.shift(&ray, turn) * hit.distance);
        SampleShifts::new(ray.direction, hit.rest_normal, shifts)
    }

    /// Linear sRGB of what is seen along `line_of_sight`, in [0, 1] where it is a body.
    fn colour(
        &self,
        backdrop: &Backdrop,
        line_of_sight: DVec3,
        hit: Option<Hit>,
        mark: impl Fn(&Hit) -> f64,
        surface: impl Fn(&Hit) -> [f64; 3],
    ) -> [f64; 3] {
        let is_above_ground = |hit: &Hit| {
            backdrop.ground_distance(line_of_sight).is_none_or(|distance| hit.distance <= distance)
        };
        let Some(hit) = hit.filter(is_above_ground) else { return backdrop.behind(line_of_sight) };
        let colour = surface(&hit);
        let mark = if self.bodies()[hit.body].marking.is_some() { mark(&hit) } else { 1.0 };
        colour.map(|part| part * mark)
    }

    /// Returns one value per pixel of `view`, row by row, from the hits of `samples` times `samples` rays in
    /// it; the default in bands of rows that are not `wanted` when they would begin.
    fn pixels<T: Clone + Default + Send>(
        &self,
        view: &View,
        group_views: &[GroupView],
        lines_of_sight: &LinesOfSight,
        samples: u32,
        wanted: &(dyn Fn(u32) -> bool + Sync),
        value: impl Fn(&PixelHits<'_>) -> T + Sync,
    ) -> Vec<T> {
        // As many pixels are looked at together as have the rays of a tile with one ray to each.
        let side = (TILE_SIDE / samples).max(1);
        self.tiles(view, group_views, wanted, |look, rows| {
            for part in look.tile.parts(side) {
                let cap = || if part == look.tile { look.cap } else { Some(part.cap(lines_of_sight)) };
                let standing = look.cap.and_then(|_| cap());
                let bodies = TileBodies { groups: look.groups, others: look.others, standing };
                let mut places = Vec::with_capacity(RayBundle::MOST);
                part.pixels().for_each(|pixel| places.extend(sample_grid(pixel, samples)));
                let sights: Vec<_> = places.iter().map(|&place| lines_of_sight.through(place)).collect();
                let mut hits = Vec::with_capacity(sights.len());
                for some in sights.chunks(RayBundle::MOST) {
                    hits.append(&mut self.first_hits_among(&bodies, view, group_views, some));
                }
                let count = (samples * samples) as usize;
                let mut first = 0;
                part.pixels().for_each(|pixel| {
                    let own = first..first + count;
                    let met = PixelHits {
                        places: &places[own.clone()],
                        sights: &sights[own.clone()],
                        hits: &hits[own],
                    };
                    rows.put(pixel, value(&met));
                    first += count;
                });
            }
        })
    }
}

/// The hits of a pixel's rays.
struct PixelHits<'a> {
    /// Places of the rays in the picture, px.
    places: &'a [[f64; 2]],
    /// Lines of sight of the rays.
    sights: &'a [DVec3],
    hits: &'a [Option<Hit>],
}

/// The bodies that a part of a picture may show.
struct TileBodies<'a> {
    /// The numbers, which ascend, of the groups they are in.
    groups: &'a [u32],
    /// The numbers, which ascend, of those that do not keep their places, or of all those of a group whose
    /// rays curve.
    others: &'a [u32],
    /// Around the lines of sight along which those that do are looked for.
    standing: Option<Cap>,
}
