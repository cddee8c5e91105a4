//! The paint of models where they are hit.

use super::hit::Hit;
use crate::colour::paint::Paint;
use crate::scene::pattern::SampleShifts;
use crate::scene::prepared_scene::PreparedScene;

impl PreparedScene {
    /// Returns the paint at `hit`, on average over what is `covered` there: white of what is no model.
    pub(crate) fn paint_at(&self, hit: &Hit, covered: impl Fn() -> SampleShifts) -> Paint {
        let Some((triangles, point)) = self.triangles(hit.body).zip(hit.triangle) else {
            return Paint::WHITE;
        };
        if let Some(material) = triangles.material(point.triangle) {
            return Paint::Measured(material);
        }
        let solid = self.solid(hit.body);
        let range = |gradient| covered().turned_back(hit.turn).range(solid.rest_from_box(gradient));
        Paint::Smooth(triangles.paint_over(point, range))
    }
}
