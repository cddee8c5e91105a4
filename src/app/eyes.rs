//! The two eyes' pictures, each drawn again only when something about it changed: on the GPU within the frame, or
//! by the reference renderer in the background.

use eframe::egui::{Context, TextureId};
use eframe::egui_wgpu::RenderState;
use eframe::wgpu::FilterMode;
use relativity_render::{Appearance, EyeTarget, Gpu, Method, PreparedScene, Renderers, View};

use super::background_picture::BackgroundPicture;
use super::stillness::Stillness;
use crate::accuracy::REFERENCE_SAMPLES;

/// Both eyes' pictures, and what draws them.
pub struct EyePictures {
    render_state: RenderState,
    gpu: Gpu,
    renderers: Renderers,
    pictures: [Option<EyePicture>; 2],
    references: [Option<ReferencePicture>; 2],
}

struct EyePicture {
    target: EyeTarget,
    texture: TextureId,
    drawn: Option<Request>,
}

/// Everything a picture depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Who looks at what.
    pub view: View,
    /// What becomes of its light.
    pub appearance: Appearance,
    /// What there is to see.
    pub scene: PreparedScene,
    /// What is to draw it.
    pub method: Method,
}

/// A picture to show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// The picture.
    pub texture: TextureId,
    /// What drew it. The exact renderer stands in for the reference until that is done; the published model is
    /// only known to the mesh renderer, and one light cone for both eyes not to the exact one.
    pub method: Method,
}

impl Request {
    /// Whether it is the reference's to draw.
    fn is_for_reference(&self) -> bool {
        self.method.of_view(&self.view) == Method::Reference
    }

    /// What draws it on the GPU.
    fn method_on_gpu(&self) -> Method {
        self.method.on_gpu(&self.view)
    }
}

/// A picture by the reference renderer.
struct ReferencePicture {
    picture: BackgroundPicture<Request>,
    stillness: Stillness<Request>,
    is_awaited: bool,
}

impl ReferencePicture {
    fn new(ctx: &Context) -> Self {
        let picture =
            |request: &Request| request.scene.picture(&request.view, &request.appearance, REFERENCE_SAMPLES);
        let picture = BackgroundPicture::new(ctx, "reference", picture);
        Self { picture, stillness: Stillness::default(), is_awaited: false }
    }

    /// The picture, once it is done. It is begun when what is asked for no longer changes.
    fn texture(&mut self, ctx: &Context, request: &Request) -> Option<TextureId> {
        let done = self.picture.of(request).map(Into::into);
        if done.is_none() && self.stillness.is_still(ctx, request) {
            self.picture.request(request);
        }
        self.is_awaited = done.is_none();
        done
    }
}

impl EyePictures {
    /// On the window's device.
    #[must_use]
    pub fn new(render_state: &RenderState) -> Self {
        let RenderState { adapter, device, queue, .. } = render_state;
        let gpu = Gpu::from_device(adapter, device.clone(), queue.clone());
        Self {
            renderers: Renderers::new(Some(gpu.clone())),
            gpu,
            render_state: render_state.clone(),
            pictures: [None, None],
            references: [None, None],
        }
    }

    /// None yet, for another window of the same device.
    #[must_use]
    pub fn another(&self) -> Self {
        Self::new(&self.render_state)
    }

    /// The device they are drawn on.
    #[must_use]
    pub const fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Largest width and height of a picture, pixels.
    #[must_use]
    pub fn largest_side(&self) -> u32 {
        self.gpu.largest_side()
    }

    /// Whether every picture is drawn by what is to draw it.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        !self.references.iter().flatten().any(|reference| reference.is_awaited)
    }

    /// The picture of the eye with this `index` (0 left, 1 right), drawn if it is not up to date.
    pub fn picture(&mut self, ctx: &Context, index: usize, request: &Request) -> Shown {
        let reference = &mut self.references[index];
        if request.is_for_reference() {
            let reference = reference.get_or_insert_with(|| ReferencePicture::new(ctx));
            if let Some(texture) = reference.texture(ctx, request) {
                return Shown { texture, method: Method::Reference };
            }
        } else if let Some(reference) = reference {
            // Kept, since ending its thread would take until its picture is done.
            reference.is_awaited = false;
        }
        self.picture_on_gpu(index, request)
    }

    /// Gives up all pictures, as nobody looks.
    pub fn forget(&mut self) {
        for EyePicture { texture, .. } in self.pictures.iter_mut().filter_map(Option::take) {
            self.render_state.renderer.write().free_texture(&texture);
        }
        self.references = [None, None];
    }

    fn picture_on_gpu(&mut self, index: usize, request: &Request) -> Shown {
        let Self { render_state, gpu, renderers, pictures, .. } = self;
        let method = request.method_on_gpu();
        let request = Request { method, ..request.clone() };
        let picture = fitting(&mut pictures[index], request.view.camera.size, gpu, render_state);
        if picture.drawn.as_ref() != Some(&request) {
            let Request { scene, view, appearance, .. } = &request;
            let drawn = renderers.draw(method, scene, view, appearance, &mut picture.target);
            picture.drawn = drawn.is_ok().then_some(request);
        }
        Shown { texture: picture.texture, method }
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
