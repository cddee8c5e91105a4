//! The f64 renderer on the CPU: the truth the other renderers are held against.
//!
//! Each ray is boosted into the rest frame of the bodies, where it is straight (see `View::rest_ray`), and
//! the nearest entry into a body is what the aperture sees.
//!
//! # Accuracy
//!
//! `tests/reference.rs`: against the core's light cone of each point shown, from rest to gamma = 1e30,
//! positions are off by less than 1e-11 px, distances and Doppler factors by less than 1e-13 of themselves;
//! a tracer that walks back along the light, without a boost, sees the same bodies.

use glam::DVec3;
use rayon::prelude::*;

use crate::backdrop::Backdrop;
use crate::body::Body;
use crate::camera::LinesOfSight;
use crate::colour::hue_preserving_clip;
use crate::cone::Cone;
use crate::intersect::{Entry, Solid, bounding_box};
use crate::picture::{Picture, encoded};
use crate::ray::Ray;
use crate::shade::surface_colour;
use crate::tiles::{TILE_SIDE, bands};
use crate::view::{Appearance, View};

/// What one ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Number of the body, in the order given.
    pub body: usize,
    /// On its surface, in the rest frame.
    pub rest_position: DVec3,
    /// Outward unit normal in the rest frame.
    pub rest_normal: DVec3,
    /// From the aperture to the event of emission in the ground frame (in the rest frame for
    /// [`Geometry::Rest`](crate::Geometry::Rest)).
    pub distance: f64,
    /// Ground time of emission; the observation time itself for
    /// [`Geometry::Contracted`](crate::Geometry::Contracted), whose light is instantaneous.
    pub emission_time: f64,
    /// Doppler factor, 1 unless the geometry is [`Geometry::Seen`](crate::Geometry::Seen).
    pub doppler_factor: f64,
}

/// Of two surfaces nearer to each other than this part of the scene's size, along a ray, that of the body with
/// the lower number is seen: they are one surface, and which comes out nearer is a matter of rounding.
const TIE: f64 = 1e-12;

/// Bodies prepared for tracing. Bodies may overlap; the nearest surface is seen, of equally near ones the
/// one with the lowest number.
#[derive(Debug, Clone)]
pub struct ReferenceScene {
    solids: Vec<Solid>,
    /// Of a box around the bodies: distances along rays count from near it.
    middle: DVec3,
    /// [`TIE`] times the box's diagonal.
    tie: f64,
    /// The numbers of all bodies.
    all: Vec<u32>,
    rest_wavelengths_nm: Vec<f64>,
}

/// What every pixel of a picture shows, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct HitImage {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// One per pixel centre, `None` where nothing is seen.
    pub hits: Vec<Option<Hit>>,
}

impl ReferenceScene {
    /// Prepares `bodies`, numbered from 0 in this order.
    #[must_use]
    pub fn new(bodies: &[Body]) -> Self {
        let solids: Vec<_> = bodies.iter().map(|body| Solid::new(&body.shape)).collect();
        let [low, high] = bounding_box(&solids).unwrap_or_default();
        Self {
            solids,
            middle: 0.5 * (low + high),
            tie: TIE * low.distance(high),
            all: (0..bodies.len() as u32).collect(),
            rest_wavelengths_nm: bodies.iter().map(|body| body.rest_wavelength_nm).collect(),
        }
    }

    /// What is seen along `line_of_sight` (unit vector, ground frame).
    ///
    /// Tests every body: meant for single rays. [`Self::hit_image`] is much faster per ray.
    #[must_use]
    pub fn first_hit(&self, view: &View, line_of_sight: DVec3) -> Option<Hit> {
        self.first_hit_among(&self.all, view, line_of_sight)
    }

    fn first_hit_among(&self, bodies: &[u32], view: &View, line_of_sight: DVec3) -> Option<Hit> {
        if bodies.is_empty() {
            return None;
        }
        let ray = view.rest_ray(line_of_sight);
        let near = Ray::new(ray.origin, ray.direction).counted_from(self.middle);
        let (body, entry) = self.first_entry(bodies, &near)?;
        let distance = (near.from_camera + entry.distance) * ray.ground_per_rest;
        Some(Hit {
            body,
            rest_position: entry.position,
            rest_normal: entry.normal,
            distance,
            emission_time: view.emission_time(line_of_sight, distance),
            doppler_factor: ray.doppler_factor,
        })
    }

    /// The nearest entry of `ray` among `bodies`, whose numbers ascend.
    fn first_entry(&self, bodies: &[u32], ray: &Ray) -> Option<(usize, Entry)> {
        let entries = bodies.iter().filter_map(|&body| {
            let body = body as usize;
            Some((body, self.solids[body].entry(ray)?))
        });
        entries.reduce(|first, next| if next.1.distance < first.1.distance - self.tie { next } else { first })
    }

    /// What `view` shows at the centre of every pixel.
    #[must_use]
    pub fn hit_image(&self, view: &View) -> HitImage {
        let lines_of_sight = LinesOfSight::new(&view.camera);
        let hits = self.pixels(view, |bodies, [u, v]| {
            let center = [f64::from(u) + 0.5, f64::from(v) + 0.5];
            self.first_hit_among(bodies, view, lines_of_sight.through(center))
        });
        HitImage { size: view.camera.size, hits }
    }

    /// The picture `view` shows, sRGB-encoded, with `samples` times `samples` rays per pixel
    /// (1 or more).
    ///
    /// Samples are clipped one by one, so that a bright body does not bleed over its silhouette, and
    /// averaged in linear light.
    #[must_use]
    pub fn picture(&self, view: &View, appearance: &Appearance, samples: u32) -> Picture {
        let lines_of_sight = LinesOfSight::new(&view.camera);
        let backdrop = Backdrop::new(&view.camera, appearance);
        let rgba = self.pixels(view, |bodies, pixel| {
            let sum = sample_grid(pixel, samples).fold([0.0; 3], |sum: [f64; 3], place| {
                let line_of_sight = lines_of_sight.through(place);
                let hit = self.first_hit_among(bodies, view, line_of_sight);
                let colour = self.colour(appearance, &backdrop, line_of_sight, hit);
                std::array::from_fn(|i| sum[i] + colour[i])
            });
            encoded(sum.map(|part| part / f64::from(samples * samples)))
        });
        Picture { size: view.camera.size, rgba }
    }

    /// Linear sRGB of what is seen along `line_of_sight`, in [0, 1] where it is a body.
    fn colour(
        &self,
        appearance: &Appearance,
        backdrop: &Backdrop,
        line_of_sight: DVec3,
        hit: Option<Hit>,
    ) -> [f64; 3] {
        let ground_distance = backdrop.ground_distance(line_of_sight);
        match (hit, ground_distance) {
            (Some(hit), ground) if ground.is_none_or(|distance| hit.distance <= distance) => {
                let wavelength_nm = self.rest_wavelengths_nm[hit.body];
                let Hit { rest_normal, doppler_factor, .. } = hit;
                hue_preserving_clip(surface_colour(appearance, wavelength_nm, rest_normal, doppler_factor))
            }
            (_, Some(distance)) => backdrop.ground(line_of_sight, distance),
            (_, None) => backdrop.sky(line_of_sight),
        }
    }

    /// One value per pixel of `view`, row by row, from the bodies that can be seen there and the pixel.
    fn pixels<T: Clone + Default + Send>(
        &self,
        view: &View,
        value: impl Fn(&[u32], [u32; 2]) -> T + Sync,
    ) -> Vec<T> {
        let cone = |solid: &Solid| Cone::of_sight(view, solid.center(), solid.bounding_radius());
        let cones: Vec<_> = self.solids.iter().map(cone).collect();
        let bands = bands(&view.camera, &cones);
        let [width, height] = view.camera.size.map(|side| side as usize);
        let mut image = vec![T::default(); width * height];
        let rows = image.par_chunks_mut((width * TILE_SIDE as usize).max(1));
        rows.zip(bands).for_each(|(rows, band)| {
            for (tile, bodies) in band {
                for [u, v] in tile.pixels() {
                    rows[(v % TILE_SIDE) as usize * width + u as usize] = value(&bodies, [u, v]);
                }
            }
        });
        image
    }
}

/// The centres of `samples` times `samples` equal parts of a pixel.
pub(crate) fn sample_grid([u, v]: [u32; 2], samples: u32) -> impl Iterator<Item = [f64; 2]> {
    let place = move |pixel, part| f64::from(pixel) + (f64::from(part) + 0.5) / f64::from(samples);
    (0..samples).flat_map(move |j| (0..samples).map(move |i| [place(u, i), place(v, j)]))
}
