//! The two eyes' pictures, each drawn again only when something about it changed: on the GPU within the frame, or
//! by the reference renderer in the background.

use eframe::egui::{Context, TextureId};
use eframe::egui_wgpu::RenderState;
use eframe::wgpu::{FilterMode, TextureView};
use relativity_render::{
    Appearance, Composed, Composer, Composition, EyeTarget, Gpu, GpuError, Method, Picture, PreparedScene,
    Renderers, View,
};

use super::painting;
use super::stillness::Stillness;
use super::worker::{Wanted, Worker};
use crate::accuracy::REFERENCE_SAMPLES;

/// Both eyes' pictures, and what draws them.
pub struct EyePictures {
    render_state: RenderState,
    gpu: Gpu,
    renderers: Renderers,
    pictures: [Option<EyePicture>; 2],
    references: [Option<ReferencePicture>; 2],
    composer: Option<Composer>,
    composed: Option<ComposedPicture>,
    /// How often a picture was drawn.
    drawings: u64,
    /// Why the device no longer draws, once it has refused to: from then on the reference does.
    refusal: Option<GpuError>,
    /// Whether that is yet to be told.
    is_untold: bool,
}

struct EyePicture {
    target: EyeTarget,
    texture: TextureId,
    /// What it is of, and what drew that.
    drawn: Option<(Request, Method)>,
    /// Which of all drawings it was.
    number: u64,
}

/// What is made of both.
struct ComposedPicture {
    target: Composed,
    texture: TextureId,
    /// How it was composed, and of which drawings.
    of: Option<(Composition, [u64; 2])>,
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
    /// What drew it. The rays stand in for the reference until that is done; the published model is
    /// only known to the mesh renderer, and one light cone for both eyes not to the rays.
    pub method: Method,
}

impl Request {
    /// Whether a picture of it is one of the `other`, too, by the same method.
    fn shows_as(&self, other: &Self) -> bool {
        (self.view, self.appearance) == (other.view, other.appearance) && self.scene == other.scene
    }

    /// Whether it is the reference's to draw.
    fn is_for_reference(&self) -> bool {
        self.method.of_view(&self.view) == Method::Reference
    }

    /// It, for the reference to draw.
    fn for_reference(&self) -> Self {
        Self { method: Method::Reference, ..self.clone() }
    }

    /// What draws it on the GPU.
    fn method_on_gpu(&self) -> Method {
        self.method.on_gpu(&self.view)
    }
}

/// Pictures by the reference renderer, which are made in the background.
struct ReferencePicture {
    worker: Worker<Request, (Request, Picture)>,
    stillness: Stillness<Request>,
    requested: Option<Request>,
    /// The newest.
    done: Option<(Request, Picture)>,
    is_awaited: bool,
}

impl ReferencePicture {
    fn new(ctx: &Context) -> Self {
        let work = |request: Request, _: &Wanted| {
            let Request { view, appearance, scene, .. } = &request;
            let picture = scene.picture(view, appearance, REFERENCE_SAMPLES);
            Some((request, picture))
        };
        Self {
            worker: Worker::new(ctx.clone(), work),
            stillness: Stillness::default(),
            requested: None,
            done: None,
            is_awaited: false,
        }
    }

    /// The picture, once it is done. It is begun when what is asked for no longer changes.
    fn picture(&mut self, ctx: &Context, request: &Request) -> Option<&Picture> {
        let is_still = self.stillness.is_still(ctx, request);
        self.update(request, is_still);
        self.done.as_ref().filter(|_| !self.is_awaited).map(|(_, picture)| picture)
    }

    /// The newest picture of this size, be it of what was asked for before: a late one is better than none.
    fn newest(&mut self, request: &Request) -> Option<&(Request, Picture)> {
        self.update(request, true);
        self.done.as_ref().filter(|(_, picture)| picture.size == request.view.camera.size)
    }

    /// Receives what is done, and begins what is asked for if it `may_begin`.
    fn update(&mut self, request: &Request, may_begin: bool) {
        if let Some(done) = self.worker.result() {
            self.done = Some(done);
        }
        self.is_awaited = self.done.as_ref().is_none_or(|(of, _)| of != request);
        if self.is_awaited && may_begin && self.requested.as_ref() != Some(request) {
            self.worker.request(request.clone());
            self.requested = Some(request.clone());
        }
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
            composer: None,
            composed: None,
            drawings: 0,
            refusal: None,
            is_untold: false,
        }
    }

    /// None yet, for another window of the same device.
    #[must_use]
    pub fn another(&self) -> Self {
        Self { refusal: self.refusal.clone(), ..Self::new(&self.render_state) }
    }

    /// Why the device no longer draws, if it has refused to since this was last asked.
    pub fn newly_refused(&mut self) -> Option<&GpuError> {
        std::mem::take(&mut self.is_untold).then_some(self.refusal.as_ref()).flatten()
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

    /// The picture of the eye with this `index` (0 left, 1 right), drawn if it is not up to date; none if neither the device
    /// nor, once that has refused, the reference draws it.
    pub fn picture(&mut self, ctx: &Context, index: usize, request: &Request) -> Option<Shown> {
        let scopes = self.gpu.error_scopes();
        let before = self.drawings;
        let shown = if self.refusal.is_some() {
            Ok(self.picture_by_reference(ctx, index, request))
        } else {
            self.picture_by_method(ctx, index, request).map(Some)
        };
        if let Ok(Some(Shown { texture, .. })) = shown
            && self.drawings != before
        {
            painting::is_drawn_anew(ctx, texture);
        }
        scopes.close().and(shown).unwrap_or_else(|error| {
            self.give_up(index);
            self.is_untold |= self.refusal.is_none();
            self.refusal.get_or_insert(error);
            ctx.request_repaint();
            None
        })
    }

    /// Gives up the picture with this `index`, of which parts may be missing.
    fn give_up(&mut self, index: usize) {
        if let Some(EyePicture { texture, .. }) = self.pictures[index].take() {
            self.render_state.renderer.write().free_texture(&texture);
        }
    }

    /// The picture as it is asked for.
    fn picture_by_method(
        &mut self,
        ctx: &Context,
        index: usize,
        request: &Request,
    ) -> Result<Shown, GpuError> {
        let Self { render_state, gpu, renderers, pictures, references, drawings, .. } = self;
        let picture = fitting(&mut pictures[index], request.view.camera.size, gpu, render_state);
        let reference = &mut references[index];
        if request.is_for_reference() {
            let reference = reference.get_or_insert_with(|| ReferencePicture::new(ctx));
            if let Some(made) = reference.picture(ctx, request) {
                return picture.shown(request, Method::Reference, drawings, |target| {
                    target.write(gpu, made);
                    Ok(())
                });
            }
        } else if let Some(reference) = reference {
            // Kept, since ending its thread would take until its picture is done.
            reference.is_awaited = false;
        }
        let method = request.method_on_gpu();
        picture.shown(request, method, drawings, |target| {
            let Request { scene, view, appearance, .. } = request;
            renderers.draw(method, scene, view, appearance, target)
        })
    }

    /// The newest picture by the reference, if that draws what is asked for and has drawn any.
    fn picture_by_reference(&mut self, ctx: &Context, index: usize, request: &Request) -> Option<Shown> {
        let request = request.for_reference();
        let Self { render_state, gpu, pictures, references, drawings, .. } = self;
        let reference = references[index].get_or_insert_with(|| ReferencePicture::new(ctx));
        if !request.is_for_reference() {
            reference.is_awaited = false;
            return None;
        }
        let (of, made) = reference.newest(&request)?;
        let picture = fitting(&mut pictures[index], made.size, gpu, render_state);
        let written = picture.shown(of, Method::Reference, drawings, |target| {
            target.write(gpu, made);
            Ok(())
        });
        written.ok()
    }

    /// The picture that is made of those of both eyes, which are drawn first if they are not up to date: each with its
    /// number, in the order of the layout.
    pub fn composed(
        &mut self,
        ctx: &Context,
        composition: Composition,
        requests: [(usize, &Request); 2],
    ) -> Option<Shown> {
        let [shown, other] = requests.map(|(index, request)| self.picture(ctx, index, request));
        let Shown { method, .. } = shown.and(other).and(shown)?;
        let Self { render_state, gpu, pictures, composer, composed, .. } = self;
        let [first, second] = requests.map(|(index, _)| pictures[index].as_ref());
        let (first, second) = (first?, second?);
        let composed = fitting_composed(composed, composition.size(first.target.size()), gpu, render_state);
        let of = Some((composition, [first.number, second.number]));
        if composed.of != of {
            let composer = composer.get_or_insert_with(|| Composer::new(gpu));
            composer.compose(gpu, composition, [&first.target, &second.target], &composed.target);
            composed.of = of;
            painting::is_drawn_anew(ctx, composed.texture);
        }
        Some(Shown { texture: composed.texture, method })
    }

    /// Gives up all pictures, as nobody looks.
    pub fn forget(&mut self) {
        self.forget_composed();
        for EyePicture { texture, .. } in self.pictures.iter_mut().filter_map(Option::take) {
            self.render_state.renderer.write().free_texture(&texture);
        }
        self.references = [None, None];
    }

    /// Gives up what was composed, as nobody looks.
    pub fn forget_composed(&mut self) {
        if let Some(ComposedPicture { texture, .. }) = self.composed.take() {
            self.render_state.renderer.write().free_texture(&texture);
        }
    }
}

impl EyePicture {
    /// It, after `draw` has drawn what is asked for by `method`, unless that is up to date.
    fn shown(
        &mut self,
        request: &Request,
        method: Method,
        drawings: &mut u64,
        draw: impl FnOnce(&mut EyeTarget) -> Result<(), GpuError>,
    ) -> Result<Shown, GpuError> {
        let is_up_to_date = self.drawn.as_ref().is_some_and(|(of, by)| *by == method && of.shows_as(request));
        if !is_up_to_date {
            self.drawn = None;
            draw(&mut self.target)?;
            self.drawn = Some((request.clone(), method));
            *drawings += 1;
            self.number = *drawings;
        }
        Ok(Shown { texture: self.texture, method })
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
        let texture = registered(render_state, target.view(), outgrown.map(|picture| picture.texture));
        EyePicture { target, texture, drawn: None, number: 0 }
    })
}

/// What is composed in `slot`, made anew if it does not have this `size`.
fn fitting_composed<'a>(
    slot: &'a mut Option<ComposedPicture>,
    size: [u32; 2],
    gpu: &Gpu,
    render_state: &RenderState,
) -> &'a mut ComposedPicture {
    let outgrown = slot.take_if(|composed| composed.target.size() != size);
    slot.get_or_insert_with(|| {
        let target = Composed::new(gpu, size);
        let texture = registered(render_state, target.view(), outgrown.map(|composed| composed.texture));
        ComposedPicture { target, texture, of: None }
    })
}

/// What egui calls the picture in `view`, be it new or in place of the one that it called so `before`.
fn registered(render_state: &RenderState, view: &TextureView, before: Option<TextureId>) -> TextureId {
    let mut renderer = render_state.renderer.write();
    let (device, filter) = (&render_state.device, FilterMode::Linear);
    match before {
        Some(texture) => {
            renderer.update_egui_texture_from_wgpu_texture(device, view, filter, texture);
            texture
        }
        None => renderer.register_native_texture(device, view, filter),
    }
}
