//! The f64 renderer on the CPU: the truth the other renderers are held against.
//!
//! Each ray is boosted into the rest frame of the bodies, where it is straight (see `View::rest_ray`), and the
//! nearest entry into a body is what the aperture sees.

use glam::DVec3;
use rayon::prelude::*;

use crate::backdrop::backdrop;
use crate::body::Body;
use crate::bvh::Bvh;
use crate::camera::LinesOfSight;
use crate::colour::hue_preserving_clip;
use crate::intersect::Solid;
use crate::picture::{Picture, encoded};
use crate::shade::surface_colour;
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
    /// [`Geometry::Rest`]).
    pub distance: f64,
    /// Ground time of emission; the observation time itself for [`Geometry::Contracted`], whose light is
    /// instantaneous.
    pub emission_time: f64,
    /// Doppler factor, 1 unless the geometry is [`Geometry::Seen`].
    pub doppler_factor: f64,
}

/// Bodies prepared for tracing. Bodies may overlap; the nearest surface is seen.
#[derive(Debug, Clone)]
pub struct ReferenceScene {
    bvh: Bvh,
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
        Self {
            bvh: Bvh::new(bodies.iter().map(|body| Solid::new(&body.shape))),
            rest_wavelengths_nm: bodies.iter().map(|body| body.rest_wavelength_nm).collect(),
        }
    }

    /// What is seen along `line_of_sight` (unit vector, ground frame).
    #[must_use]
    pub fn first_hit(&self, view: &View, line_of_sight: DVec3) -> Option<Hit> {
        let ray = view.rest_ray(line_of_sight);
        let (body, entry) = self.bvh.nearest_entry(ray.origin, ray.direction)?;
        Some(Hit {
            body,
            rest_position: entry.position,
            rest_normal: entry.normal,
            distance: entry.distance * ray.ground_per_rest,
            emission_time: view.emission_time(line_of_sight, entry.distance * ray.ground_per_rest),
            doppler_factor: ray.doppler_factor,
        })
    }

    /// What `view` shows at the centre of every pixel.
    #[must_use]
    pub fn hit_image(&self, view: &View) -> HitImage {
        let size @ [width, height] = view.camera.size;
        let lines_of_sight = LinesOfSight::new(&view.camera);
        let mut hits = vec![None; width as usize * height as usize];
        let rows = hits.par_chunks_mut(width.max(1) as usize).zip(0..height);
        rows.for_each(|(row, v)| {
            for (hit, u) in row.iter_mut().zip(0..width) {
                let pixel = [f64::from(u) + 0.5, f64::from(v) + 0.5];
                *hit = self.first_hit(view, lines_of_sight.through(pixel));
            }
        });
        HitImage { size, hits }
    }

    /// The picture `view` shows, sRGB-encoded, with `samples` times `samples` rays per pixel
    /// (1 or more).
    ///
    /// Samples are clipped one by one, so that a bright body does not bleed over its silhouette, and averaged in linear light.
    #[must_use]
    pub fn picture(&self, view: &View, appearance: &Appearance, samples: u32) -> Picture {
        let size @ [width, height] = view.camera.size;
        let lines_of_sight = LinesOfSight::new(&view.camera);
        let mut rgba = vec![[0; 4]; width as usize * height as usize];
        let rows = rgba.par_chunks_mut(width.max(1) as usize).zip(0..height);
        rows.for_each(|(row, v)| {
            for (pixel, u) in row.iter_mut().zip(0..width) {
                let sum = sample_grid([u, v], samples).fold([0.0; 3], |sum: [f64; 3], place| {
                    let colour = self.colour(view, appearance, lines_of_sight.through(place));
                    std::array::from_fn(|i| sum[i] + colour[i])
                });
                *pixel = encoded(sum.map(|part| part / f64::from(samples * samples)));
            }
        });
        Picture { size, rgba }
    }

    /// Linear sRGB in [0, 1] of what is seen along `line_of_sight`.
    fn colour(&self, view: &View, appearance: &Appearance, line_of_sight: DVec3) -> [f64; 3] {
        let Some(hit) = self.first_hit(view, line_of_sight) else {
            return backdrop(&view.camera, appearance, line_of_sight);
        };
        let wavelength_nm = self.rest_wavelengths_nm[hit.body];
        hue_preserving_clip(surface_colour(appearance, wavelength_nm, hit.rest_normal, hit.doppler_factor))
    }
}

/// The centres of `samples` times `samples` equal parts of a pixel.
fn sample_grid([u, v]: [u32; 2], samples: u32) -> impl Iterator<Item = [f64; 2]> {
    let place = move |pixel, part| f64::from(pixel) + (f64::from(part) + 0.5) / f64::from(samples);
    (0..samples).flat_map(move |j| (0..samples).map(move |i| [place(u, i), place(v, j)]))
}
