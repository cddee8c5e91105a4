//! The two eyes' pictures, each drawn again only when something about it changed: within the frame, or in the
//! background, which also makes smoother what does not change, and whole what no frame has the time for.

mod background;
mod meter;
mod pace;
mod request;
mod slot;

use eframe::egui::{Context, TextureId};
use eframe::egui_wgpu::RenderState;
use relativity_render::{Composer, Composition, Gpu, GpuError, Method, Renderers};

pub use meter::Chosen;
pub use request::{Request, ShownPicture};

use self::background::{Background, FinishedPicture};
use self::meter::Meter;
use self::slot::{ComposedPicture, Drawn, DrawnBy, EyePicture, fitting, fitting_composed};
use crate::accuracy::MethodViews;
use crate::app::tools::debounce::Debounce;
use crate::app::tools::graphics;
use crate::app::tools::painting;
use crate::app::tools::preparing::Preparing;
use crate::flags::Goal;

/// Both eyes' pictures, and what draws them.
pub struct EyePictures {
    render_state: RenderState,
    gpu: Gpu,
    renderers: Renderers,
    meter: Meter,
    pictures: [Option<EyePicture>; 2],
    /// Textures of the pictures before, which are shown until the new ones stand alone.
    set_aside: Vec<TextureId>,
    backgrounds: [Option<Background>; 2],
    /// When the pictures that a GPU in software draws coarsely last changed.
    stillness: [Debounce<Request>; 2],
    composer: Option<Composer>,
    composed: Option<ComposedPicture>,
    /// Makes pipelines in the background, where they are not made when a picture needs them.
    preparing: Option<Preparing>,
    /// Whether a picture waits for its pipelines since the last call of [`Self::take_waiting`].
    is_waiting: bool,
    /// Number of pictures drawn.
    drawings: u64,
    /// Why the device no longer draws, once it has refused to: from then on the reference does.
    refusal: Option<GpuError>,
    /// Whether the refusal is still to be reported.
    is_unreported: bool,
}

impl EyePictures {
    /// On the window's device.
    #[must_use]
    pub fn new(render_state: &RenderState) -> Self {
        let gpu = graphics::gpu(render_state);
        let renderers = Renderers::new(Some(gpu.clone()));
        Self {
            meter: Meter::new(&gpu, renderers.has_packets()),
            renderers,
            gpu,
            render_state: render_state.clone(),
            pictures: [None, None],
            set_aside: Vec::new(),
            backgrounds: [None, None],
            stillness: Default::default(),
            composer: None,
            composed: None,
            preparing: None,
            is_waiting: false,
            drawings: 0,
            refusal: None,
            is_unreported: false,
        }
    }

    /// Returns these pictures, drawn in full on the GPU whatever that takes.
    #[must_use]
    pub fn in_full(self) -> Self {
        Self { meter: self.meter.in_full(), ..self }
    }

    /// Returns these pictures, drawn by rays only where somebody asks for them.
    #[must_use]
    pub fn without_automatic_rays(self) -> Self {
        Self { meter: self.meter.without_rays(), ..self }
    }

    /// Has pipelines made in the background from now on; until they are there, the packets draw in their
    /// place, or the last picture stands.
    pub fn prepare_in_background(&mut self, ctx: &Context) {
        self.preparing = Some(Preparing::new(ctx, &self.gpu));
    }

    /// None yet, for another window of the same device.
    #[must_use]
    pub fn another(&self, ctx: &Context) -> Self {
        let preparing = self.preparing.as_ref().map(|_| Preparing::new(ctx, &self.gpu));
        Self { preparing, refusal: self.refusal.clone(), ..Self::new(&self.render_state) }
    }

    /// Whether a picture has had to wait for its pipelines since the last call.
    pub const fn take_waiting(&mut self) -> bool {
        std::mem::replace(&mut self.is_waiting, false)
    }

    /// Returns the reason why the device no longer draws, if it has refused since the last call.
    pub fn take_refusal(&mut self) -> Option<&GpuError> {
        std::mem::take(&mut self.is_unreported).then_some(self.refusal.as_ref()).flatten()
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
        !self.backgrounds.iter().flatten().any(|background| background.is_awaited)
            && !self.pictures.iter().flatten().any(EyePicture::waits_for_rest)
            && !self.preparing.as_ref().is_some_and(Preparing::is_pending)
    }

    /// Whether no picture is to get smoother.
    #[must_use]
    pub fn is_refined(&self) -> bool {
        !self.backgrounds.iter().flatten().any(|background| background.is_refining)
    }

    /// Begins a frame in which the choice of what draws is automatic or not.
    pub fn begin_frame(&mut self, is_automatic: bool) {
        self.meter.begin(self.drawings, is_automatic);
    }

    /// Returns the choice for `sight` in this frame and this `goal`; `None` if nothing draws it.
    pub fn choose(&mut self, goal: Goal, sight: MethodViews<'_>) -> Option<Chosen> {
        self.meter.choose(goal, sight)
    }

    /// The picture of the eye with this `index` (0 left, 1 right), drawn if it is not up to date; none if
    /// neither the device nor, once that has refused, the reference draws it.
    pub fn picture(&mut self, ctx: &Context, index: usize, request: &Request) -> Option<ShownPicture> {
        let scopes = self.gpu.error_scopes();
        let before = self.drawings;
        let shown = if self.refusal.is_some() {
            Ok(self.picture_by_reference(ctx, index, request))
        } else {
            self.picture_by_method(ctx, index, request)
        };
        if let Ok(Some(ShownPicture { texture, .. })) = shown
            && self.drawings != before
        {
            painting::is_drawn_anew(ctx, texture);
        }
        scopes.close().and(shown).unwrap_or_else(|error| {
            self.give_up(index);
            self.is_unreported |= self.refusal.is_none();
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

    /// Draws the picture by the method of the request; until that is ready it is the last one, if there is
    /// one.
    fn picture_by_method(
        &mut self,
        ctx: &Context,
        index: usize,
        request: &Request,
    ) -> Result<Option<ShownPicture>, GpuError> {
        let Self { render_state, gpu, renderers, meter, pictures, backgrounds, drawings, .. } = self;
        let picture = fitting(&mut pictures[index], request.view.camera.size, gpu, render_state);
        let background = &mut backgrounds[index];
        let method = request.method_in_frame();
        let coarsely_by = picture.coarsely_by(request);
        let made = if request.is_for_reference() {
            let background = background.get_or_insert_with(|| Background::new(ctx));
            background.picture(ctx, request).map(|made| (made, Method::Reference))
        } else if coarsely_by == Some(Method::Packets) {
            let background = background.get_or_insert_with(|| Background::new(ctx));
            background
                .picture(ctx, &request.in_background_by(Method::Packets))
                .map(|made| (made, Method::Packets))
        } else if request.refine && request.is_known_to_reference() {
            let background = background.get_or_insert_with(|| Background::new(ctx));
            background.smoother(ctx, &request.in_background_by(Method::Reference)).map(|made| (made, method))
        } else {
            // Kept, since ending its thread would take until its picture is done.
            background.iter_mut().for_each(Background::stop);
            None
        };
        if let Some((FinishedPicture { picture: made, samples, .. }, method)) = made {
            let by = DrawnBy { method, samples: Some(*samples), at_rest: false };
            let shown = picture.shown(request, by, drawings, |target| {
                target.write(gpu, made);
                Ok(Drawn::in_full(method))
            });
            return shown.map(Some);
        }
        let Some(method) = at_hand(self.preparing.as_ref(), renderers, request, method) else {
            self.is_waiting = true;
            return Ok(picture.last());
        };
        let at_rest = coarsely_by.is_some() && self.stillness[index].is_still(ctx, request);
        let by = DrawnBy { method, samples: None, at_rest };
        let shown =
            picture.shown(request, by, drawings, |target| meter.draw(renderers, gpu, request, by, target));
        shown.map(Some)
    }

    /// Returns the newest picture by the reference, if that draws the request and has drawn any.
    fn picture_by_reference(
        &mut self,
        ctx: &Context,
        index: usize,
        request: &Request,
    ) -> Option<ShownPicture> {
        let request = request.in_background_by(Method::Reference);
        let Self { render_state, gpu, pictures, backgrounds, drawings, .. } = self;
        let background = backgrounds[index].get_or_insert_with(|| Background::new(ctx));
        if !request.is_for_reference() {
            background.stop();
            return None;
        }
        let FinishedPicture { of, picture: made, samples } = background.newest(&request)?;
        let picture = fitting(&mut pictures[index], made.size, gpu, render_state);
        let by = DrawnBy { method: Method::Reference, samples: Some(*samples), at_rest: false };
        let written = picture.shown(of, by, drawings, |target| {
            target.write(gpu, made);
            Ok(Drawn::in_full(Method::Reference))
        });
        written.ok()
    }

    /// The picture that is made of those of both eyes, which are drawn first if they are not up to date: each
    /// with its number, in the order of the layout.
    pub fn composed(
        &mut self,
        ctx: &Context,
        composition: Composition,
        requests: [(usize, &Request); 2],
    ) -> Option<ShownPicture> {
        let [shown, other] = requests.map(|(index, request)| self.picture(ctx, index, request));
        let ShownPicture { method, coarseness, .. } = shown.and(other).and(shown)?;
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
        Some(ShownPicture { texture: composed.texture, method, coarseness })
    }

    /// Keeps the pictures as they are, while others are drawn in their place.
    pub fn set_aside(&mut self) {
        self.forget_set_aside();
        let pictures = self.pictures.iter_mut().filter_map(Option::take).map(|picture| picture.texture);
        self.set_aside = pictures.chain(self.composed.take().map(|composed| composed.texture)).collect();
    }

    /// Gives up what was set aside.
    pub fn forget_set_aside(&mut self) {
        for texture in self.set_aside.drain(..) {
            self.render_state.renderer.write().free_texture(&texture);
        }
    }

    /// Gives up all pictures, as nobody looks.
    pub fn forget(&mut self) {
        self.forget_set_aside();
        self.forget_composed();
        for EyePicture { texture, .. } in self.pictures.iter_mut().filter_map(Option::take) {
            self.render_state.renderer.write().free_texture(&texture);
        }
        self.backgrounds = [None, None];
    }

    /// Gives up what was composed, as nobody looks.
    pub fn forget_composed(&mut self) {
        if let Some(ComposedPicture { texture, .. }) = self.composed.take() {
            self.render_state.renderer.write().free_texture(&texture);
        }
    }
}

/// Returns the method that draws `request` now: the one it is for, or the packets while its pipelines are
/// being made; `None` if only that one draws it.
fn at_hand(
    preparing: Option<&Preparing>,
    renderers: &Renderers,
    request: &Request,
    method: Method,
) -> Option<Method> {
    let Some(preparing) = preparing else { return Some(method) };
    let Request { scene, view, appearance, .. } = request;
    let missing = renderers.missing(method, scene, view, appearance);
    preparing.go_on(&missing);
    let packets = Method::Packets.of_view(view) == Method::Packets && renderers.has_packets();
    if missing.is_empty() { Some(method) } else { packets.then_some(Method::Packets) }
}
