//! A slider moved: a frame in which only the speed changes allocates nothing per body. Each test has a device
//! and a thread of its own, so that nothing else is counted.

use std::panic::resume_unwind;
use std::thread;

use relativity_core::Speed;
use relativity_render::{Appearance, EyeTarget, Gpu, Method, PreparedScene, Renderers};

use crate::gpu_support::OwnDeviceTest;
use crate::gpu_support::scenes::{crowd, view_following};

pub const TESTS: &[OwnDeviceTest] = &[
    ("frames_of_rays_allocate_nothing_per_body", frames_of_rays_allocate_nothing_per_body),
    ("mesh_frames_allocate_nothing_per_body", mesh_frames_allocate_nothing_per_body),
];

fn frames_of_rays_allocate_nothing_per_body() {
    allocate_nothing_per_body(Method::Rays);
}

fn mesh_frames_allocate_nothing_per_body() {
    allocate_nothing_per_body(Method::Mesh);
}

fn allocate_nothing_per_body(method: Method) {
    // Allocations are counted on one thread, so all work is done on it: a new one, since it stays in its pool
    // for good.
    let counted = thread::spawn(move || {
        let mut renderers = Renderers::new(Some(Gpu::headless().expect("a device")));
        let here =
            rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().expect("a pool");
        here.install(|| [64, 640].map(|count| allocations(&mut renderers, method, count)))
    });
    let [few, many] = counted.join().unwrap_or_else(|panic| resume_unwind(panic));
    println!("{method}: {few} and {many} allocations");
    assert!(many <= few + 16, "{method}: {few} allocations for 64 bodies, {many} for 640");
}

/// Returns the number of allocations of a frame with another speed than the one before, of `count` bodies.
///
/// Both speeds were drawn before: what is made once (pipelines, templates, buffers large enough) is there.
fn allocations(renderers: &mut Renderers, method: Method, count: u32) -> u64 {
    let gpu = renderers.gpu().expect("a device").clone();
    let scene = PreparedScene::moving(&crowd(count));
    let views = [0.5, 0.6].map(|beta| {
        let speed = Speed::from_beta(beta).expect("below 1");
        view_following([0.0, 3.0, 0.5], speed, 0.3, 90.0).with_size([64, 48])
    });
    let appearance = Appearance::default();
    let mut target = EyeTarget::new(&gpu, views[0].camera.size);
    let mut draw = |view| {
        renderers.draw(method, &scene, view, &appearance, &mut target).expect("a device");
        gpu.wait().expect("device works");
    };
    views.iter().cycle().take(6).for_each(&mut draw);
    allocation_counter::measure(|| draw(&views[0])).count_total
}
