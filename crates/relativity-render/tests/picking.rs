//! A single ray, as picking traces one per click and per drag: it allocates nothing per body.

use relativity_core::Speed;
use relativity_render::PreparedScene;

use crate::scenes::{crowd, view_following};

#[test]
fn a_ray_allocates_nothing_per_body() {
    let view = view_following([0.0, 3.0, 0.5], Speed::from_beta(0.6).expect("below 1"), 0.3, 90.0);
    let [few, many] = [64, 640].map(|count| {
        let scene = PreparedScene::moving(&crowd(count));
        allocation_counter::measure(|| {
            let hits = (0..64)
                .map(|i| f64::from(5 * i) + 0.5)
                .filter(|&u| scene.first_hit(&view, view.camera.line_of_sight([u, 120.5])).is_some());
            assert!(hits.count() > 3);
        })
    });
    assert_eq!(few.count_total, many.count_total);
}
