//! Painting of the window where the GPU is software: its picture is kept, and only changed parts are painted
//! again, by a shader as plain as can be. The toolkit's own paints all of it in each frame, and each pixel
//! costs it ten times as much.

mod changes;
mod pipelines;
mod window_picture;

use std::collections::HashSet;

use eframe::egui::epaint::textures::TexturesDelta;
use eframe::egui::epaint::{ClippedShape, Mesh, RectShape};
use eframe::egui::{
    Color32, Context, FullOutput, Id, Plugin, Pos2, RawInput, Rect, Shape, TextureId, Vec2, ViewportId, vec2,
};
use eframe::egui_wgpu::{Callback, RenderState};

use crate::app::tools::graphics;
use pipelines::PaintPipelines;
use window_picture::{PictureCallback, WindowPicture};

/// Has the window that `ctx` runs painted so, where its device is software; only from its first frame on.
pub fn install(ctx: &Context, render_state: &RenderState) {
    if graphics::gpu(render_state).is_software() && !render_state.target_format.is_srgb() {
        ctx.add_plugin(WindowPainter::new(render_state));
    }
}

/// Notes that the picture which the toolkit calls `texture` is another from this frame on.
pub fn is_drawn_anew(ctx: &Context, texture: TextureId) {
    ctx.data_mut(|data| data.get_temp_mut_or_default::<Anew>(Id::NULL).0.insert(texture));
}

/// Pictures that were drawn since the last frame.
#[derive(Debug, Clone, Default)]
struct Anew(HashSet<TextureId>);

/// The painter of all windows.
struct WindowPainter {
    render_state: RenderState,
    pipelines: PaintPipelines,
    /// Windows whose passes have begun, the innermost last.
    begun: Vec<ViewportId>,
    windows: Vec<(ViewportId, PaintedWindow)>,
}

/// The picture of a window.
#[derive(Default)]
struct PaintedWindow {
    /// Size of the window as last reported, points.
    size: Option<Vec2>,
    kept: Option<WindowPicture>,
    /// Shapes painted there.
    shapes: Vec<ClippedShape>,
    pixels_per_point: f32,
    news: News,
}

/// Changes that are not to be seen in a window yet, whatever its shapes are.
#[derive(Debug, Clone, Default)]
struct News {
    /// Pictures that are others than before.
    pictures: HashSet<TextureId>,
    /// Writing is elsewhere in the fonts' picture.
    is_all: bool,
}

impl WindowPainter {
    fn new(render_state: &RenderState) -> Self {
        Self {
            render_state: render_state.clone(),
            pipelines: PaintPipelines::new(&render_state.device, render_state.target_format),
            begun: Vec::new(),
            windows: Vec::new(),
        }
    }

    /// The window called `id`, for a while.
    fn take(&mut self, id: ViewportId) -> PaintedWindow {
        let place = self.windows.iter().position(|(window, _)| *window == id);
        place.map(|place| self.windows.swap_remove(place).1).unwrap_or_default()
    }

    /// Loads the fonts and images that are new, as the toolkit's renderer would.
    fn load(&self, delta: &mut TexturesDelta) -> News {
        let RenderState { device, queue, renderer, .. } = &self.render_state;
        let mut renderer = renderer.write();
        let mut news = News::default();
        for (id, images) in delta.set.drain() {
            for image in images {
                if id != TextureId::default() {
                    news.pictures.insert(id);
                } else if image.is_whole() {
                    news.is_all = true;
                }
                renderer.update_texture(device, queue, id, &image);
            }
        }
        news
    }
}

impl PaintedWindow {
    /// Paints what of `shapes` is not yet there; what shows it.
    fn paint(
        &mut self,
        painting: &WindowPainter,
        ctx: &Context,
        shapes: Vec<ClippedShape>,
        size: Vec2,
        pixels_per_point: f32,
    ) -> PictureCallback {
        let WindowPainter { render_state, pipelines, .. } = painting;
        let News { pictures, is_all } = std::mem::take(&mut self.news);
        let whole = Rect::from_min_size(Pos2::ZERO, size);
        let pixels = size * pixels_per_point;
        let pixels = [pixels.x, pixels.y].map(|side| (side.round() as u32).max(1));
        let is_of_size = self.kept.as_ref().is_some_and(|kept| kept.size() == pixels);
        let areas = if is_all || !is_of_size || self.pixels_per_point != pixels_per_point {
            vec![whole]
        } else {
            changes::areas(&self.shapes, &shapes, &pictures, whole, pixels_per_point)
        };
        let kept = self.kept.take_if(|_| is_of_size);
        let mut kept = kept.unwrap_or_else(|| WindowPicture::new(render_state, pipelines, pixels));
        let (ground, above) = ground(&shapes, whole);
        let extents: Vec<Rect> =
            shapes[above..].iter().map(|shape| changes::extent(shape, pixels_per_point)).collect();
        let mut primitives = Vec::new();
        for area in areas {
            let mut in_area = vec![ClippedShape::new(area, plain(area, ground))];
            let shown = shapes[above..].iter().zip(&extents).filter(|(_, extent)| extent.intersects(area));
            in_area.extend(shown.map(|(shape, _)| ClippedShape {
                clip_rect: shape.clip_rect.intersect(area),
                ..shape.clone()
            }));
            primitives.extend(ctx.tessellate(in_area, pixels_per_point));
        }
        if !primitives.is_empty() {
            kept.paint(render_state, pipelines, &primitives, pixels_per_point);
        }
        self.shapes = shapes;
        self.pixels_per_point = pixels_per_point;
        self.kept.insert(kept).shown()
    }
}

impl Plugin for WindowPainter {
    fn debug_name(&self) -> &'static str {
        "painting"
    }

    fn input_hook(&mut self, _: &Context, input: &mut RawInput) {
        self.begun.push(input.viewport_id);
        if let Some(rect) = input.screen_rect {
            let mut painted = self.take(input.viewport_id);
            painted.size = Some(rect.size());
            self.windows.push((input.viewport_id, painted));
        }
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let mut news = self.load(&mut output.textures_delta);
        news.pictures.extend(ctx.data_mut(|data| data.remove_temp::<Anew>(Id::NULL)).unwrap_or_default().0);
        for (_, window) in &mut self.windows {
            window.news.pictures.extend(&news.pictures);
            window.news.is_all |= news.is_all;
        }
        let Some(id) = self.begun.pop() else { return };
        if id == ViewportId::ROOT {
            self.windows.retain(|(window, _)| output.viewport_output.contains_key(window));
        }
        let mut painted = self.take(id);
        if let Some(size) = painted.size {
            let shapes = std::mem::take(&mut output.shapes);
            let shown = painted.paint(self, ctx, shapes, size, output.pixels_per_point);
            let whole = Rect::from_min_size(Pos2::ZERO, size);
            let callback = Callback::new_paint_callback(whole, shown);
            output.shapes = vec![ClippedShape::new(whole, Shape::Callback(callback))];
        }
        self.windows.push((id, painted));
    }
}

/// The colour that all of the window has before anything else is painted on it, and how many of its `shapes`
/// say so.
fn ground(shapes: &[ClippedShape], whole: Rect) -> (Color32, usize) {
    let hides_all = |(number, shape): (usize, &ClippedShape)| match &shape.shape {
        Shape::Rect(RectShape { rect, fill, .. })
            if fill.is_opaque() && rect.contains_rect(whole) && shape.clip_rect.contains_rect(whole) =>
        {
            Some((*fill, number + 1))
        }
        _ => None,
    };
    let first = shapes.iter().enumerate().find(|(_, shape)| shape.shape != Shape::Noop);
    first.and_then(hides_all).unwrap_or((Color32::BLACK, 0))
}

/// Returns a mesh that fills `area` with one `colour`, to its edges.
fn plain(area: Rect, colour: Color32) -> Mesh {
    let mut mesh = Mesh::default();
    mesh.add_colored_rect(area.expand2(vec2(1.0, 1.0)), colour);
    mesh
}
