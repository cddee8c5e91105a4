//! GPU resources of the window: switching back and forth does not accumulate any.

use eframe::egui::Key;
use eframe::wgpu;
use egui_kittest::wgpu::WgpuTestRenderer;
use gamow::app::shell::App;
use gamow::flags::choices::RendererChoice;

use super::support::{builder, cyclist, sweep, wait_for};
use super::{Test, device};

pub const TESTS: &[Test] = trials![switches_keep_nothing_on_the_device,];

/// Keys that switch geometry, layout, presenting, projection, panorama, outline and map, and back.
const SWITCHES: [&[Key]; 6] = [
    &[Key::Num2, Key::Num3, Key::Num4, Key::Num1],
    &[Key::L; 16],
    &[Key::P, Key::Escape],
    &[Key::V, Key::V],
    &[Key::U, Key::U],
    &[Key::O, Key::O, Key::M, Key::M],
];

/// The live resources of the device, by kind.
fn live(instance: &wgpu::Instance) -> [(&'static str, usize); 7] {
    let hub = instance.generate_report().expect("it is no browser's").hub;
    [
        ("buffers", hub.buffers),
        ("textures", hub.textures),
        ("views of textures", hub.texture_views),
        ("bind groups", hub.bind_groups),
        ("samplers", hub.samplers),
        ("pipelines", hub.render_pipelines),
        ("shaders", hub.shader_modules),
    ]
    .map(|(name, report)| (name, report.num_kept_from_user))
}

fn switches_keep_nothing_on_the_device() {
    // By day each switch with one of the renderers, at night with all.
    let parts = sweep([3, 1]);
    for (number, renderer) in
        [RendererChoice::Rays, RendererChoice::Mesh, RendererChoice::Packets].into_iter().enumerate()
    {
        let render_state = device::own().expect("there is a device");
        let instance = render_state.instance.clone();
        let mut state = cyclist(0.9);
        state.document.settings.quality.renderer = renderer;
        let mut harness =
            builder([640.0, 480.0]).renderer(WgpuTestRenderer::from_render_state(render_state)).build_eframe(
                |cc| App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state).without_refinement(),
            );
        harness.run_steps(3);
        for switch in SWITCHES.iter().skip(number % parts).step_by(parts) {
            let mut round = || {
                for key in *switch {
                    harness.key_press(*key);
                    harness.run_steps(2);
                }
                // Pictures that fade are kept until then.
                wait_for(&mut harness, "nothing fades", |window| !window.state().is_fading());
                live(&instance)
            };
            round();
            let second = round();
            assert_eq!(round(), second, "{renderer:?}: {switch:?}");
        }
    }
}
