//! What the window does when its graphics device fails. Each test has a device of its own, which it may
//! break.

use std::sync::Arc;

use eframe::egui::{Vec2, ViewportCommand};
use eframe::egui_wgpu::{RenderState, RendererOptions, WgpuSetup, WgpuSetupExisting};
use eframe::wgpu;
use egui_kittest::Harness;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};
use gamow::app::commands::{PlaybackCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::tools::painting;
use gamow::flags::choices::RendererChoice;

use super::Test;
use super::support::{builder, cyclist, settle, window_of_size};

pub const TESTS: &[Test] = trials![
    a_device_that_refuses_leaves_the_views_to_the_cpu,
    an_error_that_nobody_waits_for_is_told_once,
    a_lost_device_closes_the_window_and_leaves_its_state,
    no_size_of_the_window_is_an_error,
    the_device_of_a_closed_window_is_freed,
];

/// A window, and its device, whose limits are those of the adapter after `lower`.
fn on_device(lower: fn(&mut wgpu::Limits)) -> (Harness<'static, App>, RenderState) {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.device_descriptor = Arc::new(move |adapter| {
            let mut limits = adapter.limits();
            lower(&mut limits);
            wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() }
        });
    }
    let render_state = create_render_state(setup, RendererOptions::PREDICTABLE);
    let mut state = cyclist(0.9);
    // A software device would have the CPU draw in its place.
    state.document.settings.quality.renderer = RendererChoice::Rays;
    let harness = builder([1280.0, 800.0])
        .renderer(WgpuTestRenderer::from_render_state(render_state.clone()))
        .build_eframe(|cc| App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state));
    (harness, render_state)
}

fn notice(harness: &Harness<'_, App>) -> Option<String> {
    harness.state().state().scratch.notice.as_ref().map(|notice| notice.text.clone())
}

fn a_device_that_refuses_leaves_the_views_to_the_cpu() {
    // Less than what a frame's numbers take, and enough for the panels.
    let (mut harness, _) = on_device(|limits| limits.max_uniform_buffer_binding_size = 64);
    harness.run_steps(3);
    let text = notice(&harness).expect("it is told");
    assert!(text.contains("refused to draw") && text.contains("drawn on the CPU"), "{text}");
    settle(&mut harness);
    // Told once; what is set stays.
    harness.state_mut().run(WindowCommand::CloseNotice);
    harness.run_steps(3);
    assert_eq!(notice(&harness), None);
    assert!((harness.state().state().speed().beta() - 0.9).abs() < 1e-12);
    let picture = harness.render().expect("it is drawn");
    let default = window_of_size(cyclist(0.9), [1280.0, 800.0], 1.0).render().expect("it is drawn");
    let off = picture.pixels().zip(default.pixels());
    let off = off.filter(|(a, b)| (0..3).any(|i| a.0[i].abs_diff(b.0[i]) > 48)).count();
    // Outlines differ by how rays share pixels; without pictures a quarter of the window would.
    let all = picture.pixels().len();
    assert!(off * 20 < all, "{off} of {all} pixels");
}

fn an_error_that_nobody_waits_for_is_told_once() {
    let (mut harness, render_state) = on_device(|_| {});
    harness.run_steps(2);
    let before = notice(&harness);
    let invalid = |size: u64| {
        let usage = wgpu::BufferUsages::COPY_DST;
        let wanted =
            wgpu::BufferDescriptor { label: Some("too large"), size, usage, mapped_at_creation: false };
        drop(render_state.device.create_buffer(&wanted));
    };
    invalid(1 << 60);
    harness.run_steps(2);
    let text = notice(&harness).expect("it is told");
    assert!(before != Some(text.clone()) && text.contains("too large"), "{text}");
    harness.state_mut().run(WindowCommand::CloseNotice);
    for _ in 0..10 {
        invalid(1 << 61);
        harness.step();
        assert_eq!(notice(&harness), None);
    }
}

fn a_lost_device_closes_the_window_and_leaves_its_state() {
    let (mut harness, render_state) = on_device(|_| {});
    harness.run_steps(2);
    assert_eq!(harness.state().loss(), None);
    let before = harness.state().state().clone();
    render_state.device.destroy();
    // The loss is told once what was submitted before it is done.
    let _ = render_state.device.poll(wgpu::PollType::wait_indefinitely());
    harness.step();
    assert!(harness.state().loss().is_some());
    let mut asked = harness.output().viewport_output.values().flat_map(|output| &output.commands);
    assert!(asked.any(|command| *command == ViewportCommand::Close));
    assert_eq!(harness.state().state().document.settings, before.document.settings);
    assert_eq!(harness.state().state().document.points, before.document.points);
}

fn no_size_of_the_window_is_an_error() {
    // A device that draws little more than the window is large.
    let (mut harness, _) = on_device(|limits| limits.max_texture_dimension_2d = 2048);
    harness.state_mut().run(PlaybackCommand::Toggle);
    for size in [[0.0, 0.0], [1.0, 1.0], [1.0, 800.0], [20_000.0, 3.0], [5000.0, 4000.0], [1280.0, 800.0]] {
        harness.set_size(Vec2::from(size));
        harness.run_steps(2);
        let numbers = harness.state().state().frame.picture.size;
        assert!(numbers.iter().all(|side| (1..=2048).contains(side)), "{size:?}: {numbers:?}");
        assert_eq!(notice(&harness), None, "{size:?}");
    }
}

fn the_device_of_a_closed_window_is_freed() {
    let setup = default_wgpu_setup();
    let instance = pollster::block_on(setup.new_instance());
    let devices =
        || instance.generate_report().expect("a native instance").hub_report().devices.num_allocated;
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
        .expect("an adapter");
    let (device, queue) =
        pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default())).expect("a device");
    let existing = WgpuSetupExisting { instance: instance.clone(), adapter, device, queue };
    let render_state = create_render_state(WgpuSetup::Existing(existing), RendererOptions::PREDICTABLE);
    let mut harness = builder([640.0, 480.0])
        .renderer(WgpuTestRenderer::from_render_state(render_state))
        .build_eframe(|cc| {
            // Owned by the window's context, and owner of the device.
            painting::install(&cc.egui_ctx, cc.wgpu_render_state.as_ref().expect("a device"));
            App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), cyclist(0.9))
        });
    harness.run_steps(3);
    assert_eq!(devices(), 1);
    drop(harness);
    assert_eq!(devices(), 0);
}
