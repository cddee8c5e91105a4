//! Slots: pictures that are kept on the device, with the requests they fulfil.

use eframe::egui::TextureId;
use eframe::egui_wgpu::RenderState;
use eframe::wgpu::{FilterMode, TextureView};
use relativity_render::{Composed, Composition, EyeTarget, Gpu, GpuError, Method};

use super::request::{Request, ShownPicture};

/// The picture of an eye.
pub struct EyePicture {
    pub target: EyeTarget,
    pub texture: TextureId,
    /// Request of the picture, how it was to be drawn, and how it was.
    drawn: Option<(Request, DrawnBy, Drawn)>,
    /// [`Drawn::coarseness`] of the last drawing within a frame.
    pub coarseness: u32,
    /// Number of the picture's drawing among all.
    pub number: u64,
}

/// The way in which a picture is to be drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnBy {
    /// Method of the drawing.
    pub method: Method,
    /// Rays per pixel and direction, where the reference has made it smoother than that does.
    pub samples: Option<u32>,
    /// Whether there is time for more pixels than in a picture that moves, where the GPU is software.
    pub at_rest: bool,
}

/// The way in which a picture was drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drawn {
    pub method: Method,
    /// Number of pixels each way that are drawn as one, where there was no time for more: else 1.
    pub coarseness: u32,
}

/// A picture composed of both eyes' pictures.
pub struct ComposedPicture {
    pub target: Composed,
    pub texture: TextureId,
    /// Composition of the picture, and the numbers of its drawings.
    pub of: Option<(Composition, [u64; 2])>,
}

impl EyePicture {
    /// Returns what was drawn last, whatever is wanted by now.
    pub fn last(&self) -> Option<ShownPicture> {
        self.drawn.as_ref().map(|&(.., drawn)| self.as_drawn(drawn))
    }

    /// Returns the picture, after `draw` has drawn the request `by` this method or by the one it returns,
    /// unless it is up to date.
    pub fn shown(
        &mut self,
        request: &Request,
        by: DrawnBy,
        drawings: &mut u64,
        draw: impl FnOnce(&mut EyeTarget) -> Result<Drawn, GpuError>,
    ) -> Result<ShownPicture, GpuError> {
        let up_to_date = self.drawn.as_ref().filter(|(of, drawn_by, drawn)| {
            let by = DrawnBy { at_rest: drawn_by.at_rest || (by.at_rest && drawn.coarseness > 1), ..by };
            *drawn_by == by && of.shows_as(request)
        });
        if let Some(&(.., drawn)) = up_to_date {
            return Ok(self.as_drawn(drawn));
        }
        self.drawn = None;
        let drawn = draw(&mut self.target)?;
        self.drawn = Some((request.clone(), by, drawn));
        if by.samples.is_none() {
            self.coarseness = drawn.coarseness;
        }
        *drawings += 1;
        self.number = *drawings;
        Ok(self.as_drawn(drawn))
    }

    /// Returns the method by which this `request` was last drawn coarsely within a frame, if it was.
    pub fn coarsely_by(&self, request: &Request) -> Option<Method> {
        let (of, _, drawn) = self.drawn.as_ref().filter(|_| self.coarseness > 1)?;
        of.shows_as(request).then_some(drawn.method)
    }

    /// Whether it is drawn with more pixels once it rests.
    pub fn waits_for_rest(&self) -> bool {
        let drawn = self.drawn.as_ref();
        drawn.is_some_and(|(_, by, drawn)| {
            drawn.coarseness > 1 && drawn.method != Method::Packets && !by.at_rest
        })
    }

    const fn as_drawn(&self, Drawn { method, coarseness }: Drawn) -> ShownPicture {
        ShownPicture { texture: self.texture, method, coarseness }
    }
}

impl Drawn {
    /// Returns all of a picture by this `method`.
    pub const fn in_full(method: Method) -> Self {
        Self { method, coarseness: 1 }
    }
}

/// Returns the picture in `slot`, replaced by a new one if it does not have this `size`.
pub fn fitting<'a>(
    slot: &'a mut Option<EyePicture>,
    size: [u32; 2],
    gpu: &Gpu,
    render_state: &RenderState,
) -> &'a mut EyePicture {
    let outgrown = slot.take_if(|picture| picture.target.size() != size);
    slot.get_or_insert_with(|| {
        let target = EyeTarget::new(gpu, size);
        let texture = registered(render_state, target.view(), outgrown.map(|picture| picture.texture));
        EyePicture { target, texture, drawn: None, coarseness: 1, number: 0 }
    })
}

/// Returns the composed picture in `slot`, replaced by a new one if it does not have this `size`.
pub fn fitting_composed<'a>(
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

/// Registers the picture in `view` with egui, as a new texture or in place of the one `before`.
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
