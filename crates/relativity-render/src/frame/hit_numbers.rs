//! The numbers that a renderer in f32 writes per pixel, and the hits that these stand for.

use glam::DVec3;

use crate::kinematics::spin::about_y;
use crate::picture::hit::{Hit, HitImage, Turned};
use crate::scene::prepared_scene::PreparedScene;
use crate::scene::wheel::packed::Turns;
use crate::view::View;

/// The numbers of each pixel's hit, as the shaders' `Hit` has them.
pub struct HitNumbers {
    pub measures: Vec<[f32; 4]>,
    pub places: Vec<[f32; 4]>,
}

impl HitNumbers {
    /// Returns the hits of `scene` in `view`; the numbers that the shader does not write are computed in f64.
    pub fn hit_image(&self, scene: &PreparedScene, view: &View) -> HitImage {
        let lines_of_sight = view.camera.lines_of_sight();
        let group_views = scene.group_views(view);
        let size = view.camera.size;
        let width = size[0] as usize;
        let hit = |(i, (measures, place)): (usize, (&[f32; 4], &[f32; 4]))| {
            let [index, distance, doppler_factor, is_hit] = measures.map(f64::from);
            if is_hit != 1.0 {
                return None;
            }
            let body = index as usize;
            let [x, y, z, triangle] = place.map(f64::from);
            let (prepared, group_view) = (&scene.bodies()[body], &group_views[scene.group_of(body)]);
            let solid = scene.solid(body);
            let from = match (prepared.spin, group_view.turns(prepared)) {
                (Some(spin), Turns::About) => DVec3::from(spin.hub),
                _ => solid.centre(),
            };
            let rest_position = from + DVec3::new(x, y, z);
            let Turned { proper_time, turn, material_position, .. } =
                Turned::new(prepared.spin, group_view, rest_position);
            let line_of_sight = lines_of_sight.through([(i % width) as f64 + 0.5, (i / width) as f64 + 0.5]);
            let on_triangle = scene.triangles(body).map(|triangles| {
                let direction = group_view.rest_ray_at(line_of_sight, distance).direction;
                let passes = group_view.passing(prepared.spin, rest_position, direction);
                triangles.point_in(solid, triangle as u32, material_position, about_y(passes, -turn))
            });
            let (triangle, normal) = match on_triangle {
                Some((point, normal)) => (Some(point), normal),
                None => (None, solid.normal(material_position)),
            };
            let rest_normal = about_y(normal, turn);
            Some(Hit {
                body,
                rest_position,
                rest_normal,
                distance,
                emission_time: view.emission_time(line_of_sight, distance),
                proper_time,
                turn,
                material_position,
                doppler_factor,
                triangle,
            })
        };
        let hits = self.measures.iter().zip(&self.places).enumerate().map(hit).collect();
        HitImage { size, hits }
    }
}
