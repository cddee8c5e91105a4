//! The paint of models on the light of white surfaces.

use super::hit::Hit;
use crate::scene::pattern::SampleShifts;
use crate::scene::prepared_scene::PreparedScene;
use crate::view::Appearance;

impl PreparedScene {
    /// Returns the `colour` of white paint as that of the paint at `hit`, on average over what is `covered`
    /// there: of false colours, which show no paint, only as dark.
    pub(crate) fn painted(
        &self,
        colour: [f64; 3],
        hit: &Hit,
        covered: impl Fn() -> SampleShifts,
        appearance: &Appearance,
    ) -> [f64; 3] {
        let Some((triangles, point)) = self.triangles(hit.body).zip(hit.triangle) else { return colour };
        let solid = self.solid(hit.body);
        let range = |gradient| covered().turned_back(hit.turn).range(solid.rest_from_box(gradient));
        let paint = appearance.paint(triangles.paint_over(point, range));
        std::array::from_fn(|part| colour[part] * paint[part])
    }
}
