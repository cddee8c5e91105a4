//! The GPU's part of the window: a picture per eye, drawn again only when something about it changed.

use eframe::egui::TextureId;
use eframe::egui_wgpu::RenderState;
use eframe::wgpu::FilterMode;
use relativity_render::{Appearance, Body, ExactRenderer, EyeTarget, Gpu, View};

/// Both eyes' pictures, and what draws them.
pub struct EyePictures {
    render_state: RenderState,
    gpu: Gpu,
    renderer: ExactRenderer,
    pictures: [Option<EyePicture>; 2],
}

struct EyePicture {
    target: EyeTarget,
    texture: TextureId,
    drawn: Option<Request>,
}

/// Everything a picture depends on.
#[derive(Debug, Clone, PartialEq)]
struct Request {
    view: View,
    appearance: Appearance,
    bodies: Vec<Body>,
}

impl EyePictures {
    /// On the window's device.
    #[must_use]
    pub fn new(render_state: &RenderState) -> Self {
        let RenderState { adapter, device, queue, .. } = render_state;
        let gpu = Gpu::from_device(adapter, device.clone(), queue.clone());
        let renderer = ExactRenderer::new(&gpu);
        Self { render_state: render_state.clone(), gpu, renderer, pictures: [None, None] }
    }

    /// Largest width and height of a picture, pixels.
    #[must_use]
    pub fn largest_side(&self) -> u32 {
        self.render_state.device.limits().max_texture_dimension_2d
    }

    /// The picture of the eye with this `index` (0 left, 1 right), drawn if it is not up to date.
    pub fn picture(
        &mut self,
        index: usize,
        bodies: &[Body],
        view: &View,
        appearance: &Appearance,
    ) -> TextureId {
        let Self { render_state, gpu, renderer, pictures } = self;
        let picture = fitting(&mut pictures[index], view.camera.size, gpu, render_state);
        let up_to_date = picture.drawn.as_ref().is_some_and(|drawn| {
            drawn.view == *view && drawn.appearance == *appearance && drawn.bodies == bodies
        });
        if !up_to_date {
            renderer.draw(gpu, bodies, view, appearance, &mut picture.target);
            picture.drawn = Some(Request { view: *view, appearance: *appearance, bodies: bodies.to_vec() });
        }
        picture.texture
    }
}

/// The picture in `slot`, made anew if it does not have this `size`.
fn fitting<'a>(
    slot: &'a mut Option<EyePicture>,
    size: [u32; 2],
    gpu: &Gpu,
    render_state: &RenderState,
) -> &'a mut EyePicture {
    let outgrown = slot.take_if(|picture| picture.target.size() != size);
    slot.get_or_insert_with(|| {
        let target = EyeTarget::new(gpu, size);
        let mut renderer = render_state.renderer.write();
        let (device, view, filter) = (&render_state.device, target.view(), FilterMode::Linear);
        let texture = match outgrown {
            Some(EyePicture { texture, .. }) => {
                renderer.update_egui_texture_from_wgpu_texture(device, view, filter, texture);
                texture
            }
            None => renderer.register_native_texture(device, view, filter),
        };
        EyePicture { target, texture, drawn: None }
    })
}
