//! Pipelines that are made by another thread before a picture needs them.

use std::thread;

use relativity_core::Speed;
use relativity_render::gpu::mirrors::pipelines;
use relativity_render::{
    Appearance, EyeTarget, Geometry, Gpu, Method, PipelineMaker, PreparedScene, Renderers, View,
};

use crate::gpu_support::OwnDeviceTest;
use crate::gpu_support::scenes::{still_life, view_following};

pub const TESTS: &[OwnDeviceTest] =
    &[("what_is_made_before_is_all_that_pictures_need", what_is_made_before_is_all_that_pictures_need)];

const SIZE: [u32; 2] = [96, 64];

/// Far and near, before and after the passage: bodies look thick and thin.
fn views(geometry: Geometry) -> Vec<View> {
    let speed = Speed::from_beta(0.6).expect("below 1");
    let of_time = |time: f64| {
        let view = view_following([0.0, 3.0, 0.5], speed, time, 90.0).with_size(SIZE);
        View { geometry, ..view }
    };
    [-30.0, -2.0, 0.3, 2.0, 40.0].map(of_time).to_vec()
}

fn what_is_made_before_is_all_that_pictures_need() {
    let appearance = Appearance {
        ground_z: Some(-2.0),
        road: Some([1.0, 30.0]),
        fronts: Some(9.0),
        ..Appearance::default()
    };
    let scene = PreparedScene::moving(&still_life());
    for (method, geometry) in
        [(Method::Rays, Geometry::Seen), (Method::Mesh, Geometry::Seen), (Method::Mesh, Geometry::Published)]
    {
        let [prepared, plain] = [0, 1].map(|_| Gpu::headless().expect("a device"));
        let [mut renderers, mut without] = [&prepared, &plain].map(|gpu| Renderers::new(Some(gpu.clone())));
        let views = views(geometry);
        let missing = renderers.missing(method, &scene, &views[0], &appearance);
        assert!(missing.len() > 5, "{method} needs {}", missing.len());
        let maker = PipelineMaker::new(&prepared);
        let made = thread::spawn(move || missing.iter().try_for_each(|needed| maker.make(needed)));
        made.join().expect("it works").expect("the device makes them");
        assert!(renderers.missing(method, &scene, &views[0], &appearance).is_empty());
        let before = pipelines(&prepared);
        for view in &views {
            let [shown, expected] = [(&mut renderers, &prepared), (&mut without, &plain)].map(|(by, gpu)| {
                let mut target = EyeTarget::new(gpu, SIZE);
                by.draw(method, &scene, view, &appearance, &mut target).expect("it is drawn");
                target.rgba8(gpu).expect("it is there")
            });
            assert!(shown == expected, "{method} at {}", view.observation_time);
        }
        assert_eq!(pipelines(&prepared), before, "{method}: another was made");
    }
}
