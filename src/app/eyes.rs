//! The GPU's part of the window: a picture per eye, drawn again only when something about it changed.

use std::borrow::Cow;

use eframe::egui::TextureId;
use eframe::egui_wgpu::RenderState;
use eframe::wgpu::{Backend, FilterMode};
use relativity_render::{Appearance, Body, ExactRenderer, EyeTarget, Gpu, MeshRenderer, View};

/// Both eyes' pictures, and what draws them.
pub struct EyePictures {
    render_state: RenderState,
    gpu: Gpu,
    renderers: Renderers,
    pictures: [Option<EyePicture>; 2],
}

struct EyePicture {
    target: EyeTarget,
    texture: TextureId,
    drawn: Option<Request<'static>>,
}

/// Everything a picture depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct Request<'a> {
    /// Who looks at what.
    pub view: View,
    /// With which looks.
    pub appearance: Appearance,
    /// What there is to see.
    pub bodies: Cow<'a, [Body]>,
    /// Whether it is the right eye's in the published model; `view` is then the left eye's.
    pub published_right: bool,
}

/// What draws. Each is made when it is first needed.
#[derive(Default)]
struct Renderers {
    /// Whether the exact renderer is out of reach: OpenGL cannot choose the samples of a pixel.
    mesh_only: bool,
    exact: Option<ExactRenderer>,
    mesh: Option<MeshRenderer>,
}

impl Renderers {
    fn draw(&mut self, gpu: &Gpu, request: &Request<'_>, target: &mut EyeTarget) {
        let Request { view, appearance, bodies, published_right } = request;
        if *published_right {
            let mesh = self.mesh.get_or_insert_with(|| MeshRenderer::new(gpu));
            mesh.draw_published_right(gpu, bodies, view, appearance, target);
        } else if self.mesh_only {
            let mesh = self.mesh.get_or_insert_with(|| MeshRenderer::new(gpu));
            mesh.draw(gpu, bodies, view, appearance, target);
        } else {
            let exact = self.exact.get_or_insert_with(|| ExactRenderer::new(gpu));
            exact.draw(gpu, bodies, view, appearance, target);
        }
    }
}

impl EyePictures {
    /// On the window's device.
    #[must_use]
    pub fn new(render_state: &RenderState) -> Self {
        let RenderState { adapter, device, queue, .. } = render_state;
        let gpu = Gpu::from_device(adapter, device.clone(), queue.clone());
        let mesh_only = adapter.get_info().backend == Backend::Gl;
        let renderers = Renderers { mesh_only, ..Renderers::default() };
        Self { render_state: render_state.clone(), gpu, renderers, pictures: [None, None] }
    }

    /// Largest width and height of a picture, pixels.
    #[must_use]
    pub fn largest_side(&self) -> u32 {
        self.render_state.device.limits().max_texture_dimension_2d
    }

    /// The picture of the eye with this `index` (0 left, 1 right), drawn if it is not up to date.
    pub fn picture(&mut self, index: usize, request: &Request<'_>) -> TextureId {
        let Self { render_state, gpu, renderers, pictures } = self;
        let picture = fitting(&mut pictures[index], request.view.camera.size, gpu, render_state);
        if picture.drawn.as_ref() != Some(request) {
            renderers.draw(gpu, request, &mut picture.target);
            picture.drawn = Some(request.clone().into_owned());
        }
        picture.texture
    }
}

impl Request<'_> {
    fn into_owned(self) -> Request<'static> {
        let bodies = Cow::Owned(self.bodies.into_owned());
        Request { bodies, ..self }
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
