//! A refusal of the device is an error for the caller, and none ends the program. Each test has a device of
//! its own, which it may break.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use relativity_core::{Aperture, Speed};
use relativity_render::{
    Appearance, Body, Camera, DeviceErrors, EyeTarget, Gaze, Geometry, Gpu, GpuError, Method, PreparedScene,
    Renderers, Shape, View, named_adapter,
};

use crate::gpu_support::OwnDeviceTest;

pub const TESTS: &[OwnDeviceTest] = &[
    (
        "what_a_device_has_no_room_for_is_an_error_of_the_drawing",
        what_a_device_has_no_room_for_is_an_error_of_the_drawing,
    ),
    (
        "errors_that_nobody_waits_for_are_counted_and_the_first_is_told",
        errors_that_nobody_waits_for_are_counted_and_the_first_is_told,
    ),
    ("memory_that_is_not_there_is_no_panic", memory_that_is_not_there_is_no_panic),
    ("a_lost_device_is_told_and_draws_nothing", a_lost_device_is_told_and_draws_nothing),
    ("an_adapter_is_asked_for_by_a_part_of_its_name", an_adapter_is_asked_for_by_a_part_of_its_name),
];

const SIZE: [u32; 2] = [64, 48];
const MESH: Method = Method::Mesh;

fn scene() -> PreparedScene {
    PreparedScene::moving(&[Body::new(Shape::Sphere { centre: [0.0, 3.0, 1.6], radius: 0.5 }, 600.0)])
}

fn view() -> View {
    let gaze = Gaze { azimuth: 1.6, elevation: 0.3 };
    let camera = Camera::new(Aperture { x: 0.0, y: 0.0, z: 0.0 }, gaze, 1.2, SIZE);
    let speed = Speed::from_beta(0.9).expect("a speed");
    View { camera, speed, observation_time: 1.1, geometry: Geometry::Seen }
}

/// A device whose limits are those of the adapter after `lower`.
fn device(lower: impl FnOnce(&mut wgpu::Limits)) -> (wgpu::Adapter, wgpu::Device, wgpu::Queue) {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let found = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
    let adapter = found.expect("an adapter");
    let mut limits = adapter.limits();
    lower(&mut limits);
    let wanted = wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() };
    let (device, queue) = pollster::block_on(adapter.request_device(&wanted)).expect("a device");
    (adapter, device, queue)
}

fn what_a_device_has_no_room_for_is_an_error_of_the_drawing() {
    // Less than what a frame's numbers take.
    let (adapter, device, queue) = device(|limits| limits.max_uniform_buffer_binding_size = 64);
    let gpu = Gpu::from_device(&adapter, device, queue);
    let mut renderers = Renderers::new(Some(gpu.clone()));
    let mut target = EyeTarget::new(&gpu, SIZE);
    for _ in 0..3 {
        let drawn = renderers.draw(MESH, &scene(), &view(), &Appearance::default(), &mut target);
        assert!(matches!(drawn, Err(GpuError::Refused(_))), "{drawn:?}");
        let picture = renderers.picture(MESH, &scene(), &view(), &Appearance::default(), 1);
        assert!(matches!(picture, Err(GpuError::Refused(_))), "{:?}", picture.err());
        let hits = renderers.hits(MESH, &scene(), &view());
        assert!(matches!(hits, Err(GpuError::Refused(_))), "{:?}", hits.err());
    }
    // The reference needs no device.
    let picture = renderers.picture(Method::Reference, &scene(), &view(), &Appearance::default(), 1);
    assert!(picture.is_ok());
}

fn errors_that_nobody_waits_for_are_counted_and_the_first_is_told() {
    let (_, device, _queue) = device(|_| {});
    let frames = Arc::new(AtomicU64::new(0));
    let counted = Arc::clone(&frames);
    let faults = DeviceErrors::collect(&device, move || {
        counted.fetch_add(1, Ordering::Relaxed);
    });
    assert_eq!((faults.errors(), faults.first(), faults.loss()), (0, None, None));
    for side in [0, u32::MAX] {
        let size = wgpu::Extent3d { width: side, height: 1, depth_or_array_layers: 1 };
        let _invalid = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("invalid"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
    }
    assert_eq!((faults.errors(), frames.load(Ordering::Relaxed)), (2, 2));
    let first = faults.first().expect("it is kept");
    assert!(first.contains("invalid") && !first.contains('\n'), "{first}");
    assert_eq!(faults.loss(), None);
}

fn memory_that_is_not_there_is_no_panic() {
    let (adapter, device, queue) = device(|_| {});
    let faults = DeviceErrors::collect(&device, || {});
    let gpu = Gpu::from_device(&adapter, device.clone(), queue);
    let huge = || {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("huge"),
            size: 1 << 60,
            usage: wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    };
    let scopes = gpu.error_scopes();
    drop(huge());
    let refused = scopes.close();
    assert!(matches!(refused, Err(GpuError::Refused(_) | GpuError::OutOfMemory)), "{refused:?}");
    assert_eq!(faults.errors(), 0);
    drop(huge());
    assert_eq!(faults.errors(), 1);
    // The device goes on.
    let picture = Renderers::new(Some(gpu)).picture(MESH, &scene(), &view(), &Appearance::default(), 1);
    assert!(picture.is_ok(), "{:?}", picture.err());
}

fn a_lost_device_is_told_and_draws_nothing() {
    let (adapter, device, queue) = device(|_| {});
    let faults = DeviceErrors::collect(&device, || {});
    let gpu = Gpu::from_device(&adapter, device.clone(), queue);
    let mut renderers = Renderers::new(Some(gpu.clone()));
    let mut draw = |method| renderers.picture(method, &scene(), &view(), &Appearance::default(), 1);
    assert!(draw(MESH).is_ok() && faults.loss().is_none());
    device.destroy();
    // Callbacks come with the device's next answer.
    let _ = device.poll(wgpu::PollType::Poll);
    assert!(faults.loss().is_some());
    for method in [MESH, Method::Rays] {
        assert!(draw(method).is_err(), "{method}");
    }
    assert!(draw(Method::Reference).is_ok());
}

fn an_adapter_is_asked_for_by_a_part_of_its_name() {
    let (adapter, ..) = device(|_| {});
    let name = adapter.get_info().name;
    let found = named_adapter(&name.to_lowercase()[..3], std::slice::from_ref(&adapter), None);
    assert_eq!(found.map(|found| found.get_info().name).ok(), Some(name.clone()));
    let Err(error) = named_adapter("nothing", std::slice::from_ref(&adapter), None) else {
        panic!("there is none of that name");
    };
    let text = error.to_string();
    assert!(text.contains(r#"WGPU_ADAPTER_NAME="nothing""#) && text.contains(&name), "{text}");
    assert!(
        named_adapter("nothing", &[], None).is_err_and(|error| error.to_string().ends_with("there is none"))
    );
}
